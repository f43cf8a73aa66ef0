"""Builds a board's firmware with CMake (src/port/CMakeLists.txt) into build/firmware/BOARD."""
import os
import shutil
import subprocess
import typing

from boards import BUILD, PORTS, Failure, find


class Size(typing.NamedTuple):
    flash: int  # code, constants and the initial values of variables
    static: int  # variables


def execute(command, what):
    """A command's output; one that fails or is not there is a Failure that says what could not be done."""
    words = list(map(str, command))
    if shutil.which(words[0]) is None:
        raise Failure(f"{what} needs {words[0]}, which is not installed: `.ci/install firmware` installs it")
    run = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                         errors="replace")
    if run.returncode != 0:
        raise Failure(f"{what} failed: {' '.join(words)} ended with exit code {run.returncode}:\n{run.stdout}")
    return run.stdout


def directory(name):
    return BUILD / "firmware" / name


def build(name, crc=False):
    """The path of the program, fresh."""
    board, place = find(name), directory(name)
    program = "firmware-crc" if crc else "firmware"
    link = " ".join(board.link).format(port=PORTS / name)
    what = f"building the firmware of {name}"
    for tool in (f"{board.prefix}gcc", f"{board.prefix}size"):
        if shutil.which(tool) is None:
            raise Failure(f"{what} needs {tool}, which is not installed: `.ci/install firmware` installs it")
    # Compiler and flags can't change in a directory that CMake has configured.
    execute(["cmake", "-S", PORTS, "-B", place, "-DCMAKE_SYSTEM_NAME=Generic", f"-DCMAKE_C_COMPILER={board.prefix}gcc",
             f"-DCMAKE_C_FLAGS={' '.join(board.flags)}", "-DCMAKE_BUILD_TYPE=None", f"-DFIXCAST_BOARD={name}",
             f"-DFIXCAST_BOARD_LINK={link}", "--log-level=WARNING"], what)
    execute(["cmake", "--build", place, "--parallel", os.cpu_count() or 1, "--target", program], what)
    return place / f"{program}.elf"


def size(name, program):
    text = execute([f"{find(name).prefix}size", program], "measuring the firmware")
    code, data, bss = map(int, text.splitlines()[1].split()[:3])
    return Size(code + data, data + bss)
