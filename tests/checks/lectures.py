"""docs/LECTURES.md names only what is there: pictures, source files, public names, tests; and it shows every picture of the gallery.

lectures.py ROOT                 checks a tree
lectures.py --self-test ROOT     proves that each kind of dead reference is noticed
"""
import pathlib
import re
import sys

from support import Report

SOURCE = re.compile(r"(?<![\w/.])((?:[\w]+/)*\w+\.(?:c|h|cpp|py))\b")
TEST = re.compile(r"\btests ((?:[a-z]+_)?[a-z]+(?:(?:, | and )[a-z]+_[a-z]+)*)")


def tests_of(root):
    """Names that CMake gives tests, as far as the page uses them: by files and by add_labelled_test."""
    names = set(re.findall(r"add_labelled_test\((\w+)", (root / "tests/CMakeLists.txt").read_text()))
    names |= {f"volume_{path.stem}" for path in (root / "tests/volume").glob("*.cpp")}
    return names | {f"core_{path.stem.removeprefix('test_')}" for path in (root / "tests/core").glob("test_*.c")}


def check(root, text, report):
    files = {path.relative_to(root).as_posix() for top in ("include", "src", "host_sim", "tests") for path in (root / top).rglob("*")}
    public = "".join(path.read_text() for path in (root / "include").rglob("*.h"))
    shown = set(re.findall(r"gallery/\w+\.png", text))
    for picture in sorted(shown):
        report.check((root / "docs" / picture).is_file(), f"there is no docs/{picture}")
    for picture in sorted((root / "docs/gallery").glob("*.png")):
        report.check(f"![" in text and f"(gallery/{picture.name})" in text, f"docs/gallery/{picture.name} is not shown")
    for name in sorted(set(SOURCE.findall(text))):
        report.check(any(file == name or file.endswith(f"/{name}") for file in files), f"there is no {name}")
    for name in sorted(set(re.findall(r"\b(?:fc|FC)_\w+", text))):
        report.check(re.search(rf"\b{name}\b", public), f"no public header has {name}")
    tests = tests_of(root)
    for names in sorted(set(TEST.findall(text))):
        for name in re.split(r", | and ", names):
            report.check(name in tests, f"there is no test {name}")
    report.check(len(shown) > 8 and len(set(SOURCE.findall(text))) > 20, "the page names hardly anything: has its form changed?")


def self_test(root, text):
    report = Report()
    for what, change in (("nothing", text), ("a picture", text + "\n![x](gallery/none.png)\n"),
                         ("an unseen picture", text.replace("(gallery/cracks.png)", "")), ("a file", text + " none.c "),
                         ("a name", text + " `fc_none` "), ("a test", text + " tests core_none ")):
        found = Report()
        check(root, change, found)
        report.equal(f"faults found after {what}", 0 if what == "nothing" else 1, len(found.wrong))
    return report.finish()


def main(arguments):
    root = pathlib.Path(arguments[-1]).resolve()
    text = (root / "docs/LECTURES.md").read_text(encoding="utf-8")
    if arguments[0] == "--self-test":
        return self_test(root, text)
    report = Report()
    check(root, text, report)
    return report.finish()


sys.exit(main(sys.argv[1:]))
