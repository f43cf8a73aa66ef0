"""`fixcast view` under a virtual X server: real mouse and keyboard events, and what they make of the picture and the window.

view.py SIMULATOR [DIRECTORY]      keeps its screenshots in DIRECTORY
"""
import math
import os
import pathlib
import queue
import re
import subprocess
import sys
import tempfile
import threading
import time
import zlib

import picture_files
from support import ROOT, SCENES, Report
from xscreen import Screen

S1 = SCENES / "s1.nff"
WIDTH, HEIGHT, ZOOM = 80, 60, 5
# docs/REPORT.md's row of S1 on the smallest chip
COUNTED = dict(zip(("exact", "fast", "half", "interlaced"),
                   re.findall(r"\| ([\d.]+)(?= )", re.search(r"^\| Cortex-M0\+ \| S1 (\|.*)$", (ROOT / "docs/REPORT.md").read_text(),
                                                             re.MULTILINE).group(1))))
EYE, PIVOT = 1, (-7 - 2.5) / 2  # z of S1's camera and of the middle of its spheres; x = 0, y = 1.5


class View:
    """The program, its window, and the lines of its log."""

    def __init__(self, simulator, screen, directory, *options):
        self.screen = screen
        command = [simulator, "view", str(S1), "--size", f"{WIDTH}x{HEIGHT}", "--zoom", str(ZOOM), "--log",
                   "--shots", str(directory / "shot_%02d.png"), *options]
        self.process = subprocess.Popen(command, env=screen.environment, stdout=subprocess.PIPE, text=True, stdin=subprocess.DEVNULL)
        self.lines = queue.Queue()
        threading.Thread(target=lambda: [self.lines.put(line.strip()) for line in self.process.stdout], daemon=True).start()
        self.window = screen.window("fixcast s1.nff")
        screen.do("windowfocus", self.window)

    def next(self, pattern=r"picture \d+ crc (0x\w+) zoom (\d+) grid (\d) turning (\d); (.*)", seconds=30):
        end = time.monotonic() + seconds
        while True:
            match = re.match(pattern, self.lines.get(timeout=max(0.01, end - time.monotonic())))
            if match:
                return match.groups()

    def settled(self, seconds=0.5):
        """The last picture, after which none came for so long."""
        last = self.next()
        while True:
            try:
                last = self.next(seconds=seconds)
            except queue.Empty:
                return last

    def key(self, name):
        self.screen.do("key", "--window", "0", name)

    def mouse(self, x, y):
        self.screen.do("mousemove", "--window", self.window, x, y)

    def finish(self):
        """The exit code, and the longest times in ms: from input to picture, and for a picture."""
        self.key("q")
        times = self.next(r"\d+ pictures in .* at most ([\d.]+) ms from input to picture, ([\d.]+) for a picture")
        return self.process.wait(timeout=20), *map(float, times)


def render(simulator, directory, *options):
    """The rows of a picture by `render`."""
    path = directory / "render.png"
    subprocess.run([simulator, "render", str(S1), "--size", f"{WIDTH}x{HEIGHT}", "-o", str(path), *map(str, options)], check=True,
                   stdout=subprocess.DEVNULL)
    return picture_files.png(path)[4]


def crc(rows):
    return f"0x{zlib.crc32(b''.join(map(bytes, rows))):08x}"


def unlike(a, b):
    """The part of the samples that differ by more than eight levels."""
    pairs = [(p, q) for r, s in zip(a, b) for p, q in zip(r, s)]
    return sum(abs(p - q) > 8 for p, q in pairs) / len(pairs)


def shot(view, directory):
    view.key("s")
    path, = view.next(r"wrote (.*)")
    return picture_files.png(pathlib.Path(path))[4]


