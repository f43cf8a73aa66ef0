"""What the lectures' methods cost on chips: instructions a pixel of tests/rivals and of ours, seeing alone, into one JSON file.

methods.py [--work DIR] [--simulator FILE] [--rivals FILE] [--only SCENE CHIP]

Writes DIR/methods.json. FILE is what the test `rivals` wrote: a chip must see, primitive for primitive, what was judged there. Two minutes.
"""
import argparse
import concurrent.futures
import functools
import json
import pathlib
import sys
import time

import bench_scenes
import counting
import images
import measured
from images import Failure, HERE, ROOT, TARGETS, TESTS

# By method.cpp's numbers.
METHODS = ("ours, a ray a pixel", "ours, by scan lines", "sphere by algebra", "sphere by geometry", "triangle by Cramer",
           "triangle by plane and barycentrics", "triangle by edges", "z-buffer", "painter", "BSP tree", "Warnock")
OURS, SPHERES, TRIANGLES, SURFACES = (0, 1), (2, 3), (4, 5, 6), (7, 8, 9, 10)
CASES = {"s1": OURS + SPHERES, "box": OURS + TRIANGLES + SURFACES, "s2": OURS + SURFACES}  # a ray a pixel of the rivals would take too long on s2
CHIPS = ("m0plus", "m3")
PIXELS = 128 * 128
LIMIT, SECONDS = 6_000_000_000, 600


def build(workshop, scene, method, chip):
    """As Workshop.build: (image, map, {object: source})."""
    target = TARGETS[chip]
    options = ["-O2", "-ffunction-sections", "-fdata-sections", *target.flags, "-I", ROOT / "include"]
    c = [f"{target.prefix}gcc", "-std=c99", *options]
    cpp = [f"{target.prefix}g++", "-std=c++17", "-fno-exceptions", "-fno-rtti", "-fno-math-errno", "-fno-threadsafe-statics",
           *options, "-Wall", "-Wextra", "-Werror",
           "-I", TESTS / "rivals"]
    todo = [([*cpp, f"-DSCENE={scene}", f"-DMETHOD={method}"], HERE / "image/method.cpp")]
    todo += [(cpp, TESTS / "rivals" / f"{name}.cpp") for name in ("picture", "rays", "surfaces")]
    todo += [(c, source) for source in target.port] + [(c, workshop.scenes.baked(scene))]
    todo += [([*c, "-I", ROOT / "src/core"], source) for source in sorted(ROOT.glob("src/core/*.c"))]
    objects = [workshop.compile(*task) for task in todo]
    made = workshop.work / "images" / f"{chip}-method{method}-{scene}.elf"
    images.execute([c[0], *target.flags, *objects, *target.link, "-Wl,-u,bench_mark_setup", f"-Wl,-Map={made.with_suffix('.map')}", "-o", made])
    return made, made.with_suffix(".map"), {str(path): source for path, (_, source) in zip(objects, todo)}


def judged(path):
    """{(scene, method): CRC of what it sees on the host}, in float or, for ours, exactly."""
    scenes = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["scenes"]
    right = {}
    for scene, rows in scenes.items():
        for row in rows:
            if row["numbers"] == "float":
                right[scene, row["method"]] = row["crc"]
            elif row["method"] == "ours":
                right[scene, METHODS[0]] = right[scene, METHODS[1]] = row["crc"]
    return right


def measure(workshop, right, case):
    scene, method, chip = case
    counts = counting.count(chip, build(workshop, scene, method, chip), workshop.work, LIMIT, SECONDS)
    row = {"scene": scene, "method": METHODS[method], "target": chip, "instructions_per_pixel": None}
    if counts.instructions is not None:
        seen = int(counts.printed["crc"], 16)
        if seen != right[scene, METHODS[method]]:
            raise Failure(f"{METHODS[method]} on {scene}, {chip}: sees {seen:#x}, on the host {right[scene, METHODS[method]]:#x}")
        row["instructions_per_pixel"] = round(sum(counts.instructions.values()) / PIXELS, 1)
    return row


def run(workshop, rivals, jobs, only):
    cases = [(scene, method, chip) for scene, methods in CASES.items() for method in methods for chip in CHIPS
             if not only or (scene in only and chip in only)]
    for scene in CASES:
        workshop.scenes.baked(scene)
    counting.plugin(workshop.work)
    started, rows = time.monotonic(), []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for row in pool.map(functools.partial(measure, workshop, judged(rivals)), cases):
            rows.append(row)
            if sys.stderr.isatty():
                left = (time.monotonic() - started) / len(rows) * (len(cases) - len(rows))
                print(f"\r\033[K{len(rows)} of {len(cases)} methods, about {left / 60:.1f} minutes left", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", default=ROOT / "build/bench", type=pathlib.Path, metavar="DIR")
    parser.add_argument("--simulator", default=ROOT / "build/fixcast", metavar="FILE")
    parser.add_argument("--rivals", default=ROOT / "build/rivals.json", metavar="FILE")
    parser.add_argument("--jobs", type=int, default=2, metavar="N")
    parser.add_argument("--only", nargs=2, default=[], metavar=("SCENE", "CHIP"), help="that alone, into methods-part.json")
    options = parser.parse_args()
    try:
        workshop = images.Workshop(options.work, bench_scenes.Scenes(options.work, options.simulator), jobs=1)
        digest = measured.digest(ROOT)
        rows = run(workshop, options.rivals, options.jobs, options.only)
    except FileNotFoundError as missing:
        print(f"methods: {missing.filename} is not there: `ctest -R rivals` in the build directory writes what methods are judged by",
              file=sys.stderr)
        return 2
    except Failure as failure:
        print(f"methods: {failure}", file=sys.stderr)
        return 2
    out = options.work / ("methods-part.json" if options.only else "methods.json")
    fresh = out.with_suffix(".tmp")
    fresh.write_text(json.dumps({"digest": digest, "rows": rows}, indent=1) + "\n", encoding="utf-8")
    fresh.replace(out)
    for row in rows:
        print(f"{row['scene']:4} {row['method']:36} {row['target']:7} {row['instructions_per_pixel'] or '-':>10}")
    print(f"{len(rows)} rows, written to {out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
