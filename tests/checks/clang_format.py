"""Every C and C++ file is as clang-format writes it with .clang-format, and no line is longer than 150 characters.

clang_format.py CLANG_FORMAT ROOT          `CLANG_FORMAT -i FILE` mends what it finds, but for long lines
clang_format.py CLANG_FORMAT --self-test   proves that both are noticed
"""
import pathlib
import subprocess
import sys
import tempfile

from support import Report

PLACES = ("src", "include", "host_sim", "tests", "examples")
LONGEST = 150


def files_of(root):
    return sorted(path for place in PLACES for path in (root / place).rglob("*") if path.suffix in (".c", ".h", ".cpp"))


def complaints(program, style, paths):
    """Lines that say what is wrong with which file."""
    checked = subprocess.run([program, f"--style=file:{style}", "--dry-run", "--Werror", *map(str, paths)], capture_output=True, text=True,
                             check=False)
    wrong = [line for line in checked.stderr.splitlines() if "error:" in line]
    if checked.returncode != 0 and not wrong:
        wrong = [checked.stderr.strip() or f"{program} failed"]
    for path in paths:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if len(line) > LONGEST:
                wrong.append(f"{path}:{number}: {len(line)} characters; break the line at {LONGEST}")
    return wrong


def self_test(program, style):
    report = Report()
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory) / "a.c"
        for text, wrong in (("int one(void) { return 1; }\n", 0), ("int one(void){ return 1; }\n", 1),
                            (f"/* {'x' * LONGEST} */\nint one(void) {{ return 1; }}\n", 1)):
            path.write_text(text, encoding="utf-8")
            found = complaints(program, style, [path])
            report.check((len(found) > 0) == bool(wrong), f"{text!r}: {found}")
    return report.finish()


def main(arguments):
    program, where = arguments[1:3]
    if where == "--self-test":
        return self_test(program, pathlib.Path(__file__).resolve().parents[2] / ".clang-format")
    report = Report()
    root = pathlib.Path(where)
    wrong = complaints(program, root / ".clang-format", files_of(root))
    report.check(not wrong, "\n".join(wrong))
    return report.finish()


sys.exit(main(sys.argv))
