"""Every own scene's picture is the one in tests/golden, sample for sample; what differs is shown as one picture.

golden_pictures.py SIMULATOR WORK              checks; writes WORK/SCENE.png (old, new, difference) for each that differs
golden_pictures.py --update SIMULATOR WORK     takes the new pictures as golden, and writes the same for each that changed
golden_pictures.py --self-test SIMULATOR WORK  proves that a changed and a missing picture are noticed
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from support import GOLDEN, SCENES, Report, scene_names

SIZE = "128x128"


def run(simulator, *arguments):
    return subprocess.run([simulator, *map(str, arguments)], capture_output=True, text=True, stdin=subprocess.DEVNULL)


def render(simulator, scene, path):
    result = run(simulator, "render", SCENES / f"{scene}.nff", "--size", SIZE, "-o", path)
    if result.returncode != 0:
        sys.exit(f"{scene}: {result.stderr.strip()}")


def compare(simulator, old, new, picture):
    """diff's exit code (0 same, 1 different, 2 unreadable) and its words; the picture is only written when they differ."""
    result = run(simulator, "diff", old, new)
    if result.returncode == 1:
        picture.parent.mkdir(parents=True, exist_ok=True)
        run(simulator, "diff", old, new, "-o", picture, "--zoom", 2)
    return result.returncode, (result.stdout + result.stderr).strip().splitlines()


def check(simulator, golden, work, report, scenes):
    with tempfile.TemporaryDirectory() as directory:
        for scene in scenes:
            old, new = golden / f"{scene}.png", pathlib.Path(directory, f"{scene}.png")
            if not report.check(old.is_file(), f"no golden picture of {scene}; `make golden-update` adds it"):
                continue
            render(simulator, scene, new)
            code, words = compare(simulator, old, new, work / f"{scene}.png")
            report.check(code == 0, f"{scene}: {words[0]}; see {work / scene}.png (old, new, difference)")
    for stray in sorted({path.stem for path in golden.glob("*.png")} - set(scenes)):
        report.check(False, f"golden picture of {stray}, which is no scene")


def update(simulator, golden, work):
    with tempfile.TemporaryDirectory() as directory:
        for scene in scene_names():
            old, new = golden / f"{scene}.png", pathlib.Path(directory, f"{scene}.png")
            render(simulator, scene, new)
            if not old.is_file():
                print(f"{scene}: new")
            else:
                code, words = compare(simulator, old, new, work / f"{scene}.png")
                if code == 0:
                    continue
                print(f"{scene}: {words[0]}; look at {work / scene}.png (old, new, difference)")
            shutil.copyfile(new, old)
    return 0


def self_test(simulator, work):
    with tempfile.TemporaryDirectory() as directory:
        golden = pathlib.Path(directory)
        render(simulator, "s1", golden / "s1.png")
        failures = []
        for scenes, source in ((["s1"], None), (["s1"], "s1r"), (["s1", "s2"], None), ([], None)):
            if source:
                render(simulator, source, golden / "s1.png")
            report = Report()
            check(simulator, golden, work / "self-test", report, scenes)
            failures.append(len(report.wrong))
            render(simulator, "s1", golden / "s1.png")
        if failures != [0, 1, 1, 1]:
            sys.exit(f"failures {failures}, expected [0, 1, 1, 1]")
        if not (work / "self-test" / "s1.png").is_file():
            sys.exit("no picture of the difference was written")
    print("self-test passed: the failures above were meant")
    return 0


def main(arguments):
    simulator, work = arguments[-2], pathlib.Path(arguments[-1])
    if arguments[0] == "--update":
        return update(simulator, GOLDEN.parent, work)
    if arguments[0] == "--self-test":
        return self_test(simulator, work)
    report = Report()
    check(simulator, GOLDEN.parent, work, report, scene_names())
    return report.finish()


sys.exit(main(sys.argv[1:]))