def check_start(simulator, view, directory, report):
    first = view.settled()
    rows = render(simulator, directory)
    report.equal("first picture", crc(rows), first[0])
    captured = view.screen.capture(view.window, ZOOM * WIDTH, ZOOM * HEIGHT)
    zoomed = [b"".join(bytes(row[3 * x:3 * x + 3]) * ZOOM for x in range(WIDTH)) for row in rows for _ in range(ZOOM)]
    report.check(captured == zoomed, "the window does not show the picture, each pixel as a square")
    return first[0]


def check_mouse(simulator, view, directory, report, still):
    # 75 pixels from the middle of a ball of radius 150: sin = 1/2. The front goes to the right, so the camera goes to the left around it.
    view.mouse(200, 150)
    view.screen.do("mousedown", 1)
    view.mouse(275, 150)
    rolled = view.settled()
    distance, angle = EYE - PIVOT, math.radians(30)
    expected = render(simulator, directory, "--from", f"{-distance * math.sin(angle):.9f},1.5,{PIVOT + distance * math.cos(angle):.9f}",
                      "--at", f"0,1.5,{PIVOT}")
    report.at_most("a roll by 30 degrees to the right", 0.01, unlike(shot(view, directory), expected))
    report.check(unlike(render(simulator, directory), expected) > 0.1, "the roll hardly changes the picture: no check")
    view.mouse(200, 150)
    report.equal("rolled back", still, view.settled()[0])
    report.check(rolled[0] != still, "a roll changed nothing")
    # Downwards: the front goes down, so the camera comes from above.
    view.mouse(200, 190)
    view.settled()
    angle = math.asin(40 / 150)
    expected = render(simulator, directory, "--at", f"0,1.5,{PIVOT}",
                      "--from", f"0,{1.5 + distance * math.sin(angle):.9f},{PIVOT + distance * math.cos(angle):.9f}")
    report.at_most("a roll downwards", 0.01, unlike(shot(view, directory), expected))
    view.screen.do("mouseup", 1)
    view.key("r")
    report.equal("reset after a roll", still, view.settled()[0])

    view.mouse(200, 150)
    view.screen.do("click", "--repeat", 3, 4)
    view.settled()
    nearer = PIVOT + distance * (10 / 11) ** 3
    expected = render(simulator, directory, "--from", f"0,1.5,{nearer:.9f}", "--at", f"0,1.5,{PIVOT - 9}")
    report.at_most("three steps nearer", 0.01, unlike(shot(view, directory), expected))
    view.screen.do("click", "--repeat", 3, 5)
    report.equal("and three back", still, view.settled()[0])

    # 50 pixels of the window are 10 of the picture; the scene follows the mouse, so the camera goes the other way.
    view.screen.do("mousedown", 3)
    view.mouse(250, 125)
    view.settled()
    view.screen.do("mouseup", 3)
    across, up = distance * 2 * 0.5 / HEIGHT * 10, distance * 2 * 0.5 / HEIGHT * 5
    place = f"{-across:.9f},{1.5 - up:.9f}"
    expected = render(simulator, directory, "--from", f"{place},1", "--at", f"{place},0")
    report.at_most("moved by 10 and 5 pixels", 0.01, unlike(shot(view, directory), expected))
    view.key("r")
    report.equal("reset after a move", still, view.settled()[0])


def difference(a, b):
    """Pixels that differ, and the largest difference of a channel."""
    pixels = [(p[i:i + 3], q[i:i + 3]) for p, q in zip(a, b) for i in range(0, len(p), 3)]
    levels = [max(abs(m - n) for m, n in zip(p, q)) for p, q in pixels]
    return sum(level > 0 for level in levels), max(levels)


