"""The firmware of the LM3S6965 evaluation board in QEMU: picture and CRC of each frame are those of the same firmware on the host, bit for bit.

board_lm3s6965evb.py FIRMWARE_HOST               checks
board_lm3s6965evb.py --self-test FIRMWARE_HOST   proves that a wrong pixel, a wrong CRC and a board that stands still are noticed
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "src/port/tools"))
import boards  # noqa: E402
import build  # noqa: E402
import qemu  # noqa: E402
from firmware_host import HEIGHT, WIDTH, Run  # noqa: E402
from support import Report  # noqa: E402

NAME = "lm3s6965evb"
FRAMES = 60
ZOOM = 4  # QEMU shows a pixel of the OLED as 4x4
RAM_LIMIT = 20 * 1024
SPI_LIMIT_HZ = 4_000_000  # SSD0323: 250 ns a cycle
QEMU_CYCLES, CYCLES = 1.6, 1.5  # an instruction, by qemu.ICOUNT, and what a Cortex-M3 takes
LEAST_FPS = 35
KEYS = ("up", "down", "left", "right", "ctrl")


def glass_of(picture):
    """QEMU's picture as that of firmware_host: one pixel a pixel. Or a sentence, when a pixel is not of one colour."""
    width, height, rgb = picture
    if (width, height) != (ZOOM * WIDTH, ZOOM * HEIGHT):
        return f"QEMU's picture has {width}x{height} pixels, not {ZOOM * WIDTH}x{ZOOM * HEIGHT}"
    rows = [rgb[3 * width * y:3 * width * (y + 1)] for y in range(height)]
    out = []
    for y in range(0, height, ZOOM):
        small = b"".join(rows[y][3 * x:3 * x + 3] for x in range(0, width, ZOOM))
        large = b"".join(small[i:i + 3] * ZOOM for i in range(0, len(small), 3))
        if any(row != large for row in rows[y:y + ZOOM]):
            return f"row {y // ZOOM} of the OLED is not of whole pixels"
        out.append(small)
    return b"".join(out)


def check_frames(report, image, host):
    """The pattern and a turn, each stop's picture and line."""
    with qemu.Machine(NAME, image) as machine:
        for number, glass in enumerate(host.glass):
            what = f"frame {number - 1}" if number else "the pattern"
            machine.next_frame()
            shown = glass_of(machine.picture())
            report.check(shown == glass, f"{what}: the OLED shows another picture than the host's"
                         + (f": {shown}" if isinstance(shown, str) else ""))
        text = machine.printed()
    lines = re.findall(r"^(?:pattern shown|frame \d+) crc ([0-9a-f]{8})$", text, re.M)
    report.equal("CRCs that the board printed, against the host's", host.lines, lines)
    return text


def check_registers(report, image):
    """What QEMU lets pass, but the chip would not: clocks, pins and pads, as the data sheet's registers say."""
    with qemu.Machine(NAME, image) as machine:
        machine.next_frame()
        machine.next_frame()
        word = machine.remote.word
        rcc, rcgc1, rcgc2 = word(0x400fe060), word(0x400fe104), word(0x400fe108)
        ports = {name: {what: word(base + offset) for what, offset in
                        (("direction", 0x400), ("function", 0x420), ("pull-up", 0x510), ("enable", 0x51c))}
                 for name, base in (("A", 0x40004000), ("C", 0x40006000), ("D", 0x40007000), ("E", 0x40024000),
                                    ("F", 0x40025000))}
        data = {name: word(base + 0x3fc) for name, base in (("C", 0x40006000), ("D", 0x40007000))}
        cr0, cr1, prescale = word(0x40008000), word(0x40008004), word(0x40008010)
        baud = word(0x4000c024) + word(0x4000c028) / 64
    report.equal("RCC: crystal of 8 MHz, main oscillator on and chosen, PLL on and not bypassed, divider in use",
                 (14, 0, 0, 0, 0, 1), (rcc >> 6 & 15, rcc & 1, rcc >> 4 & 3, rcc >> 13 & 1, rcc >> 11 & 1, rcc >> 22 & 1))
    hz = 400e6 / 2 / ((rcc >> 23 & 15) + 1)
    report.equal("processor clock", 50e6, hz)
    report.equal("clock gates of UART 0 and SSI 0", 0x11, rcgc1 & 0x11)
    report.equal("clock gates of ports A, C, D, E, F", 0x3d, rcgc2 & 0x3d)
    for name, what, bits, value in (("A", "function", 0x3f, 0x3f), ("A", "enable", 0x3f, 0x3f), ("C", "direction", 0xc0, 0xc0),
                                    ("C", "enable", 0xc0, 0xc0), ("C", "function", 0xc0, 0), ("D", "direction", 1, 1),
                                    ("D", "enable", 1, 1), ("E", "direction", 15, 0), ("E", "pull-up", 15, 15),
                                    ("E", "enable", 15, 15), ("F", "direction", 2, 0), ("F", "pull-up", 2, 2),
                                    ("F", "enable", 2, 2)):
        report.equal(f"port {name}, {what}, bits {bits:#x}", value, ports[name][what] & bits)
    report.equal("the OLED's 15 V are on, D/C says data", 0xc0, data["C"] & 0xc0)
    report.equal("the SD card is not selected", 1, data["D"] & 1)
    report.equal("SSI: on, a master; Freescale's frames of 8 bits, mode 3", (2, 0xc7), (cr1 & 6, cr0 & 0xff))
    wire = hz / (prescale * ((cr0 >> 8) + 1))
    report.check(SPI_LIMIT_HZ * 3 / 4 < wire <= SPI_LIMIT_HZ, f"the SSI's registers make {wire:.0f} Hz of {hz:.0f}")
    report.check(abs(hz / 16 / baud / 115200 - 1) < 0.002, f"the UART's registers make {hz / 16 / baud:.0f} baud")


