"""Renders three scenes and prints how exact each picture is: `make demo`.

demo.py SIMULATOR DIRECTORY
"""
import json
import pathlib
import subprocess
import sys

SCENES = pathlib.Path(__file__).resolve().parent / "scenes"
DEMO = (("s1", "128x128"), ("box", "240x240"), ("flake", "240x240"))


def fixcast(simulator, *arguments):
    run = subprocess.run([simulator, *map(str, arguments)], stdout=subprocess.PIPE, text=True)
    if run.returncode != 0:
        sys.exit(f"demo: {simulator} {' '.join(map(str, arguments))} ended with exit code {run.returncode}")
    return run.stdout


def main(simulator, directory):
    directory = pathlib.Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    rows, pictures = [], []
    for number, (name, size) in enumerate(DEMO, 1):
        print(f"[{number}/{len(DEMO)}] {name} {size}: rendering, then comparing with exact arithmetic ...", flush=True)
        scene = SCENES / f"{name}.nff"
        frame, depth = directory / f"{name}.png", directory / f"{name}-depth.png"
        text = fixcast(simulator, "render", scene, "--size", size, "-o", frame, "--depth", depth)
        # The program says what it wrote: without OpenImageIO these are PPM and PGM.
        pictures += [line[len("wrote "):] for line in text.splitlines() if line.startswith("wrote ")]
        figures = json.loads(fixcast(simulator, "compare", scene, "--size", size, "--json"))
        rows.append((name, size, figures["crc32"], figures["wrong_id"], figures["wrong_shadow"],
                     f"{figures['colour_max']:.3f}", f"{figures['colour_rmse']:.3f}"))

    head = ("scene", "size", "CRC", "wrong ids", "wrong shadows", "colour error max", "rmse")
    widths = [max(len(str(row[i])) for row in [head, *rows]) for i in range(len(head))]
    print()
    for row in (head, *rows):
        print("  ".join(str(cell).ljust(width) for cell, width in zip(row, widths)).rstrip())
    print("(wrong: pixels that differ from exact arithmetic; colour error: in 8-bit levels)\n")
    print("Pictures (a frame and its depth each):")
    for picture in pictures:
        print(f"  {picture}")


main(*sys.argv[1:])
