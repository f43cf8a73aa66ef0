"""What the documents say exists: links and their anchors, files, `make` targets, `fixcast` commands, ctest names; and SECURITY.md's watchers.

docs.py ROOT SIMULATOR BUILD   checks README.md, CONTRIBUTING.md and docs/*.md of a tree; BUILD: where ctest knows its tests
docs.py --self-test            proves on made-up documents that each kind of mistake is noticed
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from support import Report

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
# Of file names with a directory of the tree in front; words in capitals stand for what the reader chooses.
FILE = re.compile(r"(?<![\w/.-])((?:docs|src|include|tests|host_sim|examples|\.ci)/[\w./-]*[\w/])")
COMMAND = re.compile(r"(?:`|^|build/)fixcast ([a-z]+)\b", re.M)
# What readers call their own files.
OWN = {"scene.c", "s1.c", "gloss.c"}
CODE = re.compile(r"```.*?```|`[^`\n]+`", re.S)


def anchor(heading):
    """GitHub's: lower case, no punctuation, hyphens for spaces."""
    text = re.sub(r"[`*]", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def anchors_of(path):
    text = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.S)
    return {anchor(match) for match in re.findall(r"^#+ (.*)$", text, re.M)}


def check_links(root, path, text, report):
    for target in LINK.findall(re.sub(r"```.*?```", "", text, flags=re.S)):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, part = target.partition("#")
        place = (path.parent / name).resolve() if name else path
        if report.check(place.exists(), f"{path.relative_to(root)}: a link to {target}, which is not there") and part and place.suffix == ".md":
            report.check(part in anchors_of(place), f"{path.relative_to(root)}: {target}: no such heading")


def check_names(root, path, text, targets, commands, sources, report):
    where = path.relative_to(root)
    for name in sorted(set(FILE.findall(LINK.sub("", text)))):
        if "NAME" in name or re.search(r"\b[A-Z]{4,}\b(?!\.md)", name):
            continue
        found = (root / name).exists() or list(root.glob(f"{name}.*")) or list(root.glob(f"{name}*"))
        report.check(bool(found), f"{where}: names {name}, which is not there")
    for name in sorted(set(re.findall(r"(?<![\w/.])(\w+\.[ch])\b", text)) - OWN):
        report.check(name in sources["files"], f"{where}: names {name}; no file is called that")
    for name in sorted(set(re.findall(r"\bfc_\w*[a-z0-9]\b(?![*_])", text))):
        report.check(name in sources["text"], f"{where}: names {name}, which stands in no source")
    code = "\n".join(CODE.findall(text))
    for target in sorted(set(re.findall(r"\bmake ([a-z][a-z-]*)", code))):
        report.check(target in targets, f"{where}: `make {target}`: no such target")
    for command in sorted(set(COMMAND.findall(code))):
        report.check(command in commands, f"{where}: `fixcast {command}`: no such command")


def check_watchers(path, tests, report):
    """Rows of SECURITY.md's table: | S1 | invariant | `test`, `fuzz_target` |; each must name what watches it, and that must exist."""
    rows = re.findall(r"^\| (S\d+) \|(.*)\|([^|]*)\|$", path.read_text(encoding="utf-8"), re.M)
    report.check([row[0] for row in rows] == [f"S{number + 1}" for number in range(len(rows))] and rows != [],
                 f"{path.name}: invariants S1, S2, ... in order are expected")
    for number, _, watchers in rows:
        names = re.findall(r"`([^`]+)`", watchers)
        report.check(names != [], f"{path.name}: {number} names no test")
        for name in names:
            report.check(name in tests, f"{path.name}: {number}: there is no test or fuzz target {name}")


