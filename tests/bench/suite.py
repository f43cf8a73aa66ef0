"""`make bench`: every renderer on every scene and chip, counted and judged by the oracle, into one JSON file.

suite.py [--work DIR] [--simulator FILE] [--only WORD...]

Prints a table and writes DIR/bench.json. What takes more instructions than the limit is null there. A failed build, a
picture unlike the host's, or one by the exact profile that is not exact makes the exit code 1.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import threading
import time
import typing

import accuracy
import bench_scenes
import counting
import images
import linkmap
import measured
from images import Failure, RENDERERS, ROOT
from plan import PROFILES, plan

QEMU_LIMIT = 4_000_000_000
RP2040_LIMIT = 400_000_000  # a hundred times slower than QEMU
SECONDS = 120  # for one run; no image of the plan should come near
HOST_SECONDS = 0.2  # of drawing the same frame again and again, to time it


class Host(typing.NamedTuple):
    """What a renderer's program says on the host: the right CRC, its errors, seconds a frame."""
    crc: str
    errors: dict
    seconds: float


def seconds_of(program):
    """CPU seconds a frame takes on the host: of many frames in one process."""
    frames = 1
    while True:
        process = subprocess.Popen([program, str(frames)], stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            raise Failure(f"exit code {process.returncode}: {program}")
        if usage.ru_utime >= HOST_SECONDS or frames >= 4096:
            return usage.ru_utime / frames
        frames *= 4


class Suite:
    def __init__(self, workshop):
        self.workshop = workshop
        self.failures, self.lock = [], threading.Lock()

    def fail(self, image, sentence):
        with self.lock:
            self.failures.append(f"{image.name()}: {sentence}"[:800])

    def count(self, image):
        """The row of an image; what needs the host comes later."""
        row = dict(scene=image.scene, size=f"{image.width}x{image.height}", target=image.target,
                   opt=image.opt.strip("-"), renderer=image.renderer,
                   profile=PROFILES[image.profile] if RENDERERS[image.renderer].core else None,
                   instructions_per_pixel=None, cycles_per_pixel=None, flash_bytes=None, ram_bytes=None,
                   stack_bytes=None, **dict.fromkeys(accuracy.KEYS), setup_instructions=None, crc=None, stages=None,
                   functions=None, libc_bytes=None, host_ratio=None)
        try:
            built = self.workshop.build(image)
            flash = linkmap.flash(linkmap.read(built[1]), built[2], self.workshop.work)
            row.update(flash_bytes=flash["core"] + flash["libgcc"] + flash["libm"], libc_bytes=flash["libc"])
            counts = counting.count(image.target, built, self.workshop.work,
                                    RP2040_LIMIT if image.target == "rp2040" else QEMU_LIMIT, SECONDS)
        except Failure as failure:
            self.fail(image, failure)
            return row
        if counts.instructions is not None:
            pixels = image.width * image.height
            row.update(instructions_per_pixel=sum(counts.instructions.values()) / pixels,
                       setup_instructions=counts.instructions["setup"], crc=counts.printed.get("crc"),
                       stages={region: stages(functions, pixels) for region, functions in counts.functions.items()})
            if RENDERERS[image.renderer].core:
                row["functions"] = {region: per_pixel(functions, pixels) for region, functions in counts.functions.items()}
            for key in ("ram_bytes", "stack_bytes"):
                row[key] = int(counts.printed[key]) if key in counts.printed else None
            if counts.cycles:
                row["cycles_per_pixel"] = sum(counts.cycles.values()) / pixels
        return row

    def judge(self, image):
        """The Host of an image, or None where something failed."""
        try:
            errors = accuracy.measure(self.workshop, image)
            if RENDERERS[image.renderer].core and PROFILES[image.profile] == "exact" and not accuracy.exact(errors):
                self.fail(image, f"not exact: {errors}")
            program, _, _ = self.workshop.build(image)
            return Host(counting.run_on_host(program).get("crc"), errors, seconds_of(program))
        except Failure as failure:
            self.fail(image, failure)
            return None

    def complete(self, image, row, host):
        """Adds what the host says to a row that was counted."""
        row.update(host.errors)
        if row["crc"] != host.crc:
            self.fail(image, f"a wrong picture: CRC {row['crc']}, on the host {host.crc}")


def stages(functions, pixels):
    """Instructions a pixel by the file they are in."""
    sums = collections.Counter()
    for name, count in functions.items():
        sums[name.split(":")[0]] += count
    return per_pixel(sums, pixels)


def per_pixel(counts, pixels):
    """The largest first, without what rounds to nothing."""
    shares = {name: round(count / pixels, 3) for name, count in collections.Counter(counts).most_common()}
    return {name: share for name, share in shares.items() if share}


def progress(done, of, started):
    """A line on a terminal; nothing elsewhere."""
    if not sys.stderr.isatty():
        return
    left = (time.monotonic() - started) / done * (of - done) if done else 0
    print(f"\r\033[K{done} of {of}" + (f", about {left / 60:.1f} minutes left" if 0 < done < of else ""),
          end="" if done < of else "\r\033[K", file=sys.stderr, flush=True)


def run(suite, todo, jobs):
    """The rows of all images, in their order."""
    for scene in {image.scene for image in todo}:  # made here, lest two threads write the same file
        suite.workshop.scenes.kind(scene)
        suite.workshop.scenes.baked(scene)
        if suite.workshop.scenes.kind(scene) != "other":
            suite.workshop.scenes.for_rivals(scene)
    counting.plugin(suite.workshop.work)
    if any(image.target == "rp2040" for image in todo):
        counting.emulator(suite.workshop.work)
    on_host = {image: image._replace(target="host", opt="-O2") for image in todo}
    started, steps = time.monotonic(), len(todo) + len(set(on_host.values()))
    done = 0

    def step(result):
        nonlocal done
        with suite.lock:
            done += 1
            progress(done, steps, started)
        return result

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        rows = list(pool.map(lambda image: step(suite.count(image)), todo))
        # A frame that no chip finished is not worth the oracle's time.
        frames = list(dict.fromkeys(on_host[image] for image, row in zip(todo, rows) if row["crc"] is not None))
        hosts = dict(zip(frames, pool.map(lambda image: step(suite.judge(image)), frames)))
    progress(steps, steps, started)
    floats = {(frame.scene, frame.width, frame.height): host.seconds for frame, host in hosts.items()
              if frame.renderer == "float" and host is not None}
    for image, row in zip(todo, rows):
        host = hosts.get(on_host[image])
        if row["crc"] is None or host is None:
            continue
        suite.complete(image, row, host)
        base = floats.get((image.scene, image.width, image.height))
        if base:
            row["host_ratio"] = round(host.seconds / base, 2)
    return rows


def write_atomically(path, text):
    fresh = path.with_suffix(f".{os.getpid()}")
    fresh.write_text(text)
    fresh.replace(path)


def table(rows):
    head = ("scene", "size", "target", "opt", "renderer", "profile", "instr/px", "cycles/px", "flash", "ram", "stack", "ids",
            "shadows", "rmse", "max", "host/float")
    keys = ("scene", "size", "target", "opt", "renderer", "profile", "instructions_per_pixel", "cycles_per_pixel", "flash_bytes",
            "ram_bytes", "stack_bytes", "wrong_id", "wrong_shadow", "colour_rmse", "colour_max", "host_ratio")
    digits = {"instructions_per_pixel": 1, "cycles_per_pixel": 1, "colour_rmse": 2, "colour_max": 1}

    def text(row, key):
        value = row[key]
        return "-" if value is None else f"{value:.{digits[key]}f}" if key in digits else str(value)

    lines = [head] + [tuple(text(row, key) for key in keys) for row in rows]
    widths = [max(map(len, column)) for column in zip(*lines)]
    return "\n".join("  ".join(word.ljust(width) if i < 6 else word.rjust(width)
                               for i, (word, width) in enumerate(zip(line, widths))).rstrip() for line in lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", default=ROOT / "build/bench", metavar="DIR")
    parser.add_argument("--simulator", default=ROOT / "build/fixcast", metavar="FILE")
    parser.add_argument("--source", default=ROOT, metavar="DIR", help="the tree whose core is measured")
    parser.add_argument("--jobs", type=int, default=2, metavar="N")
    parser.add_argument("--only", nargs="+", default=[], metavar="WORD",
                        help="only images of these scenes, targets or renderers, into part.json")
    options = parser.parse_args()
    work = pathlib.Path(options.work)
    try:
        workshop = images.Workshop(work, bench_scenes.Scenes(work, options.simulator), options.source, jobs=1)
        suite = Suite(workshop)
        todo = plan()
        if not any("fc_render_rows_by_rays" in path.read_text() for path in workshop.source.glob("include/**/*.h")):
            todo = [image for image in todo if image.renderer != "fixcast-rays"]
        for kind in ("scene", "target", "renderer"):
            words = {word for word in options.only if word in {getattr(image, kind) for image in plan()}}
            todo = [image for image in todo if not words or getattr(image, kind) in words]
        taken = measured.note(options.source)
        rows = run(suite, todo, options.jobs)
    except Failure as failure:
        print(f"bench: {failure}", file=sys.stderr)
        return 2
    out = work / ("part.json" if options.only else "bench.json")
    write_atomically(out, json.dumps(rows, indent=1) + "\n")
    if not options.only:
        measured.write(out, taken)
    print(table(rows))
    print("-: more instructions than the limit allows, or not known there")
    for sentence in suite.failures:
        print(f"FAIL: {sentence}")
    print(f"{len(rows)} rows, {len(suite.failures)} failures, written to {out}")
    return 1 if suite.failures else 0


if __name__ == "__main__":
    sys.exit(main())
