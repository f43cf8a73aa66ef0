"""Brings a board's firmware onto the board itself. Each function takes (name, image); no board or no tool is a Failure."""
import shutil
import subprocess

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
