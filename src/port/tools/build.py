"""Builds a board's firmware with CMake (src/port/CMakeLists.txt) into build/firmware/BOARD."""
import importlib
import os
import shutil
import typing

from boards import BUILD, PORTS, find
from run import execute, require


class Size(typing.NamedTuple):
    flash: int   # code, constants and the initial values of variables
    static: int  # variables


def configure(name, what):
    """CMake's directory for the board. It starts over when compiler or flags are others: CMake would forget half of them."""
    board, place = find(name), BUILD / "firmware" / name
    compiler = require(f"{board.prefix}gcc", what)
    require(f"{board.prefix}size", what)
    port = board.port or name
    link = " ".join(board.link).format(port=PORTS / port)
    command = ["cmake", "-S", PORTS, "-B", place, "-DCMAKE_SYSTEM_NAME=Generic", f"-DCMAKE_C_COMPILER={compiler}",
               f"-DCMAKE_C_FLAGS={' '.join(board.flags)}", "-DCMAKE_BUILD_TYPE=None", f"-DFIXCAST_BOARD={port}",
               f"-DFIXCAST_BOARD_LINK={link}", "--log-level=WARNING"]
    recipe, text = place / "recipe", " ".join(map(str, command))
    if place.exists() and not (recipe.exists() and recipe.read_text() == text):
        shutil.rmtree(place)
    execute(command, what)
    recipe.write_text(text)
    return place


def build(name, crc=False):
    """The path of the program, fresh; `crc`: the one that prints a CRC a frame."""
    what, program = f"building the firmware of {name}", "firmware-crc" if crc else "firmware"
    place = configure(name, what)
    execute(["cmake", "--build", place, "--parallel", os.cpu_count() or 1, "--target", program], what)
    elf = place / f"{program}.elf"
    for task in find(name).tasks:
        importlib.import_module(task).finish(elf)
    return elf


def size(name, program):
    text = execute([f"{find(name).prefix}size", program], "measuring the firmware")
    code, data, bss = map(int, text.splitlines()[1].split()[:3])
    return Size(code + data, data + bss)
