"""Cones, models and views: what the scene readers make of them, checked by geometry and by the same scene written otherwise.

scenes.py SIMULATOR
"""
import math
import pathlib
import subprocess
import sys
import tempfile

import picture_files
from support import SCENES, Report, fixcast_json

VIEW = "v\nfrom 0.3 1.1 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 80 60\n"
LIT = "b 0 0 0\nl 3 4 5\n#fc: ambient 0.2\nf 0.8 0.4 0.2 1 0 0 0 1\n"


def run(simulator, *arguments):
    return subprocess.run([simulator, *map(str, arguments)], capture_output=True, text=True, stdin=subprocess.DEVNULL)


def crc(simulator, path, *options):
    return fixcast_json(simulator, "render", path, *options)["crc32"]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(c / math.sqrt(dot(a, a)) for c in a)


def rays(eye, at, up, degrees, width, height):
    """Directions whose component along the view is 1, so that t is camera z; rows from the top (SPEC section 8: NFF's angle)."""
    forward = unit(tuple(q - p for p, q in zip(eye, at)))
    right = unit(cross(forward, up))
    above = cross(right, forward)
    scale = math.tan(math.radians(degrees / 2)) / (min(width, height) - 1)
    for y in range(height):
        for x in range(width):
            h, v = (2 * x + 1 - width) * scale, (height - 2 * y - 1) * scale
            yield tuple(f + h * r + v * u for f, r, u in zip(forward, right, above))


def open_cone(eye, d, base, apex, r0, r1):
    """The smallest t > 0 at which the ray meets the side of a truncated cone, or None."""
    axis = tuple(q - p for p, q in zip(base, apex))
    length = math.sqrt(dot(axis, axis))
    a = unit(axis)
    o = tuple(p - q for p, q in zip(eye, base))
    od, oo, slope = dot(d, a), dot(o, a), (r1 - r0) / length
    dp = tuple(p - od * q for p, q in zip(d, a))
    op = tuple(p - oo * q for p, q in zip(o, a))
    radius = r0 + slope * oo
    qa, qb = dot(dp, dp) - (slope * od) ** 2, dot(dp, op) - radius * slope * od
    root = qb * qb - qa * (dot(op, op) - radius * radius)
    if root < 0 or qa == 0:
        return None
    for t in sorted(((-qb - math.sqrt(root)) / qa, (-qb + math.sqrt(root)) / qa)):
        if t > 0 and 0 <= oo + t * od <= length:
            return t
    return None


def check_cone(simulator, directory, report):
    """Every pixel is between the true cone and one thinner by the stated error; so is every depth of its near side."""
    path, picture = directory / "cone.nff", directory / "cone.exr"
    for error, base, apex, r0, r1 in ((0.005, (-0.5, -1, 0), (0.6, 1, 0.3), 0.8, 0.4), (0.05, (-1, -0.5, 0.5), (1, 0.7, -0.5), 0.5, 0.5),
                                      (0.005, (0, -1.2, 0), (0.2, 1.4, 0), 1, 0)):
        numbers = " ".join(map(str, (*base, r0))) + "\n" + " ".join(map(str, (*apex, r1)))
        path.write_text(VIEW + LIT + (f"#fc: cone_error {error}\n" if error != 0.005 else "") + f"c\n{numbers}\n")
        result = run(simulator, "render", path, "--layers", "id,depth", "-o", picture)
        if not report.check(result.returncode == 0, f"cone: {result.stderr}"):
            return
        width, height, channels, _ = picture_files.exr(picture)
        inside = outside = between = 0
        eye = (0.3, 1.1, 5)
        for i, d in enumerate(rays(eye, (0, 0, 0), (0, 1, 0), 45, width, height)):
            true = open_cone(eye, d, base, apex, r0, r1)
            less = error * max(r0, r1) * 1.001
            thin = open_cone(eye, d, base, apex, max(r0 - less, 0), max(r1 - less, 0))
            seen, z = channels["id"][1][i], channels["Z"][1][i]
            if true is None and thin is None:
                outside += 1
                report.check(seen == 0, f"cone {base}: pixel {i} is outside, but shows {seen}")
            elif true is not None and thin is not None and abs(thin - true) < 0.5:
                inside += 1
                low, high = min(true, thin), max(true, thin) # the far side is seen through an open end
                report.check(seen == 1 and low * (1 - 1e-4) <= z <= high * (1 + 1e-4),
                             f"cone {base}: pixel {i} shows {seen} at {z}, not {true} to {thin}")
            else:
                between += 1
        report.check(inside > 200 and outside > 1000 and between < inside, f"cone {base}: {inside} inside, {outside} outside, {between} between")
        single = directory / "single.nff"
        single.write_text(path.read_text().replace("c\n", "c ").replace(f"{r0}\n" + str(apex[0]), f"{r0} " + str(apex[0])))
        report.equal("cone on one line", crc(simulator, path), crc(simulator, single))
        compared = fixcast_json(simulator, "compare", path)
        report.equal(f"cone {base}: wrong ids and shadows", (0, 0), (compared["wrong_id"], compared["wrong_shadow"]))
    path.write_text(VIEW + LIT + "c\n0 -1 0 -0.5\n0 1 0 -0.5\n")
    negative = crc(simulator, path)
    path.write_text(VIEW + LIT + "c\n0 -1 0 0.5\n0 1 0 0.5\n")
    report.equal("radii below 0: seen from both sides all the same", crc(simulator, path), negative)


