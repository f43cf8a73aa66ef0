"""Brings a board's firmware onto the board itself. Each function takes the board's name and make_image(), which builds the image; it asks for what else it
needs first. No board or no tool is a Failure."""
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
