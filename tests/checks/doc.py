"""Every public symbol is documented: functions, types, macros, enumerations, variables, and members by themselves or by their structure's comment.

doc.py OUTPUT        runs Doxygen into OUTPUT (docs/Doxyfile); fails on an undocumented symbol and any other warning
doc.py --self-test   proves that an undocumented function, type and macro are noticed
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from support import ROOT, Report

# Of compounds without a comment Doxygen complains too, so what a structure does not explain does not pass by this.
MEMBER = re.compile(r"Member .*\(variable\) of (struct|union) \S+ is not documented")
# Written twice, for compilers that have it and others.
ALTERNATIVES = re.compile(r"Member FC_(ALIGNED[24]|READ|ROM)\b.*\(macro definition\)")


def complaints(headers, output):
    """Doxygen's warnings about a directory of headers."""
    settings = (ROOT / "docs/Doxyfile").read_text(encoding="utf-8")
    settings += f"\nINPUT = {headers}\nOUTPUT_DIRECTORY = {output}\n"
    run = subprocess.run(["doxygen", "-"], input=settings, cwd=ROOT, capture_output=True, text=True)
    lines = [line for line in (run.stdout + run.stderr).splitlines() if re.search(r": (warning|error): |^(error|warning): ", line)]
    return [line for line in lines if not MEMBER.search(line) and not ALTERNATIVES.search(line)]


def self_test():
    head = "/* A header. */\n#ifndef A_H\n#define A_H\n"
    cases = (("/* Does. */\nint f(int a);\n", True), ("int f(int a);\n", False), ("typedef struct s {\n  int x;\n} s;\n", False),
             ("/* A point. */\ntypedef struct s {\n  int x;\n} s;\n", True), ("#define F(a) (a)\n", False), ("/* As it is. */\n#define F(a) (a)\n", True))
    for code, documented in cases:
        with tempfile.TemporaryDirectory() as directory:
            place = pathlib.Path(directory, "in")
            place.mkdir()
            (place / "a.h").write_text(f"{head}{code}#endif\n")
            found = complaints(place, directory)
        if documented == bool(found):
            sys.exit(f"{code}is {'' if documented else 'not '}documented, but Doxygen says: {found}")
    print("self-test passed")
    return 0


def main(argument):
    if argument == "--self-test":
        return self_test()
    output = pathlib.Path(argument)
    output.mkdir(parents=True, exist_ok=True)
    report = Report()
    for line in complaints(ROOT / "include/fixcast", output):
        report.check(False, line)
    report.check((output / "html/index.html").is_file(), "no reference was written")
    return report.finish()


sys.exit(main(sys.argv[1]))
