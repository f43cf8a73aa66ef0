"""What the simulator writes as pictures, read by readers of our own: samples, channels, metadata, sequences, and byte for byte the same again.

pictures.py SIMULATOR
"""
import json
import math
import os
import pathlib
import pty
import subprocess
import sys
import tempfile
import zlib

import picture_files
from support import SCENES, Report, fixcast_json

S1, FLAKE = SCENES / "s1.nff", SCENES / "flake.nff"


def run(simulator, *arguments, code=0):
    command = [simulator, *map(str, arguments)]
    result = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if result.returncode != code:
        sys.exit(f"{' '.join(command)}\nexit code {result.returncode}, expected {code}: {result.stderr.strip()}")
    return result


def ppm(path):
    head, rest = path.read_bytes().split(b"\n255\n", 1)
    magic, size = head.split(b"\n")
    assert magic == b"P6"
    return tuple(map(int, size.split())), rest


def check_png(simulator, directory, report):
    frame = fixcast_json(simulator, "render", S1, "--size", "70x50", "-o", directory / "a.ppm")
    size, plain = ppm(directory / "a.ppm")
    report.equal("size of the PPM", (70, 50), size)
    for bits in (8, 16):
        path = directory / f"a{bits}.png"
        run(simulator, "render", S1, "--size", "70x50", "--bits", bits, "-o", path)
        width, height, stored, channels, rows, texts = picture_files.png(path)
        report.equal(f"PNG of {bits} bits", (70, 50, bits, 3), (width, height, stored, channels))
        expected = list(plain) if bits == 8 else [v * 257 for v in plain]
        report.check([v for row in rows for v in row] == expected, f"PNG of {bits} bits: other samples than the PPM")
        report.equal("scene in the PNG", "s1.nff", texts.get("fixcast:scene"))
        report.equal("CRC in the PNG", frame["crc32"], texts.get("fixcast:crc32"))
        report.equal("profile in the PNG", "exact", texts.get("fixcast:profile"))
        version = run(simulator, "--version").stdout.split()[1]
        report.equal("version in the PNG", version, texts.get("fixcast:version"))


