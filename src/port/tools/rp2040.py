"""Boards with an RP2040, in the emulator rp2040js with a strict ST7789 (rp2040/*.mjs): boots the UF2 file that a user copies."""
import json
import pathlib
import re
import tempfile
import typing

import rp2040js
import uf2
from boards import BUILD, Failure, find
from run import execute

TOOL = "node"
HERE = pathlib.Path(__file__).resolve().parent / "rp2040"
NOTE = ("Cycles are those of a Cortex-M0+ whose code comes from flash without waiting; bits take their time on the wires. "
        "Two cores never wait for each other at memory.")


class Seen(typing.NamedTuple):
    text: str      # of the serial line
    pictures: list  # RGB bytes at each stop: the pattern, then the frames
    figures: dict  # run.mjs: width, height, problems, frames_a_second, bus_busy, ...


def stop_of(prefix, elf, function):
    marker = re.search(rf"^([0-9a-f]+) T {function}$", execute([f"{prefix}nm", elf], f"reading {elf}"), re.M)
    if marker is None:
        raise Failure(f"{elf} has no function {function}, at which the emulator should look at the panel: build it anew")
    return f"{int(marker.group(1), 16) & ~1:x}"


def watch(elf, panel, frames, prefix="arm-none-eabi-", words=(), function="fc_firmware_frame_shown"):
    """Runs a program from its UF2 file: what was Seen each time it reached `function`, first and then for `frames` frames.
    `words`: further ones of run.mjs."""
    image = uf2.file_of(elf)
    with tempfile.TemporaryDirectory(prefix="fixcast-") as place:
        out = pathlib.Path(place) / "seen"
        execute(["node", HERE / "run.mjs", rp2040js.installed(BUILD / "node"), image, panel, stop_of(prefix, elf, function), frames, out, *words],
                f"emulating {image}")
        figures = json.loads(pathlib.Path(f"{out}.json").read_text())
        text = pathlib.Path(f"{out}.log").read_text(errors="replace").replace("\r", "")
        glass = pathlib.Path(f"{out}.glass").read_bytes()
    size = 3 * figures["width"] * figures["height"]
    return Seen(text, [glass[at:at + size] for at in range(0, len(glass), size)], figures)


def run(name, image, frames, show):
    """As emulate.py wants it; what the panel, the flash or the chip complain of is a Failure."""
    board = find(name)
    seen = watch(image, board.panel, frames, board.prefix)
    if seen.figures["problems"]:
        raise Failure("what the board did is not right:\n  " + "\n  ".join(seen.figures["problems"])
                      + f"\n{seen.figures['problem_count']} such; it said:\n{seen.text}")
    size = seen.figures["width"], seen.figures["height"]
    for number, picture in enumerate(seen.pictures):
        show(number, lambda rgb=picture: (*size, rgb))
    return seen.text + (f"emulator: {seen.figures['frames_a_second']:.2f} frames a second of the chip's time, bits moved "
                        f"{100 * seen.figures['bus_busy']:.1f} % of it, at {seen.figures['bus_hz']:.0f} Hz\n")