# A house: a square of two walls and a concave front, in two groups with two materials; one face counts its corners from the end.
HOUSE_OBJ = """\
mtllib house.mtl
v -1 0 0
v 1 0 0
v 1 1 0
v 0 0.4 0
v -1 1 0
v -1 0 -2
v 1 0 -2
v 1 1 -2
o front
usemtl red
f 1 2 3 4 5
g wall # not closed
usemtl blue
f 2/7/1 7 8 -6
"""
HOUSE_NFF = """\
f 0.75 0.25 0.125 1 0 0 0 1
p 5
-1 0 0
1 0 0
1 1 0
0 0.4 0
-1 1 0
f 0.1 0.2 0.6 1 0 0 0 1
p 4
1 0 0
1 0 -2
1 1 -2
1 1 0
"""
HOUSE_VIEW = ("--from", "-3,2,4", "--at", "0,0.5,-0.5", "--up", "0,1,0", "--angle", "45", "--light", "0,4,3", "--ambient", "0.2", "--background",
              "0.1,0.2,0.3", "--size", "80x60")


def check_model(simulator, directory, report):
    model, scene = directory / "house.obj", directory / "house.nff"
    (directory / "house.mtl").write_text("newmtl red\nKd 0.75 0.25 0.125\nnewmtl blue\nKd 0.1 0.2 0.6\n")
    text = "v\nfrom -3 2 4\nat 0 0.5 -0.5\nup 0 1 0\nangle 45\nhither 1\nresolution 80 60\nb 0.1 0.2 0.3\n#fc: ambient 0.2\nl 0 4 3\n" + HOUSE_NFF
    scene.write_text(text)
    broken = HOUSE_OBJ.replace("2/7/1", "2")
    model.write_text(broken)
    report.equal("a model and the same as NFF", fixcast_json(simulator, "render", scene), fixcast_json(simulator, "render", model, *HOUSE_VIEW))
    # The view's options on an NFF file: the same as in the file.
    other = directory / "other.nff"
    changed = text
    for was, now in (("from -3 2 4", "from 9 9 9"), ("at 0 0.5 -0.5", "at 1 2 3"), ("angle 45", "angle 10"), ("l 0 4 3", "l 1 1 1\nl 2 2 2"),
                     ("b 0.1 0.2 0.3", "b 1 1 1"), ("ambient 0.2", "ambient 1")):
        report.check(was in changed, f"no {was} in the scene")
        changed = changed.replace(was, now)
    other.write_text(changed)
    report.equal("an NFF scene with another view", crc(simulator, scene), crc(simulator, other, *HOUSE_VIEW))
    # Faces without area and without influence.
    model.write_text(broken + "v 0.5 0.5 0\nv 0.25 0.25 0\nv 0 0 0\nf 9 10 11\nf 9 9 10\nf 1 2 3\n")
    plain = run(simulator, "render", model, *HOUSE_VIEW, "--json")
    report.check("2 triangles without area were left out" in plain.stderr, f"flat triangles: {plain.stderr}")
    # Three triangles on an edge.
    model.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n")
    report.check("1 edge is shared by more than two" in run(simulator, "render", model).stderr, "a non-manifold edge went unnoticed")
    model.write_text("mtllib nowhere.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    result = run(simulator, "render", model)
    report.check(result.returncode == 0 and "nowhere.mtl" in result.stderr, "a missing material file went unnoticed")


def check_auto_view(simulator, directory, report):
    """Every model is whole, in the middle, large, and lit, from wherever it is seen."""
    model = directory / "box.obj"
    corners = [(x, y, z) for x in (100, 103) for y in (-7, -6) for z in (0.5, 1)]
    faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
    model.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join("f " + " ".join(map(str, f)) + "\n" for f in faces))
    for path in (model, SCENES / "pawn.obj"):
        for look in (None, "0,0", "90,0", "-45,30", "200,-20", "0,90"):
            options = ("--look", look) if look else ()
            picture = directory / "auto.exr"
            result = run(simulator, "render", path, "--size", "100x100", "--layers", "id,color", *options, "-o", picture)
            if not report.check(result.returncode == 0, f"{path.name} from {look}: {result.stderr}"):
                continue
            channels = picture_files.exr(picture)[2]
            seen = [divmod(i, 100) for i, v in enumerate(channels["id"][1]) if v]
            rows, columns = [y for y, _ in seen], [x for _, x in seen]
            box = (min(columns), max(columns), min(rows), max(rows))
            report.check(min(box[0], box[2], 99 - box[1], 99 - box[3]) >= 3, f"{path.name} from {look} is cut: {box}")
            report.check(max(box[1] - box[0], box[3] - box[2]) >= 80, f"{path.name} from {look} is small: {box}")
            report.at_most(f"{path.name} from {look}: out of the middle", 5, max(abs(box[0] + box[1] - 99), abs(box[2] + box[3] - 99)))
            light = [channels["R"][1][100 * y + x] for y, x in seen]
            report.check(look == "200,-20" or sum(v > 0.25 for v in light) > len(light) / 4, f"{path.name} from {look} is dark")


