"""What firmware should show, computed here without a line of its code.

S1 from each step of the orbit is drawn by the simulator from a scene file; how displays of fewer bits should show that, is taken from the text at the
top of src/panel/convert.c.
"""
import math
import pathlib
import sys
import tempfile
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "checks"))
from support import SCENES, fixcast_json  # noqa: E402

STEPS = 60
AXIS = (0.0, -6.0)  # x and z, in world units


def bayer():
    matrix = [[0]]
    while len(matrix) < 8:
        n = len(matrix)
        matrix = [[4 * matrix[y % n][x % n] + ((0, 2), (3, 1))[y // n][x // n] for x in range(2 * n)] for y in range(2 * n)]
    return matrix


BAYER = bayer()


def turned(x, z, step):
    """A point in 65536ths of world units, turned; sines are rounded to 32768ths, the result to the nearest, halves away from 0."""
    def sine(angle):
        return round(32768 * math.sin(math.radians(angle)))

    def rounded(value):
        return int(math.copysign((abs(value) + 16384) // 32768, value))

    axis_x, axis_z = (round(65536 * value) for value in AXIS)
    s, c = sine(6 * step), sine(6 * step + 90)
    x, z = x - axis_x, z - axis_z
    return axis_x + rounded(x * c + z * s), axis_z + rounded(z * c - x * s)


def scene(step):
    """S1 as a scene file, seen from a step of the orbit."""
    lines = []
    for line in (SCENES / "s1.nff").read_text().splitlines():
        words = line.split()
        if words and words[0] in ("from", "at"):
            x, z = turned(round(65536 * float(words[1])), round(65536 * float(words[3])), step)
            line = f"{words[0]} {x / 65536:.16f} {words[2]} {z / 65536:.16f}"
        lines.append(line)
    return "\n".join(lines) + "\n"


def crc_565(simulator, step, width, height):
    """The CRC-32 of a frame in FC_DISPLAY_RGB565, as eight digits."""
    with tempfile.TemporaryDirectory() as place:
        path = pathlib.Path(place) / "s1.nff"
        path.write_text(scene(step))
        return fixcast_json(simulator, "render", path, "--size", f"{width}x{height}")["crc32"][2:]


def level(value, most, steps, x, y):
    """A value of 0..most as a level of 0..steps at a pixel."""
    return (128 * steps * value + (2 * BAYER[y % 8][x % 8] + 1) * most) // (128 * most)


def luma(pixel):
    return 41 * (pixel >> 11) + 39 * (pixel >> 5 & 63) + 16 * (pixel & 31)


def pixels_565(rgb):
    """16-bit pixels from what the eye sees of them."""
    return [(rgb[i] >> 3) << 11 | (rgb[i + 1] >> 2) << 5 | rgb[i + 2] >> 3 for i in range(0, len(rgb), 3)]


def bytes_565(pixels):
    return b"".join(pixel.to_bytes(2, "big") for pixel in pixels)


def grey4_levels(pixels, width):
    return [level(luma(pixel), 4224, 15, i % width, i // width) for i, pixel in enumerate(pixels)]


def bytes_grey4(pixels, width):
    levels = grey4_levels(pixels, width)
    return bytes(left << 4 | right for left, right in zip(levels[::2], levels[1::2]))


def bytes_rgb444(pixels, width):
    nibbles = []
    for i, pixel in enumerate(pixels):
        place = (i % width, i // width)
        nibbles += [level(pixel >> 11, 31, 15, *place), level(pixel >> 5 & 63, 63, 15, *place),
                    level(pixel & 31, 31, 15, *place)]
    return bytes(left << 4 | right for left, right in zip(nibbles[::2], nibbles[1::2]))


def mono_levels(pixels, width):
    return [level(luma(pixel), 4224, 1, i % width, i // width) for i, pixel in enumerate(pixels)]


def bytes_mono8(pixels, width):
    levels = mono_levels(pixels, width)
    height = len(levels) // width
    return bytes(sum(levels[(page + bit) * width + x] << bit for bit in range(8)) for page in range(0, height, 8)
                 for x in range(width))


def crc(data):
    return f"{zlib.crc32(data):08x}"
