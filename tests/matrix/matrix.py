"""The same picture on every machine: the CRC of small frames for each processor, compiler and option.

matrix.py --baked DIR [--work DIR] [--jobs N] [CELL...]   builds and runs all cells or those named, prints a table
matrix.py --list                                          prints the cells' names
matrix.py --baked DIR [--work DIR] --self-test            proves that a wrong CRC and a dead program are noticed

A cell compiles the core and golden/frame_crc.c anew and compares what each program prints with golden/crc.txt.
DIR of --baked holds the scenes as C files (`fixcast bake`). What is compiled is kept in DIR of --work until a
source changes.
"""
import argparse
import collections
import concurrent.futures
import functools
import hashlib
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TESTS = HERE.parent
ROOT = TESTS.parent
sys.path.insert(0, str(TESTS / "checks"))
from support import GOLDEN, read_golden  # noqa: E402

SIZE = "32x24"
WIDTH, HEIGHT = SIZE.split("x")
RUN_SECONDS = 100

# label: what the table says. prefix: of the gcc. target: clang's, where it is not the host.
# flags: of the compiler. link: further ones of the linker. port: what stands in for an operating system.
# run: what runs a program. only: the scenes that it draws; none: all.
Machine = collections.namedtuple("Machine", "label prefix target flags link port run only",
                                 defaults=(None, [], [], [], [], ()))


BARE = ["-DFIXCAST_BAREMETAL", "-I", TESTS / "baremetal"]


def linux(label, triple, emulator):
    return Machine(label, triple + "-", triple, link=["-static"], run=[emulator])


def cortex_m(cpu):
    return Machine(
        f"{cpu}, LM3S6965 in QEMU", "arm-none-eabi-",
        flags=[f"-mcpu={cpu}", "-mthumb", *BARE],
        link=["-nostartfiles", "-Wl,--gc-sections", "-T", TESTS / "baremetal/lm3s6965.ld"],
        port=[TESTS / "baremetal/start.c", TESTS / "baremetal/semihost.c"],
        run=["qemu-system-arm", "-M", "lm3s6965evb", "-cpu", cpu, "-display", "none", "-nic", "none",
             "-monitor", "none", "-serial", "none", "-chardev", "stdio,id=output",
             "-semihosting-config", "enable=on,target=native,chardev=output", "-kernel"])


def avr(chip, *only):
    return Machine(
        f"{chip}, simavr", "avr-",
        flags=[f"-mmcu={chip}", "-mcall-prologues", "-DSTRIP_ROWS=1", "-DMEMORY_BYTES=1024", *BARE],
        link=["-Wl,--gc-sections"],
        port=[HERE / "avr.c"],
        run=["simavr", "-m", chip, "-f", "16000000"],
        only=only)


MACHINES = {
    "native": Machine(platform.machine(), ""),
    "i686": linux("i686, qemu-i386", "i686-linux-gnu", "qemu-i386"),
    "armhf": linux("armhf, qemu-arm", "arm-linux-gnueabihf", "qemu-arm"),
    "aarch64": linux("aarch64, qemu-aarch64", "aarch64-linux-gnu", "qemu-aarch64"),
    "powerpc": linux("powerpc (big-endian), qemu-ppc", "powerpc-linux-gnu", "qemu-ppc"),
    "rv32": Machine(
        "rv32imc without a system, qemu-riscv32", "riscv64-unknown-elf-",
        flags=["-march=rv32imc", "-mabi=ilp32", "-ffreestanding", "-isystem", HERE / "freestanding", *BARE],
        link=["-nostdlib", "-lgcc"],
        port=[HERE / "riscv32.c", HERE / "memory.c"],
        run=["qemu-riscv32"]),
    "m0": cortex_m("cortex-m0"),
    "m3": cortex_m("cortex-m3"),
    "m4": cortex_m("cortex-m4"),
    "atmega2560": avr("atmega2560", "box", "s1", "s1r"),
}

