"""Baked scenes: C99 without a warning, the same frame as the file they came from, and the costs that they state.

bake_roundtrip.py SIMULATOR COMPILER LIBRARY [SCENE...]     of all own scenes, and those named
"""
import hashlib
import json
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
    for kind, size in (("spheres", 20), ("triangles", 10), ("vertices", 12)):
        report.equal(f"{scene.name}: {kind}", sizes.get(kind, 0), size * facts[kind])
    text = code.read_text()
    for fact in run(simulator, "stats", scene).splitlines():
        report.check(fact in words, f"{scene.name}: bake does not say: {fact}")
        report.check(re.sub(r"[?\\]", "_", fact) in text, f"{scene.name}: not in the file: {fact}")
    return facts


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
            facts = check(simulator, compiler, library, scene, pathlib.Path(directory), report)
            print(f"{scene.name}: {facts['flash_bytes']} bytes of flash, {facts['frame_bytes']} of memory")
    check_features(simulator, report)
    return report.finish()


sys.exit(main(*sys.argv[1:]))
