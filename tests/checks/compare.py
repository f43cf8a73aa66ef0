"""The core against the oracle, on every own scene: the guarantees about wrong pixels, colour and depth.

compare.py SIMULATOR
"""
import sys

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
    return report.finish()


sys.exit(main(sys.argv[1]))
