"""Who may include whom: design by layers, without cycles, enforced on the text of the sources.

includes.py ROOT          checks a tree
includes.py --self-test   proves on made-up trees that each rule is noticed when broken
"""
import pathlib
import re
import sys
import tempfile

from support import Report

FREESTANDING = {"stdint.h", "stddef.h", "stdbool.h", "string.h", "limits.h"}
FIRMWARE_SHARED = {"controls.h", "firmware.h", "orbit.h", "pattern.h"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:<([^>\n]+)>|"([^"\n]+)"|(\S.*))', re.M)
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)
SUFFIXES = {".c", ".h", ".cpp", ".hpp", ".cc", ".S"}


def includes_of(path):
    """(line, name, is it <...>) of each include; an include of a macro is returned with its text and None."""
    text = COMMENT.sub(lambda match: "\n" * match.group().count("\n"), path.read_text(errors="replace"))
    for match in INCLUDE.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        if match.group(1) is not None:
            yield line, match.group(1), True
        elif match.group(2) is not None:
            yield line, match.group(2), False
        else:
            yield line, match.group(3), None


def own(name, directory):
    """Whether a quoted name is a file of this directory itself."""
    return "/" not in name and (directory / name).is_file()


def shared_with_boards(root, path, name):
    """Whether the simulator may include this header of a board: what the boards' demo shares with 'fixcast show', and, in the
    files X_PORT.cpp, the headers PORT_Y.h of that port."""
    if path.name.startswith("oracle"):
        return False
    if name in FIRMWARE_SHARED:
        return (root / "src" / "firmware" / name).is_file()
    port = path.stem.rpartition("_")[2]
    return name.startswith(port + "_") and (root / "src" / "port" / port / name).is_file()


def reason(root, path, name, system):
    """Why this file must not include this name, or None."""
    parts = path.relative_to(root).parts
    public = name.startswith("fixcast/") and (root / "include" / name).is_file()
    if system is None:
        return "an include must name its file"
    if ".." in pathlib.PurePosixPath(name).parts:
        return "an include must not climb out of its directory"
    if name.startswith("fixcast/") and not public:
        return "no such public header"

    if parts[0] == "include":
        if system and parts[-1] == "config.h" and name == "avr/pgmspace.h":
            return None
        return None if public or (system and name in FREESTANDING) else "public headers need only each other"
    if parts[:2] == ("src", "core"):
        if public or (system and name in FREESTANDING) or (not system and own(name, path.parent)):
            return None
        return "the core is freestanding and knows only itself"
    if parts[:2] == ("src", "extra"):
        if public or (system and name in FREESTANDING):
            return None
        if not system and (own(name, path.parent) or own(name, root / "src" / "core")):
            return None
        return "the extras are freestanding and know only the core"
    if parts[:2] == ("src", "panel"):
        if public or (system and name in FREESTANDING) or (not system and own(name, path.parent)):
            return None
        return "panels know public headers only: no port, no core internals"
    if parts[:2] == ("src", "firmware"):
        scene = not system and own(name, root / "host_sim" / "scenes")
        if public or scene or (system and name in FREESTANDING) or (not system and own(name, path.parent)):
            return None
        return "firmware knows public headers, scenes as tables and itself: no port, no core or panel internals"
    if parts[:2] == ("src", "port"):
        if not system and name == "firmware.h" and (root / "src" / "firmware" / name).is_file():
            return None
        return None if system or public or own(name, path.parent) else "a port knows no other port and no internals"
    if parts[:2] == ("tests", "panel") and path.name.startswith("virtual_") and path.stem != "virtual_bus":
        return None if (system and not public) or own(name, path.parent) else "virtual panels are an oracle: nothing of fixcast"
    if parts[0] == "host_sim":
        if path.name.startswith("oracle") and public:
            return "the oracle shares nothing with the core"
        if not system and shared_with_boards(root, path, name):
            return None
        return None if system or public or own(name, path.parent) else "the simulator uses public headers only"
    return None


def check(root, report):
    files = [path for top in ("include", "src", "host_sim", "tests/panel") for path in sorted((root / top).rglob("*"))
             if path.suffix in SUFFIXES]
    for path in files:
        report.checked += 1
        for line, name, system in includes_of(path):
            why = reason(root, path, name, system)
            if why:
                report.check(False, f"{path.relative_to(root)}:{line}: includes {name}: {why}")


def check_cycles(root, report):
    """Headers of the core and public ones include each other in one order: none reaches itself."""
    graph = {}
    for path in [*(root / "include").rglob("*.h"), *(root / "src" / "core").glob("*.h"), *(root / "src" / "extra").glob("*.h")]:
        name = f"fixcast/{path.name}" if path.parent.name == "fixcast" else path.name
        graph[name] = sorted(included for _, included, system in includes_of(path) if system is False)
    done, trail = set(), []

    def visit(name):
        if name in trail:
            report.check(False, f"headers include each other: {' > '.join(trail[trail.index(name):] + [name])}")
        elif name not in done:
            trail.append(name)
            for other in graph.get(name, ()):
                visit(other)
            done.add(trail.pop())

    for name in sorted(graph):
        visit(name)
    report.checked += len(graph)


