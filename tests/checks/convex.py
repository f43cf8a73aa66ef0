"""Which meshes bake takes for convex, and the margins that it states, against rational arithmetic.

convex.py SIMULATOR
"""
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from math import isqrt

from support import Report

VIEW = "v\nfrom 0 3 20\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 48\n"
LIGHT = "l 5 9 7\n"
RING = [(1, 0, 0), (0.309, 0.951, 0), (-0.809, 0.588, 0), (-0.809, -0.588, 0), (0.309, -0.951, 0)]
TOP, BOTTOM = (0, 0, 1), (0, 0, -1)


def two_pyramids(top=TOP, bottom=BOTTOM):
    """Ten faces, counter-clockwise seen from outside, as lists of corners."""
    pairs = list(zip(RING, RING[1:] + RING[:1]))
    return [(a, b, top) for a, b in pairs] + [(b, a, bottom) for a, b in pairs]


def box():
    """Twelve faces, each flat with a neighbour."""
    faces = []
    for axis, side in itertools.product(range(3), (-1, 1)):
        square = []
        for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            corner = [0, 0, 0]
            corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = side, u, v
            square.append(tuple(corner))
        if side < 0:
            square.reverse()
        faces += [(square[0], square[1], square[2]), (square[0], square[2], square[3])]
    return faces


def moved(faces, by):
    return [tuple(tuple(c + d for c, d in zip(corner, by)) for corner in face) for face in faces]


def scene(*objects, light=True, extra=""):
    """NFF: an id for each list of faces."""
    text = VIEW + (LIGHT if light else "")
    for number, faces in enumerate(objects, 1):
        text += f"#fc: object {number}\nf 0.5 0.6 0.7 1 0 0 0 1\n"
        for face in faces:
            text += "p 3\n" + "".join(f"{x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in face)
    return text + extra


def baked(simulator, text, directory):
    """For each table of triangles: its macro, its margin or None, vertices, faces."""
    source, made = pathlib.Path(directory, "m.nff"), pathlib.Path(directory, "m.c")
    source.write_text(text)
    subprocess.run([simulator, "bake", source, "-o", made, "--name", "m"], check=True, capture_output=True)
    text = made.read_text()
    tables = {}
    for name, body in re.findall(r"static const \w+ m_(\w+)\[\] FC_ROM = \{\n(.*?)\n\};", text, re.DOTALL):
        tables[name] = [tuple(map(int, re.findall(r"-?\d+", line.replace("INT32_C", "")))) for line in body.splitlines()]
    for macro, vertices, rest in re.findall(r"  (FC_TRIANGLES\w*)\(m_(\w+), (.*?)\),\n", text):
        faces = re.search(r"m_(triangles\w*)", rest).group(1)
        margin = int(rest.rsplit(", ", 1)[1]) if macro == "FC_TRIANGLES_CONVEX" else None
        yield macro, margin, tables[vertices], [face[:3] for face in tables[faces]]


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def margin_of(vertices, faces):
    """floor(log2 of the margin), by squares, which are rational; None when it is below 1."""
    least = None
    for face in faces:
        a, b, c = (vertices[i] for i in face)
        n = cross(sub(b, a), sub(c, a))
        squares = [Fraction(dot(n, n), 256 * max(dot(sub(p, q), sub(p, q)) for p, q in ((a, b), (b, c), (c, a))))]
        for i, vertex in enumerate(vertices):
            if i in face:
                continue
            below, v = -dot(n, sub(vertex, a)), sub(vertex, a)
            if below <= 0:
                return None
            second, third = Fraction(dot(cross(v, sub(c, a)), n), dot(n, n)), Fraction(dot(cross(sub(b, a), v), n), dot(n, n))
            weights = abs(1 - second - third) + abs(second) + abs(third)
            squares.append(Fraction(below * below, dot(n, n)) / (1 + weights) ** 2)
        least = min(squares + ([least] if least is not None else []))
    return isqrt(int(least)).bit_length() - 1 if least >= 1 else None


def main(arguments):
    simulator = arguments[1]
    report = Report()
    hull, dented = two_pyramids(), two_pyramids(top=(0, 0, -0.5))
    far = "#fc: object 9\nf 0.5 0.6 0.7 1 0 0 0 1\np 3\n0 -{0} 0\n{0} -{0} 0\n0 -{0} {0}\n"
    expected = [
        ("two pyramids", scene(hull), ["CONVEX"]),
        ("two of them", scene(hull, moved(hull, (3, 0, 0))), ["CONVEX", "CONVEX"]),
        ("one object of two parts", scene(hull + moved(hull, (3, 0, 0))), ["CLOSED"]),
        ("a dent", scene(dented), ["CLOSED"]),
        ("a box", scene(box()), ["SHORT"]),
        ("a convex mesh between a box and a dent", scene(box(), moved(hull, (3, 0, 0)), moved(dented, (6, 0, 0))),
         ["CLOSED", "CONVEX", "CLOSED"]),
        ("no light", scene(hull, moved(hull, (3, 0, 0)), light=False), ["CLOSED"]),
        ("a hole", scene(hull[1:]), [""]),
        ("a low roof", scene(two_pyramids(top=(0, 0, 0.01), bottom=(0, 0, -0.01))), ["CONVEX"]),
        ("one too small for the grid", scene(hull, extra=far.format(200000000)), ["CLOSED", ""]),
    ]
    with tempfile.TemporaryDirectory() as directory:
        for name, text, macros in expected:
            found = list(baked(simulator, text, directory))
            names = [macro.replace("FC_TRIANGLES", "").strip("_") for macro, *_ in found]
            report.check(names == macros, f"{name}: tables {names}, not {macros}")
            for macro, margin, vertices, faces in found:
                right = margin_of(vertices, faces) if macro == "FC_TRIANGLES_CONVEX" else None
                report.check(margin == right, f"{name}: a margin of 2^{margin} stated, 2^{right} there is")
    return report.finish()


sys.exit(main(sys.argv))
