"""Writes docs/REPORT.md and its plots from build/bench/bench.json and the oracle: `fixcast report`, `make report`.

Says what to run where bench.json is missing or was measured from other sources than this tree's.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys

import against_oracle
import advice
import bars
import methods
import rows as bench
import stages
import wire
from against_oracle import table

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/bench"))
import measured  # noqa: E402 - the bench's own note of what it measured

SYSTEM_PYTHON = "/usr/bin/python3"  # the one that Debian's python3-matplotlib belongs to


def by_package(python):
    """Starts over with the system's Python, where another one comes first in PATH; does not come back then."""
    if os.access(python, os.X_OK) and os.path.realpath(python) != os.path.realpath(sys.executable):
        os.execv(python, [python, *sys.argv])


TEXT = """# What it costs and how exact it is, measured

Written by `make report` from `make bench`; nothing here is written by hand. The core that was counted: {core}.
Instructions are counted in QEMU, cycles in an emulator of the RP2040; gcc -O2, 16-row strips, set-up included, 128x128
unless said. tests/bench holds the harness and the other renderers.

## Which profile to use

{advice}

Instructions are not seconds: an RP2040 takes about {measured_cycles} cycles for one. A frame that must be the same on every chip and
build, or exact at every scale, is what `exact` is for; a chip with an FPU that needs neither has faster ways.

## Bars and aims

A bar is what a release must meet, an aim what is worth having (tests/bench/bars.json).
{missed}

{bars}

![Measured figures against bars and aims]({plots}/bars.svg)

## Speed against error

Every renderer and profile on each chip. On the blue line is what nothing else beats in both; what is pale is beaten.

![S1: instructions a pixel against wrong pixels]({plots}/wrong-s1.svg)

![S1: instructions a pixel against colour error]({plots}/colour-s1.svg)

S1r is S1 seen askew, without a level horizon or round numbers.

![S1r: instructions a pixel against wrong pixels]({plots}/wrong-s1r.svg)

![S1r: instructions a pixel against colour error]({plots}/colour-s1r.svg)

S2 is 1016 triangles, unlit: the rivals are rasterisers.

![S2: instructions a pixel against wrong pixels]({plots}/wrong-s2.svg)

{speed}

## Cost by stage

Instructions a pixel by what they are for, found from the functions that they are in{by_file}. What the compiler inlined
counts where it was inlined. Long arithmetic: products, quotients and copies of more than a word, which several
stages ask for.

![Instructions a pixel by stage]({plots}/stages.svg)

{stages}

## Cost against primitives and pixels

Spheres under a light with hard shadows on a plane; triangles of a height field in final colours as a rasteriser draws
them, and lit, with hard shadows. A curve ends where the bench's limit of instructions was reached.

![Instructions a pixel against primitives]({plots}/primitives.svg)

![Instructions a pixel against the size of the frame]({plots}/sizes.svg)

## Memory

Flash: the core, its tables and the compiler's helpers that it calls, without the scene; by what the scene names.
RAM: what the frame keeps beyond a strip's pixels and depth. Stack: the most that was used.

![Flash, RAM and stack]({plots}/memory.svg)

{memory}

## The wire

Frames a second that the display's bus takes at 16 bits a pixel, and that the chip draws; the smaller one is what is seen,
with DMA sending one strip while the next is drawn. Cycles are the RP2040's where a row says "measured"; elsewhere
Cortex-M0+ instructions at an assumed {cycles} cycles each. Two cores are inferred, not run: strips halved, set-up not.

![Frames a second: bus and chip]({plots}/wire.svg)

{wire}

## The lectures' methods compared

Pixels of a wrong object at 128x128, each method on the same rays and triangles, against exact visibility (tests/rivals); "-" where a scene has nothing for a
method.

{rivals}

What seeing alone costs, in instructions a pixel: the methods in float (software on these chips) with scene and unit directions at hand, closest hit a
pixel for spheres and triangles, the others for triangles; ours exact, set-up included, drawn without lights. The methods are textbook loops that ask each
pixel of a polygon's box; a float rasteriser that steps along rows is in S2's table above. Each chip's picture is, primitive for primitive, the one judged
above.

{methods}

{accuracy}"""


def number(value, digits=0):
    return "-" if value is None else f"{value:.{digits}f}"


def bar_table(judged):
    def text(value):
        return "-" if value is None else str(value) if isinstance(value, int) else f"{value:.2f}" if value < 10 else \
            f"{value:.1f}"
    lines = []
    for bar, value, verdict in judged:
        shown = "over the bench's limit" if value is None and verdict == "MISSED" else text(value)
        lines.append((bar["what"], bar["unit"], bar["bar"], bar["aim"], shown,
                      f"**{verdict}**" if verdict == "MISSED" else verdict))
    return table(["", "unit", "bar", "aim", "measured", "verdict"], lines)


def missed_line(judged):
    count = {verdict: sum(found == verdict for _, _, found in judged) for verdict in bars.VERDICTS}
    return (f"Of {len(judged)}: {count['aim met']} meet their aim, {count['bar met']} their bar, {count['MISSED']} miss it, "
            f"{count['not measured']} not measured.")


def speed_table(rows):
    lines = []
    for scene in ("s1", "s1r", "s2"):
        for target in bench.TARGETS:
            for row in bench.find(rows, scene=scene, target=target):
                lines.append((bench.SCENES[scene], bench.TARGETS[target], bench.name_of(row),
                              number(row["instructions_per_pixel"], 1), number(bench.wrong(row)),
                              number(row["colour_rmse"], 2), number(row["colour_max"], 1), number(row["flash_bytes"])))
    return table(["scene", "chip", "renderer", "instructions a pixel", "wrong pixels", "colour rmse", "colour max", "flash"],
                 lines)


