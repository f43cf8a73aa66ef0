"""The core against the oracle, on every own scene: the guarantees about wrong pixels, colour and depth.

compare.py SIMULATOR
"""
import pathlib
import sys
import tempfile

from support import SCENES, Report, fixcast_json, scene_names

# Half a step of the depth format with 13 mantissa bits, and a little for the rounding of what goes into it.
DEPTH_LIMIT = 1.02 * 2**-14
# From 80-digit arithmetic: the exact picture of S1 at 128x128.
S1_PIXELS = {"0": 8150, "1": 1074, "2": 1036, "3": 878, "4": 5246}
S1_UNLIT = 1171
SCALES = ("1/64", "1/16", "1/4", "4", "16", "64")


def check_scene(simulator, scene, report):
    path = SCENES / f"{scene}.nff"
    small = fixcast_json(simulator, "compare", path, "--size", "128x128")
    print(f"{scene} 128x128: {small}", flush=True)
    report.equal(f"{scene} 128x128 wrong_id", 0, small["wrong_id"])
    report.equal(f"{scene} 128x128 wrong_shadow", 0, small["wrong_shadow"])
    report.at_most(f"{scene} 128x128 colour_max", 1.0, small["colour_max"])
    if scene in ("s1", "s1r"):
        report.at_most(f"{scene} 128x128 colour_rmse", 0.35, small["colour_rmse"])
        report.at_most(f"{scene} 128x128 depth_rel_max", DEPTH_LIMIT, small["depth_rel_max"])
    if scene == "s1":
        report.equal("s1 128x128 pixels_by_id", S1_PIXELS, small["pixels_by_id"])
        report.equal("s1 128x128 unlit_pixels", S1_UNLIT, small["unlit_pixels"])

    large = fixcast_json(simulator, "compare", path, "--size", "240x240")
    print(f"{scene} 240x240: {large}", flush=True)
    report.equal(f"{scene} 240x240 wrong_id", 0, large["wrong_id"])
    report.equal(f"{scene} 240x240 wrong_shadow", 0, large["wrong_shadow"])
    report.at_most(f"{scene} 240x240 colour_max", 1.0, large["colour_max"])


def check_world_scale(simulator, report):
    path = SCENES / "s1.nff"
    crc = fixcast_json(simulator, "render", path, "--size", "128x128")["crc32"]
    for scale in SCALES:
        scaled = fixcast_json(simulator, "render", path, "--size", "128x128", "--world-scale", scale)
        report.equal(f"CRC of s1 with --world-scale {scale}", crc, scaled["crc32"])


def check_rules(simulator, report):
    """The knobs that show a fault do show it, and the oracle sees it."""
    s1, fight = SCENES / "s1.nff", SCENES / "fight.nff"

    def shadows(rule):
        c = fixcast_json(simulator, "compare", s1, "--size", "128x128", "--offset", rule)
        return c["wrong_shadow"], c["false_shadow_ppm"] > 0, c["leak_ppm"] > 0

    report.equal("s1 --offset exact", (0, False, False), shadows("exact"))
    report.equal("s1 --offset residual", (0, False, False), shadows("residual"))
    report.equal("s1 --offset epsilon=0.002: wrong shadows", 5, shadows("epsilon=0.002")[0])
    report.equal("s1 --offset epsilon=0.1 has false shadows and leaks", (True, True), shadows("epsilon=0.1")[1:])
    report.equal("s1 --offset none has acne and no leaks", (True, False), shadows("none")[1:])

    order = {name: fixcast_json(simulator, "compare", fight, "--size", "64x64", "--depth-format", name)
             for name in ("e2m14", "e4m12", "inverse")}
    report.equal("fight: fixcast itself is right", [0, 0, 0], [c["wrong_id"] for c in order.values()])
    report.equal("fight: e4m12 alone confuses some cards, 1/z in equal steps more", True,
                 0 < order["e4m12"]["wrong_order"] < order["inverse"]["wrong_order"] < order["e2m14"]["wrong_order"])


