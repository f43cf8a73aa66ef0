"""What the core's objects may hold: no floating point, no state, no library beyond memcpy and memset.

objects.py --nm NM --objdump OBJDUMP ARCHIVE                        checks a static library
objects.py --nm NM --objdump OBJDUMP --self-test COMPILER FLAGS...  proves on snippets that each rule is noticed

The library is to be built for a processor without float instructions (Cortex-M0, M3) or with
-mgeneral-regs-only: then every float operation is a call, and its name shows.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from support import Report

ALLOWED = re.compile(
    # memory
    r"mem(cpy|set)|__aeabi_mem(cpy|set|clr)[48]?|"
    # libgcc's integer helpers, by their names on Arm ...
    r"__aeabi_(lmul|llsl|llsr|lasr|lcmp|ulcmp|u?idiv|u?idivmod|u?ldivmod)|"
    r"__gnu_thumb1_case_([su][qh]i|si)|"
    # ... and elsewhere
    r"__(clz|ctz|popcount|ffs|bswap|parity)[sd]i2|__(mul|u?div|u?mod|u?divmod|u?cmp|ashl|ashr|lshr)[sdt]i[234]")


def text_of(command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def symbols(nm, archive):
    """(symbols defined anywhere in the library, [(member, undefined symbol)])."""
    defined, undefined = set(), []
    for line in text_of([nm, "-A", "-P", archive]).splitlines():
        where, name, kind = line.split()[:3]
        if kind in "Uwv":
            undefined.append((where.rstrip(":"), name))
        else:
            defined.add(name)
    return defined, undefined


def sections(objdump, archive):
    """(member, section, bytes) of each section that takes up writable memory."""
    member = ""
    lines = text_of([objdump, "-h", archive]).splitlines()
    for line, flags in zip(lines, lines[1:] + [""]):
        if "file format" in line:
            member = line.split(":")[0]
        match = re.match(r"\s*\d+ (\S+)\s+([0-9a-f]{8,16}) ", line)
        if match and "ALLOC" in flags and "READONLY" not in flags:
            yield member, match.group(1), int(match.group(2), 16)


def check(nm, objdump, archive, report):
    defined, undefined = symbols(nm, archive)
    for member, name in undefined:
        if name not in defined:
            report.check(ALLOWED.fullmatch(name), f"{member} needs {name}")
    for member, section, size in sections(objdump, archive):
        report.check(size == 0, f"{member} has {size} bytes of {section}")


SNIPPETS = (  # source, whether it is allowed
    ("int f(int a, int b) { return a * b; }", True),
    ("long long f(long long a, long long b) { return a / b + a * b + (a >> (b & 63)); }", True),
    ("#include <string.h>\nvoid f(char *a, const char *b, unsigned long n) { memcpy(a, b, n); memset(a, 0, n); }", True),
    ("static const int table[4] = {1, 2, 3, 4}; int f(int i) { return table[i & 3]; }", True),
    ("int f(int a) { return (int)(a * 1.5f); }", False),
    ("int f(int a) { return (int)(a * 1.5); }", False),
    ("int f(const float *a) { return *a > 1.0f; }", False),
    ("float f(int a) { return (float)a; }", False),
    ("double f(unsigned long long a) { return (double)a; }", False),
    ("int counter; int f(void) { return counter++; }", False),
    ("int f(void) { static int counter = 3; return counter++; }", False),
    ("static int seen[8]; int f(int i) { return seen[i & 7]++; }", False),
    ("void *malloc(unsigned long); void *f(void) { return malloc(4); }", False),
    ("int printf(const char *, ...); int f(int a) { return printf(\"%d\\n\", a); }", False),
    ("#include <string.h>\nvoid f(char *a, const char *b, unsigned long n) { memmove(a, b, n); }", False),
    ("void abort(void); void f(int a) { if (a) abort(); }", False),
)


def self_test(nm, objdump, compiler):
    for source, allowed in SNIPPETS:
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory, "snippet.c")
            path.write_text(source + "\n")
            compiled = subprocess.run([*compiler, "-w", "-c", path, "-o", path.with_suffix(".o")],
                                      capture_output=True, text=True)
            report = Report()
            if compiled.returncode != 0:
                # -mgeneral-regs-only makes some floats an error at once.
                report.check(False, "does not compile")
            else:
                check(nm, objdump, path.with_suffix(".o"), report)
            if allowed == bool(report.wrong):
                sys.exit(f"{source}\nis {'allowed' if allowed else 'forbidden'}, but the check says otherwise\n"
                         + compiled.stderr)
    print("self-test passed: the failures above were meant")
    return 0


def main(arguments):
    _, nm, _, objdump, *rest = arguments
    if rest[0] == "--self-test":
        return self_test(nm, objdump, rest[1:])
    report = Report()
    check(nm, objdump, rest[0], report)
    return report.finish()


sys.exit(main(sys.argv[1:]))
