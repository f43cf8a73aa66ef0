"""A scene for the rivals: reads what fixcast reads, writes a C table of plain numbers (rivals/scene.h)."""
import math
from fractions import Fraction

from images import Failure


class Scene:
    """What an NFF file says, as far as rivals draw it: one grey light without falloff, triangles, spheres, planes."""

    def __init__(self):
        self.camera, self.far, self.ambient = {}, None, Fraction(1, 10)
        self.background, self.lights = (0, 0, 0), []
        self.spheres, self.planes, self.faces = [], [], []
        self.materials, self.vertices = {}, {}  # where each stands in its table


def numbers(words):
    return tuple(Fraction(word) for word in words)


def read(path):
    scene, lines = Scene(), path.read_text().splitlines()
    entities = fixed = material = 0
    at = 0

    def next_object():
        nonlocal entities
        entities += 1
        return fixed or entities

    while at < len(lines):
        words = lines[at].split()
        at += 1
        if words[:1] == ["#fc:"]:
            words = words[1:]
            if words[0] == "tan_half_fov":
                scene.camera["tan"] = Fraction(words[1])
            elif words[0] == "ambient" and len(set(words[1:])) == 1:
                scene.ambient = Fraction(words[1])
            elif words[0] == "far":
                scene.far = Fraction(words[1])
            elif words[0] == "object":
                fixed = 0 if words[1] == "auto" else int(words[1])
            elif words[0] == "plane":
                scene.planes.append((numbers(words[1:5]), material, next_object()))
            elif words != ["falloff", "none"]:
                raise Failure(f"{path}:{at}: rivals do not draw this: {lines[at - 1]}")
        elif not words or words[0].startswith("#") or words[0] in ("v", "angle", "hither", "resolution"):
            pass
        elif words[0] in ("from", "at", "up"):
            scene.camera[words[0]] = numbers(words[1:4])
        elif words[0] == "b":
            scene.background = numbers(words[1:4])
        elif words[0] == "l" and len(set(words[4:7])) == 1:
            scene.lights.append((numbers(words[1:4]), Fraction(words[4])))
        elif words[0] == "f":
            colour = tuple(channel * Fraction(words[4]) for channel in numbers(words[1:4]))
            material = scene.materials.setdefault(colour, len(scene.materials))
        elif words[0] == "s":
            scene.spheres.append((numbers(words[1:5]), material, next_object()))
        elif words == ["p", "3"]:
            points = [numbers(line.split()) for line in lines[at:at + 3]]
            at += 3
            corners = [scene.vertices.setdefault(point, len(scene.vertices)) for point in points]
            scene.faces.append((corners, material, next_object()))
        else:
            raise Failure(f"{path}:{at}: rivals do not draw this: {lines[at - 1]}")
    if len(scene.lights) > 1 or "tan" not in scene.camera:
        raise Failure(f"{path}: rivals draw one light, and want #fc: tan_half_fov")
    return scene


def axes(camera):
    """Right, up and forward: unit vectors."""
    def cross(a, b):
        return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))

    def unit(a):
        length = math.sqrt(sum(x * x for x in a))
        return tuple(float(x) / length for x in a)

    forward = tuple(a - b for a, b in zip(camera["at"], camera["from"]))
    right = cross(forward, camera["up"])
    return unit(right), unit(cross(right, forward)), unit(forward)


def real(value):
    return f"R({float(value)!r})"


def vector(values):
    return "{" + ", ".join(map(real, values)) + "}"


def table(kind, name, rows):
    """A table, and what the scene says of it: its name, or NULL where it is empty."""
    if not rows:
        return "", "0"
    return f"static const {kind} {name}[] = {{\n" + "".join(f"  {{{row}}},\n" for row in rows) + "};\n", name


def text(scene, source):
    planes = []
    for (*normal, d), material, number in scene.planes:
        length = math.sqrt(sum(x * x for x in normal))
        planes.append(f"{vector(x / length for x in map(float, normal))}, {real(float(d) / length)}, "
                      f"{material}, {number}")
    tables = [
        table("sphere", "spheres", [f"{vector(s[:3])}, {real(s[3])}, {m}, {o}" for s, m, o in scene.spheres]),
        table("plane", "planes", planes),
        table("vec", "vertices", [vector(point)[1:-1] for point in scene.vertices]),
        table("face", "faces", [f"{{{c[0]}, {c[1]}, {c[2]}}}, {m}, {o}" for c, m, o in scene.faces]),
        table("vec", "materials", [vector(colour)[1:-1] for colour in scene.materials])]
    right, up, forward = axes(scene.camera)
    light, intensity = scene.lights[0] if scene.lights else ((0, 0, 0), 0)
    fields = [name for _, name in tables]
    fields += [str(len(rows)) for rows in (scene.spheres, scene.planes, scene.vertices, scene.faces, scene.materials)]
    fields += [vector(scene.camera["from"]), vector(right), vector(up), vector(forward), real(scene.camera["tan"]),
               vector(light), real(intensity), real(scene.ambient), vector(scene.background),
               real(scene.far if scene.far is not None else 16000)]
    return (f"/* From {source.name}; do not edit. */\n#include \"scene.h\"\n\n" + "".join(text for text, _ in tables)
            + "const rival_scene SCENE = {\n" + "".join(f"  {field},\n" for field in fields) + "};\n")


def write(source, made):
    made.write_text(text(read(source), source))
