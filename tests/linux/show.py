"""fixcast show without hardware: what a dry run sends, where the camera goes, what is said to bad input.

show.py SIMULATOR
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "checks"))
from support import SCENES, Report, fixcast_json

BITS = {"rgb565": 16, "rgb444": 12, "grey4": 4, "mono": 1}
TRIO = """v
from {eye}
at {target}
up {up}
angle 50
hither 0.01
resolution 64 64
#fc: tan_half_fov 1/2
b 0.1 0.2 0.3
l 30 40 60
f 1 0 0 1 0 0 0 1
s {a} 1
f 0 1 0 1 0 0 0 1
s {b} 0.5
f 0 0 1 1 0 0 0 1
s {c} 0.5
"""


class Show:
    def __init__(self, simulator):
        self.simulator = simulator

    def run(self, *arguments):
        return subprocess.run([self.simulator, "show", *map(str, arguments)], capture_output=True, text=True, stdin=subprocess.DEVNULL)

    def dry(self, *arguments):
        run = self.run(*arguments, "--dry-run", "--crc")
        if run.returncode != 0:
            sys.exit(f"show {arguments}: exit {run.returncode}: {run.stderr.strip()}")
        return run.stdout

    def crcs(self, *arguments):
        return re.findall(r"^frame \d+ crc32 (\w+)$", self.dry(*arguments), re.M)


def panels(simulator):
    """[(name, width, height, format)] as `fixcast panels` lists them."""
    text = subprocess.run([simulator, "panels"], capture_output=True, text=True, check=True).stdout
    return [(match[1], int(match[2]), int(match[3]), match[4]) for match in re.finditer(r"^(\S+) +(\d+)x(\d+) +(\w+)", text, re.M)]


def check_panels(report, show):
    """On every panel the frame is the renderer's, in the panel's number of bytes."""
    known = panels(show.simulator)
    report.check(len(known) >= 9, f"{len(known)} panels")
    for name, width, height, pixel_format in known:
        text = show.dry(SCENES / "s1.nff", "--panel", name)
        crc = re.search(r"^frame 0 crc32 (\w+)$", text, re.M)[1]
        rendered = fixcast_json(show.simulator, "render", SCENES / "s1.nff", "--size", f"{width}x{height}")["crc32"]
        report.equal(f"{name}: CRC", rendered, "0x" + crc)
        sent = sum(int(count) for count in re.findall(r"^.* \+ (\d+) bytes, crc32", text, re.M))
        report.equal(f"{name}: bytes of the frame", width * height * BITS[pixel_format] // 8, sent)


def check_stream(report, show):
    """The summary of a stream, from what is known of the ST7789: reset, initialisation, window, pixels, off."""
    text = show.dry(SCENES / "s1.nff", "--panel", "st7789-240", "--reset", "x", "--backlight", "y", "--frames", "2", "--hz", "40000000")
    order = [r"reset low", r"wait [\d.]+ ms", r"reset high", r"01", r"11", r"wait 120 ms", r"3A 55", r"29", r"clock 40000000 Hz, SPI mode [03]",
             r"2A 00 00 00 ef", r"2B 00 00 00 ef",
             r"2C \+ 115200 bytes, crc32 \w+", r"backlight on", r"2C \+ 115200 bytes, crc32 \w+", r"backlight off",
             r"28", r"10", r"in all: \d+ commands, \d+ data bytes, crc32 \w+ "]
    at = 0
    for line in order:
        match = re.compile(f"^{line}", re.M).search(text, at)
        report.check(match, f"no line {line!r} where it belongs in:\n{text}")
        at = match.end() if match else at
    report.equal("frames", 2, text.count("2C + "))
    pixels = re.search(r"^2C \+ 115200 bytes, crc32 (\w+)$", text, re.M)[1]
    report.equal("CRC of the data bytes against that of the frame", re.search(r"^frame 0 crc32 (\w+)$", text, re.M)[1], pixels)


def check_orbit(report, show, directory):
    """60 steps are a turn. A quarter of it, which integers do exactly, is the scene seen from a camera turned by hand, whichever axis is up."""
    turn = show.crcs(SCENES / "s1.nff", "--panel", "st7735-128", "--frames", "61")
    report.equal("frame 60", turn[0], turn[60])
    report.equal("different frames of a turn", 60, len(set(turn[:60])))
    # In the order (up, next, last) of a right-handed system; the quarter turn about `up` is (next, last) -> (-last, next).
    for axis in range(3):
        def place(up, ahead, aside):
            coordinates = [0, 0, 0]
            coordinates[axis], coordinates[(axis + 1) % 3], coordinates[(axis + 2) % 3] = up, ahead, aside
            return " ".join(map(str, coordinates))
        spheres = {"a": place(0, 1, 1), "b": place(1.5, 2.5, 0.25), "c": place(0.25, 0.5, -0.5)}
        middle = (1.5, 0.5)  # of the box around all, 0..3 and -1..2; the view goes through it, so that the camera goes round it
        frames = []
        start = ((0.5, -7, 0.5), (0.5, 1, 0.5), (8, 0, 0))

        def turned(point, centre):
            up, ahead, aside = point
            return up, centre[0] - (aside - centre[1]), centre[1] + (ahead - centre[0])
        for eye, target, up in (start, (turned(start[0], middle), turned(start[1], middle), turned(start[2], (0, 0)))):
            path = directory / f"trio-{axis}-{len(frames)}.nff"
            path.write_text(TRIO.format(eye=place(*eye), target=place(*target), up=place(*up), **spheres))
            frames.append(path)
        quarter = show.crcs(frames[0], "--panel", "st7735-128", "--frames", "16")[15]
        by_hand = fixcast_json(show.simulator, "render", frames[1], "--size", "128x160")["crc32"]
        report.equal(f"a quarter turn about axis {axis}", by_hand, "0x" + quarter)


def check_pattern(report, show):
    """The bring-up pattern, pixel by pixel where it matters, from its description."""
    text = show.dry("--pattern", "--panel", "st7789-240")
    crc = re.search(r"^frame 0 crc32 (\w+)$", text, re.M)[1]
    width = height = 240
    pixels = bytearray()
    for y in range(height):
        for x in range(width):
            border = x in (0, width - 1) or y in (0, height - 1)
            off = abs(2 * x + 1 - width)
            row = y - (height // 2 - 60)
            arrow = 0 <= row < 120 and (off <= 2 * row + 1 if row < 60 else off <= 30)
            colour = 0xffff if border or arrow else (0xf800, 0x07e0, 0x001f)[3 * x // width]
            pixels += colour.to_bytes(2, "big")
    report.equal("CRC of the pattern", f"{zlib.crc32(pixels):08x}", crc)


def check_bad_input(report, show):
    scene, panel = str(SCENES / "s1.nff"), ("--panel", "st7789-240")
    cases = [
        ((*panel, "--dry-run"), "show needs a SCENE to show, or --pattern"),
        ((scene, "--pattern", *panel, "--dry-run"), "show takes a scene or --pattern, not both"),
        ((scene, *panel), "show needs --spi and --dc, or --dry-run; 'fixcast probe' lists what this board has"),
        ((scene, "--dry-run"), "--panel is required; see 'fixcast --help'"),
        ((scene, "--panel", "st7790", "--dry-run"), "--panel st7790: there is no such panel; there are st7789-240, "),
        ((scene, *panel, "--dry-run", "--button", "jump=GPIO5"),
         "--button jump=GPIO5: give WHAT=LINE, WHAT one of pause, faster, slower, reverse, pattern, such as pause=GPIO5"),
        ((scene, *panel, "--dry-run", "--button", "pause="), "--button pause=: give WHAT=LINE"),
        ((scene, "--panel", "ssd1306", "--dry-run", "--twelve-bit"), "--twelve-bit: panel ssd1306 has no such format; leave it out"),
        ((scene, *panel, "--dry-run", "--profile", "interlaced"), "--profile interlaced: show sends whole frames; take exact, fast or half"),
        ((scene, *panel, "--dry-run", "--frames", "0"), "--frames: "),
        ((scene, *panel, "--dry-run", "--fps", "-1"), "--fps: "),
        ((scene, *panel, "--dry-run", "--hz", "10"), "--hz: "),
        ((scene, *panel, "--dry-run", "--strip", "0"), "--strip: "),
        (("nowhere.nff", *panel, "--dry-run"), "nowhere.nff: "),
        ((scene, *panel, "--spi", "/dev/spidev99.9", "--dc", "GPIO25"), "")]
    for arguments, sentence in cases:
        run = show.run(*arguments)
        lines = run.stderr.splitlines()
        report.equal(f"{arguments}: exit code", 2, run.returncode)
        report.check(len(lines) == 1 and lines[0].startswith("fixcast: " + sentence), f"{arguments}: said {run.stderr!r}, not {sentence!r}")


def main(simulator):
    report = Report()
    show = Show(simulator)
    check_panels(report, show)
    check_stream(report, show)
    with tempfile.TemporaryDirectory() as name:
        check_orbit(report, show, pathlib.Path(name))
    check_pattern(report, show)
    check_bad_input(report, show)
    return report.finish()


sys.exit(main(sys.argv[1]))