ALL = ("-O0", "-O1", "-O2", "-O3", "-Os", "-O2 -flto")
GRID = (
    ("native", "gcc", ALL),
    ("native", "clang", ALL),
    ("i686", "gcc", ("-O2", "-Os")),
    ("i686", "clang", ("-O3",)),
    ("armhf", "gcc", ("-O2", "-O3")),
    ("armhf", "clang", ("-Os",)),
    ("aarch64", "gcc", ("-O2", "-O3")),
    ("aarch64", "clang", ("-O1",)),
    ("powerpc", "gcc", ("-O0", "-O2")),
    ("powerpc", "clang", ("-O3",)),
    ("rv32", "gcc", ("-O2", "-Os")),
    ("m0", "gcc", ("-Os", "-O3")),
    ("m3", "gcc", ("-O2",)),
    ("m4", "gcc", ("-O2", "-O2 -flto")),
    ("atmega2560", "gcc", ("-Os", "-O2")),
)
Cell = collections.namedtuple("Cell", "machine compiler options")
CELLS = {re.sub(r"\W+", "_", f"{machine}_{compiler}{options}"): Cell(MACHINES[machine], compiler, options)
         for machine, compiler, variants in GRID for options in variants}


class Failure(Exception):
    pass


def execute(command, seconds=None, **options):
    """Output of a command, errors included. A command that fails, hangs or is not there is a Failure."""
    text = " ".join(map(str, command))
    try:
        run = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, errors="replace", timeout=seconds, **options)
    except FileNotFoundError:
        raise Failure(f"there is no {command[0]}: `.ci/install test` installs it") from None
    except subprocess.TimeoutExpired as late:
        raise Failure(f"{text}\nstill running after {late.timeout} s") from None
    if run.returncode != 0:
        raise Failure(f"{text}\nexit code {run.returncode}\n{run.stdout}")
    return run.stdout


def compiler_of(cell):
    if cell.compiler == "gcc":
        return [cell.machine.prefix + "gcc"]
    if cell.machine.target is None:
        return ["clang"]
    # Debian's cross libraries are not where clang looks for them.
    place = f"/usr/{cell.machine.target}"
    return ["clang", f"--target={cell.machine.target}", "-isystem", f"{place}/include", f"-B{place}/lib",
            f"-L{place}/lib", "-Wno-unused-command-line-argument"]


@functools.lru_cache(maxsize=None)
def version(compiler):
    """The compiler's name and version, for the table."""
    match = re.search(r"\b\d+\.\d+\.\d+\b", execute([compiler, "--version"]))
    return f"{'clang' if 'clang' in compiler else 'gcc'} {match.group() if match else '?'}"


