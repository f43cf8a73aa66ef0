"""Sampled frames have the CRCs and ray counts of tests/golden/sampling.txt, whatever the height of the strips.

sampling.py SIMULATOR               checks
sampling.py --update SIMULATOR      rewrites the file from what the simulator renders
sampling.py --self-test SIMULATOR   proves that wrong, missing and superfluous lines are noticed
"""
import math
import pathlib
import sys
import tempfile

from support import GOLDEN, SCENES, Report, fixcast_json, scene_names

FILE = GOLDEN.with_name("sampling.txt")
HEADER = """\
# Sampled frames: scene, size, rays that make the pixels, zlib's CRC-32 of the RGB565 big-endian frame, options.
# `python3 tests/checks/sampling.py --update build/fixcast` rewrites this file; look at the pictures before you commit it.
"""
FRAMES = tuple(
    (scene, "64x48", options) for scene, options in (
        ("s1", "--samples regular:4"),
        ("s1", "--samples regular:4 --filter tent"),
        ("s1", "--samples random:16 --seed 5"),
        ("s1", "--samples jitter:16 --seed 5"),
        ("s1", "--samples quincunx:3"),
        ("s1", "--samples quincunx:2:2 --lens orthographic:6.5"),
        ("s1", "--samples quincunx --lens fisheye:180"),
        ("s1", "--samples jitter:4 --filter tent --lens panorama"),
        ("flake", "--samples quincunx:2"),
        ("flake", "--lens orthographic"),
        ("box", "--samples quincunx:2 --lens fisheye:240"),
        ("fight", "--samples jitter:9"),
    ))


def rendered(simulator, scene, size, options, *more):
    """What stands in the golden file between size and options."""
    report = fixcast_json(simulator, "render", SCENES / f"{scene}.nff", "--size", size, *options.split(), *more)
    return f"{report['rays']} {report['crc32']}"


def read(path):
    """{(scene, size, options): "rays crc"}"""
    golden = {}
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            scene, size, rays, crc, options = line.split(" ", 4)
            golden[scene, size, options] = f"{rays} {crc}"
    return golden


def check(simulator, golden, report, frames, strips=(1, 7)):
    for frame in frames:
        name = " ".join(frame)
        if not report.check(frame in golden, f"no golden line for {name}; --update adds it"):
            continue
        report.equal(name, golden[frame], rendered(simulator, *frame))
        for rows in strips:
            report.equal(f"{name} in strips of {rows}", golden[frame], rendered(simulator, *frame, "--strip", rows))
    for frame in set(golden) - set(frames):
        report.check(False, f"golden line that no test renders: {' '.join(frame)}")


def check_one_ray(simulator, report):
    """One ray a pixel at its centre sees what the frame shows without sampling."""
    for scene in scene_names():
        frame = [fixcast_json(simulator, "render", SCENES / f"{scene}.nff", "--size", "64x48", *options)
                 for options in ((), ("--samples", "one"))]
        for key in ("pixels_by_id", "unlit_pixels"):
            report.equal(f"{key} of {scene} by one ray a pixel", frame[0][key], frame[1][key])


def check_samples_image(simulator, report):
    """The picture of ray counts: those of the frame's edges, as many greys as counts, the greatest white."""
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory, "samples.pgm")
        fixcast_json(simulator, "render", SCENES / "s1.nff", "--size", "64x48", "--samples", "quincunx:3", "--samples-image", path)
        data = path.read_bytes()
        report.equal("header of samples.pgm", b"P5\n64 48\n65535\n", data[:15])
        greys = [int.from_bytes(data[i:i + 2], "big") for i in range(15, len(data), 2)]
        report.equal("white of samples.pgm", 65535, max(greys))
        report.check(64 * 48 * 0.5 < greys.count(min(greys)), "samples.pgm: most pixels are not those with the fewest rays")


def kernel_weights(kernel, n):
    """{offset of a cell to the pixel's first: weight}, n cells a pixel, by the midpoint rule on 1000 parts of each cell."""
    parts, weights = 1000, {}
    for cell in range(-2 * n, 3 * n):
        places = ((cell + (part + 0.5) / parts) / n - 0.5 for part in range(parts))
        weights[cell] = sum(kernel(abs(x)) for x in places if abs(x) < 2)
    total = sum(weights.values())
    return {cell: weight / total for cell, weight in weights.items() if weight}