def glowing(mirrors, bounces):
    """S1 without light: things glow in colours of their own, so a pixel's colour says what is seen at the end of its path; `mirrors` by object show only others."""
    things = {1: ("0.9 0.25 0.1", "s 0 1 -6 1"), 2: ("0.1 0.75 0.3", "s -1.75 0.75 -4.5 0.75"), 3: ("0.25 0.1 0.9", "s 1.25 0.5 -3 0.5"),
              4: ("0.75 0.75 0.6", "#fc: plane 0 1 0 0"), 5: ("0.6 0.6 0.1", "s 0.2 0.5 -3.5 0.5")}
    lines = ["v", "from 0 1.5 1", "at 0 1.5 0", "up 0 1 0", "angle 53.13010235", "hither 0.01", "resolution 128 128", "#fc: tan_half_fov 1/2",
             "b 0.35 0.55 0.95", "#fc: ambient 1"]
    for number, (colour, shape) in things.items():
        lines += [f"#fc: object {number}", f"f {'0 0 0' if number in mirrors else colour} 1 0 0 0 1"]
        lines += [f"#fc: mirror 1 1 1 {bounces}"] * (number in mirrors) + [shape]
    return "\n".join(lines) + "\n"


def check_mirrors(simulator, report):
    """What is seen in mirrors, in one bounce by a plane and in four between balls: with glowing things a colour that is off by more than rounding is a wrong thing, and there
    is none (the bar: 100 in a million pixels)."""
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory, "mirrors.nff")
        crcs = set()
        for name, mirrors, bounces in (("no mirror", (), 1), ("a plane mirror", (4,), 1), ("balls", (1, 2, 5), 4), ("all but a ball", (1, 2, 4, 5), 4),
                                       ("all but a ball, once", (1, 2, 4, 5), 1)):
            path.write_text(glowing(mirrors, bounces))
            for size in ("128x128", "97x61"):
                found = fixcast_json(simulator, "compare", path, "--size", size)
                report.equal(f"{name}, {size}: wrong ids and shadows", (0, 0), (found["wrong_id"], found["wrong_shadow"]))
                report.at_most(f"{name}, {size}: worst colour", 0.501, found["colour_max"])
            crcs.add(found["crc32"])
        report.equal("different pictures by mirrors and bounces", 5, len(crcs))


def check_profiles(simulator, report):
    """What a profile gives up is what it says, against the oracle; what it keeps is right."""
    def errors(scene, profile, size):
        return fixcast_json(simulator, "compare", SCENES / f"{scene}.nff", "--size", size, "--profile", profile)

    for scene in ("s1", "s1r", "s2", "box"):
        fast = errors(scene, "fast", "128x128")
        report.equal(f"{scene} fast: wrong ids", 0, fast["wrong_id"])
        report.check(fast["wrong_shadow"] * 2000 <= 128 * 128, f"{scene} fast: {fast['wrong_shadow']} wrong shadows")
        if fast["wrong_shadow"] == 0:
            report.check(fast["colour_max"] <= 4, f"{scene} fast: a colour is {fast['colour_max']} levels off")
        both = errors(scene, "interlaced", "97x61")
        report.equal(f"{scene} interlaced: wrong pixels", (0, 0), (both["wrong_id"], both["wrong_shadow"]))
        report.check(both["colour_max"] <= 1, f"{scene} interlaced: a colour is {both['colour_max']} levels off")

        def picked(profile, x, y):
            return fixcast_json(simulator, "pick", SCENES / f"{scene}.nff", x, y, "--size", "65x65", "--profile", profile)

        # of an odd size the sample is the block's first pixel
        for x, y in ((0, 0), (33, 41), (64, 64)):
            report.equal(f"{scene} half: pick {x} {y}", picked("exact", x // 2 * 2, y // 2 * 2), picked("half", x, y))
    half = errors("s1", "half", "128x128")
    report.check(0 < half["wrong_id"] < 128 * 128 / 20, f"s1 half: {half['wrong_id']} wrong ids, which is not what it gives up")


def main(simulator):
    report = Report()
    for scene in scene_names():
        check_scene(simulator, scene, report)
    check_world_scale(simulator, report)
    check_rules(simulator, report)
    check_profiles(simulator, report)
    check_mirrors(simulator, report)
    return report.finish()


sys.exit(main(sys.argv[1]))
