"""The single header where tests expect the tree's headers: DIR/fixcast/fixcast.h, its implementation as DIR/fixcast.c, and for each
other public header one that only includes the single one.

amalgamated.py DIR
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

place = pathlib.Path(sys.argv[1]) / "fixcast"
subprocess.run([sys.executable, ROOT / "src/dist/amalgamate.py", place / "fixcast.h"], check=True)
for header in (ROOT / "include/fixcast").glob("*.h"):
    if header.name != "fixcast.h":
        (place / header.name).write_text('#include "fixcast/fixcast.h"\n')
(place.parent / "fixcast.c").write_text('#define FIXCAST_IMPLEMENTATION\n#include "fixcast/fixcast.h"\n')
