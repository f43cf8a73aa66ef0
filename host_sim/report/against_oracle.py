"""Accuracy against the oracle: every scene, every shadow rule, every depth format."""
import json
import math
import pathlib
import subprocess
import sys

SCENES = pathlib.Path(__file__).resolve().parents[1] / "scenes"
SHADOWED = ("s1", "s1r", "box", "flake")
RULES = ("exact", "residual", "epsilon=0.0001", "epsilon=0.001", "epsilon=0.01", "epsilon=0.1", "none")
FORMATS = ("e2m14", "e3m13", "e4m12", "linear", "inverse", "half")

TEXT = """## Accuracy of every scene, default rules

Every figure is against the oracle (docs/SPEC.md, section 9), at 240x240.

{scenes}

Rounding to 8 bits costs 0.5 at most and 0.29 on average over evenly spread values. Depth: the worst relative error of z
as a power of two; the format is chosen by the scene's depth range.

## Self-shadowing

How a shadow segment leaves its surface (`compare --offset`). False shadows: lit in truth, dark in the picture (acne).
Leaks: dark in truth, lit in the picture (light seeping under contacts). Both per million pixels times lights.

{shadows}

The exact rule has neither, with nothing to tune. The residual rule moves a rounded point by at most sqrt(3) grid
units and is as good on these scenes; an occluder closer than that may be missed, which is the proved bound of its leaks
(a unit is 2^-29 to 2^-30 of the distance to the farthest geometry). A fixed epsilon trades one fault for
the other: small ones fall below the rounding of far points in other arithmetic, large ones leak at every contact and
edge. (Points are rounded here on a grid of about 2^-29 of the scene, so small epsilons look better than they do in float.)

## 16-bit depth

Largest relative error of z, as a power of two, over far/near ratios (`fixcast depths`). A format whose range is too
small for the ratio saturates: its figure is near 0.

{depths}

Wrong pixels of a z-buffer of that format alone, first come first kept (`compare --depth-format`), on
`fight.nff`: cards 4 to 4000 units away with gaps of 2^-8 to 2^-15 of the distance. fixcast itself has 0 with every
format, as equal codes are settled exactly.

{fights}
"""


def compare(simulator, scene, *options):
    arguments = [simulator, "compare", str(SCENES / f"{scene}.nff"), "--size", "240x240", "--json", *options]
    return json.loads(subprocess.run(arguments, check=True, stdout=subprocess.PIPE, text=True).stdout)


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def power_of_two(error):
    return f"2^{math.log2(error):.2f}" if error else "0"


def measure(simulator):
    """All that the sections say, as JSON takes it."""
    names = sorted(path.stem for path in SCENES.glob("*.nff"))
    steps = len(names) + len(SHADOWED) * len(RULES) + len(FORMATS)
    done = 0

    def ask(*arguments):
        nonlocal done
        done += 1
        if sys.stderr.isatty():
            print(f"\rreport: frame {done} of {steps}", end="\n" if done == steps else "", file=sys.stderr, flush=True)
        return compare(simulator, *arguments)

    return {
        "scenes": {name: ask(name) for name in names},
        "shadows": {rule: {scene: ask(scene, "--offset", rule) for scene in SHADOWED} for rule in RULES},
        "fights": {name: ask("fight", "--depth-format", name)["wrong_order"] for name in FORMATS},
        "depths": subprocess.run([simulator, "depths"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()[1:],
    }


def sections(measured):
    scenes = [(name, c["crc32"], c["wrong_id"], c["wrong_shadow"], f"{c['colour_max']:.3f}", f"{c['colour_rmse']:.3f}",
               power_of_two(c["depth_rel_max"])) for name, c in measured["scenes"].items()]
    shadows = [(rule, *(f"{c['false_shadow_ppm']:.0f} / {c['leak_ppm']:.0f}" for c in found.values()))
               for rule, found in measured["shadows"].items()]
    head, *lines = measured["depths"]
    return TEXT.format(
        scenes=table(["scene", "CRC-32", "wrong ids", "wrong shadows", "colour max", "colour rmse", "depth"], scenes),
        shadows=table(["rule: false shadows / leaks", *SHADOWED], shadows),
        depths=table(head.split(), [line.split() for line in lines]),
        fights=table(["format", "wrong pixels of 57600"], list(measured["fights"].items())))
