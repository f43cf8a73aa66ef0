"""Builds the bench's images: one renderer drawing one scene, for one target. What is compiled is kept by content."""
import concurrent.futures
import functools
import hashlib
import os
import pathlib
import subprocess
import time
import typing

HERE = pathlib.Path(__file__).resolve().parent
TESTS = HERE.parent
ROOT = TESTS.parent
BAREMETAL = TESTS / "baremetal"
KEEP_SECONDS = 3 * 24 * 3600  # compiled files that are older are made again


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
        raise Failure(f"{words[0]} ended with exit code {run.returncode}:\n{run.stdout}\nThe command was: "
                      f"{' '.join(words)}")
    return run.stdout


class Target(typing.NamedTuple):
    """A chip, its compiler and what runs its images."""
    prefix: str                # of the compiler and its tools
    flags: tuple = ()          # of the compiler, wherever it runs
    link: tuple = ()           # when linking
    port: tuple = ()           # C files that stand in for an operating system
    run: tuple = ()            # the emulator, before the image's name


BARE = ("-DFIXCAST_BAREMETAL", "-I", BAREMETAL)


def mps2(machine, *cpu):
    return Target(
        "arm-none-eabi-", ("-mthumb", *cpu, *BARE),
        ("-nostartfiles", "-Wl,--gc-sections", "-L", HERE / "image", "-T", HERE / "image/mps2.ld", "-lm"),
        (BAREMETAL / "start.c", BAREMETAL / "semihost.c"),
        ("qemu-system-arm", "-M", machine, "-display", "none", "-nic", "none", "-monitor", "none", "-serial", "none",
         "-chardev", "stdio,id=output", "-semihosting-config", "enable=on,target=native,chardev=output", "-kernel"))


# Code for Cortex-M0+ and M4 without FPU takes as many instructions on the M3 that has the memory as on its own chip.
TARGETS = {
    "m0plus": mps2("mps2-an385", "-mcpu=cortex-m0plus"),
    "m3": mps2("mps2-an385", "-mcpu=cortex-m3"),
    "m4": mps2("mps2-an386", "-mcpu=cortex-m4", "-mfloat-abi=soft"),
    "m4f": mps2("mps2-an386", "-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"),
    "rv32": Target(
        "riscv64-unknown-elf-", ("-march=rv32imc", "-mabi=ilp32", "--specs=picolibc.specs", *BARE),
        ("-nostartfiles", "-Wl,--gc-sections", "-L", HERE / "image", "-T", HERE / "image/rv32.ld", "-lm"),
        (TESTS / "matrix/riscv32.c",), ("qemu-riscv32",)),
    # An M0+ in the emulator that knows its cycles; see cycles.mjs.
    "rp2040": Target(
        "arm-none-eabi-", ("-mthumb", "-mcpu=cortex-m0plus", "-DMEMORY_BYTES=65536", *BARE),
        ("-nostartfiles", "-Wl,--gc-sections", "-L", HERE / "image", "-T", HERE / "image/rp2040.ld", "-lm"),
        (BAREMETAL / "start.c", BAREMETAL / "semihost.c"), ("node",)),
    "host": Target("", link=("-lm",)),
}


class Renderer(typing.NamedTuple):
    """A program of the harness: its source for scenes of spheres and planes, for flat meshes, for all others."""
    quadrics: typing.Optional[pathlib.Path] = None
    mesh: typing.Optional[pathlib.Path] = None
    other: typing.Optional[pathlib.Path] = None
    flags: tuple = ()
    core: bool = False  # draws baked scenes with the core

    def source(self, kind):
        return getattr(self, kind)


def core_renderer(*flags):
    return Renderer(*[HERE / "image/fixcast.c"] * 3, flags, core=True)


