"""Baked scenes: C99 without a warning, the same frame as the file they came from, and the costs that they state.

bake_roundtrip.py SIMULATOR COMPILER LIBRARY [SCENE...]     of all own scenes, and those named
"""
import hashlib
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

from support import ROOT, SCENES, Report, fixcast_json

TABLES = ("spheres", "planes", "vertices", "triangles", "materials", "lights", "nodes", "order", "normals", "uvs", "sky")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wundef", "-pedantic", "-Werror", "-O1")
WIDTH, HEIGHT = 64, 48


def run(*command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nexit code {result.returncode}: {result.stderr.strip()}")
    return result.stdout


def table_bytes(object_file, name):
    """The sizes of a baked scene's tables, as the compiler laid them out."""
    total = {}
    for line in run("nm", "-S", object_file).splitlines():
        match = re.fullmatch(rf"\w+ (\w+) \w {name}_({'|'.join(TABLES)}|layers_\d+(?:_[a-z]+)?)(?:_\d+)?", line)
        if match:
            total[match.group(2)] = total.get(match.group(2), 0) + int(match.group(1), 16)
    return total


def check(simulator, compiler, library, scene, directory, report):
    name = "scene_under_test"
    code, header, objects = directory / "scene.c", directory / "scene.h", directory / "scene.o"
    words = run(simulator, "bake", scene, "-o", code, "--header", header, "--name", name)
    again = directory / "again.c"
    run(simulator, "bake", scene, "-o", again, "--name", name)
    report.check(code.read_bytes() == again.read_bytes(), f"{scene.name}: two runs gave different bytes")
    run(compiler, *STRICT, "-I", ROOT / "include", "-include", header, "-c", code, "-o", objects)
    program = directory / "program"
    run(compiler, "-O1", "-I", ROOT / "include", f"-DSCENE={name}", f"-DWIDTH={WIDTH}", f"-DHEIGHT={HEIGHT}", "-DMEMORY_BYTES=4194304",
        ROOT / "tests" / "golden" / "frame_crc.c", objects, library, "-o", program)
    expected = fixcast_json(simulator, "render", scene, "--size", f"{WIDTH}x{HEIGHT}")["crc32"]
    report.equal(f"{scene.name}: the baked frame", f"{name} {WIDTH}x{HEIGHT} {expected}", run(program).strip())

    facts = json.loads(run(simulator, "stats", scene, "--json"))
    report.equal(f"{scene.name}: SHA-256", hashlib.sha256(scene.read_bytes()).hexdigest(), facts["sha256"])
    sizes = table_bytes(objects, name)
    report.equal(f"{scene.name}: flash", sum(sizes.values()), facts["flash_bytes"])
    report.equal(f"{scene.name}: flash of the hierarchy", sizes.get("nodes", 0) + sizes.get("order", 0), facts["hierarchy_bytes"])
    for kind, size in (("spheres", 20), ("triangles", 10), ("vertices", facts["vertex_bytes"])):
        report.equal(f"{scene.name}: {kind}", sizes.get(kind, 0), size * facts[kind])
    text = code.read_text()
    for fact in run(simulator, "stats", scene).splitlines():
        report.check(fact in words, f"{scene.name}: bake does not say: {fact}")
        report.check(re.sub(r"[?\\]", "_", fact) in text, f"{scene.name}: not in the file: {fact}")
    return facts, text


HEAD = """v
from 9 7 12
at 0 0 0
up 0 1 0
angle 40
hither 0.1
resolution 64 48
b 0.4 0.6 0.8
l 20 30 10
"""


def quad(*corners):
    return "p 4\n" + "".join("%g %g %g\n" % corner for corner in corners)


def steps(far):
    """A staircase in whole numbers, 512 triangles, whose farthest corner is `far` units away: so many that 16 bits hold it, or not."""
    text = HEAD + "f 0.8 0.7 0.5 1 0 0 0 1\n"
    for i in range(-64, 64):
        text += quad((i, i % 7, -9), (i, i % 7, 9), (i + 1, i % 7, 9), (i + 1, i % 7, -9))
        text += quad((i, i % 7, 9), (i, i % 7, -9), (i, -8, -9), (i, -8, 9))
    return text + "p 3\n0 -8 0\n%d -8 0\n1 -8 -1\n" % far


def textured(directory, name, pixel):
    """A floor with an image of 48 x 32 pixels."""
    (directory / f"{name}.ppm").write_bytes(b"P6\n48 32\n255\n" + b"".join(bytes(pixel(x, y)) for y in range(32) for x in range(48)))
    return (HEAD + f"f 1 1 1 1 0 0 0 1\n#fc: image {name}.ppm bilinear planar -4 0 -4 8 0 0 0 0 8\n" +
            quad((-8, 0, -8), (-8, 0, 8), (8, 0, 8), (8, 0, -8)))


def torus(around, along):
    """A closed model of 2 x around x along triangles, as OBJ."""
    text = ""
    for i in range(along):
        for j in range(around):
            a, b = math.tau * i / along, math.tau * j / around
            r = 2 + math.cos(b)
            text += "v %.6f %.6f %.6f\n" % (r * math.cos(a), math.sin(b), r * math.sin(a))
    for i in range(along):
        for j in range(around):
            a, b = i * around, (i + 1) % along * around
            k = (j + 1) % around
            text += f"f {a + j + 1} {a + k + 1} {b + k + 1} {b + j + 1}\n"
    return text


def check_forms(simulator, compiler, library, directory, report):
    """Each form that a table may take is taken where it is the smallest that is exact, and nowhere else."""
    exact565 = lambda v, most: (v % (most + 1) * 255 + most // 2) // most
    scenes = {"steps.nff": (steps(2 ** 14), "fc_short_vec3", "fc_vec3 "),
              "far_steps.nff": (steps(2 ** 15 + 1), "fc_vec3 ", "fc_short_vec3"),
              "grey.nff": (textured(directory, "grey", lambda x, y: (5 * x,) * 3), "FC_TEXEL_GREY8", "palette"),
              "palette.nff": (textured(directory, "palette", lambda x, y: (5 * x, 200, 9)), "fc_palette_image", "FC_TEXEL_RGB565"),
              "rgb565.nff": (textured(directory, "rgb565", lambda x, y: (exact565(x, 31), exact565(y + x, 63), exact565(7 * y, 31))),
                             "FC_TEXEL_RGB565", "palette"),
              "rgb888.nff": (textured(directory, "rgb888", lambda x, y: (5 * x + 1, 8 * y + 1, 3)), "FC_TEXEL_RGB888", "palette"),
              "torus.obj": (torus(54, 54), "fc_bvh_node", "fc_short_vec3")}
    for name, (source, wanted, unwanted) in scenes.items():
        path = directory / name
        path.write_text(source)
        facts, text = check(simulator, compiler, library, path, directory, report)
        report.check(wanted in text and unwanted not in text, f"{name}: baked with {wanted.strip()}, without {unwanted.strip()}?")
        if name == "torus.obj":
            report.equal("the torus's triangles", 5832, facts["triangles"])
            report.at_most("bytes a triangle of the torus", 24, facts["flash_bytes"] / facts["triangles"])


def check_features(simulator, report):
    expected = {"s1.nff": {"spheres", "planes", "one light, by the scan engine", "far limit"},
                "box.nff": {"inverse-square falloff, by a ray a pixel"},
                "flake.nff": {"spheres", "planes", "hierarchy", "several lights, by a ray a pixel"},
                "pawn.obj": {"triangles", "closed meshes", "hierarchy", "one light, by the scan engine"}}
    for name, some in expected.items():
        features = set(json.loads(run(simulator, "stats", SCENES / name, "--json"))["features"])
        report.check(some <= features, f"{name}: {sorted(some)} expected among {sorted(features)}")
    report.check("triangles" not in json.loads(run(simulator, "stats", SCENES / "s1.nff", "--json"))["features"], "s1 has no triangles")
    without = json.loads(run(simulator, "stats", SCENES / "flake.nff", "--bvh", "off", "--json"))
    report.check("hierarchy" not in without["features"] and without["hierarchy_bytes"] == 0, "--bvh off left a hierarchy")


def main(simulator, compiler, library, *more):
    report = Report()
    for scene in sorted([*SCENES.glob("*.nff"), *SCENES.glob("*.obj"), *map(pathlib.Path, more)]):
        with tempfile.TemporaryDirectory() as directory:
            facts, _ = check(simulator, compiler, library, scene, pathlib.Path(directory), report)
            print(f"{scene.name}: {facts['flash_bytes']} bytes of flash, {facts['frame_bytes']} of memory")
    check_features(simulator, report)
    with tempfile.TemporaryDirectory() as directory:
        check_forms(simulator, compiler, library, pathlib.Path(directory), report)
    return report.finish()


sys.exit(main(*sys.argv[1:]))
