"""Builds the bench's images: one renderer drawing one scene, for one target. What is compiled is kept by content."""
import concurrent.futures
import functools
import hashlib
import pathlib
import subprocess
import typing

HERE = pathlib.Path(__file__).resolve().parent
TESTS = HERE.parent
ROOT = TESTS.parent
BAREMETAL = TESTS / "baremetal"


class Failure(Exception):
    """Something the user should read: one sentence, then perhaps a program's output."""


def execute(command, seconds=None, **options):
    """Output of a command, errors included. A command that fails, hangs or is not there is a Failure."""
    words = list(map(str, command))
    try:
        run = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             text=True, errors="replace", timeout=seconds, **options)
    except FileNotFoundError:
        raise Failure(f"there is no {words[0]}: `.ci/install bench` installs it") from None
    except subprocess.TimeoutExpired:
        raise Failure(f"still running after {seconds:g} s: {' '.join(words)}") from None
    if run.returncode != 0:
        raise Failure(f"exit code {run.returncode}: {' '.join(words)}\n{run.stdout}")
    return run.stdout


class Target(typing.NamedTuple):
    """A chip, its compiler and what runs its images."""
    prefix: str                # of the compiler and its tools
    flags: tuple = ()          # of the compiler, wherever it runs
    link: tuple = ()           # when linking
    port: tuple = ()           # C files that stand in for an operating system
    run: tuple = ()            # the emulator, before the image's name
    plugin: str = "-plugin"    # the emulator's option for a plug-in; empty: it counts by other means
    fpu: bool = False


BARE = ("-DFIXCAST_BAREMETAL", "-I", BAREMETAL)


def mps2(machine, *cpu, fpu=False):
    return Target(
        "arm-none-eabi-", ("-mthumb", *cpu, *BARE),
        ("-nostartfiles", "-Wl,--gc-sections", "-L", HERE / "image", "-T", HERE / "image/mps2.ld", "-lm"),
        (BAREMETAL / "start.c", BAREMETAL / "semihost.c"),
        ("qemu-system-arm", "-M", machine, "-display", "none", "-nic", "none", "-monitor", "none", "-serial", "none",
         "-chardev", "stdio,id=output", "-semihosting-config", "enable=on,target=native,chardev=output", "-kernel"),
        fpu=fpu)


# Code for Cortex-M0+ and M4 without FPU takes as many instructions on the M3 that has the memory as on its own chip.
TARGETS = {
    "m0plus": mps2("mps2-an385", "-mcpu=cortex-m0plus"),
    "m3": mps2("mps2-an385", "-mcpu=cortex-m3"),
    "m4": mps2("mps2-an386", "-mcpu=cortex-m4", "-mfloat-abi=soft"),
    "m4f": mps2("mps2-an386", "-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard", fpu=True),
    "host": Target("", link=("-lm",)),
}

# What is linked into an image, besides the port, the scene and, for the core's own renderers, the core.
RENDERERS = {
    "fixcast": ((HERE / "image/fixcast.c",), ()),
    "fixcast-rays": ((HERE / "image/fixcast.c",), ("-DBY_RAYS",)),
}


class Image(typing.NamedTuple):
    """What to build: names of TARGETS and RENDERERS, the compiler's level, the scene's C file, the frame."""
    target: str
    renderer: str
    scene: str
    width: int
    height: int
    opt: str = "-O2"
    profile: int = 0
    dump: bool = False

    def name(self):
        parts = [self.target, self.renderer, self.opt.strip("-"), self.scene, f"{self.width}x{self.height}",
                 f"profile{self.profile}", "dump" if self.dump else ""]
        return "-".join(part for part in parts if part)


class Workshop:
    """Compiles and links under one directory."""

    def __init__(self, work, scene_file, jobs=2):
        """`scene_file(scene, renderer)`: the C file of a scene for a renderer."""
        self.work = pathlib.Path(work).resolve()
        self.scene_file, self.jobs = scene_file, jobs
        for part in ("objects", "images"):
            (self.work / part).mkdir(parents=True, exist_ok=True)

    @functools.lru_cache(maxsize=None)
    def headers(self):
        """All headers that anything here includes, as one digest."""
        paths = [*ROOT.glob("include/**/*.h"), *ROOT.glob("src/core/*.h"), *HERE.rglob("*.h"), *BAREMETAL.glob("*.h")]
        return hashlib.sha256(b"".join(path.read_bytes() for path in sorted(paths))).hexdigest()

    @functools.lru_cache(maxsize=None)
    def version(self, compiler):
        return execute([compiler, "-dumpfullversion"])

    def compile(self, command, source):
        """The object file of a source."""
        recipe = f"{self.version(command[0])} {self.headers()} {' '.join(map(str, command))}".encode()
        digest = hashlib.sha256(recipe + b"\0" + source.read_bytes()).hexdigest()[:20]
        target = self.work / "objects" / f"{source.stem}-{digest}.o"
        if not target.exists():
            # Under another name first: two runs may build the same file, and one may be interrupted.
            fresh = target.with_suffix(f".{id(command):x}.tmp")
            execute([*command, "-c", source, "-o", fresh])
            fresh.rename(target)
        return target

    def build(self, image):
        """(path of the image, path of its map, {object file: source}); the core's sources only where it is linked."""
        target = TARGETS[image.target]
        sources, flags = RENDERERS[image.renderer]
        compiler = [f"{target.prefix}gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", image.opt, "-ffunction-sections",
                    "-fdata-sections", *target.flags, "-I", ROOT / "include"]
        harness = [*compiler, *flags, "-I", HERE / "image", f"-DWIDTH={image.width}", f"-DHEIGHT={image.height}",
                   f"-DSCENE={image.scene}", f"-DPROFILE={image.profile}", *(["-DDUMP"] if image.dump else [])]
        todo = [(harness, HERE / "image/main.c")] + [(harness, source) for source in sources]
        todo += [(compiler, source) for source in target.port]
        if image.renderer.startswith("fixcast"):
            core = [*compiler, "-I", ROOT / "src/core"]
            todo += [(core, source) for source in sorted(ROOT.glob("src/core/*.c"))]
            todo.append((compiler, self.scene_file(image.scene, image.renderer)))
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            objects = list(pool.map(lambda task: self.compile(*task), todo))
        place = self.work / "images" / image.name()
        link = [*compiler, *objects, *target.link, f"-Wl,-Map={place}.map", "-o", f"{place}.elf"]
        recipe = " ".join(map(str, link))
        stamp = pathlib.Path(f"{place}.recipe")
        if not (stamp.exists() and stamp.read_text() == recipe):
            stamp.unlink(missing_ok=True)
            execute(link)
            stamp.write_text(recipe)
        return pathlib.Path(f"{place}.elf"), pathlib.Path(f"{place}.map"), \
            {str(made): source for made, (_, source) in zip(objects, todo)}
