"""Brings a board's firmware onto the board itself.

Each function takes the board's name and make_image(), which builds the image; it asks for what else it needs first. No board or no tool is a Failure.
"""
import os
import pathlib

import uf2
from boards import Failure
from run import attempt, require


def told(command, what, absent):
    """The output of a tool that talks to a board. `absent`: words of its output that mean there is none."""
    code, output = attempt(command)
    if code == 0:
        return output
    if any(words in output for words in absent):
        raise Failure(f"{what}: no board found; connect it by USB, and see that you may use the device")
    raise Failure(f"{what} failed: {command[0]} ended with exit code {code}:\n{output}")


def openocd_lm3s(name, make_image):
    """The debugger on TI's board is an FTDI chip, which OpenOCD knows with the board."""
    what = f"flashing {name}"
    tool = require("openocd", what, package="openocd")
    return told([tool, "-f", "board/ek-lm3s6965.cfg", "-c", f"program {{{make_image()}}} verify reset exit"], what,
                ("no device found", "unable to open ftdi device", "No such device"))


def mounts():
    """Where file systems are mounted: on Linux from the kernel, on macOS under /Volumes."""
    table = pathlib.Path("/proc/self/mounts")
    if table.exists():
        paths = [line.split()[1] for line in table.read_text().splitlines()]
        return [pathlib.Path(path.encode().decode("unicode_escape")) for path in paths]
    return list(pathlib.Path("/Volumes").glob("*"))


def is_rp2040_drive(path):
    try:
        return "Board-ID: RPI-RP2" in (path / "INFO_UF2.TXT").read_text(errors="replace")
    except OSError:
        return False


def uf2_drive(name, make_image):
    """The boot ROM of an RP2040 is a drive that takes a UF2 file (RP2040 data sheet 2.8.4), and then starts it."""
    drives = [path for path in mounts() if is_rp2040_drive(path)]
    if len(drives) != 1:
        raise Failure(f"flashing {name}: {len(drives)} drives named RPI-RP2 found, one is needed; hold the board's BOOTSEL button down "
                      "while you plug it in by USB, and mount the drive that appears")
    source = uf2.file_of(make_image())
    try:
        with open(drives[0] / source.name, "wb") as file:
            file.write(source.read_bytes())
            os.fsync(file.fileno())
    except OSError as problem:
        raise Failure(f"flashing {name}: cannot write to {drives[0]}: {problem.strerror}") from None
    return f"{source.name} copied to {drives[0]}; the board starts it by itself\n"
