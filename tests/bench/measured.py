"""Which sources a bench.json was measured from: a note beside it, so that a report never passes old figures for new."""
import hashlib
import json
import pathlib
import subprocess

# What the counts depend on; the scripts that only arrange them are left out.
PARTS = ("include/**/*.h", "src/core/*.[ch]", "host_sim/scenes/*.nff", "host_sim/scenes/generate.py",
         "tests/bench/image/*", "tests/bench/rivals/*", "tests/bench/plan.py")
NAME = "measured.json"


def digest(source):
    """One word for all sources that figures depend on."""
    source = pathlib.Path(source)
    whole = hashlib.sha256()
    for path in sorted(path for part in PARTS for path in source.glob(part)):
        whole.update(f"{path.relative_to(source).as_posix()} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return whole.hexdigest()[:20]


def commit(source):
    """The last commit that touched the core, with "+" where the tree has changed since; None outside of git."""
    def git(*arguments):
        run = subprocess.run(["git", "-C", str(source), *arguments], capture_output=True, text=True)
        return run.stdout.strip() if run.returncode == 0 else None
    try:
        name = git("log", "-1", "--format=%h", "--", "include", "src/core")
        return name and name + ("+" if git("status", "--porcelain", "--", "include", "src/core") else "")
    except FileNotFoundError:
        return None


def note(source):
    """To be taken when measuring starts."""
    return {"digest": digest(source), "commit": commit(source)}


def write(bench, taken):
    (pathlib.Path(bench).parent / NAME).write_text(json.dumps(taken) + "\n")


def read(bench):
    """The note beside a bench.json, {} where there is none."""
    path = pathlib.Path(bench).parent / NAME
    return json.loads(path.read_text()) if path.exists() else {}
