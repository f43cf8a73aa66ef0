"""Writes the example of a Wavefront model, pawn.obj and pawn.mtl: a pawn on four squares of a board.

generate_obj.py [DIRECTORY]
"""
import math
import pathlib
import sys

SIDES = 20
# Radius and height of the pawn's outline, from the foot to the top; radius 0 closes it.
OUTLINE = ((0, 0.03), (0.46, 0), (0.48, 0.06), (0.42, 0.14), (0.3, 0.22), (0.22, 0.36), (0.17, 0.56), (0.15, 0.72), (0.26, 0.78),
           (0.26, 0.82), (0.15, 0.86), (0.21, 0.94), (0.25, 1.06), (0.21, 1.18), (0.12, 1.26), (0, 1.29))
MATERIALS = {"ivory": (0.9, 0.84, 0.7), "light": (0.72, 0.56, 0.36), "dark": (0.28, 0.17, 0.1)}


def pawn(first):
    """Vertices and faces of a closed body of revolution, counter-clockwise seen from outside; vertices are numbered from `first`."""
    vertices, faces, rings = [], [], []
    for radius, height in OUTLINE:
        count = SIDES if radius else 1
        rings.append([first + len(vertices) + i for i in range(count)])
        for i in range(count):
            angle = 2 * math.pi * i / SIDES
            vertices.append((radius * math.cos(angle), height, -radius * math.sin(angle)))
    for low, high in zip(rings, rings[1:]):
        for i in range(SIDES):
            j = (i + 1) % SIDES
            corners = [low[i % len(low)], low[j % len(low)], high[j % len(high)], high[i % len(high)]]
            faces.append(list(dict.fromkeys(corners)))
    return vertices, faces


def main(directory):
    vertices, faces = pawn(1)
    lines = ["# A pawn on four squares of a board; generate_obj.py wrote it.", "mtllib pawn.mtl"]
    lines += ["v " + " ".join(f"{c:.5f}" for c in v) for v in vertices]
    lines += ["o pawn", "usemtl ivory"] + ["f " + " ".join(map(str, f)) for f in faces]
    number = len(vertices)
    lines += [f"v {x} 0 {z}" for z in (-1, 0, 1) for x in (-1, 0, 1)]
    lines.append("o board")
    for z in range(2):
        for x in range(2):
            at = number + 1 + 3 * z + x
            lines += [f"usemtl {'dark' if (x + z) % 2 else 'light'}", f"f {at} {at + 3} {at + 4} {at + 1}"]
    directory.joinpath("pawn.obj").write_text("\n".join(lines) + "\n")
    text = ["# Materials of pawn.obj; generate_obj.py wrote it."]
    for name, colour in MATERIALS.items():
        text += [f"newmtl {name}", "Kd " + " ".join(map(str, colour))]
    directory.joinpath("pawn.mtl").write_text("\n".join(text) + "\n")


main(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent)
