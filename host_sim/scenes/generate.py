#!/usr/bin/env python3
"""Writes the scenes of this directory: python3 generate.py [DIRECTORY], the same bytes on every run.

python3 generate.py --bench DIRECTORY writes those that only tests/bench draws, up to half a megabyte each.

Coordinates and colours come from + - * / and square roots only, which IEEE 754 rounds the same everywhere,
and no number has more than 12 decimals.
"""
import math
import os
import re
import sys
from fractions import Fraction


def text(number):
    """12 decimals without trailing zeros; never "-0"."""
    digits = f"{float(number):.12f}".rstrip("0").rstrip(".")
    return "0" if digits == "-0" else digits


def join(numbers):
    return " ".join(text(number) for number in numbers)


def rgb(*levels):
    """8-bit levels as NFF's 0..1, ten decimals."""
    return " ".join(f"{level / 255:.10f}".rstrip("0").rstrip(".") for level in levels)


def header(*lines):
    return [f"# {line}" for line in lines]


def camera(origin, target, up, tan_half_fov, size):
    """The angle is for readers that don't know tan_half_fov; 8 decimals hide what atan rounds differently."""
    angle = 2 * math.degrees(math.atan(Fraction(tan_half_fov)))
    return ["v", f"from {origin}", f"at {target}", f"up {up}", f"angle {angle:.8f}", "hither 0.01",
            f"resolution {size} {size}", f"#fc: tan_half_fov {tan_half_fov}"]


def matte(colour):
    return f"f {colour} 1 0 0 0 1"


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


# The bench scene: three spheres on a plane, a point light, a hard shadow. -z points into the picture.
SPHERES = [((0, 1, -6), 1, (224, 64, 48)),
           ((-1.75, 0.75, -4.5), 0.75, (48, 192, 80)),
           ((1.25, 0.5, -3), 0.5, (64, 96, 224))]
GROUND = (192, 192, 176)
SKY = "b " + rgb(96, 144, 208)
LIGHT = (-3, 5, -1)
LEVEL_CAMERA = camera("0 1.5 1", "0 1.5 0", "0 1 0", "1/2", 128)


def bench_spheres():
    lines = []
    for center, radius, colour in SPHERES:
        lines += [matte(rgb(*colour)), f"s {join(center)} {text(radius)}"]
    return lines + [matte(rgb(*GROUND)), "#fc: plane 0 1 0 0"]


def bench_light():
    return [SKY, "#fc: ambient 0.125", "#fc: falloff none", "#fc: far 100", f"l {join(LIGHT)} 0.875 0.875 0.875"]


def bench_rest():
    return bench_light() + bench_spheres()


def s1():
    lines = header("S1: three spheres on a plane under one point light with hard shadows.")
    return lines + LEVEL_CAMERA + bench_rest()


def s1r():
    lines = header("S1r: S1 from a place without round numbers, the head tilted: no level horizon.")
    return lines + camera("0.75 2 1.5", "0 0.75 -4", "0.17 0.98 0", "0.466", 128) + bench_rest()


def icosphere(divisions=2):
    """An icosahedron's faces, outside anticlockwise, divided: 20, 80, 320 triangles of the unit sphere."""
    golden = (1 + math.sqrt(5)) / 2
    corners = []
    for a in (-1, 1):
        for b in (-golden, golden):
            corners += [(0, a, b), (a, b, 0), (b, 0, a)]
    corners.sort()
    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                a, b, c = corners[i], corners[j], corners[k]
                if all(dot(sub(p, q), sub(p, q)) < 5 for p, q in ((a, b), (b, c), (c, a))):
                    outward = dot(cross(sub(b, a), sub(c, a)), a) > 0
                    faces.append(tuple(unit(p) for p in ((a, b, c) if outward else (a, c, b))))
    for _ in range(divisions):
        divided = []
        for a, b, c in faces:
            # a + b is b + a to the last bit: both faces of an edge get the same point
            ab, bc, ca = (unit(tuple(x + y for x, y in zip(p, q))) for p, q in ((a, b), (b, c), (c, a)))
            divided += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = divided
    return faces


