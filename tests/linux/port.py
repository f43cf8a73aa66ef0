"""The Linux port over a fake kernel, with the header of libgpiod v1 or v2: under valgrind, and with ThreadSanitizer.

port.py v1|v2 --work DIR
"""
import argparse
import pathlib
import subprocess
import sys

from parts import Parts

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PORT = ROOT / "src" / "port" / "linux"
WRAPPED = ("open", "close", "ioctl", "scandir", "fopen", "stat", "pthread_create", "clock_nanosleep")
WARNINGS = ("-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wundef", "-pedantic", "-Werror")


def compile_test(api, headers, program, compiler, *options):
    number = api[1:]
    own = [path for path in sorted(PORT.glob("*.c")) if not path.name.startswith("gpio_v")] + [PORT / f"gpio_v{number}.c"]
    tests = [HERE / "test_port.c", HERE / "fake_kernel.c", HERE / f"fake_gpiod_v{number}.c"]
    virtual = sorted((ROOT / "tests" / "panel").glob("virtual_*.c"))
    rest = [path for path in virtual if path.name != "virtual_bus.c"]
    rest += [*sorted((ROOT / "src" / "panel").glob("*.c")), ROOT / "src" / "core" / "error.c"]
    command = [compiler, "-std=c99", "-D_GNU_SOURCE", "-g", *WARNINGS, *options, f"-isystem{headers}", f"-I{ROOT / 'include'}", f"-I{PORT}",
               f"-I{ROOT / 'src' / 'core'}", f"-I{ROOT / 'tests' / 'unity'}", *own, *tests, *rest, "-o", program, "-pthread",
               *(f"-Wl,--wrap={name}" for name in WRAPPED)]
    subprocess.run(command, check=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("api", choices=("v1", "v2"))
    parser.add_argument("--work", type=pathlib.Path, required=True)
    options = parser.parse_args()
    work = options.work.resolve()
    headers = Parts(work).libgpiod(options.api) / "include"
    plain, threads = work / f"port-{options.api}", work / f"port-{options.api}-threads"
    compile_test(options.api, headers, plain, "gcc", "-O1")
    compile_test(options.api, headers, threads, "clang", "-O1", "-fsanitize=thread")
    valgrind = ["valgrind", "--quiet", "--leak-check=full", "--show-leak-kinds=all", "--errors-for-leak-kinds=all", "--error-exitcode=9"]
    failed = subprocess.run([*valgrind, plain]).returncode != 0
    failed |= subprocess.run([threads], stdout=subprocess.DEVNULL).returncode != 0
    print("failed" if failed else "passed, without leaks or data races")
    return 1 if failed else 0


sys.exit(main())