BAD_MODELS = (
    ("empty", "", "no faces"),
    ("no faces", "v 0 0 0\n", "no faces"),
    ("vertex that is not there", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "does not exist"),
    ("vertex before the first", "v 0 0 0\nv 1 0 0\nf -1 -2 -3\n", ""),
    ("vertex 0", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", ""),
    ("word for a number", "v 0 0 zero\n", "bad.obj:1: a word that is not a decimal number"),
    ("number with a tail", "v 0 0 1\nv 1 0 1x\n", "bad.obj:2:"),
    ("endless exponent", "v 0 0 1e-2147483648\n", "bad.obj:1:"),
    ("corner that is none", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3/\n", "bad.obj:4: a corner"),
    ("face of two corners", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "bad.obj:4: fewer than three corners"),
    ("vertex of two numbers", "v 0 0\n", "bad.obj:1: fewer than three numbers"),
    ("huge coordinate", "v 1e300 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "1e30"),
    ("binary", b"\x7fELF\x01\x02\x03" + bytes(range(256)), "not a text file"),
    ("too many faces", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 65536, "65535 faces"),
    ("long line", "v 0 0 0\nf " + "1 " * 40000 + "\n", "65536 characters"),
)


def check_bad_models(simulator, directory, report):
    model = directory / "bad.obj"
    for name, text, words in BAD_MODELS:
        model.write_bytes(text if isinstance(text, bytes) else text.encode())
        result = run(simulator, "render", model, "-o", directory / "bad.png")
        good = result.returncode == 2 and "bad.obj" in result.stderr and words in result.stderr and result.stderr.count("\n") == 1
        report.check(good, f"{name}: exit code {result.returncode}, {result.stderr}")
        report.check(not (directory / "bad.png").exists(), f"{name}: a picture was written")
    good = SCENES / "s1.nff"
    for options in (("--from", "1,2"), ("--from", "1,2,x"), ("--from", "nan,0,0"), ("--angle", "180"), ("--light", "1,2,3,4"), ("--look", "0,91"),
                    ("--background", "2"), ("--ambient", "-1"), ("--from", "0,1.5,0"), ("--up", "0,0,-1")):
        result = run(simulator, "render", good, *options)
        report.check(result.returncode == 2 and result.stderr.count("\n") == 1, f"{options}: exit code {result.returncode}, {result.stderr}")


def main(simulator):
    report = Report()
    for check in (check_cone, check_model, check_auto_view, check_bad_models):
        with tempfile.TemporaryDirectory() as directory:
            check(simulator, pathlib.Path(directory), report)
    return report.finish()


sys.exit(main(sys.argv[1]))
