"""Flash, RAM and stack of the boards' firmware and of the least programs for S1, S2 and a ball, against what is recorded in budgets.txt.

budgets.py --baked DIR --work DIR [--update]   prints the table; fails when a figure has grown by more than 3 %
budgets.py --self-test                         proves that growth, a missing line and recursion are noticed

flash: code and constants; ram: variables (frame, memory, scratch, strip); stack: the deepest calls of fc_frame_setup and fc_render_rows_in, of functions
that are linked (stack.py), the firmware's own few frames above them left out. All in bytes.
"""
import argparse
import collections
import concurrent.futures
import pathlib
import re
import sys
import tempfile

from images import Failure, HERE, ROOT, execute
from stack import Graph

sys.path.insert(0, str(ROOT / "src/port/tools"))
import boards  # noqa: E402
import build  # noqa: E402

FILE = HERE / "budgets.txt"
HEAD = """# Bytes: name flash ram stack. `make budgets-update` rewrites this file; say in the commit why the figures changed.
"""
TOLERANCE = 1.03
ENTRIES = ("fc_frame_setup", "fc_render_rows_in")
FLAGS = {"m0plus": ("-mthumb", "-mcpu=cortex-m0plus"), "m3": ("-mthumb", "-mcpu=cortex-m3")}
BOARDS = {"pico": "m0plus", "pico-135": "m0plus", "lm3s6965evb": "m3"}
COMPILER = ["arm-none-eabi-gcc", "-std=c99", "-O2", "-ffunction-sections", "-fdata-sections", "-I", ROOT / "include"]

Figures = collections.namedtuple("Figures", "flash ram stack")


def read(text):
    recorded = {}
    for line in text.splitlines():
        match = re.fullmatch(r"(\S+) (\d+) (\d+) (\d+)", line)
        if match:
            recorded[match.group(1)] = Figures(*map(int, match.groups()[1:]))
        elif line.strip() and not line.startswith("#"):
            raise Failure(f"{FILE}: not `name flash ram stack`: {line}")
    return recorded


def objects(work, cpu):
    """The core's objects and call graphs for a processor."""
    place = work / cpu
    place.mkdir(parents=True, exist_ok=True)
    sources = sorted((ROOT / "src/core").glob("*.c"))

    def compile_one(source):
        execute([*COMPILER, *FLAGS[cpu], "-fcallgraph-info=su,da", "-I", ROOT / "src/core", "-c", source, "-o", f"{source.stem}.o"], cwd=place)
        return place / f"{source.stem}.o"

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(compile_one, sources))


def size(program):
    code, data, bss = map(int, execute(["arm-none-eabi-size", program]).splitlines()[1].split()[:3])
    return code + data, data + bss


def linked(program, core_objects):
    """Whether a title of the call graph is a function that the program holds: by its name, and a static one by its file's global names too."""
    names = {line.split()[-1] for line in execute(["arm-none-eabi-nm", program]).splitlines()}
    files = set()
    for line in execute(["arm-none-eabi-nm", "-A", "-g", "--defined-only", *core_objects]).splitlines():
        where, name = line.split()[0], line.split()[-1]
        if name in names:
            files.add(pathlib.Path(where.split(":")[0]).stem)

    def holds(title):
        path, _, name = title.rpartition(":")
        return name in names and (not path or pathlib.Path(path).stem in files)

    return holds


def stack(work, cpu, program, core_objects):
    graph = Graph([path.with_suffix(".ci") for path in core_objects], ROOT / "src/core")
    graph.keep(linked(program, core_objects))
    return max(graph.worst(entry)[0] for entry in ENTRIES)


def least_program(work, name, source, core_objects, *more):
    program = work / f"{name}.elf"
    execute([*COMPILER, *FLAGS["m0plus"], *more, "-nostartfiles", "-Wl,--gc-sections", "-Wl,-e,main", "-Wl,--no-warn-rwx-segments", source,
             *core_objects, "-o", program])
    return program


def measure(work, baked):
    core = {cpu: objects(work, cpu) for cpu in FLAGS}
    programs = {}
    for scene in ("s1", "s2"):
        programs[f"{scene}-m0plus"] = least_program(work, scene, HERE / "image/budget.c", core["m0plus"], f"-DSCENE={scene}", baked / f"{scene}.c")
    programs["sphere-only-m0plus"] = least_program(work, "sphere-only", ROOT / "tests/link/sphere_only.c", core["m0plus"])
    figures = {name: Figures(*size(program), stack(work, "m0plus", program, core["m0plus"])) for name, program in programs.items()}
    for name, cpu in BOARDS.items():
        program = build.build(name)
        figures[name] = Figures(*size(program), stack(work, cpu, program, core[cpu]))
    return figures


