"""Counts the frames of recorded.txt again and fails when one takes more than 3 % more instructions than it says there.

recorded.py --simulator FILE [--work DIR] [--update]
recorded.py --simulator FILE [--work DIR] --self-test   proves that growth, a wrong picture and a bad file are noticed

A line of recorded.txt: scene size target opt renderer profile instructions compiler.
"""
import argparse
import json
import re
import sys
import typing

import accuracy
import bench_scenes
import counting
import images
from images import Failure, HERE, Image, TARGETS, execute
from plan import PROFILES

FILE = HERE / "recorded.txt"
HEAD = """# Instructions of a frame, set-up included: scene size target opt renderer profile instructions compiler.
# `make bench-update` rewrites this file; say in the commit why the figures changed.
"""
TOLERANCE = 1.03
LIMIT = 20_000_000_000


class Record(typing.NamedTuple):
    image: Image
    instructions: int
    compiler: str

    def line(self):
        image = self.image
        return (f"{image.scene} {image.width}x{image.height} {image.target} {image.opt.strip('-')} {image.renderer} "
                f"{PROFILES[image.profile]} {self.instructions} {self.compiler}\n")


def read(text):
    records = []
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        match = re.fullmatch(r"(\w+) (\d+)x(\d+) (\w+) (O\w) ([\w-]+) (\w+) (\d+) (\S+)", line)
        if not match or match.group(7) not in PROFILES:
            raise Failure(f"{FILE}:{number}: not a recorded figure: {line}")
        scene, width, height, target, opt, renderer, profile, instructions, compiler = match.groups()
        image = Image(target, renderer, scene, int(width), int(height), f"-{opt}", PROFILES.index(profile))
        records.append(Record(image, int(instructions), compiler))
    if not records:
        raise Failure(f"{FILE} records nothing")
    return records


def count(workshop, image):
    """The image's Record of today; its picture must be the host's."""
    built = workshop.build(image)
    counts = counting.count(image.target, built, workshop.work, LIMIT)
    if counts.instructions is None:
        raise Failure(f"{image.name()}: more than {LIMIT} instructions")
    program, _, _ = workshop.build(image._replace(target="host", opt="-O2"))
    crc, right = counts.printed.get("crc"), counting.run_on_host(program).get("crc")
    if crc is None or crc != right:
        raise Failure(f"{image.name()}: a wrong picture: CRC {crc}, on the host {right}")
    compiler = f"{TARGETS[image.target].prefix}gcc"
    return Record(image, sum(counts.instructions.values()), f"{compiler}-{workshop.version(compiler).strip()}")


def comparison(old, new):
    """One sentence."""
    pixels = old.image.width * old.image.height
    change = 100 * (new.instructions / old.instructions - 1)
    text = (f"{old.image.name()}: {new.instructions / pixels:.2f} instructions a pixel, {change:+.2f} % against the "
            f"recorded {old.instructions / pixels:.2f}")
    if new.compiler != old.compiler:
        text += f" (recorded with {old.compiler}, this is {new.compiler})"
    return text


def verdict(old, new):
    """(whether it is within the tolerance, a sentence that says what to do)."""
    text = comparison(old, new)
    if new.instructions > old.instructions * TOLERANCE:
        return False, text + "; more than 3 % slower: find out why, or record it with `make bench-update`"
    if new.instructions * TOLERANCE < old.instructions:
        text += "; faster: `make bench-update` records it, so that it stays"
    return True, text


def check(workshop, records):
    good = True
    for old in records:
        within, text = verdict(old, count(workshop, old.image))
        print(text)
        good = good and within
    return 0 if good else 1


def self_test(workshop, records):
    def refused(action):
        try:
            action()
        except Failure:
            return True
        return False

    new = count(workshop, records[0].image)
    tests = {
        "the same is accepted": verdict(new, new)[0],
        "3 % more is accepted": verdict(new._replace(instructions=int(new.instructions / 1.029)), new)[0],
        "4 % more is refused": not verdict(new._replace(instructions=int(new.instructions / 1.04)), new)[0],
        "a bad line is refused": refused(lambda: read("s1 128x128 m0plus\n")),
        "an empty file is refused": refused(lambda: read("# nothing\n")),
    }
    on_host = counting.run_on_host
    counting.run_on_host = lambda image: {"crc": "0x00000000"}
    tests["a wrong picture is refused"] = refused(lambda: count(workshop, records[0].image))
    counting.run_on_host = on_host
    image = records[0].image
    whole = json.loads(execute([workshop.scenes.simulator, "compare", workshop.scenes.source(image.scene), "--size",
                                f"{image.width}x{image.height}", "--json"]))
    tests["a frame from a file is judged as the core's own"] = \
        accuracy.measure(workshop, image) == {key: whole[key] for key in accuracy.KEYS}
    for name, passed in tests.items():
        print(f"{'passed' if passed else 'FAILED'}: {name}")
    return 0 if all(tests.values()) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--simulator", required=True, metavar="FILE")
    parser.add_argument("--work", default=images.ROOT / "build/bench", metavar="DIR")
    parser.add_argument("--source", default=images.ROOT, metavar="DIR", help="the tree whose core is measured")
    parser.add_argument("--update", action="store_true", help="rewrite recorded.txt")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    try:
        workshop = images.Workshop(options.work, bench_scenes.Scenes(options.work, options.simulator), options.source)
        records = read(FILE.read_text())
        if options.self_test:
            return self_test(workshop, records)
        if options.update:
            fresh = [count(workshop, record.image) for record in records]
            FILE.write_text(HEAD + "".join(record.line() for record in fresh))
            print("".join(comparison(old, new) + "\n" for old, new in zip(records, fresh)), end="")
            return 0
        return check(workshop, records)
    except Failure as failure:
        print(f"bench: {failure}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
