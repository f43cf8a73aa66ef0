"""Meshes as lesser renderers see them, for the gallery's faults: rounded edges, few bits of depth, culled backs. Exact in whole numbers where nothing is rounded on purpose.

Only for scenes of polygons whose camera looks along -z with y up: s2 and fight.
"""
import typing

import numpy

GRID = 1 << 13  # a world unit; coordinates then fit 25 bits and a sign, normals 51, edge forms 62


class Triangle(typing.NamedTuple):
    corners: tuple  # three of camera space, whole numbers: x right, y up, z forward
    colour: tuple
    object: int


class Mesh:
    def __init__(self, path):
        """The polygons of an NFF file, as fans."""
        self.triangles, self.background = [], (0, 0, 0)
        colour, owner, eye, lines = (0, 0, 0), 0, (0, 0, 0), iter(path.read_text().splitlines())
        for words in map(str.split, lines):
            if words[:1] == ["from"]:
                eye = tuple(map(float, words[1:]))
            elif words[:2] == ["#fc:", "object"]:
                owner = int(words[2])
            elif words[:1] == ["f"]:
                colour = tuple(map(float, words[1:4]))
            elif words[:1] == ["b"]:
                self.background = tuple(map(float, words[1:4]))
            elif words[:1] == ["p"]:
                points = [tuple(map(float, next(lines).split()[:3])) for _ in range(int(words[1]))]
                points = [tuple(round(GRID * v) for v in (x - eye[0], y - eye[1], eye[2] - z)) for x, y, z in points]
                self.triangles += [Triangle((points[0], points[i], points[i + 1]), colour, owner) for i in range(1, len(points) - 1)]


def normal_of(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(u * v for u, v in zip(a, b))


def volume(corners):
    """Six times that of the eye and the triangle; its sign says which side is seen."""
    return dot(corners[0], normal_of(corners[1], corners[2]))


def rounded(normals, bits):
    """A triangle's edge coefficients, cut to so many bits and a sign by a shift of its own."""
    longest = max(abs(v) for n in normals for v in n).bit_length()
    shift = max(longest - bits, 0)
    return [tuple(v >> shift for v in n) for n in normals], shift


def seen(mesh, size, bits=None, depth_bits=None, nearest=0, triangles=None):
    """(number of the triangle a pixel shows, -1 for none, by row; how many were drawn). bits: of edge coefficients; depth_bits: of `nearest` / z as a whole number, a tie
    leaving what came first; None: exact, and float of 53 bits."""
    x, y = numpy.meshgrid(2 * numpy.arange(size, dtype=numpy.int64) + 1 - size, size - 2 * numpy.arange(size, dtype=numpy.int64) - 1)
    focal = 2 * size  # both scenes: tan of half the field of view 1/2
    shown, best = numpy.full((size, size), -1), numpy.zeros((size, size))
    chosen = range(len(mesh.triangles)) if triangles is None else triangles
    for i in chosen:
        a, b, c = mesh.triangles[i].corners
        whole, side = volume((a, b, c)), 1
        if whole == 0:
            continue
        side = 1 if whole > 0 else -1
        normals, shift = [normal_of(a, b), normal_of(b, c), normal_of(c, a)], 0
        exact = normals
        if bits is not None:
            normals, shift = rounded(normals, bits)
        inside = numpy.ones((size, size), dtype=bool)
        for n in normals:
            edge = side * (n[0] * x + n[1] * y + n[2] * focal)
            tie = next((v for v in n if v), 0) * side > 0
            inside &= (edge > 0) | ((edge == 0) & tie)
        whole_normal = tuple(map(sum, zip(*exact)))
        near = (whole_normal[0] * x + whole_normal[1] * y + whole_normal[2] * focal) / (whole * float(focal)) * GRID  # 1 / z
        if depth_bits is not None:
            near = numpy.floor(near * nearest * (2 ** depth_bits - 1))
        inside &= near > best
        shown[inside], best[inside] = i, near[inside]
    return shown, len(chosen)


def picture(mesh, shown):
    """Levels of a display of gamma 2.2."""
    light = numpy.array([t.colour for t in mesh.triangles] + [mesh.background])
    return (255 * light.clip(0, 1) ** (1 / 2.2)).round().astype(numpy.uint8)[shown]


def facing(mesh, shown):
    """Which side of its triangle a pixel shows: 1, -1, or 0 for none."""
    sides = [volume(t.corners) for t in mesh.triangles]
    return numpy.array([(side > 0) - (side < 0) for side in sides] + [0])[shown]


def objects(mesh, shown):
    return numpy.array([t.object for t in mesh.triangles] + [0])[shown]