def judge(old, new, say=print):
    """Prints the table; returns what is wrong."""
    wrong = []
    say(f"{'bytes':22}" + "".join(f"{field:>10}{'change':>9}" for field in Figures._fields))
    for name, figures in new.items():
        cells = f"{name:22}"
        for field, now in zip(Figures._fields, figures):
            before = getattr(old[name], field) if name in old else None
            cells += f"{now:10}{'new' if before is None else f'{100 * (now / before - 1):+.2f} %' if before else '':>9}"
            if before is not None and now > before * TOLERANCE:
                wrong.append(f"{field} of {name}: {now} bytes, recorded {before}: more than 3 % more; find out why, or `make budgets-update`")
        say(cells)
        if name not in old:
            wrong.append(f"{name} stands not in budgets.txt: `make budgets-update`")
    return wrong


def self_test():
    old, quiet = {"a": Figures(1000, 100, 500)}, lambda _: None
    tests = {
        "the same": judge(old, {"a": Figures(1000, 100, 500)}, quiet) == [],
        "3 % more": judge(old, {"a": Figures(1030, 100, 515)}, quiet) == [],
        "4 % more flash": len(judge(old, {"a": Figures(1040, 100, 500)}, quiet)) == 1,
        "4 % more stack": len(judge(old, {"a": Figures(1000, 100, 520)}, quiet)) == 1,
        "a new name": len(judge(old, {"b": Figures(1, 1, 1)}, quiet)) == 1,
    }
    with tempfile.TemporaryDirectory() as directory:
        place = pathlib.Path(directory)
        (place / "kind.h").write_text("struct fc_kind {\n  int (*check)(int a);\n};\n")
        (place / "a.c").write_text("static int leaf(int a) { return a; }\nconst fc_kind kind_a FC_ROM = {leaf};\nint root(int a) {\n  return kind->check(a);\n}\n")

        def graph(*edges):
            lines = [f'node: {{ title: "{title}" label: "x\\n{size} bytes (static)" }}' for title, size in (("root", 8), (f"{place}/a.c:leaf", 32))]
            lines += [f'edge: {{ sourcename: "{a}" targetname: "{b}" label: "{place}/a.c:4:10" }}' for a, b in edges]
            (place / "a.ci").write_text("\n".join(lines))
            return Graph([place / "a.ci"], place)

        tests["a call through a descriptor"] = graph(("root", "__indirect_call")).worst("root")[0] == 40
        by_hand = (place / "a.c").read_text()
        (place / "a.c").write_text(by_hand.replace("FC_ROM = {leaf};", "FC_ROM = KIND(leaf);") + "#define KIND(check) \\\n  { \\\n    check \\\n  }\n")
        tests["a descriptor by a macro"] = graph(("root", "__indirect_call")).worst("root")[0] == 40
        (place / "a.c").write_text(by_hand)
        try:
            graph(("root", "__indirect_call"), (f"{place}/a.c:leaf", "root")).worst("root")
            tests["recursion"] = False
        except Failure as failure:
            tests["recursion"] = "recursion" in str(failure)
    for name, passed in tests.items():
        print(f"{'passed' if passed else 'FAILED'}: {name}")
    return 0 if all(tests.values()) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--baked", type=pathlib.Path, default=ROOT / "build/baked", metavar="DIR")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/budgets", metavar="DIR")
    parser.add_argument("--update", action="store_true", help="rewrite budgets.txt")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        return self_test()
    try:
        new = measure(options.work.resolve(), options.baked.resolve())
        wrong = judge(read(FILE.read_text()) if FILE.exists() else {}, new)
    except (Failure, boards.Failure) as failure:
        print(f"budgets: {failure}", file=sys.stderr)
        return 2
    if options.update:
        fresh = FILE.with_suffix(".new")
        fresh.write_text(HEAD + "".join(f"{name} {' '.join(map(str, figures))}\n" for name, figures in new.items()))
        fresh.replace(FILE)
        return 0
    for text in wrong:
        print("FAIL:", text)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
