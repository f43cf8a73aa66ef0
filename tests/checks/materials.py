"""Each material, light and texture of the scene format by itself: the picture as the oracle's long double has it, and its golden CRC.

materials.py SIMULATOR               checks
materials.py --update SIMULATOR      rewrites tests/golden/materials.txt from what the simulator renders
materials.py --self-test SIMULATOR   proves that a wrong, missing or superfluous line is noticed

A scene is a ball (object 1), a four-sided pyramid (2) and a floor (3), with one thing changed at a time.
"""
import itertools
import math
import pathlib
import shutil
import sys
import tempfile

from support import GOLDEN, SCENES, Report, fixcast_json

FILE = GOLDEN.with_name("materials.txt")
HEADER = """\
# Materials, lights and textures by themselves, 64x48: zlib's CRC-32 of the RGB565 big-endian frame, name.
# `python3 tests/checks/materials.py --update build/fixcast` rewrites this file; it is refused where the oracle disagrees.
"""
SIZE = "64x48"
LAMP, FLAT = "l -3 5 2 0.8 0.75 0.7", ("0.8 0.3 0.2 1 0 1 0 1", "0.2 0.6 0.3 1 0 1 0 1", "0.7 0.7 0.6 1 0 1 0 1")
WHITE = "1 1 1 1 0 1 0 1"
BASE = ("-0.2 0 -2.6", "1.8 0 -2.6", "1.8 0 -4.6", "-0.2 0 -4.6")
TIP = "0.8 1.7 -3.6"
FLOOR_MAP = "planar -3 0 -6 1.5 0 0 0 0 1.5"
WALL_MAP = "planar -0.2 0 -2.6 1 0 0 0 1 0"


def facets(center, radius, around, down):
    """A ball of triangles as the format's lines: each corner with the ball's own normal."""
    def corner(i, j):
        across, up = 2 * math.pi * i / around, math.pi * j / down
        normal = (math.sin(up) * math.cos(across), math.cos(up), math.sin(up) * math.sin(across))
        point = (c + radius * n for c, n in zip(center, normal))
        return " ".join(f"{v:.5f}" for v in (*point, *normal))
    lines = []
    for i, j in itertools.product(range(around), range(down)):
        a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
        lines += ["pp 3", a, b, c] if j > 0 else []
        lines += ["pp 3", a, c, d] if j < down - 1 else []
    return lines


def scene(lights=(LAMP,), ball=(FLAT[0],), pyramid=(FLAT[1],), floor=(FLAT[2],), more=(), smooth=False, mesh=()):
    """The text of a scene; materials are the words of `f` and then further lines. `mesh` stands in for the pyramid."""
    lines = ["v", "from 0 1.6 2", "at 0 0.8 -3", "up 0 1 0", "angle 50", "hither 0.01", "resolution 64 48", "#fc: tan_half_fov 0.42",
             "b 0.3 0.4 0.6", "#fc: ambient 0.1 0.11 0.12", "#fc: far 60", *more, *lights]
    for number, (material, *further) in enumerate((ball, pyramid, floor), 1):
        lines += [f"#fc: object {number}", f"f {material}", *further]
        if number == 1:
            lines.append("s -1 0.8 -3 0.8")
        elif number == 3:
            lines.append("#fc: plane 0 1 0 0")
        elif mesh:
            lines += mesh
        else:
            for a, b in zip(BASE, BASE[1:] + BASE[:1]):
                corners = (a, b, TIP)
                if smooth:  # normals away from the pyramid's axis and a little up
                    corners = [f"{c} {float(c.split()[0]) - 0.8:.3f} 0.6 {float(c.split()[2]) + 3.6:.3f}" for c in (a, b)] + [f"{TIP} 0 1 0"]
                lines += ["pp 3" if smooth else "p 3", *corners]
    return "\n".join(lines) + "\n"


