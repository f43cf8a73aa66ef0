"""What the checks share: where things are, the golden file, running the simulator."""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "host_sim" / "scenes"
GOLDEN = ROOT / "tests" / "golden" / "crc.txt"


def scene_names():
    return sorted(path.stem for path in SCENES.glob("*.nff"))


def read_golden(path=GOLDEN):
    """{(scene, size): crc} of a golden file; a line is `scene WxH 0x01234567`."""
    golden = {}
    for number, line in enumerate(pathlib.Path(path).read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        match = re.fullmatch(r"(\w+) (\d+x\d+) (0x[0-9a-f]{8})", line)
        if not match:
            sys.exit(f"{path}:{number}: not a golden line: {line}")
        if match.group(1, 2) in golden:
            sys.exit(f"{path}:{number}: {match.group(1)} {match.group(2)} stands here twice")
        golden[match.group(1, 2)] = match.group(3)
    return golden


def fixcast_json(simulator, *arguments):
    """Runs the simulator with --json and returns what it printed; any failure ends the check."""
    command = [simulator, *map(str, arguments), "--json"]
    run = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if run.returncode != 0:
        sys.exit(f"{' '.join(command)}\nexit code {run.returncode}: {run.stderr.strip()}")
    return json.loads(run.stdout)


class Report:
    """Collects what is wrong; finish() prints it and gives the exit code."""

    def __init__(self):
        self.checked = 0
        self.wrong = []

    def check(self, holds, message):
        self.checked += 1
        if not holds:
            self.wrong.append(message)
            print("FAIL:", message, flush=True)
        return holds

    def equal(self, what, expected, actual):
        return self.check(expected == actual, f"{what}: expected {expected}, got {actual}")

    def at_most(self, what, limit, actual):
        return self.check(actual <= limit, f"{what}: at most {limit} allowed, got {actual}")

    def finish(self):
        print(f"{self.checked} checks, {len(self.wrong)} wrong")
        return 1 if self.wrong or self.checked == 0 else 0
