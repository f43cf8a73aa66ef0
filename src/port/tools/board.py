"""The front door to the boards: builds their firmware, runs it in an emulator, brings it onto a board.

board.py build|emulate|flash [BOARD]     without BOARD: the list of boards, and exit code 2
"""
import sys

import boards
import build
import emulate
import flash


def build_one(name):
    image = build.build(name)
    size = build.size(name, image)
    print(f"{image.relative_to(boards.ROOT)}: {size.flash} bytes of flash, {size.static} bytes of variables")


def emulate_one(name):
    text, note, files = emulate.emulate(name)
    print(text, end="")
    print(note)
    for path in files:
        print(path.relative_to(boards.ROOT))


def flash_one(name):
    print(getattr(flash, boards.find(name).flasher)(name, lambda: build.build(name)), end="")


def main(arguments):
    actions = {"build": build_one, "emulate": emulate_one, "flash": flash_one}
    if not 1 <= len(arguments) <= 2 or arguments[0] not in actions:
        print(__doc__, file=sys.stderr)
        return 2
    name = arguments[1].strip() if len(arguments) == 2 else ""
    if not name:
        print(f"say which board: BOARD=NAME\n{boards.listing()}", end="", file=sys.stderr)
        return 2
    try:
        actions[arguments[0]](name)
    except boards.Failure as failure:
        print(f"{arguments[0]}: {failure}", file=sys.stderr)
        return 1
    return 0


sys.exit(main(sys.argv[1:]))
