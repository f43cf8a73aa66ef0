"""Replays a fuzz target's corpus, then lets it search; one summary line a target.

run.py [--seconds N] [--seed N] [--jobs N] BUILD TARGET...

The committed corpus is only read. What is found stays in BUILD/found/TARGET, where the next run goes on from it; an
input that breaks something is kept in BUILD and its end of the log is printed.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
LONGEST_INPUT = {"nff": 2000, "obj": 2000, "mtl": 500, "view": 300, "options": 300, "scene": 1024, "strips": 400}
HANG_SECONDS = 20  # sanitizers and a busy machine included


def run(command, log):
    with open(log, "w", encoding="utf-8", errors="replace") as out:
        return subprocess.run([str(part) for part in command], stdout=out, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL).returncode


def last(pattern, text):
    found = re.findall(pattern, text)
    return found[-1] if found else "?"


def fuzz(target, build, seconds, seed):
    """True and a summary line, or False and what went wrong."""
    corpus, found, log = HERE / "corpus" / target, build / "found" / target, build / f"{target}.log"
    program = [build / f"fuzz_{target}", f"-timeout={HANG_SECONDS}", f"-artifact_prefix={build}/{target}-"]
    inputs = sorted(corpus.iterdir())
    if not inputs:
        return False, f"{target}: no corpus in {corpus}"
    found.mkdir(parents=True, exist_ok=True)
    failed = run([*program, *inputs], log)
    if not failed and seconds > 0:
        options = [f"-max_total_time={seconds}", f"-max_len={LONGEST_INPUT[target]}", f"-seed={seed}",
                   "-print_final_stats=1"]
        if (HERE / f"{target}.dict").is_file():
            options.append(f"-dict={HERE / target}.dict")
        failed = run([*program, *options, found, corpus], log)
    text = log.read_text(encoding="utf-8", errors="replace")
    if failed:
        return False, f"{text[-6000:]}\n{target}: FAILED; all of the log is in {log}"
    summary = f"{target:7} {len(inputs):4} inputs replayed"
    if seconds > 0:
        summary += (f", {seconds} s, {last(r'number_of_executed_units: ([0-9]+)', text)} runs"
                    f", {last(r'cov: ([0-9]+)', text)} edges, nothing broken")
    return True, summary


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=int, default=10, help="search time of each target; 0: only replay")
    parser.add_argument("--seed", type=int, default=0, help="of the search; 0: another one each time")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("target", nargs="+")
    arguments = parser.parse_args()
    passed = True
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        runs = [pool.submit(fuzz, target, arguments.build.resolve(), arguments.seconds, arguments.seed)
                for target in arguments.target]
        for future in runs:
            good, text = future.result()
            passed = passed and good
            print(text, flush=True)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
