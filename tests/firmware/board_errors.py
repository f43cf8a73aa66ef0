"""What `make firmware`, `make emulate` and `make flash` say when they can't: one sentence that names what to do, exit code not 0, no picture.

Needs no board: what is not to be found is taken out of the search path.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "checks"))
from support import ROOT, Report  # noqa: E402

TOOLS = ROOT / "src/port/tools/board.py"
BOARDS = sorted(path.name for path in (ROOT / "src/port").iterdir() if path.is_dir() and path.name != "tools"
                and any(path.glob("*.c")) and path.name not in ("linux",))


def make(*arguments, path=None):
    environment = dict(os.environ, FIXCAST_NO_INSTALL="1", **({"PATH": str(path)} if path else {}))
    environment.pop("BOARD", None)
    return subprocess.run(["make", "--no-print-directory", "-C", ROOT, *arguments], env=environment, capture_output=True,
                          text=True, stdin=subprocess.DEVNULL, timeout=100)


def tool(*arguments, path):
    """The same without make."""
    return subprocess.run([sys.executable, TOOLS, *arguments], env=dict(os.environ, PATH=str(path)), capture_output=True,
                          text=True, stdin=subprocess.DEVNULL, timeout=100)


def script(path, text):
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


def refused(report, what, run, *words):
    report.check(run.returncode != 0, f"{what}: exit code 0")
    report.check(all(word in run.stderr for word in words), f"{what}: expected {words} in:\n{run.stderr}{run.stdout}")
    report.check("Traceback" not in run.stderr, f"{what}: a traceback:\n{run.stderr}")


def check_names(report):
    for target in ("firmware", "emulate", "flash"):
        for arguments in ((), ("BOARD=",), ("BOARD= ",)):
            refused(report, f"make {target} {arguments}", make(target, *arguments), "BOARD=NAME", *BOARDS)
        for name in ("nonesuch", "../linux", "tools", "a b", "a;b"):
            refused(report, f"make {target} BOARD={name}", make(target, f"BOARD={name}"), "there is no board", "BOARD=NAME")


def check_tools(report, name):
    with tempfile.TemporaryDirectory() as directory:
        place = pathlib.Path(directory)
        refused(report, "no compiler", tool("build", name, path=place), "gcc", "not installed", ".ci/install firmware")
        refused(report, "no emulator", tool("emulate", name, path=place), "qemu-system-arm", ".ci/install firmware")
        refused(report, "no flash tool", tool("flash", name, path=place), "openocd", "not installed")
        # In front of the real ones.
        path = f"{place}{os.pathsep}{os.environ['PATH']}"
        script(place / "openocd", "echo 'Error: unable to open ftdi device with description'; exit 1")
        refused(report, "no board connected", tool("flash", name, path=path), "no board found", "connect it")
        script(place / "openocd", "echo 'Error: verify failed'; exit 1")
        refused(report, "a flash tool that fails", tool("flash", name, path=path), "verify failed", "exit code 1")
        script(place / "openocd", f'echo "$@" > {place}/told')
        run = tool("flash", name, path=path)
        told = (place / "told").read_text() if (place / "told").exists() else ""
        report.check(run.returncode == 0 and f"build/firmware/{name}/firmware.elf" in told,
                     f"flashing with a tool that works: exit code {run.returncode}, it was told: {told}\n{run.stderr}")
        script(place / "qemu-system-arm", "echo 'machine is not known' >&2; exit 1")
        refused(report, "an emulator that ends", tool("emulate", name, path=path), "machine is not known")


def main():
    report = Report()
    report.check(BOARDS, "no boards in src/port")
    check_names(report)
    check_tools(report, "lm3s6965evb")
    return report.finish()


if __name__ == "__main__":
    sys.exit(main())