SPOT = "0.5 0.2 0.1 1 0.7"  # Phong's highlight: its strength, then its exponent
CASES = {
    "lambert": scene(),
    "ambient alone": scene(lights=()),
    "two coloured lights": scene(lights=("l -3 5 2 0.8 0.1 0.1", "l 4 3 1 0.1 0.2 0.9")),
    "inverse-square falloff": scene(lights=("l -1 3 -1 9 8 7",), more=("#fc: falloff inverse-square",)),
    "a directional light": scene(lights=("#fc: sun 3 4 2 0.8 0.75 0.7",)),
    "point and directional": scene(lights=(LAMP, "#fc: sun 3 2 1 0.2 0.25 0.4")),
    "gradient": scene(more=("#fc: gradient 0 1 0 0.05 0.1 0.5",)),
    "phong 1": scene(ball=(f"{SPOT} 1 0 1",)),
    "phong 20": scene(ball=(f"{SPOT} 20 0 1",), pyramid=(f"{SPOT} 20 0 1",), floor=(f"{SPOT} 20 0 1",)),
    "phong 300": scene(ball=(f"{SPOT} 300 0 1",)),
    "emission": scene(ball=(FLAT[0], "#fc: emission 0.5 0.4 0.1")),
    "mirror": scene(ball=(FLAT[0], "#fc: mirror 0.6 0.7 0.8")),
    "plane mirror, one bounce": scene(floor=(FLAT[2], "#fc: mirror 0.5 0.5 0.5 1")),
    "mirrors, four bounces": scene(ball=(FLAT[0], "#fc: mirror 0.8 0.8 0.8 4"), floor=(FLAT[2], "#fc: mirror 0.6 0.6 0.6 4")),
    "smooth": scene(smooth=True),
    "smooth phong": scene(smooth=True, pyramid=(f"{SPOT} 10 0 1",)),
    "smooth, small triangles": scene(mesh=facets((0.9, 0.8, -3.4), 0.8, 16, 9)),
    "smooth, long triangles": scene(mesh=facets((0.9, 0.8, -3.4), 0.8, 5, 40)),
    "smooth image": scene(smooth=True, pyramid=(WHITE, f"#fc: image tiles.ppm bilinear {WALL_MAP}")),
    "checker on a ball": scene(ball=(WHITE, "#fc: checker 0.9 0.8 0.7 0.1 0.1 0.3 spherical repeat 6 3")),
    "checker on a plane": scene(floor=(WHITE, f"#fc: checker 0.9 0.8 0.7 0.1 0.1 0.3 {FLOOR_MAP}")),
    "checker on triangles": scene(pyramid=(WHITE, f"#fc: checker 0.9 0.8 0.7 0.1 0.1 0.3 {WALL_MAP}")),
    "image, nearest, tile, replace": scene(floor=(WHITE, f"#fc: image tiles.ppm {FLOOR_MAP}")),
    "image, bilinear, tile": scene(floor=(WHITE, f"#fc: image tiles.ppm bilinear {FLOOR_MAP}")),
    "image, nearest, clamp": scene(floor=(WHITE, f"#fc: image tiles.ppm clamp {FLOOR_MAP}")),
    "image, bilinear, clamp": scene(floor=(WHITE, f"#fc: image tiles.ppm bilinear clamp {FLOOR_MAP}")),
    "image, modulate": scene(floor=("0.9 0.5 0.2 1 0 1 0 1", f"#fc: image tiles.ppm bilinear modulate {FLOOR_MAP}")),
    "image on a ball": scene(ball=(WHITE, "#fc: image globe.ppm bilinear spherical")),
    "image on triangles": scene(pyramid=(WHITE, f"#fc: image tiles.ppm bilinear {WALL_MAP}")),
}


class Studio:
    """A directory with the textures, where scenes are drawn and judged."""

    def __init__(self, simulator, directory):
        self.simulator, self.path = simulator, pathlib.Path(directory, "scene.nff")
        for name in ("tiles.ppm", "globe.ppm"):
            shutil.copy(SCENES / name, directory)

    def judged(self, text):
        self.path.write_text(text)
        return fixcast_json(self.simulator, "compare", self.path, "--size", SIZE)


def read(path):
    """{name: crc}"""
    lines = (line for line in path.read_text().splitlines() if line and not line.startswith("#"))
    return {name: crc for crc, name in (line.split(" ", 1) for line in lines)}


def check(studio, golden, report, cases):
    """The CRC of each case, which the oracle has judged."""
    seen = {}
    for name, text in cases.items():
        found = studio.judged(text)
        seen[name] = found["crc32"]
        report.equal(f"{name}: wrong ids and shadows", (0, 0), (found["wrong_id"], found["wrong_shadow"]))
        report.at_most(f"{name}: worst colour", 1.0, found["colour_max"])
        report.at_most(f"{name}: colour rmse", 0.35, found["colour_rmse"])
        report.equal(f"{name}: golden CRC", golden.get(name), found["crc32"])
    for name in set(golden) - set(cases):
        report.check(False, f"golden line that no test renders: {name}")
    twice = {crc for crc in seen.values() if list(seen.values()).count(crc) > 1}
    report.equal("pictures of two cases are the same: what differs between them does nothing", set(), twice)
    return seen


def update(studio):
    report = Report()
    seen = {name: studio.judged(text)["crc32"] for name, text in CASES.items()}
    check(studio, seen, report, CASES)
    if not report.wrong:
        FILE.write_text(HEADER + "".join(f"{crc} {name}\n" for name, crc in seen.items()))
    return report.finish()


def self_test(studio):
    cases = {name: CASES[name] for name in ("lambert", "emission")}
    right = {name: studio.judged(text)["crc32"] for name, text in cases.items()}
    report = Report()
    for what, golden, some, faults in (("right", right, cases, 0), ("wrong", {**right, "lambert": "0x00000000"}, cases, 1),
                                       ("missing", {"lambert": right["lambert"]}, cases, 1), ("surplus", {**right, "velvet": "0x1"}, cases, 1),
                                       ("same", {**right, "emission": right["lambert"]}, {**cases, "emission": CASES["lambert"]}, 1)):
        found = Report()
        check(studio, golden, found, some)
        report.equal(f"faults found in the {what} lines", faults, len(found.wrong))
    return report.finish()


def main(arguments):
    with tempfile.TemporaryDirectory() as directory:
        studio = Studio(arguments[-1], directory)
        if arguments[0] == "--update":
            return update(studio)
        if arguments[0] == "--self-test":
            return self_test(studio)
        report = Report()
        check(studio, read(FILE), report, CASES)
        return report.finish()


sys.exit(main(sys.argv[1:]))
