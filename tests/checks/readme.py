"""README's code is the code that is compiled: its C blocks stand in the sources, its commands exist.

readme.py SOURCE_DIRECTORY
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
readme = (root / "README.md").read_text(encoding="utf-8")
problems = []

header = (root / "host_sim/scenes/s1.h").read_text(encoding="utf-8")
tables = header[header.index("static const"):header.rindex("#endif")].strip()
def marked(path):
    """The part of a program between the marks."""
    program = (root / path).read_text(encoding="utf-8")
    return program.split("/* README: begin */")[1].split("/* README: end */")[0].strip()


blocks = [block.strip() for block in re.findall(r"```c\n(.*?)```", readme, re.S)]
for name, code in (("host_sim/scenes/s1.h", tables), ("tests/consumers/main.c", marked("tests/consumers/main.c")),
                   ("tests/twocores/example.c", marked("tests/twocores/example.c"))):
    if code not in blocks:
        problems.append(f"README.md has no C block equal to the marked part of {name}")
if len(blocks) != 3:
    problems.append(f"README.md has {len(blocks)} C blocks; 3 are checked")

makefile = (root / "Makefile").read_text(encoding="utf-8")
for target in re.findall(r"\bmake ([a-z-]+)", readme):
    if not re.search(rf"^{target}:.*## ", makefile, re.M):
        problems.append(f"README.md names 'make {target}', which make help does not list")
for path in re.findall(r"\((docs/[^)]+)\)|\b((?:docs|host_sim)/[\w./-]+\.(?:md|nff|h|png))", readme):
    name = path[0] or path[1]
    if not (root / name).exists():
        problems.append(f"README.md names {name}, which does not exist")

for problem in problems:
    print(problem)
print("README's code and names are the tree's" if not problems else f"{len(problems)} problems")
sys.exit(1 if problems else 0)
