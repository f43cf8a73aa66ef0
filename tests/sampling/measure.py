"""What each sampling pattern leaves of the error, and what it costs in rays.

measure.py --simulator PROGRAM [--work DIR] [--size WxH] [--reference N] [--check] [SCENE.nff ...]

Renders each scene with each pattern and compares it with N x N regular rays a pixel (64 x 64; kept in DIR and made anew only
when the scene or its picture with one ray a pixel changes). Prints JSON: for each scene and pattern the rays a pixel and the root of the
mean squared error of all channels, in levels of 255. With --check the exit code says whether what docs/SPEC.md promises holds:
  quincunx reaches the error of 4 x 4 regular with at most 40 % of its rays, and random falls as 1 / sqrt(n).
"""
import argparse
import hashlib
import json
import math
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = [ROOT / "host_sim" / "scenes" / f"{name}.nff" for name in ("s1", "flake")]
RANDOM = [1, 4, 16, 64, 256]
PATTERNS = (["one"] + [f"regular:{n}" for n in (2, 3, 4, 8)] + [f"random:{n}" for n in RANDOM] +
            [f"jitter:{n * n}" for n in (2, 4, 8, 16)] + [f"quincunx:{depth}" for depth in range(5)])
TARGET, SHARE = "regular:4", 0.4
SLOPE = (-0.6, -0.4)


def read_ppm(path):
    """The samples of a binary PPM."""
    data = path.read_bytes()
    fields, at = [], 0
    while len(fields) < 4:
        while data[at:at + 1].isspace():
            at += 1
        if data[at:at + 1] == b"#":
            at = data.index(b"\n", at)
            continue
        end = at
        while not data[end:end + 1].isspace():
            end += 1
        fields.append(data[at:end])
        at = end
    width, height = int(fields[1]), int(fields[2])
    if fields[0] != b"P6" or fields[3] != b"255" or len(data) - at - 1 != 3 * width * height:
        raise ValueError(f"{path}: not a PPM of 8 bits a channel")
    return data[at + 1:]


def rmse(a, b):
    if len(a) != len(b):
        raise ValueError("pictures of different sizes")
    return math.sqrt(sum((x - y) * (x - y) for x, y in zip(a, b)) / len(a))


def slope(points):
    """Of the line through (log n, log error) with the least squares."""
    xs, ys = [math.log(n) for n, _ in points], [math.log(error) for _, error in points]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


class Renderer:
    def __init__(self, simulator, size, work):
        self.simulator, self.size, self.work = simulator, size, work
        work.mkdir(parents=True, exist_ok=True)

    def render(self, scene, pattern, path):
        """(samples, what the program reports) of a frame."""
        result = subprocess.run([self.simulator, "render", str(scene), "--size", self.size, "--samples", pattern, "--seed", "1",
                                 "--json", "-o", str(path)], check=True, capture_output=True, text=True)
        return read_ppm(path), json.loads(result.stdout)

    def reference(self, scene, n):
        _, one = self.render(scene, "one", self.work / f"{scene.stem}-one.ppm")
        key = hashlib.sha256(scene.read_bytes() + f"{self.size} {n} {one['crc32']}".encode()).hexdigest()[:16]
        path = self.work / f"{scene.stem}-reference-{key}.ppm"
        if not path.exists():
            unfinished = path.with_suffix(".new.ppm")
            self.render(scene, f"regular:{n}", unfinished)
            unfinished.rename(path)
        return read_ppm(path)


def measure(renderer, scene, n, say):
    say(f"{scene.stem}: {n * n} rays a pixel")
    reference = renderer.reference(scene, n)
    rows = []
    for pattern in PATTERNS:
        say(f"{scene.stem}: {pattern}")
        pixels, report = renderer.render(scene, pattern, renderer.work / f"{scene.stem}-{pattern.replace(':', '-')}.ppm")
        rows.append({"pattern": pattern, "rays_per_pixel": round(report["rays"] / report["width"] / report["height"], 4),
                     "rmse": round(rmse(pixels, reference), 4)})
    by_name = {row["pattern"]: row for row in rows}
    target = by_name[TARGET]
    reached = [row for row in rows if row["pattern"].startswith("quincunx") and row["rmse"] <= target["rmse"]]
    best = min(reached, key=lambda row: row["rays_per_pixel"], default=None)
    return {
        "patterns": rows,
        "random_slope": round(slope([(count, by_name[f"random:{count}"]["rmse"]) for count in RANDOM]), 4),
        "quincunx_reaching_4x4": best and best["pattern"],
        "quincunx_share_of_4x4_rays": best and round(best["rays_per_pixel"] / target["rays_per_pixel"], 4),
    }


def broken(scene, result):
    """What of the promises does not hold, in sentences."""
    share, fall = result["quincunx_share_of_4x4_rays"], result["random_slope"]
    if share is None:
        yield f"{scene}: no depth of quincunx reaches the error of 4 x 4 regular"
    elif share > SHARE:
        yield f"{scene}: quincunx takes {share:.0%} of the rays of 4 x 4 regular for its error, more than {SHARE:.0%}"
    if not SLOPE[0] <= fall <= SLOPE[1]:
        yield f"{scene}: the error of random falls as n^{fall}, not as n^-1/2"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--simulator", required=True)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "sampling")
    parser.add_argument("--size", default="128x128")
    parser.add_argument("--reference", type=int, default=64, help="rays a pixel along a side")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, default=SCENES)
    options = parser.parse_args()
    started = time.monotonic()

    def say(text):
        print(f"[{time.monotonic() - started:6.1f} s] {text}", file=sys.stderr)

    renderer = Renderer(options.simulator, options.size, options.work)
    results = {scene.stem: measure(renderer, scene, options.reference, say) for scene in options.scenes}
    print(json.dumps({"size": options.size, "reference": f"regular:{options.reference}", "scenes": results}, indent=1))
    faults = [fault for scene, result in results.items() for fault in broken(scene, result)] if options.check else []
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
