"""The simulator compiles without a warning on another compiler than the one that built it.

clang_warnings.py COMPILER compile_commands.json      (the core's warnings are errors in every sub-build already)
"""
import concurrent.futures
import json
import pathlib
import shlex
import subprocess
import sys

from support import ROOT, Report


def compile_one(compiler, entry):
    arguments = shlex.split(entry["command"])[1:]
    command = [compiler, *arguments, "-fsyntax-only", "-Werror"]
    run = subprocess.run(command, cwd=entry["directory"], capture_output=True, text=True)
    return entry["file"], run.returncode, run.stderr


def main(compiler, commands):
    entries = [entry for entry in json.loads(pathlib.Path(commands).read_text())
               if pathlib.Path(entry["file"]).parent == ROOT / "host_sim"]
    report = Report()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for name, code, text in pool.map(lambda entry: compile_one(compiler, entry), entries):
            report.check(code == 0, f"{name}:\n{text}")
    return report.finish()


sys.exit(main(*sys.argv[1:]))
