"""The library as a zip file that the Arduino program installs: the single header, a C file with its implementation, an example.

arduino.py BAKED_S1.c OUT.zip

Arduino compiles every file below src and puts src alone on the include path: the tree itself, with its boards and internal headers, is no
Arduino library, the single header is one.
"""
import pathlib
import sys

from amalgamate import Amalgamation
from tree import Failure, licence, version, write_whole
from zip_file import zip_of

HERE = pathlib.Path(__file__).resolve().parent / "arduino"
# Arduino finds a library by a header in src itself; scenes and other systems write fixcast/fixcast.h.
HEADER = "/* fixcast for Arduino. */\n#include \"fixcast/fixcast.h\"\n"
SOURCE = "/* Where the library is compiled. */\n#define FIXCAST_IMPLEMENTATION\n#include \"fixcast/fixcast.h\"\n"


def properties():
    return (HERE / "library.properties.in").read_text(encoding="utf-8").replace("@VERSION@", version())


def files(scene):
    """{path: text} of the library; `scene` is S1 as C tables."""
    example = "examples/Spheres/"
    content = {
        "library.properties": properties(),
        "LICENSE": licence() + "\n",
        "src/fixcast.h": HEADER,
        "src/fixcast.c": SOURCE,
        "src/fixcast/fixcast.h": Amalgamation().text(),
        example + "Spheres.ino": (HERE / "Spheres.ino").read_text(encoding="utf-8"),
        example + "s1.c": pathlib.Path(scene).read_text(encoding="utf-8"),
    }
    return {f"fixcast/{path}": text for path, text in content.items()}


def main(arguments):
    if len(arguments) != 2:
        sys.exit("usage: arduino.py BAKED_S1.c OUT.zip")
    try:
        write_whole(arguments[1], zip_of(files(arguments[0])))
    except Failure as failure:
        sys.exit(str(failure))
    except OSError as problem:
        sys.exit(f"{problem.filename}: {problem.strerror}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