def ground_grid():
    """The ground of S2 and S4: 56 triangles in cells that grow with the distance."""
    rows = [[((depth + 1) * 0.75 * x, 0.0, -float(depth)) for x in (-1, -0.5, 0, 0.5, 1)]
            for depth in (1, 2, 4, 8, 16, 32, 64, 99)]
    return grid_faces(rows)


def grid_faces(rows):
    """Two triangles a cell of a net of points, anticlockwise seen from above; row by row into the picture."""
    faces = []
    for near, far in zip(rows, rows[1:]):
        for i in range(len(near) - 1):
            faces += [(near[i], near[i + 1], far[i + 1]), (near[i], far[i + 1], far[i])]
    return faces


def placed_icosphere(center, radius):
    return [tuple(tuple(m + radius * x for m, x in zip(center, p)) for p in face) for face in icosphere()]


def lit_face(face, colour):
    """A triangle in the colour that S1's light gives its centroid."""
    a, b, c = face
    normal = unit(cross(sub(b, a), sub(c, a)))
    centroid = tuple(sum(axis) / 3 for axis in zip(a, b, c))
    shade = 0.125 + 0.875 * max(0.0, dot(normal, unit(sub(LIGHT, centroid))))
    return [matte(rgb(*(min(255.0, level * shade) for level in colour))), "p 3"] + [join(p) for p in face]


def s2():
    lines = header("S2: S1's picture as 1016 triangles: three icospheres of 320 and a ground of 56.",
                   "The colours are final (Lambert at each face's centroid, no shadow), so the ambient light",
                   "is 1 and there is no lamp.") + LEVEL_CAMERA + [SKY, "#fc: ambient 1"]
    for index, (center, radius, colour) in enumerate(SPHERES):
        lines.append(f"#fc: object {index + 1}")
        for face in placed_icosphere(center, radius):
            lines += lit_face(face, colour)
    lines.append("#fc: object 4")
    for face in ground_grid():
        lines += lit_face(face, GROUND)
    return lines


def s3():
    lines = header("S3: S1 with its first sphere a perfect mirror of up to four bounces.") + LEVEL_CAMERA
    for line in bench_rest():
        if line.startswith("s ") and not any(earlier.startswith("#fc: mirror") for earlier in lines):
            lines[-1] = matte("0 0 0")
            lines.append("#fc: mirror 1 1 1 4")
        lines.append(line)
    return lines


def show():
    """Everything a material can be, under two lights and a gradient."""
    lines = header("A showpiece: a mirror, highlights, a globe, a lamp, a polished checker floor, a sky.",
                   "Made for a display with a transfer function: fixcast render --transfer srgb.")
    lines += camera("0.3 2.1 5.6", "0.12 0.72 -1", "0 1 0", "0.41", 240)
    lines += ["b 0.80 0.86 0.95", "#fc: gradient 0 1 0 0.05 0.16 0.52", "#fc: ambient 0.10 0.11 0.14", "#fc: far 200",
              "l -4 6 4 0.62 0.58 0.50", "#fc: sun 3 4 1.5 0.26 0.27 0.34"]
    floor = ["#fc: checker 0.62 0.58 0.50 0.10 0.09 0.08 planar 0 0 0 2 0 0 0 0 2", "#fc: mirror 0.16 0.16 0.16 3", "#fc: plane 0 1 0 0"]
    balls = [("0.02 0.02 0.02", "0.7 300", ["#fc: mirror 0.92 0.92 0.95 4"], "0 1.15 -1.6 1.15"),
             ("0.62 0.05 0.04", "0.55 60", ["#fc: mirror 0.08 0.06 0.06 2"], "-1.75 0.7 0.1 0.7"),
             ("0.04 0.22 0.11", "0.45 24", [], "1.05 0.42 0.95 0.42"),
             ("0.75 0.52 0.12", "0.6 90.5", ["#fc: mirror 0.25 0.17 0.05 2"], "0.12 0.3 1.5 0.3"),
             ("1 1 1", "0.2 16", ["#fc: image globe.ppm bilinear spherical"], "1.95 0.72 -0.4 0.72"),
             ("0.1 0.1 0.1", "0 1", ["#fc: emission 1.5 1.15 0.6"], "-0.72 0.2 1.35 0.2")]
    for colour, shine, layers, ball in balls:
        lines += [f"f {colour} 1 {shine} 0 1"] + layers + [f"s {ball}"]
    return lines + ["f 1 1 1 1 0 1 0 1"] + floor


