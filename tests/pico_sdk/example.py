"""The example for the Raspberry Pi Pico SDK (examples/pico-sdk): builds it with the SDK as Debian has it, runs its UF2 file in an emulator, and
compares what the glass shows with the simulator's picture.

example.py SIMULATOR WORK
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
for place in ("checks", "firmware", "linux"):
    sys.path.insert(0, str(HERE.parent / place))

import debian  # noqa: E402
import expected  # noqa: E402
from support import ROOT, Report  # noqa: E402

sys.path.insert(0, str(ROOT / "src/port/tools"))
import boards  # noqa: E402
import rp2040  # noqa: E402
import uf2  # noqa: E402
from run import execute  # noqa: E402

FRAMES = 2
RELEASE = "trixie"  # the first that has the SDK: 2.1.1


def sdk(work):
    """The SDK's directory, fetched once."""
    place = work / "sdk"
    if not place.exists():
        package = debian.Archive(work.parent / "packages", "amd64", RELEASE).fetch("pico-sdk-source")
        fresh = work / "sdk.part"
        subprocess.run(["dpkg-deb", "-x", package, fresh], check=True)
        fresh.rename(place)
    return place / "usr/src/pico-sdk"


def build(work):
    """The example's program."""
    what = "building the example for the Pico SDK"
    # The SDK has a C++ file in every program, and so links with C++'s library, of which this one needs nothing. The whole of it would be
    # a package of 1.5 GB.
    library = work / "library"
    library.mkdir(exist_ok=True)
    if not (library / "libstdc++.a").exists():
        execute(["arm-none-eabi-ar", "rcs", library / "libstdc++.a"], what)
    execute(["cmake", "-S", ROOT / "examples/pico-sdk", "-B", work / "example", f"-DPICO_SDK_PATH={sdk(work)}", "-DPICO_NO_PICOTOOL=1",
             f"-DCMAKE_EXE_LINKER_FLAGS=-L{library}", "--log-level=ERROR"], what)
    text = execute(["cmake", "--build", work / "example", "--parallel", "2"], what)
    own = [line for line in text.splitlines() if "warning:" in line and str(ROOT / "examples") in line]
    return work / "example/spheres.elf", own


def rom(work):
    """What the program calls in the boot ROM."""
    program, image = work / "rom.elf", work / "rom.bin"
    execute(["arm-none-eabi-gcc", "-nostdlib", "-Wl,-Ttext=0", "-Wl,-e0", HERE / "rom.S", "-o", program], "building a boot ROM")
    execute(["arm-none-eabi-objcopy", "-O", "binary", program, image], "building a boot ROM")
    return image


def check(report, simulator, work):
    program, warnings = build(work)
    report.equal("warnings", [], warnings)
    uf2.finish(program)
    # The SDK puts the CRC of its second boot stage there itself: what uf2.py reckons must be that.
    sealed = uf2.flash_pages(program.read_bytes())[uf2.FLASH]
    report.equal("CRC of the SDK's second boot stage", bytes(sealed[uf2.BOOT2_BYTES:]),
                 uf2.crc32_mpeg2(sealed[:uf2.BOOT2_BYTES]).to_bytes(4, "little"))
    seen = rp2040.watch(program, "st7789-240", FRAMES, words=[f"rom={rom(work)}"], function="frame_shown")
    for problem in seen.figures["problems"]:
        report.check(False, problem)
    report.equal("frames", FRAMES + 1, len(seen.pictures))
    wanted = expected.crc_565(simulator, 0, 240, 240)
    for number, picture in enumerate(seen.pictures):
        report.equal(f"frame {number} on the glass", wanted, expected.crc(expected.bytes_565(expected.pixels_565(picture))))
    report.check("frame 0: " in seen.text, f"the program says nothing of its frames: {seen.text!r}")


def main(arguments):
    simulator, work = arguments[0], pathlib.Path(arguments[1]).resolve()
    work.mkdir(parents=True, exist_ok=True)
    report = Report()
    try:
        check(report, simulator, work)
    except boards.Failure as failure:
        report.check(False, str(failure))
    return report.finish()


sys.exit(main(sys.argv[1:]))
