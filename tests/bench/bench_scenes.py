"""The bench's scenes: those of host_sim/scenes and those that only the bench draws, as NFF and as C files."""
import functools
import os
import pathlib
import re
import sys

import rival_scene
from images import Failure, ROOT, execute

SCENES = ROOT / "host_sim/scenes"
GENERATOR = SCENES / "generate.py"


def outdated(made, *sources):
    return not made.exists() or made.stat().st_mtime < max(source.stat().st_mtime for source in sources)


def name_of(file):
    """A name for C from a file's name."""
    return "".join(c if c.isalnum() else "_" for c in pathlib.Path(file).stem)


class Scenes:
    """Makes what is missing or older than its source, under one directory."""

    def __init__(self, work, simulator, files=()):
        """`files`: scenes from elsewhere, each named by its file's name without the ending."""
        self.place, self.simulator = pathlib.Path(work).resolve() / "scenes", pathlib.Path(simulator)
        self.files = {name_of(file): pathlib.Path(file) for file in files}
        self.place.mkdir(parents=True, exist_ok=True)

    @functools.lru_cache(maxsize=None)
    def source(self, scene):
        """The file of a scene."""
        if scene in self.files:
            return self.files[scene]
        path = SCENES / f"{scene}.nff"
        if path.exists():
            return path
        stamp = self.place / "generated"
        if outdated(stamp, GENERATOR):
            execute([sys.executable, GENERATOR, "--bench", self.place])
            stamp.touch()
        path = self.place / f"{scene}.nff"
        if not re.fullmatch(r"\w+", scene) or not path.exists():
            names = {file.stem for place in (SCENES, self.place) for file in place.glob("*.nff")}
            raise Failure(f"there is no scene {scene}; there are {', '.join(sorted(names))}")
        return path

    @functools.lru_cache(maxsize=None)
    def kind(self, scene):
        """quadrics: spheres and planes; mesh: triangles in final colours; other: anything else."""
        if self.source(scene).suffix == ".obj":
            return "other"
        text = self.source(scene).read_text()
        if re.search(r"^#fc: (image|mirror) ", text, re.MULTILINE):
            return "other"
        if not re.search(r"^pp? ", text, re.MULTILINE):
            return "quadrics"
        return "mesh" if not re.search(r"^(l|s|#fc: plane) ", text, re.MULTILINE) else "other"

    @functools.lru_cache(maxsize=None)
    def baked(self, scene):
        """The core's tables."""
        source, made = self.source(scene), self.place / f"{scene}.c"
        if not self.simulator.exists():
            raise Failure(f"there is no {self.simulator}: run `make build`")
        if outdated(made, source, self.simulator):
            fresh = made.with_suffix(f".{os.getpid()}")
            execute([self.simulator, "bake", source, "-o", fresh, "--name", scene])
            fresh.rename(made)
        return made

    @functools.lru_cache(maxsize=None)
    def for_rivals(self, scene):
        source, made = self.source(scene), self.place / f"{scene}_rivals.c"
        if outdated(made, source, pathlib.Path(rival_scene.__file__)):
            rival_scene.write(source, made)
        return made
