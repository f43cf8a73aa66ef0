"""The firmware that all boards share, on a board of software, against pictures that expected.py computes from the simulator's.

firmware_host.py SIMULATOR FIRMWARE_HOST
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import expected
from support import Report

WIDTH, HEIGHT = 128, 64


class Run:
    """What one run of firmware_host said and showed."""

    def __init__(self, program, panel, frames, rows, mode="async", size=(), buttons=None):
        with tempfile.TemporaryDirectory() as place:
            glass = pathlib.Path(place) / "glass"
            command = [program, panel, frames, rows, mode, glass, *size, *([] if buttons is None else [buttons])]
            run = subprocess.run(list(map(str, command)), capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=100)
            shown = glass.read_bytes() if glass.exists() else b""
        self.code, self.text, self.errors = run.returncode, run.stdout, run.stderr
        self.crcs = re.findall(r"^frame \d+ crc ([0-9a-f]{8})$", self.text, re.M)
        self.lines = re.findall(r"^(?:pattern shown|frame \d+) crc ([0-9a-f]{8})$", self.text, re.M)
        size = len(shown) // len(self.lines) if self.lines else 0
        self.glass = [shown[i:i + size] for i in range(0, len(shown), size)] if size else []

    def well(self, report, what):
        return report.check(self.code == 0 and self.text.endswith("done\n"),
                            f"{what}: exit code {self.code}: {self.errors or self.text}")


def middle(glass, panel_width, panel_height):
    """The picture of WIDTH x HEIGHT in the middle of a panel, and whether all round it is black."""
    x, y = (panel_width - WIDTH) // 2, (panel_height - HEIGHT) // 2
    rows = [glass[3 * panel_width * row:3 * panel_width * (row + 1)] for row in range(panel_height)]
    picture = b"".join(row[3 * x:3 * (x + WIDTH)] for row in rows[y:y + HEIGHT])
    outside = b"".join(rows[:y] + rows[y + HEIGHT:] + [row[:3 * x] + row[3 * (x + WIDTH):] for row in rows[y:y + HEIGHT]])
    return picture, not any(outside)


def check_colour(report, simulator, program):
    """Steps of the orbit as the simulator draws them. The pictures of all, as 16-bit pixels, the pattern first."""
    run = Run(program, "st7789-240", expected.STEPS, 16, size=(WIDTH, HEIGHT))
    if not run.well(report, "60 frames of 128x64 on an ST7789"):
        return []
    report.equal("frames shown", expected.STEPS, len(run.crcs))
    pictures = []
    for number, glass in enumerate(run.glass):
        picture, black = middle(glass, 240, 240)
        pictures.append(expected.pixels_565(picture))
        what = f"frame {number - 1}" if number else "the pattern"
        report.check(black, f"{what}: what is round a small picture is not black")
        report.equal(f"{what}: CRC of what the glass shows", run.lines[number], expected.crc(expected.bytes_565(pictures[-1])))
        if number % 3 == 1:  # each costs a run of the simulator; test_orbit.c has all steps
            report.equal(f"{what}: CRC, the simulator's against the firmware's",
                         expected.crc_565(simulator, number - 1, WIDTH, HEIGHT), run.lines[number])
    report.equal("different frames", expected.STEPS, len(set(run.crcs)))
    whole = Run(program, "st7789-240", 8, 16)
    whole.well(report, "240x240")
    for step in (0, 7):
        report.equal(f"frame {step} of 240x240", expected.crc_565(simulator, step, 240, 240), whole.crcs[step])
    # Three buffers, halves in turn: strips that do not divide the height, one strip, two.
    for panel, rows in (("st7789-240", 7), ("st7789-240", 240), ("st7789-240", 121), ("ssd1306", 4), ("ssd1306", 24)):
        what = f"{panel} in strips of {rows} rows, queued"
        queued, plain = Run(program, panel, 8, rows, "queue"), Run(program, panel, 8, rows)
        queued.well(report, what)
        report.equal(f"{what}: CRCs", plain.lines, queued.lines)
        report.check(queued.glass == plain.glass and len(plain.glass) == 9, f"{what}: the glass shows something else")
    return pictures


def check_formats(report, program, pictures):
    """The same pictures on displays of fewer bits."""
    def grey(values, most):
        return b"".join(bytes([value * 255 // most] * 3) for value in values)

    panels = {
        "ssd0323": (expected.STEPS, expected.bytes_grey4, lambda pixels: grey(expected.grey4_levels(pixels, WIDTH), 15)),
        "ssd1306": (10, expected.bytes_mono8, lambda pixels: grey(expected.mono_levels(pixels, WIDTH), 1)),
    }
    for panel, (frames, to_bytes, to_glass) in panels.items():
        run = Run(program, panel, frames, 16)
        if not run.well(report, panel):
            continue
        for number, pixels in enumerate(pictures[:frames + 1]):
            what = f"{panel}, stop {number}"
            report.equal(f"{what}: CRC", expected.crc(to_bytes(pixels, WIDTH)), run.lines[number])
            report.check(run.glass[number] == to_glass(pixels), f"{what}: the glass shows another picture")
    # The picture's place on the panel is where dither counts from: multiples of 8 here, so that it is that of (0, 0).
    run = Run(program, "st7789-240", 5, 16, "async12", (WIDTH, HEIGHT))
    run.well(report, "12 bits")
    for number, pixels in enumerate(pictures[:6]):
        report.equal(f"12 bits, stop {number}: CRC", expected.crc(expected.bytes_rgb444(pixels, WIDTH)), run.lines[number])


def check_strips(report, program):
    """Strips of any height, synchronous buses: the same bits."""
    for panel, heights in (("ssd0323", (1, 7, 16, 64)), ("ssd1306", (1, 2, 4, 8, 16, 64))):
        first = Run(program, panel, 3, 8)
        for rows in heights:
            for mode in ("sync", "async"):
                run = Run(program, panel, 3, rows, mode, (WIDTH, HEIGHT))
                run.well(report, f"{panel}, strips of {rows} rows, {mode}")
                report.equal(f"{panel}, strips of {rows} rows, {mode}: CRCs", first.lines, run.lines)


def check_pattern(report, pixels):
    """Red, green, blue; a white frame; an arrow that points up."""
    def at(x, y):
        return pixels[y * WIDTH + x]

    for x, colour in ((WIDTH // 6, 0xf800), (WIDTH // 2 + WIDTH // 10, 0x07e0), (5 * WIDTH // 6, 0x001f)):
        for y in (1, 2, HEIGHT - 2):
            report.equal(f"the pattern's pixel ({x}, {y})", f"{colour:04x}", f"{at(x, y):04x}")
    border = [at(x, y) for x in range(WIDTH) for y in range(HEIGHT) if x in (0, WIDTH - 1) or y in (0, HEIGHT - 1)]
    report.equal("colours of the pattern's border", {0xffff}, set(border))
    inside = [y for y in range(1, HEIGHT - 1) if at(1, y) == 0xffff] + [x for x in range(1, WIDTH - 1) if at(x, 1) == 0xffff]
    report.equal("white pixels within the border", [], inside)
    widths = [sum(at(x, y) == 0xffff for x in range(1, WIDTH - 1)) for y in range(1, HEIGHT - 1)]
    arrow = [width for width in widths if width]
    half = len(arrow) // 2
    report.check(len(arrow) >= HEIGHT // 3 and arrow[0] <= 2 and arrow[:half] == sorted(set(arrow[:half])),
                 f"the arrow's head does not widen downwards from a tip: {arrow}")
    report.check(len(set(arrow[half:])) == 1 and arrow[-1] * 2 < arrow[half - 1], f"the arrow has no shaft below: {arrow}")
    mirrored = all((at(x, y) == 0xffff) == (at(WIDTH - 1 - x, y) == 0xffff) for y in range(HEIGHT) for x in range(WIDTH))
    report.check(mirrored, "the arrow is not in the middle")


def check_buttons(report, program, crcs):
    """What is held at each frame, from the first on, and the steps that are then shown. A press shows in the frame after it."""
    pause, faster, slower, reverse, pattern = 1, 2, 4, 8, 16
    scripts = {
        "none": ([0] * 4, [0, 1, 2, 3]),
        "pause": ([0, 0, pause, pause, 0, pause], [0, 1, 1, 1, 1, 2]),
        "reverse": ([0, reverse, 0, 0, 0], [0, 59, 58, 57, 56]),
        "faster, slower": ([0, faster, 0, faster, slower, 0], [0, 2, 4, 8, 10, 12]),
        "held from the start": ([255] * 4, [0, 1, 2, 3]),
    }
    for name, (held, steps) in scripts.items():
        buttons = "".join(f"{bits:02x}" for bits in held)
        run = Run(program, "ssd0323", len(steps), 16, "async", (WIDTH, HEIGHT), buttons)
        run.well(report, f"buttons: {name}")
        shown = [crcs.index(crc) if crc in crcs else None for crc in run.crcs]
        report.equal(f"buttons, {name}: steps shown", steps, shown)
    run = Run(program, "ssd0323", 4, 16, "async", (WIDTH, HEIGHT), f"0000{pattern:02x}{pattern:02x}")
    run.well(report, "buttons: pattern")
    report.equal("the pattern is shown while its button is held", 3, run.text.count("pattern shown"))
    report.equal("frames besides", 4, len(run.crcs))


def check_figures(report, program):
    """The clock of the board of software moves by 100 us each time it is looked at: what it should say can be reckoned."""
    for rows, panel, width, height, row_bytes, hz, verdict in (
            (16, "ssd0323", 128, 64, 64, 4000000, "wire binds"), (1, "ssd0323", 128, 64, 64, 4000000, "wire binds"),
            (2, "st7789-240", 240, 240, 480, 62500000, "wire binds"),
            (1, "st7789-240", 240, 240, 480, 62500000, "render binds")):
        run = Run(program, panel, 9, rows)
        run.well(report, "figures")
        total, strips = row_bytes * height, -(-height // rows)
        render = 100 * (1 + strips)  # set-up and each strip begin and end with a look
        # From the first frame's beginning: two looks a set-up and strip, one at each end of a frame.
        elapsed = 100 * (9 * (2 + 2 * strips) + 9)
        say = (f"9 frames: {9 * 10000 // (elapsed // 1000) / 10:.1f} fps, render {render} us, "
               f"{render * 50 // (width * height)} cycles a pixel, wire {total * 8000 // (hz // 1000)} us a frame: {verdict}\n")
        report.check(say in run.text, f"expected of {panel} in strips of {rows}: {say}but it says:\n{run.text}")
        limit = f"wire limit {hz * 10 // 8 // total / 10:.1f} fps, {total} bytes a frame\n"
        report.check(limit in run.text, f"expected: {limit}but it says:\n{run.text}")
    report.check("panel st7789-240 240x240 rgb565, spi requested 62500000 Hz, actual 62500000 Hz\n" in run.text,
                 f"no line of the panel:\n{run.text}")
    run = Run(program, "ssd0323", 9, 16, "sync")
    report.check(": one after the other\n" in run.text, f"a synchronous display is said to overlap:\n{run.text}")


def check_errors(report, program):
    """Each with a sentence, a code, and before any frame."""
    for what, code, arguments in (
            ("no rows a strip", -2, ("ssd0323", 1, 0)), ("pages from strips of 3 rows", -19, ("ssd1306", 1, 3)),
            ("a picture wider than the panel", -2, ("ssd0323", 1, 8, "async", (130, 64))),
            ("half a byte a row", -19, ("ssd0323", 1, 8, "async", (127, 64))),
            ("12 bits on a panel that has none", -18, ("ssd0323", 1, 8, "async12"))):
        run = Run(program, *arguments)
        report.equal(f"{what}: exit code", 1, run.code)
        report.check(re.search(rf"^error: [^\n]+ \({code}\)\n\Z", run.text, re.M) is not None, f"{what}: it says:\n{run.text}")
        report.equal(f"{what}: frames", [], run.crcs)


def main(simulator, program):
    report = Report()
    pictures = check_colour(report, simulator, program)
    if pictures:
        check_pattern(report, pictures[0])
        check_formats(report, program, pictures)
        check_buttons(report, program, [expected.crc(expected.bytes_grey4(pixels, WIDTH)) for pixels in pictures[1:]])
    check_strips(report, program)
    check_figures(report, program)
    check_errors(report, program)
    return report.finish()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
