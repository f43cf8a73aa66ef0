"""Every own scene renders to the CRCs of tests/golden/crc.txt, whatever the height of the strips.

golden.py SIMULATOR               checks
golden.py --update SIMULATOR      rewrites the file from what the simulator renders
golden.py --self-test SIMULATOR   proves that a wrong, a missing and a superfluous line are noticed
"""
import pathlib
import sys
import tempfile

from support import GOLDEN, SCENES, Report, fixcast_json, read_golden, scene_names

HEADER = """\
# CRC-32 (zlib's) of each own scene's RGB565 big-endian frame: scene, size, CRC.
# `make golden-update` rewrites this file; look at the pictures before you commit it.
"""
STRIPS = (1, 7, 16)


def sizes(scene):
    # 32x24 is for the slowest chips (matrix.py). s2's thousand triangles at 240x240 would show nothing new.
    return ("32x24", "64x48", "128x128") + (() if scene == "s2" else ("240x240",))


def crc(simulator, scene, size, *options):
    return fixcast_json(simulator, "render", SCENES / f"{scene}.nff", "--size", size, *options)["crc32"]


def check_frames(simulator, golden, report, scenes):
    for scene in scenes:
        for size in sizes(scene):
            if report.check((scene, size) in golden, f"no golden CRC for {scene} {size}; `make golden-update` adds it"):
                report.equal(f"CRC of {scene} {size}", golden[scene, size], crc(simulator, scene, size))


def check_lines(golden, report):
    known = {(scene, size) for scene in scene_names() for size in sizes(scene)}
    for scene, size in sorted(set(golden) - known):
        report.check(False, f"golden CRC for {scene} {size}, which no test renders")


def check_strips(simulator, golden, report):
    for scene in scene_names():
        for rows in STRIPS:
            actual = crc(simulator, scene, "128x128", "--strip", rows)
            report.equal(f"CRC of {scene} 128x128 in strips of {rows}", golden.get((scene, "128x128")), actual)


def update(simulator):
    lines = [f"{scene} {size} {crc(simulator, scene, size)}\n" for scene in scene_names() for size in sizes(scene)]
    GOLDEN.write_text(HEADER + "".join(lines))
    print(f"{GOLDEN}: {len(lines)} frames")
    return 0


def self_test(simulator):
    right = {("s1", size): crc(simulator, "s1", size) for size in sizes("s1")}
    wrong = dict(right)
    wrong["s1", "64x48"] = "0x00000000"
    missing = dict(right)
    del missing["s1", "64x48"]
    for name, golden, failures in (("right", right, 0), ("wrong", wrong, 1), ("missing", missing, 1)):
        report = Report()
        check_frames(simulator, golden, report, ["s1"])
        if len(report.wrong) != failures:
            sys.exit(f"a {name} golden line gave {len(report.wrong)} failures, not {failures}")
    report = Report()
    check_lines({("nosuch", "64x48"): "0x00000000"}, report)
    if len(report.wrong) != 1:
        sys.exit("a golden line without a scene went unnoticed")
    with tempfile.TemporaryDirectory() as directory:
        for text in ("s1 64x48\n", "s1 64x48 0x00000000\n" * 2):
            path = pathlib.Path(directory, "crc.txt")
            path.write_text(text)
            try:
                read_golden(path)
            except SystemExit:
                continue
            sys.exit(f"a golden file was taken that says {text!r}")
    print("self-test passed: the failures above were meant")
    return 0


def main(arguments):
    if arguments[0] == "--update":
        return update(arguments[1])
    if arguments[0] == "--self-test":
        return self_test(arguments[1])
    golden, report = read_golden(), Report()
    check_frames(arguments[0], golden, report, scene_names())
    check_lines(golden, report)
    check_strips(arguments[0], golden, report)
    return report.finish()


sys.exit(main(sys.argv[1:]))
