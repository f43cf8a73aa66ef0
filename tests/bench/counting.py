"""Runs an image in an emulator and counts: instructions by region and function, and what the image prints."""
import collections
import os
import pathlib
import re
import sys
import tempfile
import typing

import linkmap
from images import HERE, ROOT, Failure, TARGETS, execute

sys.path.insert(0, str(ROOT / "src/port/tools"))
import boards  # noqa: E402
import rp2040js  # noqa: E402

MARKS = ("bench_mark_other", "bench_mark_setup", "bench_mark_strips")
NAME_LENGTH = 190  # what the plug-in reads of a name; those of C++ are longer, and shortened may share a count
REGIONS = {1: "setup", 2: "strips"}


class Counts(typing.NamedTuple):
    """By region: instructions, cycles (where the emulator knows them) and the same by function, named file:function.
    None: the limit was reached. `printed`: what the image said."""
    instructions: typing.Optional[dict] = None
    functions: typing.Optional[dict] = None
    cycles: typing.Optional[dict] = None
    function_cycles: typing.Optional[dict] = None
    printed: typing.Optional[dict] = None


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
        execute(["gcc", "-std=gnu99", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared", "-pthread",
                 "-fvisibility=hidden", source, "-o", fresh])
        fresh.rename(made)
    return made


def read_printed(text):
    """{name: value} of lines `name value`."""
    return dict(re.findall(r"^(crc|ram_bytes|stack_bytes) (\S+)$", text, re.MULTILINE))


def run_on_host(image):
    return read_printed(execute([image], 600))


def emulator(work):
    """The directory where npm has put the RP2040 emulator."""
    try:
        return rp2040js.installed(pathlib.Path(work) / "node")
    except boards.Failure as failure:
        raise Failure(str(failure)) from None


def qemu_command(target, image, work, files, addresses, limit):
    arguments = [str(plugin(work)), f"out={files['out']}", f"symbols={files['symbols']}", f"limit={limit}"]
    arguments += [f"region={address:x}" for address in addresses]
    return [target.run[0], "-plugin", ",".join(arguments), *target.run[1:], image]


def rp2040_command(target, image, work, files, addresses, limit):
    execute([f"{target.prefix}objcopy", "-O", "binary", image, files["bytes"]])
    return [*target.run, HERE / "cycles.mjs", emulator(work), files["bytes"], files["out"], files["symbols"], limit,
            *(f"{address:x}" for address in addresses)]


def read_counts(text, printed):
    found = {name: collections.defaultdict(dict) for name in ("region", "cycles", "function", "function_cycles")}
    for words in map(str.split, text.splitlines()):
        if words == ["limit"]:
            return Counts()
        region = REGIONS.get(int(words[1]))
        if region and words[0] in ("region", "cycles"):
            found[words[0]][region] = int(words[2])
        elif region:
            found[words[0]][region][words[2]] = found[words[0]][region].get(words[2], 0) + int(words[3])
    return Counts(dict(found["region"]), dict(found["function"]), dict(found["cycles"]) or None,
                  dict(found["function_cycles"]) or None, printed)


def count(target_name, built, work, limit, seconds=600):
    """Counts an image that Workshop.build made. An instruction limit is the same on every machine; seconds are a
    last resort."""
    target, (image, link_map, sources) = TARGETS[target_name], built
    symbols = symbols_of(target.prefix, image)
    addresses = {name: address for address, name in symbols}
    missing = [mark for mark in MARKS if mark not in addresses]
    if missing:
        raise Failure(f"{image} has no symbol {missing[0]}")
    name_of = linkmap.Names(linkmap.read(link_map), sources)
    command = rp2040_command if target_name == "rp2040" else qemu_command
    with tempfile.TemporaryDirectory() as place:
        files = {name: pathlib.Path(place) / name for name in ("out", "symbols", "bytes")}
        files["symbols"].write_text("".join(f"{address:x} {name_of(address, name)[:NAME_LENGTH]}\n" for address, name in symbols))
        output = execute(command(target, image, work, files, [addresses[mark] for mark in MARKS], limit), seconds)
        if not files["out"].exists():
            raise Failure(f"the emulator counted nothing: {output.strip() or target.run[0]}")
        return read_counts(files["out"].read_text(), read_printed(output))
