"""The lectures' methods beside ours: what tests/rivals found wrong, and what tests/bench/methods.py counted."""
import json
import pathlib

from against_oracle import table

CHIPS = {"m0plus": "Cortex-M0+", "m3": "Cortex-M3"}
OURS = {"ours, a ray a pixel", "ours, by scan lines"}


def read(path):
    try:
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None


def wrong_table(rivals):
    """Wrong pixels of each method, in each kind of numbers, on each scene; a sentence where tests/rivals has not run."""
    if rivals is None:
        return "Not measured here: `make test` writes build/rivals.json, then `make report` again."
    wrong, order = {}, []
    for scene, found in rivals["scenes"].items():
        for row in found:
            key = row["method"], row["numbers"]
            if key not in order:
                order.append(key)
            wrong[key, scene] = row["wrong_objects"]
    scenes = list(rivals["scenes"])
    return table(["method", "numbers", *scenes],
                 [(*key, *("-" if wrong.get((key, scene)) is None else str(wrong[key, scene]) for scene in scenes)) for key in order])


def cost_table(counted, rivals, digest):
    """Wrong pixels and instructions a pixel of each method that was counted; a sentence where there is none or of other sources than `digest`'s."""
    if counted is None or rivals is None:
        return "Not counted here: `make bench` writes build/bench/methods.json, then `make report` again."
    if counted["digest"] != digest:
        return "Counted from other sources than this tree's: `make bench`, then `make report` again."
    rows = counted["rows"]
    wrong = {(scene, row["method"]): row["wrong_objects"] for scene, rows in rivals["scenes"].items() for row in rows
             if row["numbers"] in ("float", "integer")}
    cost = {(row["scene"], row["method"], row["target"]): row["instructions_per_pixel"] for row in rows}
    lines = []
    for scene, method in dict.fromkeys((row["scene"], row["method"]) for row in rows):
        found = wrong.get((scene, "ours" if method in OURS else method))
        figures = [cost.get((scene, method, chip)) for chip in CHIPS]
        lines.append((scene, method, "-" if found is None else str(found),
                      *("over the limit" if figure is None else f"{figure:.0f}" for figure in figures)))
    return table(["scene", "method", "wrong pixels", *CHIPS.values()], lines)
