"""The whole library as one header, fixcast/fixcast.h, whose implementation is compiled where FIXCAST_IMPLEMENTATION is defined.

amalgamate.py OUT.h     OUT.h should be fixcast/fixcast.h: sources, and the scenes that `fixcast bake` writes, include it by that name

Headers are put where they are first included. What a source keeps to itself is renamed to fc_SOURCE_NAME, so that sources do not
clash with one another, nor with the program that they are compiled in.
"""
import collections
import re
import sys

import c_names
from tree import PUBLIC, ROOT, SOURCES, Failure, licence, version, write_whole

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+"([^"\n]+)"[^\n]*\n', re.M)

INTRODUCTION = """\
/*
 * fixcast {version}: an exact ray caster in integers only, for chips without floating point. Made from its sources; do not edit.
 *
 *   #include "fixcast/fixcast.h"      wherever it is used
 *
 *   #define FIXCAST_IMPLEMENTATION    in one C file of the program: the library is compiled there
 *   #include "fixcast/fixcast.h"
 *
 * Compile with -ffunction-sections -fdata-sections and link with -Wl,--gc-sections: what no scene names is left out.
 *
{licence}
 */
"""
NO_CXX = """\
#ifdef __cplusplus
#error "fixcast is written in C99: define FIXCAST_IMPLEMENTATION in a .c file; C++ files include fixcast.h without it."
#endif
"""


def is_public(name):
    return name.startswith("fixcast/")


class Amalgamation:
    def __init__(self):
        self.done = set()

    def find(self, name, place):
        for directory in (ROOT / "include", place, ROOT / "src/core"):
            if (directory / name).is_file():
                return directory / name
        raise Failure(f"{place}: there is no header {name} to put into the amalgamation: is the include right?")

    def expand(self, path, text=None):
        """A file's text with each header of ours put where it is first included."""
        def header(match):
            found = self.find(match.group(1), path.parent)
            if found in self.done:
                return ""
            self.done.add(found)
            return self.expand(found)
        return INCLUDE.sub(header, path.read_text(encoding="utf-8") if text is None else text)

    def interface(self):
        """All public headers. fixcast.h first, whose comment tells the conventions."""
        paths = [PUBLIC / "fixcast.h", *sorted(PUBLIC.glob("*.h"))]
        return "\n".join(self.expand(path) for path in paths if self.first(path))

    def first(self, path):
        new = path not in self.done
        self.done.add(path)
        return new

    def implementation(self):
        """All sources, none seeing another's private names."""
        paths = [path for place in SOURCES for path in sorted((ROOT / place).glob("*.c"))]
        private = {path: c_names.private_names(path.read_text(encoding="utf-8")) for path in paths}
        often = collections.Counter(name for names in private.values() for name in names)
        parts = []
        for path in paths:
            renamed = {name: f"fc_{path.stem}_{name}" for name in private[path]
                       if often[name] > 1 or not name.lower().startswith("fc_")}
            parts.append(f"/* ---- {path.name} ---- */\n\n"
                         + self.expand(path, c_names.rename(path.read_text(encoding="utf-8"), renamed)))
        return "\n".join(parts)

    def text(self):
        lines = "\n".join(f" * {line}".rstrip() for line in licence().splitlines())
        interface, implementation = self.interface(), self.implementation()
        return (INTRODUCTION.format(version=version(), licence=lines) + interface
                + "\n#if defined FIXCAST_IMPLEMENTATION && !defined FIXCAST_IMPLEMENTED\n#define FIXCAST_IMPLEMENTED\n"
                + NO_CXX + "\n" + implementation + "\n#endif\n")


def main(arguments):
    if len(arguments) != 1:
        sys.exit("usage: amalgamate.py OUT.h")
    try:
        write_whole(arguments[0], Amalgamation().text())
    except Failure as failure:
        sys.exit(str(failure))
    except OSError as problem:
        sys.exit(f"{problem.filename}: {problem.strerror}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