def smooth():
    """The same coarse ball flat and smooth, and a smooth one that shines."""
    lines = header("Smooth shading: three balls of 80 triangles; the first is flat, the others have a normal a vertex.")
    lines += camera("0 1.6 5.5", "0 0.6 0", "0 1 0", "0.42", 240)
    lines += ["b 0.35 0.4 0.45", "#fc: ambient 0.12", "l -3 5 4 0.8 0.8 0.75", "l 4 2 3 0.15 0.2 0.3"]
    for index, (x, material) in enumerate(((-1.5, "0.8 0.35 0.2 1 0 1 0 1"), (0, "0.8 0.35 0.2 1 0 1 0 1"),
                                           (1.5, "0.25 0.45 0.8 1 0.6 30 0 1"))):
        lines += [f"#fc: object {index + 1}", "f " + material]
        for face in icosphere(1):
            points = [(x + 0.7 * p[0], 0.7 + 0.7 * p[1], 0.7 * p[2]) for p in face]
            if index == 0:
                lines += plain_face(points)
            else:
                lines += ["pp 3"] + [join(point + normal) for point, normal in zip(points, face)]
    lines += ["#fc: object 4", "f 1 1 1 1 0 1 0 1", "#fc: image tiles.ppm bilinear planar -4 0 -4 2 0 0 0 0 2"]
    return lines + quad((-4, 0, 3), (4, 0, 3), (4, 0, -4), (-4, 0, -4))


def gloss():
    """What layers have fast forms for, under one light: a floor of bilinear tiles, a ball with a highlight, a smooth mesh, a shining one."""
    lines = header("Layers under one light: a floor of tiles, a ball and a coarse mesh that shine, a smooth mesh.")
    lines += camera("0.4 2.1 5.2", "0 0.55 0", "0.06 1 0", "0.42", 240) + ["b 0.3 0.38 0.52", "#fc: ambient 0.14", "#fc: far 60", "l -3 5 4 0.85 0.85 0.85"]
    lines += ["#fc: object 1", "f 0.2 0.45 0.75 1 0.5 24 0 1", "s -1.45 0.8 -0.3 0.8"]
    for index, (x, z, material, smoothed) in enumerate(((0.35, -0.9, "f 0.8 0.35 0.2 1 0 1 0 1", True), (1.7, 0.4, "f 0.75 0.65 0.25 1 0.4 9 0 1", False))):
        lines += [f"#fc: object {index + 2}", material]
        for face in icosphere(2 if smoothed else 1):
            points = [(x + 0.7 * a, 0.7 + 0.7 * b, z + 0.7 * c) for a, b, c in face]
            lines += ["pp 3"] + [join(point + normal) for point, normal in zip(points, face)] if smoothed else plain_face(points)
    return lines + ["#fc: object 4", "f 1 1 1 1 0 1 0 1", "#fc: image tiles.ppm bilinear planar 0 0 0 1 0 0 0 0 1", "#fc: plane 0 1 0 0"]


def ppm(width, height, pixel):
    rows = b"".join(bytes(pixel(x, y)) for y in range(height) for x in range(width))
    return b"P6\n%d %d\n255\n" % (width, height) + rows


def hashed(x, y, seed):
    """A number 0..1 of a lattice point."""
    n = (x * 374761393 + y * 668265263 + seed * 2246822519) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((n ^ (n >> 16)) & 0xFFFF) / 65535