def self_test():
    base = {
        "include/fixcast/a.h": "#include <stdint.h>\n",
        "include/fixcast/config.h": "#include <avr/pgmspace.h>\n",
        "src/core/inner.h": "",
        "src/core/outer.h": '#include "inner.h"\n',
        "src/core/core.c": '#include "inner.h"\n#include <string.h>\n#include "fixcast/a.h"\n',
        "src/extra/more.h": "",
        "src/extra/more.c": '#include "more.h"\n#include "inner.h"\n#include <stdint.h>\n#include "fixcast/a.h"\n',
        "src/panel/panel.c": '#include "fixcast/a.h"\n',
        "src/firmware/firmware.h": "",
        "src/firmware/run.h": "",
        "src/firmware/orbit.h": "",
        "src/firmware/run.c": '#include "firmware.h"\n#include "run.h"\n#include "fixcast/a.h"\n#include "scene.h"\n',
        "src/port/one/one.h": "",
        "src/port/one/one_bus.h": "",
        "host_sim/pins_one.cpp": '#include "one_bus.h"\n#include "orbit.h"\n',
        "src/port/one/main.c": '#include "one.h"\n#include <linux/spi/spidev.h>\n#include "firmware.h"\n',
        "src/port/two/two.h": "",
        "tests/panel/virtual_one.h": "#include <stdint.h>\n",
        "tests/panel/virtual_one.c": '#include "virtual_one.h"\n#include <stdio.h>\n',
        "tests/panel/virtual_bus.c": '#include "virtual_one.h"\n#include "fixcast/a.h"\n',
        "host_sim/main.cpp": '#include <vector>\n#include "fixcast/a.h"\n#include "oracle.h"\n',
        "host_sim/scenes/scene.h": "",
        "host_sim/oracle.h": "// #include \"fixcast/a.h\"\n",
    }
    broken = [
        ("src/core/inner.h", '#include "inner.h"\n'),
        ("src/core/inner.h", '#include "outer.h"\n'),
        ("src/core/core.c", "#include <stdio.h>\n"),
        ("src/core/core.c", "#include <math.h>\n"),
        ("src/core/core.c", "#include <avr/pgmspace.h>\n"),
        ("src/core/core.c", '#include "../panel/panel.h"\n'),
        ("src/core/core.c", '#include "panel.h"\n'),
        ("src/core/core.c", "# include HEADER\n"),
        ("src/core/core.c", '#include "more.h"\n'),
        ("src/extra/more.c", "#include <stdlib.h>\n"),
        ("src/extra/more.c", '#include "one.h"\n'),
        ("src/panel/panel.c", '#include "more.h"\n'),
        ("host_sim/main.cpp", '#include "more.h"\n'),
        ("include/fixcast/a.h", "#include <stdlib.h>\n"),
        ("include/fixcast/a.h", '#include "inner.h"\n'),
        ("include/fixcast/a.h", '#include "fixcast/missing.h"\n'),
        ("src/panel/panel.c", '#include "../core/inner.h"\n'),
        ("src/panel/panel.c", '#include "inner.h"\n'),
        ("src/panel/panel.c", '#include "one.h"\n'),
        ("src/panel/panel.c", "#include <linux/spi/spidev.h>\n"),
        ("src/firmware/run.c", '#include "inner.h"\n'),
        ("src/firmware/run.c", '#include "one.h"\n'),
        ("src/firmware/run.c", '#include "oracle.h"\n'),
        ("src/firmware/run.c", "#include <stdio.h>\n"),
        ("src/core/core.c", '#include "firmware.h"\n'),
        ("src/panel/panel.c", '#include "firmware.h"\n'),
        ("src/port/one/main.c", '#include "run.h"\n'),
        ("src/port/one/main.c", '#include "inner.h"\n'),
        ("src/port/one/main.c", '#include "two.h"\n'),
        ("src/port/one/main.c", '#include "../two/two.h"\n'),
        ("tests/panel/virtual_one.c", '#include "fixcast/a.h"\n'),
        ("tests/panel/virtual_one.c", "#include <fixcast/a.h>\n"),
        ("tests/panel/virtual_one.h", '#include "../../src/core/inner.h"\n'),
        ("host_sim/main.cpp", '#include "inner.h"\n'),
        ("host_sim/main.cpp", '#include "one_bus.h"\n'),
        ("host_sim/main.cpp", '#include "run.h"\n'),
        ("host_sim/pins_one.cpp", '#include "one.h"\n'),
        ("host_sim/pins_one.cpp", '#include "two.h"\n'),
        ("host_sim/oracle.h", '#include "orbit.h"\n'),
        ("src/port/two/two.h", '#include "one_bus.h"\n'),
        ("host_sim/main.cpp", '#include "../src/core/inner.h"\n'),
        ("host_sim/oracle.h", '#include "fixcast/a.h"\n'),
    ]
    for path, text in [(None, "")] + broken:
        with tempfile.TemporaryDirectory() as directory:
            root = pathlib.Path(directory)
            for name, content in base.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(content + (text if name == path else ""))
            report = Report()
            check(root, report)
            check_cycles(root, report)
            expected = 0 if path is None else 1
            if len(report.wrong) != expected:
                sys.exit(f"{path} with {text!r}: {len(report.wrong)} complaints, expected {expected}")
    print("self-test passed: the failures above were meant")
    return 0


def main(arguments):
    if arguments[0] == "--self-test":
        return self_test()
    report = Report()
    check(pathlib.Path(arguments[0]), report)
    check_cycles(pathlib.Path(arguments[0]), report)
    return report.finish()


sys.exit(main(sys.argv[1:]))
