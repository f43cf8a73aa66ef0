"""Where things stand in the tree, its version and licence, and files written whole: what the makers of packages share."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "port/tools"))
from boards import ROOT, Failure  # noqa: E402
from png import write_whole as replace_whole  # noqa: E402

PUBLIC = ROOT / "include" / "fixcast"
# What a library consists of, in the order in which it is put together; a program that names none of a file gets none of it.
SOURCES = ("src/core", "src/extra", "src/panel")


def version():
    """The version that include/fixcast/version.h says."""
    text = (PUBLIC / "version.h").read_text(encoding="utf-8")
    found = dict(re.findall(r"^#define FC_VERSION_(MAJOR|MINOR|PATCH) (\d+)$", text, re.M))
    if len(found) != 3:
        raise Failure("include/fixcast/version.h: three lines '#define FC_VERSION_MAJOR 0', MINOR and PATCH are needed")
    return "{MAJOR}.{MINOR}.{PATCH}".format(**found)


def licence():
    return (ROOT / "LICENSE").read_text(encoding="utf-8").strip()


def write_whole(path, data):
    """A file, text or bytes, that is either the old one or all of the new one; its directory is made if need be."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    replace_whole(path, data if isinstance(data, bytes) else data.encode("utf-8"))
