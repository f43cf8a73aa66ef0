"""Reads a linker map: which object file every byte of an image comes from."""
import bisect
import collections
import pathlib
import re
import typing

from images import Failure, HERE

FLASH_SECTIONS = (".text", ".ARM.exidx", ".data")


class Piece(typing.NamedTuple):
    address: int
    size: int
    file: str     # an object file, or archive(member)
    section: str  # of the image


def read(path):
    """The image's pieces in order of addresses."""
    pieces, section, started = [], None, False
    waiting = ""  # a long name stands on a line of its own
    for line in pathlib.Path(path).read_text(errors="replace").splitlines():
        if line.startswith("Linker script and memory map"):
            started = True
        if not started:
            continue
        match = re.match(r"(\.[\w.]+)", line)
        if match:
            section = match.group(1)
        text, waiting = waiting + line, ""
        if re.fullmatch(r" [.\w]\S*", text):
            waiting = text
            continue
        match = re.match(r" \S+\s+0x([0-9a-f]+)\s+0x([0-9a-f]+) (\S.*)$", text)
        if match and int(match.group(2), 16) and section:
            pieces.append(Piece(int(match.group(1), 16), int(match.group(2), 16), match.group(3), section))
    if not pieces:
        raise Failure(f"{path} lists nothing: not a linker map")
    return sorted(pieces)


def origin(file, sources):
    """What to call a piece's file: the source's name, or the library's."""
    match = re.search(r"([^/]+)\.a\(", file)
    if match:
        return match.group(1)
    source = sources.get(file)
    return source.name if source else pathlib.Path(file).name


def belongs(file, sources, work):
    """core (or what stands for it in a rival), libgcc, libc (memcpy and the like), libm, scene, harness."""
    match = re.search(r"([^/]+)\.a\(", file)
    if match:
        return {"libgcc": "libgcc", "libm": "libm"}.get(match.group(1), "libc")
    source = sources.get(file)
    if source is None:
        return "harness"
    if source.parent == HERE / "rivals" or source.parent.name == "core":
        return "core"
    return "scene" if work in source.parents else "harness"


def flash(pieces, sources, work):
    """Bytes of flash by what they belong to."""
    sums = collections.Counter()
    for piece in pieces:
        if piece.section in FLASH_SECTIONS:
            sums[belongs(piece.file, sources, work)] += piece.size
    return sums


class Names:
    """Calls functions by file and name, as two files may have functions of one name."""

    def __init__(self, pieces, sources):
        self.pieces = [piece for piece in pieces if piece.section == ".text"]
        self.starts = [piece.address for piece in self.pieces]
        self.sources = sources

    def __call__(self, address, name):
        at = bisect.bisect_right(self.starts, address) - 1
        if at < 0 or address >= self.starts[at] + self.pieces[at].size:
            return f"?:{name}"
        return f"{origin(self.pieces[at].file, self.sources)}:{name}"
