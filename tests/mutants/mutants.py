"""How well the tests watch the code that decides: changes it in one place, builds, runs the fast tests, and lists the changes that no test noticed.

mutants.py --work DIR [--count N] [--seed S]   N mutants (48), the same ones for the same sources and seed
mutants.py --self-test                         proves that mutants are made, compared and looked up as meant

A copy of the tree in DIR is changed, one core object compiled and the tests linked again. The result of each mutant is kept in
DIR/results.txt, so an interrupted run goes on. Survivors must stand in docs/MUTANTS.md with a reason; others fail the run.
"""
import argparse
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys

import mutate

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXPLAINED = ROOT / "docs" / "MUTANTS.md"
INTERSECT = ("sphere", "plane", "triangle", "triangle_shadow", "root", "segment", "depth")
SCAN = ("scan", "scan_plane", "scan_sphere", "scan_triangle", "facet", "cone", "planar")
FILES = [f"src/core/{name}.c" for name in INTERSECT + SCAN]
SECONDS = 120  # for a step that takes 20 at most: whoever takes longer hangs

# Quickest to notice first; a mutant that one step notices skips the rest.
SLOW_UNITS = "^core_(bvh|scan_triangle|any_scene)$"
STEPS = (
    ("goldens", ["ctest", "-L", "^frame$", "--stop-on-failure"]),
    ("units", ["ctest", "-L", "^unit$", "-R", "^core_", "-E", SLOW_UNITS, "--stop-on-failure"]),
    ("any scene, scan_triangle", ["ctest", "-R", "^core_(any_scene|scan_triangle)$", "--stop-on-failure"]),
    ("torture", ["tests/torture", "--trials", "300"]),
    ("engines", ["ctest", "-R", "^engines$"]),
)


def execute(command, directory, seconds=None):
    """(exit code, output); a command that takes too long has the code None."""
    try:
        run = subprocess.run(command, cwd=directory, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             errors="replace", timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, ""
    return run.returncode, run.stdout


def chosen(count, seed, root=ROOT):
    """An endless supply of mutants, one a file and operator in turn: no file and no operator is left out because others are longer."""
    generator, piles = random.Random(seed), {}
    for file in FILES:
        for mutant in mutate.mutants(file, (root / file).read_text(encoding="utf-8")):
            piles.setdefault(file, {}).setdefault(mutant.operator, []).append(mutant)
    for operators in piles.values():
        for pile in operators.values():
            generator.shuffle(pile)
    turn = 0
    while piles and count > 0:
        for place, file in enumerate(list(piles)):
            names = sorted(piles[file])
            name = names[(turn * 3 + place) % len(names)]
            yield piles[file][name].pop()
            if not piles[file][name]:
                del piles[file][name]
            if not piles[file]:
                del piles[file]
        turn += 1


class Copy:
    """The tree that is changed, and its build."""

    def __init__(self, work):
        self.tree, self.build = work / "tree", work / "build"
        names = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines()
        for name in names:
            source, target = ROOT / name, self.tree / name
            if source.is_file() and not (target.is_file() and target.read_bytes() == source.read_bytes()):
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, target)
        self.run(["cmake", "-S", self.tree, "-B", self.build, f"-DFIXCAST_BAKED_DIR={work.parent / 'baked'}"])
        self.run(["cmake", "--build", self.build, "--parallel", "2", "--target", "mutant_tests"])

    def run(self, command):
        code, output = execute(list(map(str, command)), None)
        if code != 0:
            sys.exit(f"mutants: {' '.join(map(str, command))} failed:\n{output[-3000:]}")

    def object(self, file):
        """Compiled code of a core file."""
        paths = [path for path in self.build.glob(f"CMakeFiles/fixcast.dir/{file}.o*") if path.suffix in (".o", ".obj")]
        if len(paths) != 1:
            sys.exit(f"mutants: {file} has {len(paths)} object files in {self.build}")
        return paths[0].read_bytes()

    def outcome(self, mutant):
        """'not built', 'same code', 'survived', or the name of the step that noticed it."""
        path = self.tree / mutant.file
        original, before = path.read_text(encoding="utf-8"), self.object(mutant.file)
        path.write_text(mutant.text, encoding="utf-8")
        try:
            if execute(["cmake", "--build", self.build, "--target", "fixcast"], None)[0] != 0:
                return "not built"
            if self.object(mutant.file) == before:
                return "same code"
            if execute(["cmake", "--build", self.build, "--target", "mutant_tests"], None)[0] != 0:
                return "not built"
            return self.noticed()
        finally:
            path.write_text(original, encoding="utf-8")

    def noticed(self):
        for name, command in STEPS:
            code, _ = execute(["timeout", str(SECONDS), *command], self.build)
            if code:
                return f"{name} (hangs)" if code == 124 else name
        return "survived"


