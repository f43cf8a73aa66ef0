"""The demo on an emulated Raspberry Pi Pico, from the UF2 file on: what its glass shows, what it says, how fast it is.

board_pico.py pictures SIMULATOR   every frame of the orbit, bit for bit as the simulator draws it; buttons
board_pico.py options SIMULATOR    the same, some frames, on the panel of 135x240, upside down, and drawn by two cores
board_pico.py speed                figures: frames a second, how busy the bus is, RAM
"""
import re
import sys

import expected
from support import ROOT, Report

sys.path.insert(0, str(ROOT / "src/port/tools"))
import boards  # noqa: E402
import build  # noqa: E402
import rp2040  # noqa: E402

FRAMES = 60
SLOW_HZ, SLOW_FRAMES = 15_625_000, 20
PAUSE, REVERSE = 1, 2  # as run.mjs names the buttons


def no_complaints(report, what, seen, frames):
    """The board, its flash and its panel found nothing wrong, and all frames came."""
    for problem in seen.figures["problems"]:
        report.check(False, f"{what}: {problem}")
    report.equal(f"{what}: things that were wrong", 0, seen.figures["problem_count"])
    report.equal(f"{what}: pictures", frames + 1, len(seen.pictures))
    report.check(seen.figures["backlight"], f"{what}: the backlight is off")


def check_steps(report, simulator, name, steps, buttons=(), upside_down=False):
    """Shows frames and compares each with the simulator's of its step of the orbit, as the glass shows it and as the board says."""
    seen = rp2040.watch(build.build(name, crc=True), boards.find(name).panel, len(steps), words=buttons)
    no_complaints(report, name, seen, len(steps))
    said = re.findall(r"^(pattern shown|frame \d+) crc ([0-9a-f]{8})$", seen.text, re.M)
    report.equal(f"{name}: lines of CRCs", ["pattern shown"] + [f"frame {i}" for i in range(len(steps))], [line[0] for line in said])
    size, drawn = (seen.figures["width"], seen.figures["height"]), {}
    for (line, crc), picture in zip(said, seen.pictures):
        pixels = expected.pixels_565(picture)
        glass = expected.crc(expected.bytes_565(pixels[::-1] if upside_down else pixels))
        report.equal(f"{name}, {line}: CRC of the glass against that of what was sent", crc, glass)
    for (line, crc), step in zip(said[1:], steps):
        drawn[step] = drawn.get(step) or expected.crc_565(simulator, step, *size)
        report.equal(f"{name}, {line}: CRC of step {step} by the simulator", drawn[step], crc)


def pictures(report, simulator):
    # Forwards to step 40; there reverse, then a pause of three frames. Stop n is that of frame n - 2, when n - 1 is drawn next: buttons
    # count for frame n.
    steps = list(range(41)) + list(range(39, 29, -1)) + [30] * 4 + list(range(29, 24, -1))
    check_steps(report, simulator, "pico", steps,
                [f"41:{REVERSE}", "42:0", f"51:{PAUSE}", "52:0", f"55:{PAUSE}", "56:0"])


def with_option(board, option):
    """The name of a board like another, built with an option of src/port/pico/main.c."""
    name = f"{board}-{option}"
    boards.BOARDS[name] = boards.BOARDS[board]._replace(port="pico", flags=(*boards.BOARDS[board].flags, f"-D{option}"))
    return name


def options(report, simulator):
    check_steps(report, simulator, "pico-135", list(range(6)))
    for board in ("pico", "pico-135"):
        check_steps(report, simulator, with_option(board, "PICO_HALF_TURN"), [0, 1], upside_down=True)
    two = with_option("pico", "PICO_TWO_CORES")
    check_steps(report, simulator, two, list(range(12)))
    report.at_most("bytes of variables and stacks of two cores", 24 * 1024, build.size(two, build.build(two)).static)


def speed(report):
    seen = rp2040.watch(build.build("pico"), "st7789-240", FRAMES)
    no_complaints(report, "62.5 MHz", seen, FRAMES)
    ram = [int(number) for number in re.findall(r", ram (\d+) bytes$", seen.text, re.M)]
    report.equal("62.5 MHz: clock of the bus", 62_500_000, seen.figures["bus_hz"])
    report.equal("clk_sys", 125_000_000, seen.figures["system_hz"])
    report.check(seen.figures["frames_a_second"] >= 16, f"62.5 MHz: at least 16 frames a second wanted: {seen.figures['frames_a_second']:.2f}")
    report.check(ram != [], "the board does not say how much RAM it uses")
    report.at_most("bytes of RAM, the stack included", 24 * 1024, max(ram, default=0))
    slow = rp2040.watch(build.build(with_option("pico", f"PICO_PIXEL_HZ={SLOW_HZ}")), "st7789-240", SLOW_FRAMES)
    no_complaints(report, "15.625 MHz", slow, SLOW_FRAMES)
    report.equal("15.625 MHz: clock of the bus", SLOW_HZ, slow.figures["bus_hz"])
    report.check(slow.figures["bus_busy"] >= 0.85, f"15.625 MHz: bits move {slow.figures['bus_busy']:.3f} of the time, at least 0.85 wanted")
    two = rp2040.watch(build.build(with_option("pico", "PICO_TWO_CORES")), "st7789-240", SLOW_FRAMES)
    no_complaints(report, "two cores", two, SLOW_FRAMES)
    report.check(two.figures["frames_a_second"] >= 25, f"two cores: at least 25 frames a second wanted: {two.figures['frames_a_second']:.2f}")
    for what, run in (("62.5 MHz", seen), ("15.625 MHz", slow), ("62.5 MHz, two cores", two)):
        print(f"{what}: {run.figures['frames_a_second']:.2f} frames a second, bits move {100 * run.figures['bus_busy']:.1f} % of the time")
    print(f"{max(ram, default=0)} bytes of RAM")


def main(arguments):
    report = Report()
    what, *rest = arguments
    try:
        {"pictures": pictures, "options": options, "speed": speed}[what](report, *rest)
    except boards.Failure as failure:
        report.check(False, str(failure))
    return report.finish()


sys.exit(main(sys.argv[1:]))