def check_buttons(report, image, host):
    """All buttons let go (in QEMU they seem held until they are), then left held: the camera turns back."""
    with qemu.Machine(NAME, image) as machine:
        machine.next_frame([(key, down) for down in (True, False) for key in KEYS])
        for keys in ((), (), (("left", True),), (), (), ()):
            machine.next_frame(keys)
        crcs = re.findall(r"^frame \d+ crc ([0-9a-f]{8})$", machine.printed(), re.M)
    steps = [host.crcs.index(crc) for crc in crcs]
    changes = [(later - earlier) % FRAMES for earlier, later in zip(steps, steps[1:])]
    report.check(changes[0] == 1 and changes[-1] == FRAMES - 1 and changes == sorted(changes)
                 and set(changes) == {1, FRAMES - 1}, f"left was pressed, but the steps shown are {steps}")


def check_figures(report):
    """The image that would be flashed, without CRCs: its speed by instructions, its memory."""
    image = build.build(NAME)
    size = build.size(NAME, image)
    with qemu.Machine(NAME, image) as machine:
        text = machine.listen(r"(\d frames: [^\n]*\n.*){3}")
    match = re.search(r"^panel ssd0323 128x64 grey4, spi requested 4000000 Hz, actual (\d+) Hz$", text, re.M)
    figures = re.findall(r"^\d+ frames: ([\d.]+) fps, render (\d+) us, (\d+) cycles a pixel, wire (\d+) us a frame: "
                         r"(\w+) binds, ram (\d+) bytes$", text, re.M)
    if not report.check(match is not None and len(figures) >= 3, f"figures are missing:\n{text}"):
        return
    hz = int(match.group(1))
    report.equal("SPI clock, as the firmware says", int(50e6 / 14), hz)  # what the registers make, see above
    fps = min(float(words[0]) for words in figures) * QEMU_CYCLES / CYCLES
    ram = max(int(words[5]) for words in figures)
    report.check(fps >= LEAST_FPS, f"{fps:.1f} frames a second at {CYCLES} cycles an instruction: at least {LEAST_FPS} are wanted")
    report.at_most("RAM, stack included", RAM_LIMIT, ram)
    report.check(ram > size.static + 1000, f"RAM with the stack is {ram} bytes, the variables alone are {size.static}")
    print(f"{fps:.1f} frames a second at {CYCLES} cycles an instruction, SPI at {hz} Hz, "
          f"{size.flash} bytes of flash, {ram} of RAM")


def self_test(image, host):
    """The check with something wrong each."""
    def wrong(change):
        other = object.__new__(Run)
        other.__dict__.update(host.__dict__)
        other.glass, other.lines = list(host.glass[:4]), list(host.lines[:4])
        change(other)
        report = Report()
        check_frames(report, image, other)
        return len(report.wrong)

    def pixel(other):
        glass = bytearray(other.glass[3])
        glass[3 * (WIDTH * HEIGHT - 1)] ^= 17
        other.glass[3] = bytes(glass)

    def crc(other):
        other.lines[2] = "00000000"

    def still(other):
        other.glass[3], other.lines[3] = other.glass[2], other.lines[2]

    found = {"nothing wrong": wrong(lambda other: None) == 0, "a wrong pixel": wrong(pixel) == 1, "a wrong CRC": wrong(crc) == 1,
             "a frame that stands still": wrong(still) == 2}
    for name, passed in found.items():
        print(f"{'passed' if passed else 'FAILED'}: {name}")
    return 0 if all(found.values()) else 1


def main(arguments):
    program = arguments[-1]
    report = Report()
    try:
        image = build.build(NAME, crc=True)
        host = Run(program, "ssd0323", FRAMES, 8)
        report.equal("pictures of the host", FRAMES + 1, len(host.glass))
        if arguments[0] == "--self-test":
            return self_test(image, host)
        check_frames(report, image, host)
        check_registers(report, image)
        check_buttons(report, image, host)
        check_figures(report)
    except boards.Failure as failure:
        print(f"{NAME}: {failure}")
        return 1
    return report.finish()


sys.exit(main(sys.argv[1:]))
