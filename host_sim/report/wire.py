"""Frames a second: what a display's bus takes, what a chip draws."""
import typing

import rows as bench


class Display(typing.NamedTuple):
    name: str
    width: int
    height: int
    mhz: float


DISPLAYS = (Display("ST7735", 128, 128, 15.15), Display("ST7789", 240, 135, 62.5), Display("ST7789", 240, 240, 62.5),
            Display("ILI9341", 320, 240, 40))
CHIPS = ((50, 1), (125, 1), (125, 2))  # MHz, cores
CYCLES_AN_INSTRUCTION = 1.35  # of an M0+ where no row has cycles: RP2040 rows have about that


def bus_frames(display):
    """At 16 bits a pixel, commands left out."""
    return display.mhz * 1e6 / (display.width * display.height * 16)


def cycles(rows, display, scene):
    """(set-up, strips) in cycles a pixel and how they are known, or None. Of the size itself, else of 240x240."""
    for size in (f"{display.width}x{display.height}", "240x240", "128x128"):
        near = "" if size == f"{display.width}x{display.height}" else f", a pixel of {size}"
        for target, known in (("rp2040", "measured"), ("m0plus", f"{CYCLES_AN_INSTRUCTION} cycles an instruction")):
            row = bench.one(rows, scene=scene, target=target, size=size)
            if row and row["instructions_per_pixel"]:
                instructions = row["instructions_per_pixel"]
                each = (row["cycles_per_pixel"] or instructions * CYCLES_AN_INSTRUCTION) / instructions
                setup = row["setup_instructions"]  # of a frame, whatever its size
                strips = instructions - setup / bench.pixels(row)
                return setup / (display.width * display.height) * each, strips * each, known + near
    return None


def drawn(rows, display, scene, clock, cores):
    """(frames a second drawn, how that is known) or None. Cores share strips, not set-up."""
    found = cycles(rows, display, scene)
    if found is None:
        return None
    setup, strips, known = found
    return clock * 1e6 / (display.width * display.height * (setup + strips / cores)), known


def cycles_an_instruction(rows):
    """What our rows on the RP2040 took, or the assumption."""
    known = [row for row in rows if row["renderer"] == "fixcast" and row["cycles_per_pixel"]]
    if not known:
        return CYCLES_AN_INSTRUCTION
    return round(sum(row["cycles_per_pixel"] / row["instructions_per_pixel"] for row in known) / len(known), 2)
