"""Runs an image in an emulator and counts: instructions by region and function, and what the image prints."""
import collections
import os
import pathlib
import re
import tempfile
import typing

from images import HERE, Failure, TARGETS, execute

MARKS = ("bench_mark_other", "bench_mark_setup", "bench_mark_strips")
REGIONS = {1: "setup", 2: "strips"}


class Counts(typing.NamedTuple):
    """`instructions` and `functions` by region; None when the limit was reached. `printed`: what the image said."""
    instructions: typing.Optional[dict]
    functions: dict
    printed: dict
    cycles: typing.Optional[dict] = None


def symbols_of(prefix, image):
    """[(address, name)] of the functions of an image, in order."""
    symbols = {}
    for line in execute([f"{prefix}nm", "-n", image]).splitlines():
        match = re.fullmatch(r"([0-9a-f]+) [tTwW] (\S+)", line)
        if match and not match.group(2).startswith("$"):
            symbols[int(match.group(1), 16)] = match.group(2)
    return sorted(symbols.items())


def plugin(work):
    """The counting plug-in, compiled."""
    source, made = HERE / "count_plugin.c", pathlib.Path(work) / "count_plugin.so"
    if not made.exists() or made.stat().st_mtime < source.stat().st_mtime:
        fresh = made.with_suffix(f".{os.getpid()}")
        execute(["gcc", "-std=gnu99", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared", "-fvisibility=hidden",
                 source, "-o", fresh])
        fresh.rename(made)
    return made


def read_printed(text):
    """{name: value} of lines `name value`."""
    return dict(re.findall(r"^(crc|ram_bytes|stack_bytes) (\S+)$", text, re.MULTILINE))


def run_on_host(image):
    return read_printed(execute([image], 600))


def count(target_name, image, work, limit=None, by_function=False, seconds=600):
    target = TARGETS[target_name]
    symbols = symbols_of(target.prefix, image)
    addresses = {name: address for address, name in symbols}
    missing = [mark for mark in MARKS if mark not in addresses]
    if missing:
        raise Failure(f"{image} has no symbol {missing[0]}")
    with tempfile.TemporaryDirectory() as place:
        out, table = pathlib.Path(place) / "counts", pathlib.Path(place) / "symbols"
        arguments = [str(plugin(work)), f"out={out}"] + [f"region={addresses[mark]:x}" for mark in MARKS]
        if by_function:
            table.write_text("".join(f"{address:x} {name}\n" for address, name in symbols))
            arguments.append(f"symbols={table}")
        if limit:
            arguments.append(f"limit={limit}")
        emulator = list(target.run)
        emulator[1:1] = [target.plugin, ",".join(arguments)]
        printed = execute([*emulator, image], seconds)
        if not out.exists():
            raise Failure(f"the emulator counted nothing: {printed.strip() or emulator[0]}")
        lines = [line.split() for line in out.read_text().splitlines()]
    if ["limit"] in lines:
        return Counts(None, {}, {})
    instructions, functions = {}, collections.defaultdict(dict)
    for words in lines:
        region = REGIONS.get(int(words[1]))
        if region and words[0] == "region":
            instructions[region] = int(words[2])
        elif region:
            functions[region][words[2]] = functions[region].get(words[2], 0) + int(words[3])
    return Counts(instructions, dict(functions), read_printed(printed))