def check_exr(simulator, directory, report):
    path = directory / "a.exr"
    options = ("--size", "40x30", "--layers", "color,depth,normal,id,samples,shadow,error")
    run(simulator, "render", FLAKE, *options, "-o", path)
    run(simulator, "render", FLAKE, "--size", "40x30", "-o", directory / "b.ppm")
    plain = ppm(directory / "b.ppm")[1]
    width, height, channels, texts = picture_files.exr(path)
    report.equal("size of the EXR", (40, 30), (width, height))
    kinds = {name: kind for name, (kind, _) in channels.items()}
    floats = dict.fromkeys(["R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "samples", "shadow", "error"], "float")
    report.equal("channels of the EXR", {**floats, "id": "uint"}, kinds)
    report.equal("scene in the EXR", "flake.nff", texts.get("fixcast:scene"))
    values = {name: samples for name, (_, samples) in channels.items()}
    for c, name in enumerate("RGB"):
        worst = max(abs(255 * v - plain[3 * i + c]) for i, v in enumerate(values[name]))
        report.at_most(f"difference of {name} to the PPM", 1e-4, worst)
    ids = fixcast_json(simulator, "render", FLAKE, "--size", "40x30")["pixels_by_id"]
    report.equal("pixels by id", ids, {str(i): values["id"].count(i) for i in sorted(set(values["id"]))})
    lit_of = {(): 1.0, (0,): 0.5, (1,): 0.5, (0, 1): 0.0}
    picked = 0
    for i in range(0, width * height, 37):
        hit = fixcast_json(simulator, "pick", FLAKE, i % width, i // width, "--size", "40x30")
        report.equal(f"id of pixel {i}", hit["id"], values["id"][i])
        report.equal(f"A of pixel {i}", 0 if hit["id"] == 0 else 1, values["A"][i])
        normal = (values["N.X"][i], values["N.Y"][i], values["N.Z"][i])
        if hit["id"] == 0:
            report.equal(f"Z and N of background {i}", (math.inf, (0, 0, 0), 0), (values["Z"][i], normal, values["shadow"][i]))
            continue
        picked += 1
        report.at_most(f"normal of pixel {i}", 1e-6, max(abs(a - b) for a, b in zip(normal, hit["normal"])))
        report.equal(f"shadow of pixel {i}", lit_of[tuple(hit["lit"])], values["shadow"][i])
    report.check(picked > 10, "too few surfaces were picked")
    report.check(max(values["error"]) <= 1 and max(values["error"]) > 0.3, f"errors up to {max(values['error'])}")
    report.equal("samples", {1.0}, set(values["samples"]))
    run(simulator, "render", FLAKE, "--size", "40x30", "--profile", "half", "--layers", "samples", "-o", path)
    report.equal("samples of the half profile", {0.25}, set(picture_files.exr(path)[2]["samples"][1]))


def check_depth(simulator, directory, report):
    """S1's plane is y = 0 seen level from 1.5 above it: camera z of row y follows from the field of view alone."""
    run(simulator, "render", S1, "--size", "40x40", "--layers", "depth,id", "-o", directory / "z.exr")
    channels = picture_files.exr(directory / "z.exr")[2]
    checked = 0
    for i, (object_id, z) in enumerate(zip(channels["id"][1], channels["Z"][1])):
        if object_id == 4:
            down = (2 * (i // 40) + 1 - 40) * 0.5 / 40
            report.at_most(f"Z of pixel {i}", 2.0 ** -13, abs(z * down / 1.5 - 1))
            checked += 1
    report.check(checked > 300, "too little of the plane was seen")


def check_gif(simulator, directory, report):
    path = directory / "turn.gif"
    crcs = fixcast_json(simulator, "render", S1, "--size", "48x40", "--path", "orbit", "--frames", 5, "--fps", 10, "-o", path)["crc32s"]
    fixcast_json(simulator, "render", S1, "--size", "48x40", "--path", "orbit", "--frames", 5, "-o", directory / "turn%02d.ppm")
    width, height, frames, comment, loops = picture_files.gif(path)
    report.equal("animation", (48, 40, 5, 0), (width, height, len(frames), loops))
    report.check(f"fixcast:crc32: {crcs[0]}" in comment, f"comment of the GIF: {comment}")
    report.equal("different frames", 5, len(set(crcs)))
    for i, (delay, pixels) in enumerate(frames):
        plain = ppm(directory / f"turn{i:02}.ppm")[1]
        report.equal(f"delay of frame {i}", 10, delay)
        used = len({plain[k:k + 3] for k in range(0, len(plain), 3)})
        worst = max(abs(a - b) for a, b in zip(plain, pixels))
        report.at_most(f"frame {i} of {used} colours: worst channel", 0 if used <= 256 else 16, worst)
    # Few colours: a frame that a palette holds exactly; large enough for the code table to be cleared.
    for layer in ("id", "normal"):
        run(simulator, "render", FLAKE, "--size", "300x240", "--show", layer, "-o", directory / "few.gif")
        run(simulator, "render", FLAKE, "--size", "300x240", "--show", layer, "-o", directory / "few.ppm")
        plain, pixels = ppm(directory / "few.ppm")[1], picture_files.gif(directory / "few.gif")[2][0][1]
        used = len({plain[k:k + 3] for k in range(0, len(plain), 3)})
        worst = max(abs(a - b) for a, b in zip(plain, pixels))
        report.at_most(f"GIF of {used} colours", 0 if used <= 256 else 64, worst)
        report.check(layer != "id" or used <= 256, "the picture of ids has too many colours for this check")


def camera_crc(simulator, directory, view, lights=None):
    """CRC of S1 with this camera and light written into the scene by hand."""
    text = S1.read_text()
    lines = []
    for line in text.splitlines():
        key = line.split()[0] if line.split() else ""
        if key in view:
            line = f"{key} {view[key]}"
        if key == "l" and lights:
            line = f"l {lights} " + " ".join(line.split()[4:])
        lines.append(line)
    path = directory / "moved.nff"
    path.write_text("\n".join(lines) + "\n")
    return fixcast_json(simulator, "render", path, "--size", "48x40")["crc32"]


def check_paths(simulator, directory, report):
    out = directory / "p%03d.ppm"
    size = ("--size", "48x40")
    still = fixcast_json(simulator, "render", S1, *size)["crc32"]
    for name in ("orbit", "turntable"):
        crcs = fixcast_json(simulator, "render", S1, *size, "--path", name, "--frames", 4, "-o", out)["crc32s"]
        report.equal(f"frame 0 of {name}", still, crcs[0])
    # The middle of S1's spheres is z = -4.875: (-7 - 2.5 ...) / 2, on the view's axis x = 0, y = 1.5. Half a turn puts the eye behind it.
    zs = [(-6, 1), (-4.5, 0.75), (-3, 0.5)]
    middle = (min(z - r for z, r in zs) + max(z + r for z, r in zs)) / 2
    back = {"from": f"0 1.5 {2 * middle - 1}", "at": f"0 1.5 {2 * middle}"}
    crcs = fixcast_json(simulator, "render", S1, *size, "--path", "orbit", "--frames", 2, "-o", out)["crc32s"]
    report.equal("half an orbit", camera_crc(simulator, directory, back), crcs[1])
    crcs = fixcast_json(simulator, "render", S1, *size, "--path", "turntable", "--frames", 2, "-o", out)["crc32s"]
    report.equal("half a turn of the table", camera_crc(simulator, directory, back, f"3 5 {2 * middle + 1}"), crcs[1])

    keys = directory / "keys.txt"
    keys.write_text("# frame, camera\n0 from 0 1.5 1 at 0 1.5 0\n4 from 1 1.5 1 at 0 1.5 -1 # second\n8 from 2 2.5 1 at 0 1.5 -2\n")
    crcs = fixcast_json(simulator, "render", S1, *size, "--path", keys, "--frames", 10, "-o", out)["crc32s"]
    report.equal("key 0", still, crcs[0])
    report.equal("key 4", camera_crc(simulator, directory, {"from": "1 1.5 1", "at": "0 1.5 -1"}), crcs[4])
    report.equal("key 8", camera_crc(simulator, directory, {"from": "2 2.5 1", "at": "0 1.5 -2"}), crcs[8])
    report.equal("after the last key", crcs[8], crcs[9])
    # Catmull-Rom in the middle of keys 0 and 4, the first counted twice: (-a + 9 b + 9 c - d) / 16.
    report.equal("frame 2", camera_crc(simulator, directory, {"from": f"{(9 - 2) / 16} {(8 * 1.5 + 9 * 1.5 - 2.5) / 16} 1",
                                                              "at": f"0 1.5 {(-9 + 2) / 16}"}), crcs[2])
    report.equal("number of frames", 10, len(sorted(directory.glob("p*.ppm"))))


def check_same_bytes(simulator, directory, report):
    for name, options in (("r.png", ()), ("r16.png", ("--bits", 16)), ("r.exr", ()),
                          ("r.gif", ("--path", "turntable", "--frames", 3)), ("r.tif", ())):
        path, copies = directory / name, []
        for zone in ("UTC", "Asia/Tokyo"):
            subprocess.run([simulator, "render", str(S1), "--size", "40x30", "-o", str(path), *map(str, options)], check=True,
                           stdout=subprocess.DEVNULL, env={**os.environ, "TZ": zone})
            copies.append(path.read_bytes())
            path.unlink()
        report.check(copies[0] == copies[1], f"{name}: two runs gave different bytes")


def check_diff(simulator, directory, report):
    a, b, c = directory / "a.png", directory / "b.png", directory / "c.exr"
    run(simulator, "render", S1, "--size", "40x30", "-o", a)
    # One sample of one pixel, changed in a PPM by hand.
    run(simulator, "render", S1, "--size", "40x30", "-o", directory / "a.ppm")
    data = bytearray((directory / "a.ppm").read_bytes())
    at = len(data) - 40 * 30 * 3 + 3 * (17 * 40 + 23) + 1
    before = data[at]
    data[at] = before ^ 1
    (directory / "b.ppm").write_bytes(data)
    run(simulator, "diff", a, a)
    run(simulator, "diff", a, directory / "a.ppm")
    found = json.loads(run(simulator, "diff", directory / "a.ppm", directory / "b.ppm", "--json", code=1).stdout)
    report.equal("one sample", (False, 1, 23, 17, "G"), tuple(found[k] for k in ("same", "pixels", "x", "y", "channel")))
    report.equal("both values", (before, before ^ 1), (found["a"][1], found["b"][1]))
    # The picture: both, and a heat map that is black but for that pixel.
    run(simulator, "diff", directory / "a.ppm", directory / "b.ppm", "-o", directory / "d.png", code=1)
    width, height, _, _, rows, _ = picture_files.png(directory / "d.png")
    report.equal("size of the picture", (3 * 40 + 2 * 4, 30), (width, height))
    heat = [(x, y) for y in range(30) for x in range(40) if any(rows[y][3 * (88 + x):3 * (88 + x) + 3])]
    report.equal("pixels of the heat map", [(23, 17)], heat)
    whole = ppm(directory / "b.ppm")[1]
    report.check(all(bytes(rows[y][3 * 44:3 * 84]) == whole[y * 120:(y + 1) * 120] for y in range(30)), "B is not in the middle")
    run(simulator, "render", S1, "--size", "41x30", "-o", b)
    report.check("sizes" in run(simulator, "diff", a, b, code=1).stdout, "sizes that differ were not named")
    run(simulator, "render", S1, "--size", "40x30", "--bits", 16, "-o", b)
    report.check("formats" in run(simulator, "diff", a, b, code=1).stdout, "formats that differ were not named")
    run(simulator, "render", S1, "--size", "40x30", "-o", c)
    report.check("channels" in run(simulator, "diff", a, c, code=1).stdout, "channels that differ were not named")
    run(simulator, "diff", c, c)
    damaged = directory / "damaged.png"
    damaged.write_bytes(a.read_bytes()[:200])
    text = directory / "text.png"
    text.write_text("no picture\n")
    short = directory / "short.ppm"
    short.write_bytes(data[:-1])
    for path in (directory / "missing.png", text, damaged, short, directory):
        error = run(simulator, "diff", a, path, code=2).stderr
        report.check(path.name in error and error.count("\n") == 1, f"message for {path.name}: {error}")


def check_compare_picture(simulator, directory, report):
    run(simulator, "compare", S1, "--size", "40x30", "--profile", "half", "-o", directory / "c.png")
    run(simulator, "render", S1, "--size", "40x30", "-o", directory / "exact.ppm")
    run(simulator, "render", S1, "--size", "40x30", "--profile", "half", "-o", directory / "half.ppm")
    width, height, _, _, rows, _ = picture_files.png(directory / "c.png")
    report.equal("size of compare's picture", (128, 30), (width, height))
    exact, half = ppm(directory / "exact.ppm")[1], ppm(directory / "half.ppm")[1]
    for y in range(30):
        report.check(bytes(rows[y][:120]) == half[y * 120:(y + 1) * 120], f"row {y}: the left picture is not the core's")
        worst = max(abs(p - q) for p, q in zip(rows[y][132:252], exact[y * 120:(y + 1) * 120]))
        report.at_most(f"row {y}: the oracle's picture", 1, worst)
    wrong = json.loads(run(simulator, "compare", S1, "--size", "40x30", "--profile", "half", "--json").stdout)["wrong_id"]
    pixels = [bytes(rows[y][3 * x:3 * x + 3]) for y in range(30) for x in range(88, 128)]
    report.equal("magenta pixels", wrong, pixels.count(b"\xff\x00\xff"))
    report.check(wrong > 20, "the half profile is not wrong enough for this check")


def check_display(simulator, directory, report):
    """RGB565 panels show the very frame that the CRC is of; grey and monochrome ones only levels that they have, as bright on the whole."""
    path = directory / "panel.png"
    frame = fixcast_json(simulator, "render", S1, "--display", "st7735-128", "-o", path)
    width, height, _, _, rows, _ = picture_files.png(path)
    report.equal("size of the st7735-128", (128, 160), (width, height))
    sent = bytearray()
    for row in rows:
        for x in range(width):
            red, green, blue = (round(row[3 * x + c] * top / 255) for c, top in enumerate((31, 63, 31)))
            sent += (red << 11 | green << 5 | blue).to_bytes(2, "big")
    report.equal("CRC of what the panel shows", frame["crc32"], f"0x{zlib.crc32(sent):08x}")
    run(simulator, "render", FLAKE, "--size", "128x64", "-o", path)
    plain = [sum(w * row[3 * x + c] for c, w in enumerate((0.299, 0.587, 0.114))) for row in picture_files.png(path)[4] for x in range(128)]
    for name, levels in (("ssd0323", set(range(0, 256, 17))), ("ssd1306", {0, 255})):
        run(simulator, "render", FLAKE, "--display", name, "-o", path)
        width, height, _, _, rows, _ = picture_files.png(path)
        report.equal(f"size of the {name}", (128, 64), (width, height))
        shown = [row[3 * x] for row in rows for x in range(128)]
        report.check(set(shown) <= levels and len(set(shown)) >= min(len(levels), 8), f"levels of the {name}: {sorted(set(shown))}")
        report.check(all(row[3 * x] == row[3 * x + 1] == row[3 * x + 2] for row in rows for x in range(128)), f"{name} is not grey")
        for part in range(4): # blocks of rows, so that a picture upside down or shifted is noticed
            cut = slice(part * 2048, part * 2048 + 2048)
            report.at_most(f"brightness of rows {16 * part} and on, {name}", 6, abs(sum(shown[cut]) - sum(plain[cut])) / 2048)


    # A white sky over a dark plane, its edge within a page of eight rows: the very rows.
    sky = ("--background", "1", "--ambient", "0.3", "--light", "0,9,0", "--at", "0,1.46,0")
    run(simulator, "render", S1, "--size", "128x64", *sky, "-o", path)
    white = [min(row) == 255 for row in picture_files.png(path)[4]]
    report.check(8 < sum(white) < 56 and sum(white) % 8 != 0, f"{sum(white)} rows of sky: no check")
    for name in ("ssd0323", "ssd1306"):
        run(simulator, "render", S1, *sky, "--display", name, "-o", path)
        report.equal(f"rows of sky, {name}", white[:40], [min(row) == 255 for row in picture_files.png(path)[4]][:40])


def check_dither(simulator, directory, report):
    """--dither: each pixel is one of the two levels beside its 8 bits, blocks of 8x8 keep their mean, and it is what --rgb565 holds."""
    shown, sent, exact = directory / "shown.png", directory / "sent.bin", directory / "exact.ppm"
    frame = fixcast_json(simulator, "render", S1, "--display", "st7735-128", "--dither", "-o", shown, "--rgb565", sent)
    run(simulator, "render", S1, "--size", "128x160", "-o", exact)
    true = ppm(exact)[1]
    got = b"".join(bytes(row) for row in picture_files.png(shown)[4])
    report.equal("CRC of the dithered frame", frame["crc32"], f"0x{zlib.crc32(sent.read_bytes()):08x}")
    packed = bytearray()
    for i in range(0, len(got), 3):
        red, green, blue = (round(got[i + c] * top / 255) for c, top in enumerate((31, 63, 31)))
        packed += (red << 11 | green << 5 | blue).to_bytes(2, "big")
    report.equal("what --rgb565 holds", bytes(packed), sent.read_bytes())
    tops = (31, 63, 31)
    worst = max(abs(round(g * tops[i % 3] / 255) - t * tops[i % 3] / 255) for i, (g, t) in enumerate(zip(got, true)))
    report.check(0.6 < worst < 1, f"a level is {worst} from its value: less than one, but more than rounding would be")
    means = []
    for y in range(0, 160, 8):
        for x in range(0, 128, 8):
            block = [3 * (128 * (y + j) + x + i) for j in range(8) for i in range(8)]
            if len({true[at] for at in block}) == 1:  # of one red: its mean is kept within 1/128 of a level
                means.append(abs(sum(round(got[at] * 31 / 255) for at in block) / 64 - true[block[0]] * 31 / 255))
    report.check(len(means) > 40 and max(means) <= 1 / 128, f"{len(means)} blocks of one colour, the worst mean off by {max(means)} levels")
    for wrong, word in ((("--display", "ssd1306"), "ssd1306"), ((), "--display")):
        fault = run(simulator, "render", S1, "--dither", *wrong, "-o", directory / "no.png", code=2).stderr
        report.check(word in fault and fault.count("\n") == 1, f"--dither {wrong}: {fault}")


def check_progress(simulator, directory, report):
    """A bar with an estimate on a terminal, nothing in a pipe."""
    command = [simulator, "render", str(FLAKE), "--size", "200x200", "--path", "orbit", "--frames", "20", "-o", str(directory / "bar.gif")]
    master, slave = pty.openpty()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=slave, stdin=subprocess.DEVNULL)
    os.close(slave)
    shown = b""
    try:
        while chunk := os.read(master, 4096):
            shown += chunk
    except OSError:
        pass
    report.equal("exit code", 0, process.wait())
    report.check(b"rendering frames [#" in shown and b" s left" in shown, f"no bar on a terminal: {shown[-200:]}")
    report.check(shown.endswith(b"\r\x1b[K"), "the bar was not wiped away")
    piped = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, check=True)
    report.equal("stderr in a pipe", b"", piped.stderr)


def main(simulator):
    report = Report()
    for check in (check_png, check_exr, check_depth, check_gif, check_paths, check_same_bytes, check_diff,
                  check_compare_picture, check_display, check_dither, check_progress):
        with tempfile.TemporaryDirectory() as directory:
            check(simulator, pathlib.Path(directory), report)
    return report.finish()


sys.exit(main(sys.argv[1]))