def explained(text):
    """Keys of the survivors that docs/MUTANTS.md explains: rows | `file` | `before` | `after` | why |."""
    keys = set()
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)]
        if len(cells) == 6 and all(re.fullmatch("`.*`", cell) for cell in cells[1:4]) and cells[4]:
            keys.add(tuple(cell.strip("`").replace("\\|", "|") for cell in cells[1:4]))
    return keys


def row(mutant):
    cells = (mutant.file, mutant.before, mutant.after)
    return "| " + " | ".join("`" + cell.replace("|", "\\|") + "`" for cell in cells) + " | why |"


def hunt(work, count, seed):
    work.mkdir(parents=True, exist_ok=True)
    kept = work / "results.txt"
    known = dict(line.split("\t", 1) for line in kept.read_text().splitlines()) if kept.exists() else {}
    copy, reasons = Copy(work), explained(EXPLAINED.read_text(encoding="utf-8"))
    broken = copy.noticed()
    if broken != "survived":
        sys.exit(f"mutants: {broken} fails on the unchanged tree")
    judged, survivors, tally = 0, [], {}
    for mutant in chosen(count, seed):
        name = f"{mutant.file}:{mutant.line}: {mutant.operator}: {mutant.before}  ->  {mutant.after}"
        if name not in known:
            known[name] = copy.outcome(mutant)
            with open(kept, "a", encoding="utf-8") as out:
                out.write(f"{name}\t{known[name]}\n")
        result = known[name]
        print(f"{result:>26}  {name}", flush=True)
        tally[result] = tally.get(result, 0) + 1
        if result == "survived":
            survivors.append(mutant)
        judged += result not in ("not built", "same code")
        if judged == count:
            break
    print("\n" + ", ".join(f"{number} {result}" for result, number in sorted(tally.items(), key=lambda item: -item[1])))
    unexplained = [mutant for mutant in survivors if mutant.key() not in reasons]
    for mutant in unexplained:
        print(f"not in docs/MUTANTS.md: {row(mutant)}")
    print(f"{judged} mutants, {judged - len(survivors)} noticed, {len(survivors)} survived, {len(unexplained)} of these unexplained")
    return 1 if unexplained or judged < count else 0


def self_test():
    wrong = mutate.self_test()
    mutant = mutate.Mutant("src/core/a.c", 3, "logic", "if (a || b) return;", "if (a && b) return;", "")
    if explained(row(mutant)) != {mutant.key()}:
        wrong.append("a survivor's row is not found again")
    if explained(row(mutant).replace("why", "")) or explained("| file | before | after | why |"):
        wrong.append("a row without a reason or a head of a table counts as explained")
    first = [next_mutant.key() for next_mutant, _ in zip(chosen(48, 1), range(60))]
    again = [next_mutant.key() for next_mutant, _ in zip(chosen(48, 1), range(60))]
    if first != again:
        wrong.append("the same seed gives other mutants")
    if {key[0] for key in first} != set(FILES):
        wrong.append("a file is left out")
    for text in wrong:
        print("FAIL:", text)
    print("self-test passed" if not wrong else f"{len(wrong)} wrong")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "mutants")
    parser.add_argument("--count", type=int, default=48)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        return self_test()
    os.nice(19)
    return hunt(options.work.resolve(), options.count, options.seed)


if __name__ == "__main__":
    sys.exit(main())