def noise(x, y, period, seed):
    """Value noise of a lattice that repeats in x every `period` cells."""
    ix, iy = int(math.floor(x)), int(math.floor(y))
    fx, fy = x - ix, y - iy
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
    a = hashed(ix % period, iy, seed) * (1 - fx) + hashed((ix + 1) % period, iy, seed) * fx
    b = hashed(ix % period, iy + 1, seed) * (1 - fx) + hashed((ix + 1) % period, iy + 1, seed) * fx
    return a * (1 - fy) + b * fy


def globe_texel(x, y, width, height):
    """Seas, land that dries towards its middle, ice at the poles."""
    level = sum(noise(x * period / width, y * period / (2 * height) + 7, period, period) * share
                for period, share in ((5, 0.5), (11, 0.28), (23, 0.15), (47, 0.07)))
    pole = abs(2 * (y + 0.5) / height - 1)
    if pole + 0.25 * level > 1.0:
        return 215, 225, 235
    if level < 0.52:
        deep = max(0.0, min(1.0, (0.52 - level) * 5))
        return int(14 + 12 * (1 - deep)), int(48 + 44 * (1 - deep)), int(120 + 40 * (1 - deep))
    dry = max(0.0, min(1.0, (level - 0.54) * 7))
    return int(40 + 110 * dry), int(96 + 14 * dry), int(34 + 26 * dry)