class Matrix:
    def __init__(self, baked, work, golden):
        self.baked, self.work = pathlib.Path(baked), pathlib.Path(work)
        self.golden = {scene: crc for (scene, size), crc in golden.items() if size == SIZE}
        if not self.golden:
            sys.exit(f"no golden CRC at {SIZE}; `make golden-update` adds them")
        self.core = sorted((ROOT / "src/core").glob("*.c"))
        inputs = [*sorted((ROOT / "src/core").iterdir()), *sorted((ROOT / "include").rglob("*.h")),
                  TESTS / "golden/frame_crc.c", *sorted((TESTS / "baremetal").iterdir()),
                  *sorted(path for path in HERE.rglob("*") if path.suffix in (".c", ".h")),
                  *(self.baked / f"{scene}.c" for scene in self.golden)]
        missing = [str(path) for path in inputs if not path.exists()]
        if missing:
            sys.exit(f"not there: {' '.join(missing)}; the target baked_scenes makes scenes")
        self.sources = hashlib.sha256(b"\0".join(path.read_bytes() for path in inputs)).hexdigest()

    def scenes(self, cell):
        return [scene for scene in self.golden if scene in (cell.machine.only or self.golden)]

    def build(self, name):
        """Compiles the programs of a cell unless they are there."""
        cell, place = CELLS[name], self.work / name
        base = [*compiler_of(cell), "-std=c99", "-ffunction-sections", "-fdata-sections", *cell.options.split(),
                *cell.machine.flags, "-I", ROOT / "include"]
        compile_core = [*base, "-c", *self.core]
        links = [[*base, f"-DSCENE={scene}", f"-DWIDTH={WIDTH}", f"-DHEIGHT={HEIGHT}", TESTS / "golden/frame_crc.c",
                  *cell.machine.port, self.baked / f"{scene}.c", *(f"{path.stem}.o" for path in self.core),
                  *cell.machine.link, "-o", scene] for scene in self.scenes(cell)]
        recipe = f"{self.sources} {version(compiler_of(cell)[0])} {compile_core} {links}"
        stamp = place / "recipe"
        if stamp.exists() and stamp.read_text() == recipe:
            return
        place.mkdir(parents=True, exist_ok=True)
        stamp.unlink(missing_ok=True)
        for command in (compile_core, *links):
            execute(command, cwd=place)
        stamp.write_text(recipe)

    def run(self, name, scene):
        """The CRC that the cell's program prints."""
        program = self.work / name / scene
        output = execute([*CELLS[name].machine.run, program], RUN_SECONDS)
        match = re.search(rf"\b{scene} {SIZE} (0x[0-9a-f]{{8}})\b", re.sub(r"\x1b\[[\d;]*m", "", output))
        if not match:
            raise Failure(f"{program} printed no CRC:\n{output}")
        return match.group(1)

    def cell(self, name):
        """({scene: CRC}, what went wrong or None) of a cell."""
        crcs = {}
        try:
            self.build(name)
            for scene in self.scenes(CELLS[name]):
                crcs[scene] = self.run(name, scene)
        except Failure as failure:
            return crcs, f"{name}: {failure}"
        return crcs, None

    def row(self, name, crcs):
        cell = CELLS[name]
        scenes = self.scenes(cell)
        equal = bool(scenes) and all(crcs.get(scene) == self.golden[scene] for scene in scenes)
        try:
            compiler = version(compiler_of(cell)[0])
        except Failure:
            compiler = cell.compiler
        columns = [crcs.get(scene, "none") if scene in scenes else "-" for scene in self.golden]
        return [cell.machine.label, compiler, cell.options, *columns, "yes" if equal else "NO"]

    def table(self, names, jobs):
        """Runs the cells, prints the table, returns how many are wrong."""
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            results = dict(zip(names, pool.map(self.cell, names)))
        rows = [["machine", "compiler", "options", *self.golden, "equal"],
                ["golden", "", "", *self.golden.values(), ""]]
        rows += [self.row(name, crcs) for name, (crcs, _) in results.items()]
        widths = [max(map(len, column)) for column in zip(*rows)]
        print(f"CRC-32 of frames of {SIZE}")
        for row in rows:
            print("  ".join(text.ljust(width) for text, width in zip(row, widths)).rstrip())
        if any("-" in row for row in rows):
            print("-: not drawn there: needs more RAM than the chip has, or half a minute")
        for _, problem in results.values():
            if problem is not None:
                print(f"\n{problem}")
        wrong = sum(row[-1] != "yes" for row in rows[2:])
        print(f"{len(names)} cells, {wrong} wrong")
        return wrong


def self_test(baked, work):
    name, golden = next(iter(CELLS)), read_golden()
    scene = next(scene for scene, size in golden if size == SIZE)
    wrong = {**golden, (scene, SIZE): "0x00000000"}
    for what, lines, run, expected in (("right", golden, [], 0), ("wrong", wrong, [], 1),
                                       ("dead", golden, ["false"], 1), ("silent", golden, ["true"], 1),
                                       ("missing", golden, ["no-such-emulator"], 1)):
        CELLS[name] = CELLS[name]._replace(machine=MACHINES["native"]._replace(run=run))
        if Matrix(baked, work, lines).table([name], 1) != expected:
            sys.exit(f"a {what} result was taken for {'right' if expected else 'wrong'}")
    print("self-test passed: the failures above were meant")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--baked", metavar="DIR")
    parser.add_argument("--work", metavar="DIR")
    parser.add_argument("--jobs", type=int, default=1, metavar="N")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("cells", nargs="*", metavar="CELL")
    options = parser.parse_args()
    if options.list:
        print("\n".join(CELLS))
        return 0
    if options.baked is None:
        parser.error("--baked is needed")
    unknown = [name for name in options.cells if name not in CELLS]
    if unknown:
        parser.error(f"no such cell: {' '.join(unknown)}")
    with tempfile.TemporaryDirectory() as scratch:
        work = pathlib.Path(options.work or scratch).resolve()
        baked = pathlib.Path(options.baked).resolve()
        if options.self_test:
            return self_test(baked, work)
        return 1 if Matrix(baked, work, read_golden()).table(options.cells or list(CELLS), options.jobs) else 0


if __name__ == "__main__":
    sys.exit(main())
