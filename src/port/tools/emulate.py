"""Runs a board's firmware in its emulator: build/emulate/BOARD.png is what the panel shows, BOARD.log what the board said.

An emulator is a module here with
  run(name, image, frames, show)   runs `frames` frames after the bring-up pattern; calls show(number, picture) at each, where
                                   picture() is (width, height, RGB bytes); returns the text
  TOOL                             the program that it needs
  NOTE                             a sentence about what its times are worth
"""
import importlib

import build
import png
from boards import BUILD, Failure, find
from run import require

FRAMES = 100  # some seconds of a chip's time: enough for lines of figures


def emulate(name, frames=FRAMES):
    emulator = importlib.import_module(find(name).emulator)
    require(emulator.TOOL, f"emulating {name}")
    image = build.build(name)
    place = BUILD / "emulate"
    place.mkdir(parents=True, exist_ok=True)
    last = []

    def show(number, picture):
        if number in (0, frames):
            last.append(picture())

    text = emulator.run(name, image, frames, show)
    if "error:" in text or "fault" in text:
        raise Failure(f"the firmware of {name} stopped:\n{text}")
    files = {place / f"{name}.png": png.png(*last[-1]), place / f"{name}-pattern.png": png.png(*last[0]),
             place / f"{name}.log": f"{text}{emulator.NOTE}\n".encode()}
    for path, data in files.items():
        png.write_whole(path, data)
    return text, emulator.NOTE, list(files)