# No errno after a root: the chip's own instruction will do.
RIVALS, RIVAL_FLAGS = HERE / "rivals", ("-fno-math-errno", "-I", HERE / "rivals")
RENDERERS = {
    "fixcast": core_renderer(),
    "fixcast-rays": core_renderer("-DBY_RAYS"),
    # Several rays a pixel, for the gallery.
    "fixcast-one": core_renderer("-DPATTERN=fc_pattern_one", "-DCOUNT=0"),
    "fixcast-regular": core_renderer("-DPATTERN=fc_pattern_regular", "-DCOUNT=4"),
    "fixcast-random": core_renderer("-DPATTERN=fc_pattern_random", "-DCOUNT=16"),
    "fixcast-jittered": core_renderer("-DPATTERN=fc_pattern_jittered", "-DCOUNT=4"),
    "fixcast-quincunx": core_renderer("-DPATTERN=fc_pattern_quincunx", "-DCOUNT=0"),
    "float": Renderer(RIVALS / "rays.c", RIVALS / "mesh_float.c",
                      flags=("-DREAL=float", "-DSQRT=sqrtf", *RIVAL_FLAGS)),
    "double": Renderer(RIVALS / "rays.c", RIVALS / "mesh_float.c", flags=("-DREAL=double", "-DSQRT=sqrt", *RIVAL_FLAGS)),
    "q16": Renderer(RIVALS / "rays_q16.c", flags=("-DREAL_IS_Q16", *RIVAL_FLAGS)),
    "scan_float": Renderer(RIVALS / "scan_float.c", flags=("-DREAL=float", *RIVAL_FLAGS)),
    "fixed": Renderer(mesh=RIVALS / "mesh_fixed.c", flags=("-DREAL_IS_Q16", *RIVAL_FLAGS)),
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

    def __init__(self, work, scenes, source=ROOT, jobs=2):
        """`scenes`: a bench_scenes.Scenes. `source`: the tree whose core is measured."""
        self.work, self.source = pathlib.Path(work).resolve(), pathlib.Path(source).resolve()
        self.scenes, self.jobs = scenes, jobs
        for part in ("objects", "images"):
            (self.work / part).mkdir(parents=True, exist_ok=True)
            for path in (self.work / part).iterdir():
                if path.stat().st_mtime < time.time() - KEEP_SECONDS:
                    path.unlink(missing_ok=True)

    @functools.lru_cache(maxsize=None)
    def headers(self):
        """All headers and linker scripts that anything here uses, as one digest."""
        paths = [*self.source.glob("include/**/*.h"), *self.source.glob("src/core/*.h"), *HERE.rglob("*.h"),
                 *HERE.rglob("*.ld"), *BAREMETAL.glob("*.h")]
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
            fresh = target.with_suffix(f".{os.getpid()}-{id(command):x}")
            execute([*command, "-c", source, "-o", fresh])
            fresh.rename(target)
        return target

    def build(self, image):
        """(path of the image, path of its map, {object file: source})."""
        target, renderer = TARGETS[image.target], RENDERERS[image.renderer]
        program = renderer.source(self.scenes.kind(image.scene))
        if program is None:
            raise Failure(f"{image.renderer} does not draw {image.scene}")
        compiler = [f"{target.prefix}gcc", "-std=c99", image.opt, "-ffunction-sections", "-fdata-sections",
                    *target.flags, "-I", self.source / "include"]
        harness = [*compiler, "-Wall", "-Wextra", "-Werror", *renderer.flags, "-I", HERE / "image", f"-DWIDTH={image.width}",
                   f"-DHEIGHT={image.height}", f"-DSCENE={image.scene}", f"-DPROFILE={image.profile}",
                   *(["-DDUMP"] if image.dump else [])]
        todo = [(harness, HERE / "image" / ("dump.c" if image.dump else "main.c")), (harness, program)]
        todo += [(compiler, source) for source in target.port]
        if renderer.core:
            core = [*compiler, "-I", self.source / "src/core"]
            todo += [(core, source) for source in sorted(self.source.glob("src/core/*.c"))]
            todo.append((compiler, self.scenes.baked(image.scene)))
        else:
            todo.append((harness, self.scenes.for_rivals(image.scene)))
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            objects = list(pool.map(lambda task: self.compile(*task), todo))
        link = [*compiler, *objects, *target.link]
        digest = hashlib.sha256(f"{self.headers()} {' '.join(map(str, link))}".encode()).hexdigest()[:12]
        made = self.work / "images" / f"{image.name()}-{digest}.elf"
        if not made.exists():
            fresh = made.with_suffix(f".{os.getpid()}")
            execute([*link, f"-Wl,-Map={made.with_suffix('.map')}", "-o", fresh])
            fresh.rename(made)
        return made, made.with_suffix(".map"), {str(path): source for path, (_, source) in zip(objects, todo)}