def check_gallery(simulator, view, directory, report, still):
    """The switches of the fault gallery: each state is what `render` makes of the same words, and the last is the first again."""
    seen_crcs = {still}
    for key, option, words, name in (("t", "--transfer", ("srgb", "gamma22"), ("sRGB", "gamma 2.2")),
                                     ("m", "--samples", ("regular:2", "quincunx"), ("regular:2", "quincunx"))):
        for word, shown in zip(words, name):
            view.key(key)
            seen = view.settled()
            report.equal(f"key {key}: {word}", crc(render(simulator, directory, option, word)), seen[0])
            report.check(shown in seen[4] and seen[0] not in seen_crcs, f"key {key}: {seen}")
            seen_crcs.add(seen[0])
            shot(view, directory)
        view.key(key)
        report.equal(f"key {key}: back", still, view.settled()[0])
    view.key("2")
    usual = view.settled()[0]
    depths = set()
    for bits in "234":
        view.key("z")
        seen = view.settled()
        report.equal(f"key z: {bits}", crc(render(simulator, directory, "--show", "depth", "--depth-bits", bits)), seen[0])
        report.check(f"e{bits} depth" in seen[4], seen[4])
        depths.add(seen[0])
    report.equal("pictures of three depth formats", 3, len(depths))
    view.key("z")
    report.equal("key z: back", usual, view.settled()[0])
    view.key("1")
    report.equal("after the gallery", still, view.settled()[0])


def check_keys(simulator, view, directory, report, still):
    for number, layer in enumerate(("color", "depth", "normal", "id", "shadow", "error"), 1):
        view.key(str(number))
        seen = view.settled(2 if layer == "error" else 0.5)
        report.equal(f"key {number}", crc(render(simulator, directory, "--show", layer)), seen[0])
        report.check(layer in seen[4], f"key {number}: {seen[4]}")
    report.check("0 wrong ids, 0 wrong shadows" in seen[4], f"error view: {seen[4]}")
    report.check(re.search(r"depth codes alone would confuse \d+ pixel", seen[4]), f"error view: {seen[4]}")
    view.key("1")
    view.settled()
    exact = render(simulator, directory)
    for profile in ("fast", "half", "interlaced", "exact"):
        view.key("p")
        seen = view.settled()
        report.equal(f"profile {profile}", crc(render(simulator, directory, "--profile", profile)), seen[0])
        report.check(profile + " profile" in seen[4], seen[4])
        counted = re.search(r"\(([\d.]+) instructions a pixel on Cortex-M0\+", seen[4])
        report.check(counted and COUNTED[profile] == counted.group(1), f"{profile}: {seen[4]} instead of {COUNTED[profile]}")
        unlike_exact = re.search(r": (\d+) pixels? unlike exact, by (\d+) levels? at most", seen[4])
        if profile == "exact":
            report.check(not unlike_exact, seen[4])
        else:
            report.equal(f"{profile}: what is unlike exact", difference(exact, render(simulator, directory, "--profile", profile)),
                         unlike_exact and tuple(map(int, unlike_exact.groups())))
    view.key("o")
    report.equal("no offset", crc(render(simulator, directory, "--offset", "none")), view.settled()[0])
    view.key("o")
    view.settled()
    view.key("o")
    report.equal("exact shadows again", still, view.settled()[0])

    check_gallery(simulator, view, directory, report, still)

    view.key("g")
    seen = view.settled()
    captured = view.screen.capture(view.window, ZOOM * WIDTH, ZOOM * HEIGHT)
    rows = render(simulator, directory)
    report.equal("grid", ("1", still), (seen[2], seen[0]))
    report.check(all(captured[y][3 * x:3 * x + 3] == b"ZZZ" for y in range(0, 300, 7) for x in range(0, 400, ZOOM)), "no upright lines of the grid")
    report.check(captured[7][3 * 12:3 * 12 + 3] == bytes(rows[1][6:9]), "the grid covers pixels")
    view.key("g")
    view.settled()
    view.key("plus")
    seen = view.settled()
    size = view.screen.do("getwindowgeometry", view.window)
    report.check(seen[1] == str(ZOOM + 1) and f"{(ZOOM + 1) * WIDTH}x{(ZOOM + 1) * HEIGHT}" in size, f"zoom: {seen}, {size}")
    view.key("minus")
    report.equal("zoomed back", str(ZOOM), view.settled()[1])

    view.key("n")
    one = view.settled()
    across, along = (EYE - PIVOT) * math.sin(math.tau / 128), (EYE - PIVOT) * math.cos(math.tau / 128)
    expected = render(simulator, directory, "--from", f"{-across:.9f},1.5,{PIVOT + along:.9f}", "--at", f"0,1.5,{PIVOT}")
    report.at_most("one step of the turn", 0.01, unlike(shot(view, directory), expected))
    view.key("space")
    crcs = {view.next()[0] for _ in range(12)}
    report.check(len(crcs) > 8, "space does not turn the scene")
    view.key("space")
    view.settled()
    try:
        view.next(seconds=1)
        report.check(False, "space does not stop the turn")
    except queue.Empty:
        pass
    report.check(one[0] != still, "n changed nothing")
    view.key("r")
    report.equal("reset after turning", still, view.settled()[0])


