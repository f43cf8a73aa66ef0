"""A project of somebody else's, made from README's own lines in a directory of its own: what the ways to use the library share."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS / "checks"))
sys.path.insert(0, str(TESTS / "matrix"))
from matrix import MACHINES, Failure, execute  # noqa: E402
from support import ROOT, SCENES, read_golden  # noqa: E402

HERE = TESTS / "consumers"


def readme_block(title):
    """The lines of README's code block whose first line is a comment that begins with the title."""
    blocks = re.findall(r"^```\w+\n[#;] ([^\n]*)\n(.*?)^```$", (ROOT / "README.md").read_text(encoding="utf-8"), re.M | re.S)
    found = [code for first, code in blocks if first.startswith(title)]
    if len(found) != 1:
        raise Failure(f"README.md has {len(found)} code blocks that begin with '{title}', needed is one")
    return found[0]


def environment(**more):
    """This process's, without what would tell a stranger's build about ours."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("CMAKE_PREFIX", "PKG_CONFIG", "CPATH"))}
    return {**kept, **more}


class Project:
    """A fresh directory with README's program and S1."""

    def __init__(self, place, program=HERE / "main.c", scene=SCENES / "s1.h"):
        self.place = pathlib.Path(place).resolve()
        shutil.rmtree(self.place, ignore_errors=True)
        self.place.mkdir(parents=True)
        self.copy(program, program.name)
        self.copy(scene, scene.name)

    def copy(self, source, name):
        target = self.place / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)

    def link_tree(self, name="fixcast"):
        """The source tree under a name in the project."""
        (self.place / name).parent.mkdir(parents=True, exist_ok=True)
        (self.place / name).symlink_to(ROOT)

    def shell(self, lines, **variables):
        return execute(["sh", "-euc", lines], cwd=self.place, env=environment(**variables))

    def cmake(self, *options):
        """Configures and builds. A build with warnings is not what a user wants to see."""
        output = execute(["cmake", "-S", ".", "-B", "build", *options, "--log-level=WARNING"], cwd=self.place, env=environment())
        output += execute(["cmake", "--build", "build", "--parallel", "2"], cwd=self.place, env=environment())
        if re.search(r"\bwarning\b", output, re.I):
            raise Failure(f"the build of {self.place} warns:\n{output}")

    def expect(self, size, program, run=(), **variables):
        """Runs the program; it must print S1's golden line of that size, and nothing wrong."""
        wanted = f"s1 {size} {read_golden()['s1', size]}"
        output = re.sub(r"\x1b\[[\d;]*m", "", execute([*run, program], 100, cwd=self.place, env=environment(**variables)))
        # simavr prints lines with a dot for the end of line.
        if wanted not in [line.rstrip(".\r") for line in output.splitlines()]:
            raise Failure(f"{program} should have printed '{wanted}':\n{output}")
        print(wanted)


def system_python(module):
    """A Python that has a module: this one, or the system's, which Debian's packages of Python modules belong to."""
    for python in (sys.executable, shutil.which("python3", path=os.defpath) or sys.executable):
        if subprocess.run([python, "-c", f"import {module}"], capture_output=True).returncode == 0:
            return python
    raise Failure(f"no Python here has the module {module}: `.ci/install test` installs it")
