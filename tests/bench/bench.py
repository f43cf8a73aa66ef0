"""Counts what a frame costs on a chip: instructions a pixel, and which functions they go to.

bench.py --scene s1 --target m0plus --renderer fixcast --profile-functions

builds that one image, runs it in an emulator, checks its picture against the host's and prints the counts, which are the
same on every run. More than one --scene, --size, --target, --opt or --renderer may be given, separated by commas.
"""
import argparse
import collections
import itertools
import json
import pathlib
import re
import sys

import bench_scenes
import counting
import images
import linkmap
from images import Failure, Image, ROOT, RENDERERS, TARGETS
from plan import PROFILES

OPTS = ("-O2", "-Os", "-O3")


def list_of(names):
    """A type for argparse: a comma-separated list of these names."""
    def read(text):
        words = text.split(",")
        for word in words:
            if word not in names:
                raise argparse.ArgumentTypeError(f"'{word}' is none of {', '.join(names)}")
        return words
    return read


def size_of(text):
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    if not match or not all(1 <= int(number) <= 4096 for number in match.groups()):
        raise argparse.ArgumentTypeError(f"'{text}' is not a size such as 128x128")
    return int(match.group(1)), int(match.group(2))


def opt_of(text):
    if "-" + text.lstrip("-") not in OPTS:
        raise argparse.ArgumentTypeError(f"'{text}' is none of O2, Os, O3")
    return "-" + text.lstrip("-")


def function_table(by_region, pixels, rows):
    """The functions that most instructions or cycles go to, with their share of the frame."""
    sums = collections.Counter()
    for functions in by_region.values():
        sums.update(functions)
    whole = sum(sums.values())
    lines = [f"  {'a pixel':>10} {'share':>6}  function (set-up included)"]
    for name, spent in sums.most_common(rows):
        lines.append(f"  {spent / pixels:10.2f} {100 * spent / whole:5.1f}%  {name}")
    return lines


def report(image, counts, flash, before):
    """One image's figures, for people."""
    pixels = image.width * image.height
    total = sum(counts.instructions.values())
    change = f" ({100 * (total / before - 1):+.2f} % since the last run)" if before else ""
    cycles = f", {sum(counts.cycles.values()) / pixels:.2f} cycles" if counts.cycles else ""
    return (f"{image.name()}: {total / pixels:.2f} instructions{cycles} a pixel{change}\n"
            f"  set-up {counts.instructions['setup']}, strips {counts.instructions['strips']} instructions; "
            f"flash {flash['core']} + libgcc {flash['libgcc']}, ram {counts.printed.get('ram_bytes')}, "
            f"stack {counts.printed.get('stack_bytes')} bytes; crc {counts.printed.get('crc')}")


def measure(workshop, image, options, last):
    """Counts one image and prints it; whether its picture is right."""
    built = workshop.build(image)
    reference, _, _ = workshop.build(image._replace(target="host", opt="-O2"))
    limit = options.limit or (300_000_000 if image.target == "rp2040" else 5_000_000_000)
    counts = counting.count(image.target, built, workshop.work, limit)
    if counts.instructions is None:
        print(f"{image.name()}: gave up after {limit} instructions; --limit raises that")
        return True
    flash = linkmap.flash(linkmap.read(built[1]), built[2], workshop.work)
    print(report(image, counts, flash, last.get(image.name())))
    last[image.name()] = sum(counts.instructions.values())
    if options.profile_functions:
        print("\n".join(function_table(counts.function_cycles or counts.functions, image.width * image.height,
                                       options.rows)))
    host = counting.run_on_host(reference)
    right = counts.printed.get("crc") == host.get("crc")
    if not right:
        print(f"{image.name()}: the picture is wrong: on the host its crc is {host.get('crc')}")
    return right


def quick(options):
    """Counts images one after the other and prints them."""
    work = pathlib.Path(options.work)
    files = [scene for scene in options.scene if pathlib.Path(scene).suffix]
    workshop = images.Workshop(work, bench_scenes.Scenes(work, options.simulator, files), options.source)
    seen = work / "last.json"
    last = json.loads(seen.read_text()) if seen.exists() else {}
    scenes = [bench_scenes.name_of(scene) for scene in options.scene]
    todo = itertools.product(scenes, options.size, options.target, options.opt, options.renderer)
    right = [measure(workshop, Image(target, renderer, scene, *size, opt, PROFILES.index(options.profile)), options, last)
             for scene, size, target, opt, renderer in todo]
    seen.write_text(json.dumps(last))
    return 0 if all(right) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    chips = [name for name in TARGETS if name != "host"]
    parser.add_argument("--scene", type=lambda text: text.split(","), default=["s1"], metavar="NAME",
                        help="of host_sim/scenes or of the bench, or a scene file")
    parser.add_argument("--size", type=lambda text: [size_of(word) for word in text.split(",")], default=[(128, 128)],
                        metavar="WxH")
    parser.add_argument("--target", type=list_of(chips), default=["m0plus"], metavar="NAME", help=", ".join(chips))
    parser.add_argument("--opt", type=lambda text: [opt_of(word) for word in text.split(",")], default=["-O2"],
                        metavar="LEVEL", help="O2, Os, O3")
    parser.add_argument("--renderer", type=list_of(RENDERERS), default=["fixcast"], metavar="NAME",
                        help=", ".join(RENDERERS))
    parser.add_argument("--profile", choices=PROFILES, default=PROFILES[0], metavar="NAME", help=", ".join(PROFILES))
    parser.add_argument("--profile-functions", action="store_true", help="also print where the instructions go")
    parser.add_argument("--rows", type=int, default=25, metavar="N", help="of that table")
    parser.add_argument("--limit", type=int, metavar="N",
                        help="give up after N instructions; default: what takes about ten seconds")
    parser.add_argument("--source", default=ROOT, metavar="DIR", help="the tree whose core is measured")
    parser.add_argument("--work", default=ROOT / "build/bench", metavar="DIR")
    parser.add_argument("--simulator", default=ROOT / "build/fixcast", metavar="FILE")
    options = parser.parse_args()
    try:
        return quick(options)
    except Failure as failure:
        print(f"bench: {failure}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
