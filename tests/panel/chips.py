"""Panels on small chips: compiled for an AVR and a Cortex-M0, run in simavr and QEMU.

chips.py --work DIR      1. stream.c prints the same hashes there as on this machine, for every panel.
                         2. src/panel holds no writable memory there.
                         3. A program that names one panel links no other, and stays within the sizes below.
chips.py --self-test     proves that a wrong hash, writable memory and a second panel are noticed.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TESTS = HERE.parent
ROOT = TESTS.parent
sys.path.insert(0, str(TESTS / "checks"))
from support import Report  # noqa: E402

PANELS = sorted((ROOT / "src/panel").glob("*.c"))
WARNINGS = "-std=c99 -Wall -Wextra -Wconversion -Wshadow -Wundef -pedantic -Werror".split()
ONE = "fc_panel_ssd1306"
# prefix, flags, what stands in for a system, linker, runner, bytes: of panel code and tables with one panel, of its state.
# The sizes are 15 % above what was measured with Debian 12's compilers.
CHIPS = {
    "atmega328p": dict(
        prefix="avr-", flags=["-mmcu=atmega328p", "-mcall-prologues"], port=[TESTS / "matrix/avr.c"], link=[],
        run=["simavr", "-m", "atmega328p", "-f", "16000000"], code=3500, state=20),
    "cortex-m0": dict(
        prefix="arm-none-eabi-", flags=["-mcpu=cortex-m0", "-mthumb"],
        port=[TESTS / "baremetal/start.c", TESTS / "baremetal/semihost.c"],
        link=["-nostartfiles", "-T", TESTS / "baremetal/lm3s6965.ld"],
        run=["qemu-system-arm", "-M", "lm3s6965evb", "-cpu", "cortex-m0", "-display", "none", "-nic", "none", "-monitor",
             "none", "-serial", "none", "-chardev", "stdio,id=output", "-semihosting-config",
             "enable=on,target=native,chardev=output", "-kernel"],
        code=2150, state=28),
}


def output_of(command, **options):
    try:
        run = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             text=True, errors="replace", timeout=100, **options)
    except FileNotFoundError:
        sys.exit(f"there is no {command[0]}: `.ci/install test` installs it")
    if run.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nexit code {run.returncode}\n{run.stdout}")
    return run.stdout


def hashes(text):
    """The lines `name hash` of what stream.c prints, in order."""
    return re.findall(r"([a-z0-9-]+) ([0-9a-f]{8})\b", re.sub(r"\x1b\[[\d;]*m", "", text))


def on_this_machine(work, *defines):
    program = work / "stream"
    output_of(["gcc", *WARNINGS, "-O1", *defines, "-I", ROOT / "include", HERE / "stream.c", *PANELS, "-o", program])
    return hashes(output_of([program]))


class Chip:
    def __init__(self, name, work):
        self.name, self.work = name, work / name
        self.chip = CHIPS[name]
        self.work.mkdir(parents=True, exist_ok=True)
        self.base = [self.chip["prefix"] + "gcc", "-Os", "-ffunction-sections", "-fdata-sections", *self.chip["flags"],
                     "-DFIXCAST_BAREMETAL", "-I", ROOT / "include", "-I", TESTS / "baremetal"]

    def compile(self, sources):
        """Objects of src/panel, compiled as strictly as on the host."""
        output_of([*self.base, *WARNINGS, "-c", *sources], cwd=self.work)
        return [self.work / f"{path.stem}.o" for path in sources]

    def link(self, name, objects, *defines):
        """stream.c with what it needs of the objects, as out of a library."""
        archive, program = self.work / f"{name}.a", self.work / name
        archive.unlink(missing_ok=True)
        output_of([self.chip["prefix"] + "ar", "rcs", archive, *objects])
        output_of([*self.base, "-std=c99", *defines, HERE / "stream.c", *self.chip["port"], archive, "-Wl,--gc-sections",
                   *self.chip["link"], "-o", program], cwd=self.work)
        return program

    def run(self, program):
        return hashes(output_of([*self.chip["run"], program]))

    def writable(self, objects):
        """(file, section, bytes) of memory that can be written."""
        for path in objects:
            lines = output_of([self.chip["prefix"] + "objdump", "-h", path]).splitlines()
            for line, flags in zip(lines, lines[1:]):
                match = re.match(r"\s*\d+ (\S+)\s+([0-9a-f]{8}) ", line)
                if match and "ALLOC" in flags and "READONLY" not in flags and int(match.group(2), 16):
                    yield path.name, match.group(1), int(match.group(2), 16)

    def symbols(self, program):
        """{name: bytes} of a program."""
        lines = output_of([self.chip["prefix"] + "nm", "-S", program]).splitlines()
        return {fields[3]: int(fields[1], 16) for fields in map(str.split, lines) if len(fields) == 4}

    def panel_bytes(self, objects, program):
        """Bytes of code and tables that the program has of these objects: all symbols of theirs that were linked."""
        linked = self.symbols(program)
        names = set()
        for path in objects:
            names |= set(self.symbols(path))
        return sum(size for name, size in linked.items() if name in names)


def check(name, work, expected, report, objects=None, one=ONE):
    chip = Chip(name, work)
    objects = objects or chip.compile(PANELS)
    for path, section, size in chip.writable(objects):
        report.check(False, f"{name}: {path} has {size} bytes of {section}")
    report.equal(f"{name}: hashes", expected, chip.run(chip.link("all", objects)))
    program = chip.link("one", objects, f"-DONLY={one}")
    others = [symbol for symbol in chip.symbols(program)
              if re.fullmatch(r"fc_panels|fc_panel_\w+", symbol) and symbol not in (ONE, "fc_panel_start", "fc_panel_stop")]
    report.equal(f"{name}: panels linked with {ONE}", [], others)
    state = chip.symbols(program)["state"]
    code = chip.panel_bytes(objects, program)
    print(f"{name}: one panel takes {code} bytes of code and tables, its state {state}")
    report.at_most(f"{name}: bytes of code and tables", chip.chip["code"], code)
    report.at_most(f"{name}: bytes of state", chip.chip["state"], state)


def self_test():
    with tempfile.TemporaryDirectory() as directory:
        work = pathlib.Path(directory)
        expected = on_this_machine(work)
        wrong = [expected[0][:1] + ("00000000",), *expected[1:]]
        counter = work / "counter.c"
        counter.write_text("int fc_counter = 3;\n")
        chip = Chip("cortex-m0", work)
        objects = chip.compile(PANELS)
        for what, arguments in (("a wrong hash", dict(expected=wrong)),
                                ("writable memory", dict(expected=expected, objects=objects + chip.compile([counter]))),
                                ("another panel", dict(expected=expected, one="fc_panel_ssd0323"))):
            report = Report()
            check("cortex-m0", work, report=report, **{"objects": objects, **arguments})
            if len(report.wrong) != 1:
                sys.exit(f"{what}: {len(report.wrong)} complaints, expected 1")
    print("self-test passed: the failures above were meant")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", metavar="DIR")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        return self_test()
    if options.work is None:
        parser.error("--work is needed")
    work = pathlib.Path(options.work).resolve()
    work.mkdir(parents=True, exist_ok=True)
    report = Report()
    expected = on_this_machine(work)
    report.check(len(expected) >= 20 and len(set(expected)) == len(expected), f"stream.c printed {expected}")
    for name in CHIPS:
        check(name, work, expected, report)
    return report.finish()


sys.exit(main())
