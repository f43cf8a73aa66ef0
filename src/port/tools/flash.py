"""Brings a board's firmware onto the board itself. Each function takes (name, image); no board or no tool is a Failure."""
import os
import pathlib
import shutil
import subprocess

import uf2
from boards import Failure


def tool(word, what):
    if shutil.which(word) is None:
        raise Failure(f"{what} needs {word}, which is not installed: install the package of that name")
    return word


def spoken(command, what, absent):
    """Runs a tool that talks to a board. `absent`: words of its output that mean there is no board."""
    run = subprocess.run([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, errors="replace")
    if run.returncode == 0:
        return run.stdout
    if any(words in run.stdout for words in absent):
        raise Failure(f"{what}: no board found; connect it by USB, and see that you may use the device")
    raise Failure(f"{what} failed: {command[0]} ended with exit code {run.returncode}:\n{run.stdout}")


def openocd_lm3s(name, image):
    """The debugger on TI's board is an FTDI chip, which OpenOCD knows with the board."""
    what = f"flashing {name}"
    script = f"program {{{image}}} verify reset exit"
    return spoken([tool("openocd", what), "-f", "board/ek-lm3s6965.cfg", "-c", script], what,
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


def uf2_drive(name, image):
    """The boot ROM of an RP2040 is a drive that takes a UF2 file (RP2040 data sheet 2.8.4), and then starts it."""
    drives = [path for path in mounts() if is_rp2040_drive(path)]
    if len(drives) != 1:
        raise Failure(f"flashing {name}: {len(drives)} drives named RPI-RP2 found, one is needed; hold the board's BOOTSEL button down "
                      "while you plug it in by USB, and mount the drive that appears")
    source = uf2.file_of(image)
    try:
        with open(drives[0] / source.name, "wb") as file:
            file.write(source.read_bytes())
            os.fsync(file.fileno())
    except OSError as problem:
        raise Failure(f"flashing {name}: cannot write to {drives[0]}: {problem.strerror}") from None
    return f"{source.name} copied to {drives[0]}; the board starts it by itself\n"
