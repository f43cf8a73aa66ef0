"""What tests/bench/bars.json asks for, against what was measured."""
import json
import pathlib

import rows as bench

FILE = pathlib.Path(__file__).resolve().parents[2] / "tests/bench/bars.json"
VERDICTS = ("aim met", "bar met", "MISSED", "not measured")


def worst(values):
    """(value, whether it is known): a row that gave up has no figure, and so no bar is met."""
    if not values:
        return None, False
    return (None, True) if None in values else (max(values), True)


def added(rows, bar):
    """Instructions for each primitive more between two scenes."""
    (few, fewer), (many, more) = bar["added"]
    a, b = (bench.ours(rows, scene=scene, **bar["where"]) for scene in (few, many))
    if not a or not b:
        return None, False
    if a[0][bar["key"]] is None or b[0][bar["key"]] is None:
        return None, True
    whole = [row[0][bar["key"]] * bench.pixels(row[0]) for row in (a, b)]
    return (whole[1] - whole[0]) / (more - fewer), True


def judge(rows, bar):
    """(measured value or None, one of VERDICTS)"""
    value, known = added(rows, bar) if "added" in bar else \
        worst([row[bar["key"]] for row in bench.ours(rows, **bar["where"])])
    if not known:
        return None, "not measured"
    if value is None or value > bar["bar"]:
        return value, "MISSED"
    return value, "aim met" if value <= bar["aim"] else "bar met"


def judged(rows, path=FILE):
    """[(bar, value, verdict)]"""
    return [(bar, *judge(rows, bar)) for bar in json.loads(pathlib.Path(path).read_text(encoding="utf-8"))]
