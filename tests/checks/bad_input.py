"""Bad input ends with exit code 2, one line on stderr that names the file and the line, and no file left behind.

bad_input.py SIMULATOR
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from support import SCENES, Report

VIEW = """\
v
from 0 1.5 1
at 0 1.5 0
up 0 1 0
angle 53.1
hither 0.01
resolution 16 16
"""
BODY = """\
b 0.4 0.6 0.8
l -3 5 -1
f 0.8 0.2 0.2 1 0 0 0 1
s 0 1 -6 1
"""
GOOD = VIEW + BODY

# name, text of the scene, line the message must name (None: the file alone)
SCENES_WRONG = (
    ("empty", "", None),
    ("comment only", "# nothing\n", None),
    ("no view", BODY, None),
    ("binary junk", bytes(range(256)) * 40, 1),
    ("binary junk after good lines", GOOD.encode() + bytes(range(128, 256)) * 8 + b"\n", 12),
    ("NUL byte", GOOD + "s 0 1 \0-6 1\n", 12),
    ("truncated view", "v\nfrom 0 1.5 1\nat 0 1.5 0\n", None),
    ("truncated polygon", GOOD + "p 3\n0 0 -4\n1 0 -4\n", None),
    ("polygon cut by an entity", GOOD + "p 3\n0 0 -4\n1 0 -4\ns 0 1 -6 1\n", 12),
    ("polygon vertex of two numbers", GOOD + "p 3\n0 0 -4\n1 0\n0 1 -4\n", 14),
    ("polygon of two vertices", GOOD + "p 2\n0 0 -4\n1 0 -4\n", 12),
    ("polygon of minus three vertices", GOOD + "p -3\n", 12),
    ("polygon without a count", GOOD + "p\n", 12),
    ("polygon of 1e9 vertices", GOOD + "p 1000000000\n0 0 -4\n", None),
    ("polygon of 2^64 vertices", GOOD + "p 18446744073709551616\n0 0 -4\n", 12),
    ("patch without normals", GOOD + "pp 3\n0 0 -4\n1 0 -4\n0 1 -4\n", 13),
    ("truncated cone", GOOD + "c\n0 0 -4 1\n", 12),
    ("cone cut by an entity", GOOD + "c\n0 0 -4 1\ns 0 1 -6 1\n", 14),
    ("cone cut by an extension", GOOD + "c\n0 0 -4 1\n#fc: plane 0 1 0 0\n", 14),
    ("cone without length", GOOD + "c\n0 0 -4 1\n0 0 -4 0.5\n", 14),
    ("cone of radii 0", GOOD + "c\n0 0 -4 0\n0 1 -4 0\n", 14),
    ("cone of radii 1 and -1", GOOD + "c\n0 0 -4 1\n0 1 -4 -1\n", 14),
    ("cone_error 0", GOOD + "#fc: cone_error 0\n", 12),
    ("NaN", GOOD + "s nan 1 -6 1\n", 12),
    ("inf", GOOD + "s 0 inf -6 1\n", 12),
    ("-infinity", GOOD + "s 0 -infinity -6 1\n", 12),
    ("1e300", GOOD + "s 0 1e300 -6 1\n", 12),
    ("1e99999", GOOD + "s 0 1e99999 -6 1\n", 12),
    ("a word for a number", GOOD + "s 0 one -6 1\n", 12),
    ("a number with a tail", GOOD + "s 0 1.5x -6 1\n", 12),
    ("hexadecimal", GOOD + "s 0 0x10 -6 1\n", 12),
    ("division by zero", GOOD + "s 0 1/0 -6 1\n", 12),
    ("a number too many", GOOD + "s 0 1 -6 1 7\n", 12),
    ("a number too few", GOOD + "s 0 1 -6\n", 12),
    ("zero radius", GOOD + "s 0 1 -6 0\n", 12),
    ("negative radius", GOOD + "s 0 1 -6 -1\n", 12),
    ("zero normal", GOOD + "#fc: plane 0 0 0 1\n", 12),
    ("short plane", GOOD + "#fc: plane 0 1 0\n", 12),
    ("a mirror before a material", VIEW + "#fc: mirror 1 1 1\n", 8),
    ("a mirror brighter than 1", GOOD + "#fc: mirror 1 1.5 1\n", 12),
    ("a mirror of no bounces", GOOD + "#fc: mirror 1 1 1 0\n", 12),
    ("a mirror of 17 bounces", GOOD + "#fc: mirror 1 1 1 17\n", 12),
    ("two mirrors", GOOD + "#fc: mirror 1 1 1\n#fc: mirror 1 1 1\n", 13),
    ("negative emission", GOOD + "#fc: emission 0 -1 0\n", 12),
    ("a checker without a mapping", GOOD + "#fc: checker 0 0 0 1 1 1\n", 12),
    ("a checker of an unknown mapping", GOOD + "#fc: checker 0 0 0 1 1 1 cubic\n", 12),
    ("a planar mapping cut short", GOOD + "#fc: checker 0 0 0 1 1 1 planar 0 0 0 1 0 0 0 0\n", 12),
    ("a planar mapping without an axis", GOOD + "#fc: checker 0 0 0 1 1 1 planar 0 0 0 1 0 0 0 0 0\n", 12),
    ("a repeat of one number", GOOD + "#fc: checker 0 0 0 1 1 1 spherical repeat 3\n", 12),
    ("a repeat of 256", GOOD + "#fc: checker 0 0 0 1 1 1 spherical repeat 256 1\n", 12),
    ("two textures", GOOD + "#fc: checker 0 0 0 1 1 1 spherical\n#fc: checker 0 0 0 1 1 1 spherical\n", 13),
    ("an image that is not there", GOOD + "#fc: image none.ppm spherical\n", 12),
    ("an image that is the scene", GOOD + "#fc: image scene.nff spherical\n", 12),
    ("a sun without a direction", GOOD + "#fc: sun 0 0 0 1 1 1\n", 12),
    ("a sun without a colour", GOOD + "#fc: sun 1 1 1\n", 12),
    ("a gradient without up", GOOD + "#fc: gradient 0 0 0 1 1 1\n", 12),
    ("two gradients", GOOD + "#fc: gradient 0 1 0 1 1 1\n#fc: gradient 0 1 0 1 1 1\n", 13),
    ("eye equals target", VIEW.replace("at 0 1.5 0", "at 0 1.5 1") + BODY, None),
    ("up parallel to view", VIEW.replace("up 0 1 0", "up 0 0 -3") + BODY, None),
    ("zero up", VIEW.replace("up 0 1 0", "up 0 0 0") + BODY, None),
    ("angle of 180", VIEW.replace("53.1", "180") + BODY, None),
    ("angle of 0", VIEW.replace("53.1", "0") + BODY, None),
    ("NaN in the view", VIEW.replace("53.1", "nan") + BODY, 5),
    ("zero field of view", GOOD + "#fc: tan_half_fov 0\n", 12),
    ("negative field of view", GOOD + "#fc: tan_half_fov -1/2\n", 12),
    ("zero far limit", GOOD + "#fc: far 0\n", 12),
    ("negative ambient", GOOD + "#fc: ambient -1\n", 12),
    ("unknown falloff", GOOD + "#fc: falloff cubic\n", 12),
    ("unknown fc line", GOOD + "#fc: mirror 1\n", 12),
    ("unknown entity", GOOD + "torus 0 0 0 1 2\n", 12),
)

# Reading is the same code for all commands, so a few of these do for the others than render.
ALL_COMMANDS = ("empty", "truncated polygon", "zero radius", "eye equals target")

# name, arguments after the command and the scene, what the line must contain
OPTIONS_WRONG = (
    ("0x0", ["--size", "0x0"], "0x0"),
    ("100000x100000", ["--size", "100000x100000"], "100000x100000"),
    ("size without x", ["--size", "128"], "128"),
    ("negative size", ["--size=-4x4"], "-4x4"),
    ("words for a size", ["--size", "widexhigh"], "widexhigh"),
    ("world scale of 0", ["--world-scale", "0"], "0"),
    ("world scale over 0", ["--world-scale", "1/0"], "1/0"),
    ("negative world scale", ["--world-scale=-1/4"], "-1/4"),
    ("unknown profile", ["--profile", "quick"], "quick"),
    ("empty profile", ["--profile", ""], "--profile"),
    ("profile without its value", ["--profile"], "--profile"),
    ("unknown option", ["--colour"], "--colour"),
    ("unknown pattern", ["--samples", "poisson"], "poisson"),
    ("no cells", ["--samples", "regular:0"], "regular:0"),
    ("too many cells", ["--samples", "regular:65"], "regular:65"),
    ("cells of a word", ["--samples", "regular:four"], "regular:four"),
    ("cells twice", ["--samples", "regular:4:4"], "regular:4:4"),
    ("a pattern without its number", ["--samples", "random"], "random"),
    ("too many random rays", ["--samples", "random:4097"], "random:4097"),
    ("jitter that is no square", ["--samples", "jitter:15"], "jitter:15"),
    ("quincunx too deep", ["--samples", "quincunx:6"], "quincunx:6"),
    ("quincunx of too many levels", ["--samples", "quincunx:2:256"], "quincunx:2:256"),
    ("quincunx with the tent", ["--samples", "quincunx", "--filter", "tent"], "tent"),
    ("unknown filter", ["--filter", "mitchell"], "mitchell"),
    ("unknown lens", ["--lens", "anamorphic"], "anamorphic"),
    ("fisheye of no angle", ["--lens", "fisheye:0"], "fisheye:0"),
    ("fisheye of more than a turn", ["--lens", "fisheye:361"], "fisheye:361"),
    ("panorama with a number", ["--lens", "panorama:360"], "panorama:360"),
    ("orthographic of no size", ["--lens", "orthographic:0"], "orthographic:0"),
    ("orthographic of a negative size", ["--lens", "orthographic:-2"], "orthographic:-2"),
    ("orthographic of not a number", ["--lens", "orthographic:nan"], "orthographic:nan"),
    ("orthographic far larger than the scene", ["--lens", "orthographic:100000000"], "beyond the scene"),
    ("negative seed", ["--seed=-1"], "--seed"),
    ("sampling in a profile", ["--samples", "one", "--profile", "half"], "half"),
    ("a samples image without samples", ["--samples-image", "n.png"], "--samples-image"),
    ("an argument too many", ["surplus"], "surplus"),
    ("option without its value", ["--size"], "--size"),
)


def run(simulator, arguments, timeout=60):
    return subprocess.run([simulator, *map(str, arguments)], capture_output=True, stdin=subprocess.DEVNULL,
                          timeout=timeout)


def check_refusal(report, what, result, contains):
    """Exit code 2, nothing on stdout, one line on stderr that contains these texts."""
    message = result.stderr.decode(errors="replace")
    report.equal(f"{what}: exit code ({message.strip()[:200]})", 2, result.returncode)
    report.check(result.stdout == b"", f"{what}: printed something to stdout")
    if not report.check(message.count("\n") == 1 and message.endswith("\n")
                        and message[:-1].isprintable() and len(message) > 12,
                        f"{what}: not one clean line on stderr: {message[:400]!r}"):
        return
    for text in contains:
        report.check(text in message, f"{what}: the message does not contain {text!r}: {message.strip()}")


def check_scenes(simulator, directory, report):
    scene, frame = directory / "scene.nff", directory / "frame.png"
    scene.write_text(GOOD)
    result = run(simulator, ["render", scene, "--size", "16x16", "-o", frame])
    report.equal(f"the good scene: exit code ({result.stderr.decode().strip()})", 0, result.returncode)
    for picture in directory.glob("frame.*"):
        picture.unlink()

    for name, text, line in SCENES_WRONG:
        scene.write_bytes(text if isinstance(text, bytes) else text.encode())
        where = f"scene.nff:{line}:" if line else "scene.nff"
        commands = [["render", scene, "-o", frame]]
        if name in ALL_COMMANDS:
            commands += [["compare", scene], ["pick", scene, 0, 0], ["bake", scene, "-o", frame]]
        for command in commands:
            check_refusal(report, f"{name} ({command[0]})", run(simulator, command), [where])
        report.equal(f"{name}: files left", ["scene.nff"], sorted(path.name for path in directory.iterdir()))
    scene.unlink()


def check_files(simulator, directory, report):
    scene = SCENES / "s1.nff"
    missing = directory / "missing.nff"
    check_refusal(report, "missing file", run(simulator, ["render", missing]), ["missing.nff"])
    check_refusal(report, "directory as a scene", run(simulator, ["render", directory]), [directory.name])
    check_refusal(report, "missing frame", run(simulator, ["compare", scene, "--frame", missing]), ["missing.nff"])
    check_refusal(report, "no frame", run(simulator, ["compare", scene, "--frame", scene]), ["s1.nff", "128x128"])
    for command, option in (("render", "-o"), ("render", "--depth"), ("bake", "-o")):
        for name, target in (("missing directory", directory / "nowhere" / "frame.png"), ("a directory", directory),
                             ("a full device", pathlib.Path("/dev/full")), ("no name", pathlib.Path("."))):
            result = run(simulator, [command, scene, option, target])
            # Without OpenImageIO it is frame.ppm that can't be written.
            check_refusal(report, f"{command} {option} to {name}", result, [str(target).removesuffix(".png")])
    check_refusal(report, "picture of unknown format", run(simulator, ["render", scene, "-o", directory / "a.xyz"]),
                  ["a.xyz"])
    report.equal("files left", [], sorted(path.name for path in directory.iterdir()))

    # A failed write leaves the old file as it was.
    frame = directory / "frame.png"
    frame.write_text("old")
    scene = directory / "scene.nff"
    scene.write_text(GOOD + "s 0 1 -6 0\n")
    check_refusal(report, "over an old picture", run(simulator, ["render", scene, "-o", frame]), ["scene.nff:12:"])
    report.equal("old picture", "old", frame.read_text())
    scene.write_text(GOOD)
    check_refusal(report, "over the scene", run(simulator, ["render", scene, "-o", scene]), ["scene.nff"])
    report.equal("the scene", GOOD, scene.read_text())
    frame.unlink()
    scene.unlink()


def check_options(simulator, directory, report):
    scene, frame = SCENES / "s1.nff", directory / "frame.png"
    for name, arguments, contains in OPTIONS_WRONG:
        check_refusal(report, name, run(simulator, ["render", scene, "-o", frame, *arguments]), [contains])
    check_refusal(report, "strips of 0 rows", run(simulator, ["render", scene, "-o", frame, "--strip", "0"]), ["--strip"])
    for command in (["compare", scene], ["pick", scene, "0", "0"]):
        check_refusal(report, f"unknown profile ({command[0]})", run(simulator, [*command, "--profile", "Half"]), ["Half"])
    check_refusal(report, "no command", run(simulator, []), [])
    check_refusal(report, "unknown command", run(simulator, ["paint", scene]), [])
    check_refusal(report, "no scene", run(simulator, ["render"]), [])
    check_refusal(report, "bake without output", run(simulator, ["bake", scene]), [])
    check_refusal(report, "pick outside", run(simulator, ["pick", scene, "128", "0"]), ["128"])
    check_refusal(report, "pick a word", run(simulator, ["pick", scene, "left", "0"]), ["left"])
    report.equal("files left", [], sorted(path.name for path in directory.iterdir()))


def check_long_file(simulator, directory, report):
    """Three million lines of something: refused at once, with the limit in the message. More than 256 MiB of nothing: refused, too."""
    scene = directory / "long.nff"
    for line, many in (("s 0 1 -6 1\n", 3_000_000), ("# " + 997 * "x" + "\n", 270_000), ("#fc: object 1\ns 0 1 -6 1\n", 1_500_000)):
        with open(scene, "w") as file:
            file.write(GOOD)
            for _ in range(100):
                file.write(line * (many // 100))
        result = run(simulator, ["render", scene, "--size", "16x16", "-o", directory / "frame.png"], 300)
        check_refusal(report, f"{many} lines of {line.strip()[:30]}", result, ["long.nff:"])
        report.check(re.search(rb"more than \d+|at 65535|larger than 256 MiB", result.stderr), f"{many} lines: no limit is named")
    report.equal("files left", ["long.nff"], sorted(path.name for path in directory.iterdir()))


def main(simulator):
    report = Report()
    for check in (check_scenes, check_files, check_options, check_long_file):
        with tempfile.TemporaryDirectory() as directory:
            check(simulator, pathlib.Path(directory), report)
    return report.finish()


sys.exit(main(sys.argv[1]))
