"""Builds lm3s6965evb_bus.c with the port's own files and runs it in QEMU.

lm3s6965evb_bus.py WORK_DIRECTORY
"""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "src/port/tools"), str(HERE.parent / "checks")]
import boards  # noqa: E402
import qemu  # noqa: E402
from run import execute  # noqa: E402
from support import Report  # noqa: E402

NAME = "lm3s6965evb"


def build(work):
    board, port = boards.find(NAME), boards.PORTS / NAME
    work.mkdir(parents=True, exist_ok=True)
    image, source = work / "lm3s6965evb_bus.elf", boards.ROOT / "src"
    files = [*(path for path in sorted(port.glob("*.c")) if path.name not in ("main.c", "buttons.c")),
             source / "firmware/text.c", HERE / "lm3s6965evb_bus.c"]
    execute([f"{board.prefix}gcc", "-std=c99", *board.flags, "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic", "-Werror",
             "-I", boards.ROOT / "include", "-I", source / "firmware", "-I", port, *files,
             *(word.format(port=port) for word in board.link), "-o", image], "building the check of the bus")
    return image


def main(work):
    report = Report()
    try:
        with qemu.Machine(NAME, build(pathlib.Path(work))) as machine:
            machine.next_frame()
            text = machine.printed()
    except boards.Failure as failure:
        print(failure)
        return 1
    found = re.search(r"^checks (\d+) wrong (\d+)$", text, re.M)
    report.check(found is not None and int(found.group(1)) > 100 and int(found.group(2)) == 0, f"the board said:\n{text}")
    return report.finish()


sys.exit(main(*sys.argv[1:]))
