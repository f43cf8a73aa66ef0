"""Lines and branches of the core that the unit and frame tests run through, as gcov counted them.

coverage.py BUILD        BUILD: a tree compiled with --coverage in which the tests have run; the counts are read and reset
coverage.py --self-test  proves that a low figure, an unexplained line and an outdated reason are noticed

At least 95 % of the lines and 88 % of the branches of src/core must have been taken; 90 % are wanted, and were there before the layers' fast forms
(coat_*.c), whose rare branches are torture's and `materials`'. Functions with lines that no test reaches
stand in untested.txt, with the reason; a function that is not there, or is there without need, fails the test.
"""
import collections
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
UNTESTED = pathlib.Path(__file__).resolve().parent / "untested.txt"
LEAST = {"lines": 95.0, "branches": 88.0}
FUNCTION = re.compile(r"^(?:[A-Za-z_][\w ]*[ *])?(\w+)\([^;]*$")


def measure(build):
    """gcovr's record of src/core."""
    command = ["gcovr", "--root", ROOT, "--filter", str(ROOT / "src/core/"), "--exclude-throw-branches", "--json", "--", build]
    run = subprocess.run(list(map(str, command)), capture_output=True, text=True, cwd=build)
    if run.returncode != 0:
        sys.exit(f"gcovr failed: {run.stderr.strip()}\n`.ci/install test` installs it")
    return json.loads(run.stdout)["files"]


def function_at(text, line):
    """Name of the function that a line stands in: the last one before it that starts at the margin."""
    for before in reversed(text.splitlines()[:line]):
        match = FUNCTION.match(before)
        if match:
            return match.group(1)
    return "?"


def read_reasons(text):
    """{(file, function): reason}; a line is `file function: reason`."""
    reasons = {}
    for line in text.splitlines():
        match = re.fullmatch(r"(\S+) (\w+): (\S.*)", line)
        if match:
            reasons[match.group(1, 2)] = match.group(3)
        elif line.strip() and not line.startswith("#"):
            sys.exit(f"untested.txt: not `file function: reason`: {line}")
    return reasons


def judge(files, reasons, source_of, say=print):
    """Prints the table; returns what is wrong."""
    sums, wrong, untested = collections.Counter(), [], {}
    say(f"{'file':28}{'lines':>8}{'taken':>8}{'branches':>10}{'taken':>8}  lines that no test reaches")
    for file in sorted(files, key=lambda entry: entry["file"]):
        lines = [line for line in file["lines"] if not line.get("gcovr/noncode")]
        branches = [branch["count"] > 0 for line in lines for branch in line["branches"]]
        missed = [line["line_number"] for line in lines if line["count"] == 0]
        for key, number in (("lines", len(lines)), ("lines taken", len(lines) - len(missed)), ("branches", len(branches)),
                            ("branches taken", sum(branches))):
            sums[key] += number
        say(f"{pathlib.Path(file['file']).name:28}{len(lines):8}{len(lines) - len(missed):8}{len(branches):10}{sum(branches):8}  "
            + " ".join(map(str, missed)))
        for number in missed:
            untested.setdefault((file["file"], function_at(source_of(file["file"]), number)), []).append(number)
    for what, least in LEAST.items():
        if sums[what] == 0:
            return [f"no {what} were counted: did the tests run?"]
        share = 100 * sums[f"{what} taken"] / sums[what]
        say(f"{what}: {sums[f'{what} taken']} of {sums[what]}, {share:.2f} %")
        if share < least:
            wrong.append(f"{share:.2f} % of the {what}; at least {least} %: write tests, or remove what cannot be reached")
    wrong += [f"{file}:{numbers[0]}: no test reaches it, and untested.txt has no reason for `{file} {function}`"
              for (file, function), numbers in untested.items() if (file, function) not in reasons]
    wrong += [f"untested.txt: tests reach all of {file} {function}: remove the line" for file, function in reasons
              if (file, function) not in untested]
    return wrong


def self_test():
    text = "static int f(int a) {\n  a++;\n  return a;\n}\n\nint g(void) {\n  return 1;\n}\n"

    def file(*counts):
        return [{"file": "a.c", "lines": [{"line_number": at, "count": count, "branches": [{"count": count}]} for at, count in counts]}]

    def complaints(files, reasons):
        return judge(files, reasons, lambda _: text, lambda _: None)

    covered = file(*[(2, 1)] * 99, (3, 1))
    almost = file(*[(2, 1)] * 99, (7, 0))
    tests = {
        "all is taken": complaints(covered, {}) == [],
        "a line with a reason": complaints(almost, {("a.c", "g"): "because"}) == [],
        "a line without": len(complaints(almost, {})) == 1 and "a.c g" in complaints(almost, {})[0],
        "a reason without a line": len(complaints(covered, {("a.c", "g"): "because"})) == 1,
        "too few": len(complaints(file((2, 1), (7, 0)), {("a.c", "g"): "because"})) == 2,
        "nothing": len(complaints([], {})) == 1,
        "a file of reasons": read_reasons("# head\na.c g: because\n") == {("a.c", "g"): "because"},
    }
    for name, passed in tests.items():
        print(f"{'passed' if passed else 'FAILED'}: {name}")
    return 0 if all(tests.values()) else 1


def main(argument):
    if argument == "--self-test":
        return self_test()
    build = pathlib.Path(argument).resolve()
    files = measure(build)
    wrong = judge(files, read_reasons(UNTESTED.read_text(encoding="utf-8")), lambda file: (ROOT / file).read_text(encoding="utf-8"))
    for counts in build.rglob("*.gcda"):
        counts.unlink()  # the next run counts anew
    for text in wrong:
        print("FAIL:", text)
    return 1 if wrong else 0


sys.exit(main(sys.argv[1]))
