"""The rows of bench.json, and how they are asked for."""
import json
import pathlib

TARGETS = {"m0plus": "Cortex-M0+", "m3": "Cortex-M3", "m4": "Cortex-M4, no FPU", "m4f": "Cortex-M4F", "rv32": "RV32IMC"}
SCENES = {"s1": "S1", "s1r": "S1r", "s2": "S2", "s4": "S4"}
NEEDED = ("scene", "size", "target", "opt", "renderer", "profile", "instructions_per_pixel", "cycles_per_pixel",
          "flash_bytes", "ram_bytes", "stack_bytes", "wrong_id", "wrong_shadow", "colour_rmse", "colour_max",
          "setup_instructions", "stages")


class Unusable(Exception):
    """Why there is no report: one sentence that says what to do."""


def load(path):
    path = pathlib.Path(path)
    if not path.exists():
        raise Unusable(f"there is no {path}: run `make bench` (10 to 20 minutes), then this again")
    try:
        rows = json.loads(path.read_text(encoding="utf-8"))
        good = bool(rows) and all(key in row for row in rows for key in NEEDED)
    except (ValueError, TypeError):
        good = False
    if not good:
        raise Unusable(f"{path} is not what this tree's bench writes: run `make bench` (10 to 20 minutes), then this again")
    return rows


def pixels(row):
    width, height = map(int, row["size"].split("x"))
    return width * height


def name_of(row):
    """A renderer and its profile, for people."""
    return f"fixcast {row['profile']}" if row["renderer"] == "fixcast" else row["renderer"].replace("_", " ")


def find(rows, **wanted):
    """Rows whose columns have these values, or one of them where a list is given. Unless said: 128x128, -O2."""
    wanted = {"size": "128x128", "opt": "O2", **wanted}
    lists = {key: value if isinstance(value, (list, tuple)) else [value] for key, value in wanted.items()}
    return [row for row in rows if all(row[key] in values for key, values in lists.items())]


def ours(rows, **wanted):
    return find(rows, **{"renderer": "fixcast", "profile": "exact", **wanted})


def one(rows, **wanted):
    """Our row, or None."""
    found = ours(rows, **wanted)
    return found[0] if found else None


def wrong(row):
    """Pixels whose object or light is wrong; None where no frame was finished."""
    return None if row["wrong_id"] is None else row["wrong_id"] + row["wrong_shadow"]


def front(points):
    """Of (error, cost) pairs those that no other beats in one and equals or beats in the other, by error."""
    best = []
    for error, cost in sorted(set(points)):
        if not best or cost < best[-1][1]:
            best.append((error, cost))
    return best
