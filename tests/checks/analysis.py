"""What clang-tidy and cppcheck say of the C code that goes onto chips: nothing, but for what .clang-tidy and cppcheck.txt explain.

analysis.py clang-tidy|cppcheck WORK          files that have not changed since they passed are not asked again
analysis.py clang-tidy|cppcheck --self-test   proves that a planted mistake is noticed
"""
import concurrent.futures
import hashlib
import pathlib
import subprocess
import sys
import tempfile

from support import ROOT, Report

CODE = ("src/core", "src/extra", "src/panel", "src/firmware")
INCLUDES = [f"-I{ROOT / part}" for part in ("include", "src/core", "host_sim/scenes")]
CPPCHECK = ["cppcheck", "--quiet", "--std=c99", "--enable=warning,performance,portability", "--error-exitcode=1",
            "--template={file}:{line}: {message} [{id}]"]
PLANTED = "int f(const int *values) {\n  int sum;\n  if (values[0] > 0) sum = 1;\n  return values[1] == values[1] ? sum : 0;\n}\n"


def run(command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return done.returncode, done.stdout + done.stderr


def version(tool):
    return run([tool, "--version"])[1]


def clang_tidy(work, report):
    """A record of WORK is the digest of a file, all headers, the settings and the tool that found nothing wrong."""
    files = [path for part in CODE for path in sorted((ROOT / part).glob("*.c"))]
    headers = [path for part in ("include/fixcast", *CODE) for path in sorted((ROOT / part).glob("*.h"))]
    common = version("clang-tidy").encode() + (ROOT / ".clang-tidy").read_bytes() + b"".join(path.read_bytes() for path in headers)

    def ask(path):
        digest = hashlib.sha256(common + path.read_bytes()).hexdigest()
        record = work / f"{path.stem}.passed"
        if record.exists() and record.read_text() == digest:
            return path, 0, ""
        code, text = run(["clang-tidy", "--quiet", path, "--", "-std=c99", *INCLUDES])
        if code == 0:
            record.write_text(digest)
        return path, code, text

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for path, code, text in pool.map(ask, files):
            report.check(code == 0, f"{path.relative_to(ROOT)}:\n{text}")


def cppcheck(work, report):
    code, text = run([*CPPCHECK, "-j2", f"--cppcheck-build-dir={work}", f"--suppressions-list={ROOT / 'tests/checks/cppcheck.txt'}",
                      *INCLUDES, *(ROOT / part for part in CODE)])
    report.check(code == 0, text)


def self_test(tool):
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory, "planted.c")
        path.write_text(PLANTED)
        command = [*CPPCHECK, path] if tool == "cppcheck" else ["clang-tidy", "--quiet", f"--config-file={ROOT / '.clang-tidy'}", path, "--"]
        code, text = run(command)
    print(text)
    if code == 0 or "planted.c" not in text:
        sys.exit(f"{tool} does not notice a planted mistake")
    print("self-test passed: the finding above was meant")
    return 0


def main(arguments):
    tool = arguments[0]
    if arguments[1] == "--self-test":
        return self_test(tool)
    work = pathlib.Path(arguments[1]) / tool
    work.mkdir(parents=True, exist_ok=True)
    report = Report()
    {"clang-tidy": clang_tidy, "cppcheck": cppcheck}[tool](work, report)
    return report.finish()


sys.exit(main(sys.argv[1:]))
