"""Runs a program and checks its exit code and one line of its output.

expect.py --exit CODE --line TEXT -- COMMAND...        the output contains the line TEXT
expect.py --golden crc.txt SCENE WxH -- COMMAND...     exit code 0, and the line is that of the golden file
"""
import subprocess
import sys

from support import read_golden


def main(arguments):
    split = arguments.index("--")
    options, command = arguments[:split], arguments[split + 1:]
    if options[0] == "--golden":
        _, path, scene, size = options
        crc = read_golden(path).get((scene, size))
        if crc is None:
            sys.exit(f"{path} has no line for {scene} {size}: look at the picture, then run `make golden-update`")
        code, line = 0, f"{scene} {size} {crc}"
    else:
        _, code, _, line = options
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                         stdin=subprocess.DEVNULL, errors="replace")
    print(run.stdout, end="")
    if run.returncode != int(code):
        sys.exit(f"expected exit code {code}, got {run.returncode}")
    if line not in run.stdout.splitlines():
        sys.exit(f"expected the line: {line}")
    return 0


sys.exit(main(sys.argv[1:]))