def stage_table(rows):
    lines = []
    for scene in ("s1b", "s1", "s1r", "s5s64", "s2", "s5f21", "s4"):
        for target in ("m0plus", "m3"):
            row = bench.one(rows, scene=scene, target=target)
            if row and row["stages"]:
                found = stages.by_stage(row)
                lines.append((scene, bench.TARGETS[target], *(f"{share:.1f}" for share in found.values()),
                              f"{sum(found.values()):.1f}"))
    return table(["scene", "chip", *stages.STAGES, "all"], lines)


def memory_table(rows):
    lines = []
    for scene, what in (("s1b", "spheres"), ("s1", "spheres and planes"), ("s2", "triangles"), ("s4", "triangles, shadows")):
        for target in bench.TARGETS:
            found = [bench.one(rows, scene=scene, target=target, opt=opt) for opt in ("O2", "Os", "O3")]
            if found[0]:
                lines.append((f"{scene}: {what}", bench.TARGETS[target],
                              *(number(row and row["flash_bytes"]) for row in found), number(found[0]["ram_bytes"]),
                              number(found[0]["stack_bytes"])))
    return table(["scene", "chip", "flash -O2", "flash -Os", "flash -O3", "RAM", "stack"], lines)


def wire_table(rows):
    lines = []
    for display in wire.DISPLAYS:
        for scene, name in bench.SCENES.items():
            frames = [wire.drawn(rows, display, scene, clock, cores) for clock, cores in wire.CHIPS]
            if frames[0]:
                limit = wire.bus_frames(display)
                holds = next((f"{clock} MHz, {cores} core{'s' if cores > 1 else ''}"
                              for (clock, cores), found in zip(wire.CHIPS, frames) if found[0] >= limit), "none of these")
                lines.append((f"{display.width}x{display.height} {display.name}, {display.mhz:g} MHz", f"{limit:.1f}", name,
                              *(f"{found[0]:.1f}" for found in frames), holds, frames[0][1]))
    return table(["display", "bus", "scene", *(f"{clock} MHz, {cores} core{'s' if cores > 1 else ''}"
                                               for clock, cores in wire.CHIPS), "keeps up with the bus", "cycles"], lines)


def write(rows, core, accuracy, plots, rivals, counted):
    judged = bars.judged(rows)
    by_function = all(row.get("functions") for row in bench.ours(rows) if row["stages"])
    return TEXT.format(core=core, advice=advice.text(rows), cycles=wire.CYCLES_AN_INSTRUCTION,
                       measured_cycles=wire.cycles_an_instruction(rows), missed=missed_line(judged),
                       bars=bar_table(judged), speed=speed_table(rows), stages=stage_table(rows),
                       by_file="" if by_function else " (here by their files, which is coarser)",
                       memory=memory_table(rows), wire=wire_table(rows), plots=plots, rivals=methods.wrong_table(rivals),
                       methods=methods.cost_table(counted, rivals, measured.digest(ROOT)),
                       accuracy=against_oracle.sections(accuracy))


def core_of(bench_file, stale_allowed):
    """Which core was measured, in words; Unusable when it is not this tree's."""
    taken = measured.read(bench_file)
    name = f"commit {taken['commit']}" if taken.get("commit") else "one without a commit"
    if taken.get("digest") == measured.digest(ROOT):
        return name
    if not stale_allowed:
        raise bench.Unusable(f"{bench_file} was measured from other sources than this tree's: run `make bench` "
                             "(10 to 20 minutes), then this again; --stale reports the old figures as such")
    return f"{name}; core, scenes or harness have changed since"


def oracle_figures(options):
    if options.accuracy:
        return json.loads(pathlib.Path(options.accuracy).read_text(encoding="utf-8"))
    return against_oracle.measure(options.simulator)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--simulator", default=ROOT / "build/fixcast", metavar="FILE")
    parser.add_argument("--bench", default=ROOT / "build/bench/bench.json", metavar="FILE", help="what `make bench` wrote")
    parser.add_argument("--output", default=ROOT / "docs/REPORT.md", metavar="FILE",
                        help="plots go to a directory of that name beside it, in small letters")
    parser.add_argument("--stale", action="store_true", help="take figures of other sources too, and say so")
    parser.add_argument("--rivals", default=ROOT / "build/rivals.json", metavar="FILE", help="what the test `rivals` wrote")
    parser.add_argument("--methods", default=ROOT / "build/bench/methods.json", metavar="FILE", help="what tests/bench/methods.py counted")
    parser.add_argument("--no-plots", action="store_true", help="the text alone; needs no matplotlib")
    parser.add_argument("--accuracy", metavar="FILE", help="JSON to use instead of asking the oracle; for tests")
    options = parser.parse_args()
    output = pathlib.Path(options.output)
    plots = output.with_suffix("").with_name(output.stem.lower())
    try:
        rows = bench.load(options.bench)
        core = core_of(options.bench, options.stale)
        if not options.no_plots:
            try:
                import plots as pictures
            except ImportError:
                by_package(SYSTEM_PYTHON)
                raise bench.Unusable("there is no matplotlib: `.ci/install report` installs it") from None
            pictures.draw(rows, plots)
        text = write(rows, core, oracle_figures(options), plots.name, methods.read(options.rivals), methods.read(options.methods))
    except (bench.Unusable, OSError, subprocess.CalledProcessError) as why:
        print(f"report: {why}", file=sys.stderr)
        return 2
    fresh = output.with_name(output.name + ".tmp")
    fresh.write_text(text, encoding="utf-8")
    os.replace(fresh, output)
    print(f"wrote {output}" + ("" if options.no_plots else f" and {plots}/*.svg"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