def names_of_tests(root):
    """Names of tests that other builds have too (variants, chips); functions test_*, and fuzz targets."""
    names = set()
    for path in root.glob("tests/**/CMakeLists.txt"):
        text = path.read_text(encoding="utf-8")
        names.update(re.findall(r"add_(?:labelled_test|test|variant)\((?:NAME )?([\w]+)", text))
    names.update(re.sub("^test_", "core_", path.stem) for path in root.glob("tests/core/test_*.c"))
    names.update(f"panel_{path.stem[5:]}" for path in root.glob("tests/panel/test_*.c"))
    names.update(f"firmware_{path.stem[5:]}" for path in root.glob("tests/firmware/test_*.c"))
    names.update(f"volume_{path.stem}" for path in root.glob("tests/volume/*.cpp"))
    names.update(path.stem for path in root.glob("tests/fuzz/fuzz_*.cpp"))
    for path in root.glob("tests/**/test_*.c"):
        names.update(re.findall(r"^static void (test_\w+)\(", path.read_text(encoding="utf-8"), re.M))
    return names


def names_of_ctest(build):
    text = subprocess.run(["ctest", "-N"], cwd=build, capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"^ *Test +#\d+: (\S+)", text, re.M))


def check(root, commands, tests, report):
    targets = set(re.findall(r"^([a-z][a-z-]*):", (root / "Makefile").read_text(encoding="utf-8"), re.M))
    code = [path for part in ("include", "src", "host_sim", "tests", "examples") for path in (root / part).rglob("*.[ch]*")]
    sources = {"files": {path.name for path in code}, "text": {word for path in code if path.is_file() and path.suffix in (".c", ".h", ".cpp")
               for word in re.findall(r"\bfc_\w+", path.read_text(encoding="utf-8", errors="replace"))}}
    for path in [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").glob("*.md"))]:
        text = path.read_text(encoding="utf-8")
        check_links(root, path, text, report)
        check_names(root, path, text, targets, commands, sources, report)
    check_watchers(root / "docs/SECURITY.md", names_of_tests(root) | tests, report)


GOOD = {
    "Makefile": "demo: ## x\n\techo\n",
    "README.md": "# A b\n[c](docs/C.md#the-way) [d](#a-b) `make demo`\n```sh\nbuild/fixcast render x\n```\nsrc/a.c\n",
    "CONTRIBUTING.md": "x\n",
    "docs/C.md": "## The way\n",
    "docs/SECURITY.md": "| S1 | holds | `core_a` |\n| S2 | holds | `fuzz_b`, `test_c` |\n",
    "src/a.c": "",
    "tests/core/test_a.c": "static void test_c(void) {}\n",
    "tests/fuzz/fuzz_b.cpp": "",
}
BAD = (("README.md", "[x](docs/D.md)\n"), ("README.md", "[x](docs/C.md#another-way)\n"), ("README.md", "[x](#nowhere)\n"), ("README.md", "`make tea`\n"),
       ("docs/C.md", "`fixcast boil`\n"), ("docs/C.md", "src/b.c\n"), ("docs/C.md", "see b.c\n"), ("docs/C.md", "fc_b\n"), ("docs/SECURITY.md", "| S3 | holds | `core_d` |\n"),
       ("docs/SECURITY.md", "| S3 | holds | none |\n"), ("docs/SECURITY.md", "| S4 | holds | `core_a` |\n"))


def self_test():
    for name, added in ((None, ""), *BAD):
        with tempfile.TemporaryDirectory() as directory:
            root = pathlib.Path(directory).resolve()
            for path, text in GOOD.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text + (added if path == name else ""))
            report = Report()
            check(root, {"render"}, set(), report)
        if len(report.wrong) != (0 if name is None else 1):
            sys.exit(f"{name} with {added!r}: {len(report.wrong)} complaints")
    print("self-test passed: the failures above were meant")
    return 0


def main(arguments):
    if arguments[0] == "--self-test":
        return self_test()
    text = subprocess.run([arguments[1], "--help"], capture_output=True, text=True, check=True).stdout
    report = Report()
    check(pathlib.Path(arguments[0]).resolve(), set(re.findall(r"^  ([a-z]+)\b", text, re.M)), names_of_ctest(arguments[2]), report)
    return report.finish()


sys.exit(main(sys.argv[1:]))