def tiles_texel(x, y):
    """Two by two tiles with joints and a bevel."""
    u, v = x % 16, y % 16
    if u == 0 or v == 0:
        return 60, 58, 55
    light = (u == 1 or v == 1) - (u == 15 or v == 15)
    tone = 150 + 34 * ((x // 16 + y // 16) % 2) + 22 * light
    return tone, tone - 8, tone - 20


IMAGES = {"globe": lambda: ppm(128, 64, lambda x, y: globe_texel(x, y, 128, 64)), "tiles": lambda: ppm(32, 32, tiles_texel)}


def plain_face(face):
    return ["p 3"] + [join(point) for point in face]


def s1b():
    """S1's spheres alone, for the flash of a scene without planes."""
    lines = header("S1b: S1 without its plane.")
    return lines + LEVEL_CAMERA + bench_light() + bench_spheres()[:2 * len(SPHERES)]


def s1p():
    """S1 with Phong's highlight on everything: what that adds to a lit pixel."""
    lines = header("S1P: S1, all of it shining.")
    shining = [re.sub(r"^(f .*) 1 0 0 0 1$", r"\1 1 0.4 32 0 1", line) for line in bench_rest()]
    return lines + LEVEL_CAMERA + shining


def s1rt():
    """S1r with an image on its plane: what that adds to a lit pixel of the plane."""
    lines = header("S1RT: S1r, its plane with a bilinear image, a unit a tile.")
    rest = bench_rest()
    rest[-2:] = ["f 1 1 1 1 0 1 0 1", "#fc: image tiles.ppm bilinear planar 0 0 0 1 0 0 0 0 1", rest[-1]]
    return lines + camera("0.75 2 1.5", "0 0.75 -4", "0.17 0.98 0", "0.466", 128) + rest


def balls(smooth):
    """S1's spheres as 80 triangles each, without a ground, flat or with a normal a vertex: what that adds to a lit pixel."""
    lines = header("Three balls of 80 triangles, " + ("smooth." if smooth else "flat.")) + LEVEL_CAMERA + bench_light()
    for index, (center, radius, colour) in enumerate(SPHERES):
        lines += [f"#fc: object {index + 1}", matte(rgb(*colour))]
        for face in icosphere(1):
            points = [tuple(m + radius * x for m, x in zip(center, corner)) for corner in face]
            lines += ["pp 3"] + [join(point + normal) for point, normal in zip(points, face)] if smooth else plain_face(points)
    return lines


def s4():
    lines = header("S4: S2's 1016 triangles under S1's light, with hard shadows.")
    lines += LEVEL_CAMERA + bench_light()
    for index, (center, radius, colour) in enumerate(SPHERES):
        lines += [f"#fc: object {index + 1}", matte(rgb(*colour))]
        for face in placed_icosphere(center, radius):
            lines += plain_face(face)
    lines += ["#fc: object 4", matte(rgb(*GROUND))]
    for face in ground_grid():
        lines += plain_face(face)
    return lines


def draws():
    """Numbers in 0..1 from a linear congruential generator: the same in any language."""
    x = 1
    while True:
        x = (1664525 * x + 1013904223) % 2**32
        yield Fraction(x, 2**32)


def s5_spheres(count):
    lines = header(f"S5, spheres: S1's camera, light and plane, and {count} spheres here and there.")
    lines += LEVEL_CAMERA + bench_light()
    u = draws()
    for index in range(count):
        x, z, radius = 8 * next(u) - 4, 2 + 10 * next(u), Fraction(1, 10) + Fraction(1, 5) * next(u)
        lines += [matte(rgb(*SPHERES[index % 3][2])), f"#fc: object {index + 1}",
                  f"s {join((x, radius + Fraction(3, 2) * next(u), -z))} {text(radius)}"]
    return lines + [matte(rgb(*GROUND)), f"#fc: object {count + 1}", "#fc: plane 0 1 0 0"]


def s5_field(cells, lit):
    """A height field of cells x cells, z from 2 to 12; under S1's light or, as S2, in final colours."""
    lines = header(f"S5, triangles: S1's camera and a height field of {cells} x {cells} cells, "
                   + ("under S1's light, with hard shadows." if lit else "in final colours as S2."))
    lines += LEVEL_CAMERA + (bench_light() if lit else [SKY, "#fc: ambient 1"]) + [matte(rgb(*GROUND)), "#fc: object 1"]
    u = draws()
    rows = [[(Fraction(8 * i, cells) - 4, Fraction(1, 4) * next(u), -2 - Fraction(10 * j, cells))
             for i in range(cells + 1)] for j in range(cells + 1)]
    for face in grid_faces(rows):
        face = tuple(tuple(map(float, point)) for point in face)
        lines += plain_face(face) if lit else lit_face(face, GROUND)
    return lines


def s5_culled(cells):
    """A flat pyramid seen from above, whose lower side is a height field: all of that is turned away."""
    lines = header(f"S5, culled triangles: S1's camera and a pyramid with {cells} x {cells} cells on its lower side.")
    lines += LEVEL_CAMERA + [SKY, "#fc: ambient 1", matte(rgb(*GROUND)), "#fc: object 1"]
    u = draws()
    rows = [[(Fraction(8 * i, cells) - 4, -Fraction(1, 10) - Fraction(1, 400) * next(u), -2 - Fraction(10 * j, cells))
             for i in range(cells + 1)] for j in range(cells + 1)]
    faces = [face[::-1] for face in grid_faces(rows)]
    # four corners around the net, clockwise from above as its sides
    foot = [(x, 0, z) for x, z in ((-Fraction(9, 2), -Fraction(25, 2)), (Fraction(9, 2), -Fraction(25, 2)),
                                   (Fraction(9, 2), -Fraction(3, 2)), (-Fraction(9, 2), -Fraction(3, 2)))]
    sides = (rows[-1], [row[-1] for row in rows[::-1]], rows[0][::-1], [row[0] for row in rows])
    top = (0, Fraction(1, 2), -7)
    for a, b, side in zip(foot, foot[1:] + foot[:1], sides):
        faces += [(a, q, p) for p, q in zip(side, side[1:])] + [(a, b, side[-1]), (b, a, top)]
    for face in faces:
        lines += plain_face(face)
    return lines


def bench_only():
    """{name: lines} of the scenes for tests/bench; of S5: spheres, triangles: lit, flat, culled."""
    scenes = {"s1b": s1b(), "s4": s4(), "s1p": s1p(), "s1rt": s1rt(), "balls": balls(False), "balls_smooth": balls(True)}
    scenes.update((f"s5s{count}", s5_spheres(count)) for count in (1, 8, 64, 512))
    for cells in (5, 10, 21, 45):
        scenes[f"s5t{cells}"] = s5_field(cells, lit=True)
        scenes[f"s5f{cells}"] = s5_field(cells, lit=False)
        scenes[f"s5c{cells}"] = s5_culled(cells)
    return scenes


def quad(*corners):
    return ["p 4"] + [join(corner) for corner in corners]


def standing_box(x, z, half, height, cosine, sine):
    """Four sides and a lid around (x, z), turned about the vertical; the bottom would lie in the floor."""
    foot = [(x + half * (cosine * u + sine * v), z + half * (cosine * v - sine * u))
            for u, v in ((-1, 1), (1, 1), (1, -1), (-1, -1))]
    lines = []
    for (ax, az), (bx, bz) in zip(foot, foot[1:] + foot[:1]):
        lines += quad((ax, 0, az), (bx, 0, bz), (bx, height, bz), (ax, height, az))
    return lines + quad(*((fx, height, fz) for fx, fz in foot))


def box():
    white, red, green = matte("0.78 0.76 0.7"), matte("0.75 0.16 0.12"), matte("0.2 0.6 0.18")
    lines = header("A room open to the front with two boxes in it, after the one at Cornell: red wall left,",
                   "green wall right, a lamp under the ceiling whose light falls off with the square of the",
                   "distance. Objects: 1 floor, 2 ceiling, 3 back, 4 left, 5 right, 6 tall box, 7 short box,",
                   "8 lamp shade.")
    lines += camera("0 1 2.5", "0 1 0", "0 1 0", "0.385", 240)
    lines += ["b 0.02 0.02 0.03", "#fc: ambient 0.24", "#fc: falloff inverse-square",
              "l 0 1.88 -0.8 1.7 1.6 1.4"]
    lines += [white] + quad((-1, 0, 0), (1, 0, 0), (1, 0, -2.2), (-1, 0, -2.2))
    lines += quad((-1, 2, -2.2), (1, 2, -2.2), (1, 2, 0), (-1, 2, 0))
    lines += quad((-1, 0, -2.2), (1, 0, -2.2), (1, 2, -2.2), (-1, 2, -2.2))
    lines += [red] + quad((-1, 0, 0), (-1, 0, -2.2), (-1, 2, -2.2), (-1, 2, 0))
    lines += [green] + quad((1, 0, -2.2), (1, 0, 0), (1, 2, 0), (1, 2, -2.2))
    lines += [white, "#fc: object 6"] + standing_box(-0.36, -1.55, 0.3, 1.2, 24 / 25, 7 / 25)
    lines += ["#fc: object 7"] + standing_box(0.4, -1.05, 0.3, 0.6, 12 / 13, -5 / 13)
    lines += ["#fc: object 8", matte("1 1 0.9")]
    return lines + quad((-0.3, 1.98, -1.1), (0.3, 1.98, -1.1), (0.3, 1.98, -0.5), (-0.3, 1.98, -0.5))


# Nine unit vectors about the axis (0, 1, 0): one along it, four 37 degrees off it, four 19 degrees below its
# equator. Fractions, so that the spheres touch as exactly as 12 decimals can say.
CHILDREN = [(Fraction(0), Fraction(1), Fraction(0))]
CHILDREN += [(Fraction(x, 5), Fraction(4, 5), Fraction(z, 5)) for x, z in ((3, 0), (0, 3), (-3, 0), (0, -3))]
CHILDREN += [(Fraction(x, 3), Fraction(-1, 3), Fraction(z, 3)) for x in (2, -2) for z in (2, -2)]


def mirrored(vector, axis):
    """The mirror image that takes (0, 1, 0) to the unit vector `axis`."""
    mirror = sub((0, 1, 0), axis)
    square = dot(mirror, mirror)
    factor = 2 * dot(mirror, vector) / square if square else 0
    return tuple(x - factor * m for x, m in zip(vector, mirror))


def flake():
    colours = [matte("0.95 0.88 0.72"), matte("0.9 0.45 0.2"), matte("0.3 0.62 0.8")]
    lines = header("A flake of 91 spheres under two coloured lights: each sphere carries nine of a third of",
                   "its radius that touch it, at (0 1 0), at (3 4 0)/5 and its quarter turns about (0 1 0),",
                   "and at (2 -1 2)/3 and its quarter turns. A child in direction d carries its own at the",
                   "mirror images of these; the mirror is the one that takes (0 1 0) to d.")
    lines += camera("1.9 2.1 4.4", "0 1.15 0", "0 1 0", "0.35", 240)
    lines += ["b 0.16 0.22 0.36", "#fc: ambient 0.12", "l 6 8 4 0.9 0.76 0.56", "l -7 4 5 0.22 0.35 0.6"]
    generation = [((Fraction(0), Fraction(11, 10), Fraction(0)), Fraction(4, 5), CHILDREN)]
    for colour in colours:
        lines.append(colour)
        children = []
        for center, radius, directions in generation:
            lines.append(f"s {join(center)} {text(radius)}")
            for d in directions:
                place = tuple(c + Fraction(4, 3) * radius * x for c, x in zip(center, d))
                children.append((place, radius / 3, [mirrored(child, d) for child in CHILDREN]))
        generation = children
    return lines + [matte("0.55 0.55 0.5"), "#fc: plane 0 1 0 0"]


def fight():
    orange, blue = matte("0.95 0.55 0.1"), matte("0.12 0.25 0.6")
    lines = header("Z-fighting: in each cell an orange card in front of a blue one. Rows from the top: 4, 40, 400 and",
                   "4000 units away; columns from the left: the gap is 2^-8, 2^-9, ... 2^-15 of the distance.",
                   "Blue comes first in the file, so a z-buffer that can't tell the two apart shows blue.",
                   "A small ball one unit from the eye stretches the depth range. Objects: 1 ball, 2 blue, 3 orange.")
    lines += camera("0 0 0", "0 0 -1", "0 1 0", "1/2", 240)
    lines += ["b 0.05 0.05 0.08", "#fc: ambient 1", matte("0.8 0.8 0.8"), "#fc: object 1", "s 0 0 -1.0625 0.0625"]
    cards = {"#fc: object 2": [blue], "#fc: object 3": [orange]}
    for row, distance in enumerate((4, 40, 400, 4000)):
        for column in range(8):
            for (name, card), z, half in zip(cards.items(), (distance, distance * (1 - Fraction(1, 2 ** (8 + column)))),
                                             (Fraction(1, 20), Fraction(1, 28))):
                x, y = Fraction(2 * column - 7, 17), Fraction(3 - 2 * row, 9)
                corners = [((x + u * half) * z, (y + v * half * Fraction(3, 2)) * z, -z)
                           for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                card += quad(*corners)
    for name, card in cards.items():
        lines += [name] + card
    return lines


def main():
    arguments = sys.argv[1:]
    bench = arguments[:1] == ["--bench"]
    if bench:
        del arguments[0]
    if len(arguments) > 1 or (bench and not arguments):
        sys.exit("usage: generate.py [DIRECTORY] or generate.py --bench DIRECTORY")
    directory = arguments[0] if arguments else os.path.dirname(os.path.abspath(__file__))
    scenes = bench_only() if bench else {scene.__name__: scene() for scene in (s1, s1r, s2, s3, box, flake, fight, show, smooth, gloss)}
    for name, lines in scenes.items():
        with open(os.path.join(directory, name + ".nff"), "w", encoding="ascii", newline="\n") as file:
            file.write("\n".join(lines) + "\n")
    for name, image in ({"tiles": IMAGES["tiles"]} if bench else IMAGES).items():
        with open(os.path.join(directory, name + ".ppm"), "wb") as file:
            file.write(image())


if __name__ == "__main__":
    main()