def reduced(samples, weights, n, count):
    """A row of count * n samples as count pixels."""
    pixels = []
    for i in range(count):
        reached = [(w, samples[i * n + cell]) for cell, w in weights.items() if 0 <= i * n + cell < count * n]
        pixels.append(sum(w * s for w, s in reached) / sum(w for w, _ in reached))
    return pixels


def check_kernels(simulator, report):
    """--filter gaussian and mitchell are these sums of the pixels of a frame n times as large. --angle goes from centre to centre (NFF's rule): of the larger
    frame's outer pixels those lie farther out."""
    kernels = {"gaussian": lambda x: math.exp(-2 * x * x),
               "mitchell": lambda x: (7 * x ** 3 - 12 * x ** 2 + 16 / 3) / 6 if x < 1 else (-7 / 3 * x ** 3 + 12 * x ** 2 - 20 * x + 32 / 3) / 6}
    width, height = 24, 20
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory, "frame.ppm")

        def frame(scene, size, *options):
            """Three planes of rows of levels."""
            fixcast_json(simulator, "render", SCENES / f"{scene}.nff", "--size", f"{size[0]}x{size[1]}", *options, "-o", path)
            pixels = path.read_bytes()[-3 * size[0] * size[1]:]
            return [[list(pixels[3 * size[0] * y + c:3 * size[0] * (y + 1):3]) for y in range(size[1])] for c in range(3)]

        wider = 2 * math.degrees(math.atan(math.tan(math.radians(20)) * (3 * height - 1) / (3 * (height - 1))))
        for scene, n, view, large_view in (("s1", 4, (), ()), ("s1", 1, (), ()),
                                           ("flake", 3, ("--angle", "40"), ("--angle", f"{wider:.12f}"))):
            large = frame(scene, (width * n, height * n), "--samples", "one", *large_view)
            for name, kernel in kernels.items():
                weights, worst, moved = kernel_weights(kernel, n), 0, 0
                got = frame(scene, (width, height), "--samples", f"regular:{n}", "--filter", name, *view)
                for plane, shown in zip(large, got):
                    across = [reduced(row, weights, n, width) for row in plane]
                    for x in range(width):
                        for y, true in enumerate(reduced([row[x] for row in across], weights, n, height)):
                            worst = max(worst, abs(shown[y][x] - min(max(true, 0), 255)))
                            moved = max(moved, abs(shown[y][x] - plane[y * n + n // 2][x * n + n // 2]))
                report.check(worst <= 0.5001, f"{scene}, {n} x {n} rays, {name}: {worst} levels from the sum")
                report.check(moved > 10, f"{scene}, {n} x {n} rays, {name}: at most {moved} levels from a sample: nothing was filtered")


def update(simulator):
    lines = []
    for scene, size, options in FRAMES:
        lines.append(f"{scene} {size} {rendered(simulator, scene, size, options)} {options}\n")
    FILE.write_text(HEADER + "".join(lines))
    print(f"{FILE}: {len(lines)} frames")
    return 0


def self_test(simulator):
    frames = FRAMES[:2]
    right = {frame: rendered(simulator, *frame) for frame in frames}
    wrong = dict(right)
    wrong[frames[0]] = right[frames[0]].replace("0x", "0y")
    rays = dict(right)
    rays[frames[1]] = "1 " + right[frames[1]].split()[1]
    missing = {frames[0]: right[frames[0]]}
    surplus = {**right, ("s1", "1x1", "--samples one"): "1 0x00000000"}
    report = Report()
    for name, golden, faults in (("right", right, 0), ("wrong", wrong, 1), ("rays", rays, 1), ("missing", missing, 1),
                                 ("surplus", surplus, 1)):
        found = Report()
        check(simulator, golden, found, frames, strips=())
        report.equal(f"faults found in the {name} lines", faults, len(found.wrong))
    return report.finish()


def main(arguments):
    if arguments[0] == "--update":
        return update(arguments[1])
    if arguments[0] == "--self-test":
        return self_test(arguments[1])
    report = Report()
    check(arguments[0], read(FILE), report, FRAMES)
    check_one_ray(arguments[0], report)
    check_samples_image(arguments[0], report)
    check_kernels(arguments[0], report)
    return report.finish()


sys.exit(main(sys.argv[1:]))