def check_panel(simulator, screen, directory, report):
    command = [simulator, "view", str(S1), "--display", "ssd1306", "--zoom", "4", "--log"]
    process = subprocess.Popen(command, env=screen.environment, stdout=subprocess.PIPE, text=True, stdin=subprocess.DEVNULL)
    line = process.stdout.readline()
    path = directory / "panel.png"
    subprocess.run([simulator, "render", str(S1), "--display", "ssd1306", "-o", str(path)], check=True, stdout=subprocess.DEVNULL)
    report.check(crc(picture_files.png(path)[4]) in line and "ssd1306" in line, f"panel: {line}")
    window = screen.window("fixcast s1.nff")
    screen.do("windowfocus", window, "key", "d")
    subprocess.run([simulator, "render", str(S1), "--size", "128x64", "-o", str(path)], check=True, stdout=subprocess.DEVNULL)
    line = process.stdout.readline()
    report.check(crc(picture_files.png(path)[4]) in line, f"without the panel: {line}")
    screen.do("key", "Escape")
    report.equal("exit code after Escape", 0, process.wait(timeout=20))


def check_rate(simulator, screen, report):
    for scene in (S1, SCENES / "pawn.obj"):
        command = [simulator, "view", str(scene), "--size", "240x240", "--frames", "60"]
        run = subprocess.run(command, env=screen.environment, capture_output=True, text=True)
        print(f"{scene.name} 240x240: {run.stdout.strip()}")
        report.check(run.returncode == 0 and run.stdout.startswith("60 pictures in"), f"{scene.name}: {run.stdout}{run.stderr}")


def check_no_screen(simulator, report):
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    run = subprocess.run([simulator, "view", str(S1)], env={**environment, "SDL_VIDEODRIVER": "x11"}, capture_output=True, text=True)
    report.check(run.returncode == 2 and run.stderr.count("\n") == 1 and "screen" in run.stderr, f"without a screen: {run.returncode}, {run.stderr}")


def main(simulator, kept=None):
    report = Report()
    with tempfile.TemporaryDirectory() as temporary, Screen() as screen:
        directory = pathlib.Path(kept or temporary)
        directory.mkdir(parents=True, exist_ok=True)
        for old in directory.glob("shot_*.png"):
            old.unlink()
        view = View(simulator, screen, directory)
        still = check_start(simulator, view, directory, report)
        check_mouse(simulator, view, directory, report, still)
        check_keys(simulator, view, directory, report, still)
        code, wait, picture = view.finish()
        report.equal("exit code after q", 0, code)
        report.check(0 < wait <= 2 * picture + 50, f"{wait} ms from input to picture, of which {picture} for a picture; 50 for a busy machine")
        check_panel(simulator, screen, directory, report)
        check_rate(simulator, screen, report)
    check_no_screen(simulator, report)
    return report.finish()


sys.exit(main(*sys.argv[1:]))
