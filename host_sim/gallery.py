"""The fault gallery: what goes wrong in a ray caster, and the cure, side by side with numbers.

gallery.py SIMULATOR DIRECTORY     writes the pictures of docs/LECTURES.md there
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests/bench"))
import bench_scenes  # noqa: E402 - the bench counts instructions
import counting  # noqa: E402
import images  # noqa: E402

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "fixcast"
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402

import gallery_mesh as meshes  # noqa: E402

SCENES = pathlib.Path(__file__).resolve().parent / "scenes"
INCH = 2.6


class Gallery:
    def __init__(self, simulator, directory):
        self.simulator = pathlib.Path(simulator).resolve()
        self.directory = pathlib.Path(directory)
        self.directory.mkdir(parents=True, exist_ok=True)
        self.temporary = tempfile.TemporaryDirectory()
        self.work = pathlib.Path(self.temporary.name)

    def run(self, *arguments):
        result = subprocess.run([self.simulator, *map(str, arguments)], capture_output=True, text=True)
        if result.returncode != 0:
            sys.exit(f"gallery: {' '.join(map(str, arguments))}: {result.stderr.strip()}")
        return result.stdout

    def picture(self, scene, *options):
        """The frame, and what --json says of it."""
        path = self.work / "frame.ppm"
        facts = json.loads(self.run("render", scene, "-o", path, "--json", *options))
        data = path.read_bytes()
        magic, size, _, pixels = data.split(b"\n", 3)
        assert magic == b"P6"
        width, height = map(int, size.split())
        return numpy.frombuffer(pixels, dtype=numpy.uint8).reshape(height, width, 3), facts

    def compare(self, scene, *options):
        return json.loads(self.run("compare", scene, "--json", *options))

    def changed(self, scene, *edits):
        """A copy of a scene with lines replaced; each must be there."""
        text = (SCENES / f"{scene}.nff").read_text()
        for old, new in edits:
            if old not in text:
                sys.exit(f"gallery: {scene}.nff has no line with {old!r}")
            text = text.replace(old, new)
        path = self.work / f"{scene}-changed.nff"
        path.write_text(text)
        return path

    def save(self, name, title, panels, columns=None):
        """panels: (picture, caption)."""
        columns = columns or len(panels)
        rows = -(-len(panels) // columns)
        shapes = [picture.shape for picture, _ in panels]
        widths = [max(shape[1] / shape[0] for shape in shapes[c::columns]) for c in range(columns)]
        high = INCH if columns == 1 else INCH / max(1.0, sum(widths) / columns)
        figure, axes = plt.subplots(rows, columns, figsize=(high * sum(widths) + 0.2 * columns, (high + 0.65) * rows + 0.45), squeeze=False,
                                    gridspec_kw={"width_ratios": widths})
        for axis in axes.flat:
            axis.axis("off")
        for axis, (picture, caption) in zip(axes.flat, panels):
            axis.imshow(picture, interpolation="nearest")
            axis.set_title(caption, fontsize=8)
        figure.suptitle(title, fontsize=9)
        figure.tight_layout(pad=0.4, rect=(0, 0, 1, 0.91))
        path = self.directory / f"{name}.png"
        figure.savefig(path, dpi=110, metadata={"Software": None})
        plt.close(figure)
        print(f"wrote {path}")


def per_million(value):
    return f"{value:,.0f}"


def acne(g):
    """Shadow rays that start too near, and too far."""
    s1 = SCENES / "s1.nff"
    panels = []
    for rule, name in (("none", "no offset: acne"), ("epsilon=0.00000001", "epsilon 1e-8: acne left"), ("epsilon=0.1", "epsilon 0.1: lights leak in"),
                       ("epsilon=0.5", "epsilon 0.5: peter-panning"), ("exact", "exact: no offset at all")):
        size = ("--size", "128x128")
        picture, _ = g.picture(s1, "--offset", rule, *size)
        c = g.compare(s1, "--offset", rule, *size)
        panels.append((picture[52:116, 0:90],
                       f"{name}\n{per_million(c['false_shadow_ppm'])} false shadows, {per_million(c['leak_ppm'])} leaks\na million points"))
    g.save("acne", "Self-shadowing and its cures (S1, a crop)", panels)


def fighting(g):
    """One frame, and what a z-buffer of 16 bits without the exact tie rule makes of it."""
    fight = SCENES / "fight.nff"
    picture, _ = g.picture(fight, "--size", "240x240")
    counts = {name: g.compare(fight, "--depth-format", form)["wrong_order"]
              for name, form in (("1/z as whole numbers", "inverse"), ("half floats", "half"), ("linear z", "linear"), ("e4m12 (ours)", "e4m12"))}
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.6))
    axes[0].imshow(picture, interpolation="nearest")
    axes[0].axis("off")
    axes[0].set_title("orange cards in front of blue, gaps of 2^-8 to 2^-15\nof the distance: ours, 0 pixels wrong", fontsize=8)
    values = list(counts.values())
    axes[1].barh(list(counts), values, color="#c0603a")
    axes[1].set_title("pixels in the wrong order with 16 bits of depth alone", fontsize=8)
    axes[1].set_xlim(0, 1.15 * max(values))
    for i, value in enumerate(values):
        axes[1].text(value, i, f" {value}", va="center", fontsize=8)
    figure.tight_layout()
    figure.savefig(g.directory / "fighting.png", dpi=110, metadata={"Software": None})
    plt.close(figure)
    print(f"wrote {g.directory / 'fighting.png'}")


def cracks(g):
    """A mesh whose triangles round their edge coefficients each by itself."""
    mesh, crop = meshes.Mesh(SCENES / "s2.nff"), (slice(46, 92), slice(42, 88))
    exact, _ = meshes.seen(mesh, 128)
    core, _ = g.picture(SCENES / "s2.nff", "--size", "128x128", "--transfer", "gamma22")
    true, front = meshes.objects(mesh, exact), meshes.facing(mesh, exact)
    panels = []
    for bits in (8, 10, 12, 16):
        shown, _ = meshes.seen(mesh, 128, bits)
        wrong = (meshes.objects(mesh, shown) != true) | (meshes.facing(mesh, shown) != front)
        image = meshes.picture(mesh, shown)
        image[wrong] = (255, 0, 255)
        panels.append((image[crop], f"{bits} bits and a sign:\n{int(wrong.sum())} pixels show what is behind"))
    panels.append((core[crop], f"exact (the core):\n{g.compare(SCENES / 's2.nff', '--size', '128x128')['wrong_id']} pixels"))
    g.save("cracks",
           "Cracks, magenta: edge coefficients rounded triangle by triangle (S2, 1016 triangles, a crop; counts of the whole frame)", panels)


def depth_bits(g):
    """The cards of `fight` by z-buffers of more and fewer bits."""
    mesh = meshes.Mesh(SCENES / "fight.nff")
    near = 1.0  # the ball's front, the nearest thing there is
    exact, _ = meshes.seen(mesh, 240)
    core, _ = g.picture(SCENES / "fight.nff", "--size", "240x240", "--transfer", "gamma22")
    ball = (core.min(axis=2) > 200)
    true, panels = meshes.objects(mesh, exact), []
    for bits in (12, 16, 20, 24):
        shown, _ = meshes.seen(mesh, 240, None, bits, near)
        wrong = int(((meshes.objects(mesh, shown) != true) & ~ball).sum())
        panels.append((numpy.where(ball[:, :, None], core, meshes.picture(mesh, shown)), f"{bits} bits of 1/z:\n{wrong} pixels wrong"))
    panels.append((core, f"ours, 16 bits and an exact tie rule:\n{g.compare(SCENES / 'fight.nff')['wrong_id']} pixels wrong"))
    g.save("depthbits",
           "Z-fighting by bits: orange cards 2^-8 (left) to 2^-15 (right) of their distance in front of blue; rows 4, 40, 400, 4000 away", panels)


def culling(g):
    """Back faces left out: of a closed mesh nothing is missed, of an open one its inside."""
    mesh, crop = meshes.Mesh(SCENES / "s2.nff"), (slice(62, 118), slice(76, 128))
    ball = [i for i, t in enumerate(mesh.triangles) if t.object == 3]
    top = sorted((sum(c[1] for c in mesh.triangles[i].corners) for i in ball))
    bowl = [i for i in ball if sum(c[1] for c in mesh.triangles[i].corners) < top[int(0.6 * len(top))]]
    panels = []
    for name, chosen in (("closed", ball), ("open", bowl)):
        rest = [i for i, t in enumerate(mesh.triangles) if t.object != 3]
        facing = [i for i in chosen if meshes.volume(mesh.triangles[i].corners) * outward(mesh, chosen[0], ball) > 0]
        for culled, drawn in ((False, chosen), (True, facing)):
            shown, _ = meshes.seen(mesh, 128, triangles=rest + drawn)
            panels.append((meshes.picture(mesh, shown)[crop], f"{name}, culling {'on' if culled else 'off'}:\n{len(drawn)} of its triangles drawn"))
    g.save("culling", "Back-face culling is free for a closed manifold and wrong for any other (a crop of S2)", panels)


def outward(mesh, index, ball):
    """The sign of `volume` of triangles of a ball that face the eye: that of the nearest."""
    nearest = min(ball, key=lambda i: sum(c[2] for c in mesh.triangles[i].corners))
    return 1 if meshes.volume(mesh.triangles[nearest].corners) > 0 else -1


def filters(g):
    panels = []
    for options, name in ((("--samples", "one"), "one ray"), (("--samples", "regular:6", "--filter", "box"), "box"),
                          (("--samples", "regular:6", "--filter", "tent"), "tent"), (("--samples", "regular:6", "--filter", "gaussian"), "Gaussian"),
                          (("--samples", "regular:6", "--filter", "mitchell"), "Mitchell")):
        picture, _ = g.picture(SCENES / "show.nff", "--size", "120x120", "--transfer", "srgb", *options)
        panels.append((picture[38:62, 36:72], name))
    g.save("filters", "Reconstruction of 6 x 6 rays a pixel (a crop of 36 x 24 pixels)", panels)


def dither(g):
    """A sky of few levels, as a display of 16 bits a pixel has them."""
    scene, panels = g.work / "sky.nff", []
    scene.write_text("v\nfrom 0 0 0\nat 0 0 -1\nup 0 1 0\nangle 60\nhither 0.01\nresolution 240 240\n#fc: gradient 0 1 0 0.18 0.3 0.5\n"
                     "b 0.02 0.03 0.06\nl 4 3 0 0.5 0.5 0.5\n#fc: ambient 0.02\n#fc: object 1\nf 0.35 0.33 0.3 1 0 0 0 1\ns 0 -0.4 -3 0.9\n")
    for options, name in (((), "5, 6 and 5 bits, rounded: bands"), (("--dither",), "5, 6 and 5 bits, ordered dither")):
        picture, _ = g.picture(scene, "--display", "st7789-240", *options)
        crop = picture[60:180, 40:200].astype(float)
        panels.append((crop.astype(numpy.uint8), name))
        panels.append(((3 * crop).clip(0, 255).astype(numpy.uint8), f"{name.split(',')[-1].strip().split(':')[0]}, three times as bright"))
    g.save("dither", "A dark gradient on a display of 65536 colours (a crop of 160 x 120 pixels)", panels)


def aliasing(g):
    """Patterns side by side, with their rays, and their instructions on a Cortex-M3 by the bench's harness."""
    panels = []
    for options, name, pattern in ((("--samples", "one"), "one ray", "one"), (("--samples", "regular:4"), "4 x 4 regular", "regular"),
                                   (("--samples", "random:16", "--seed", "1"), "16 at random", "random"),
                                   (("--samples", "jitter:16", "--seed", "1"), "4 x 4 jittered", "jittered"),
                                   (("--samples", "quincunx"), "adaptive quincunx", "quincunx")):
        picture, facts = g.picture(SCENES / "show.nff", "--size", "96x96", "--transfer", "srgb", *options)
        cost = instructions(g, pattern, 96) / 1000
        panels.append((picture[18:50, 30:78], f"{name}\n{facts['rays'] / (96 * 96):.2f} rays a pixel\n{cost:.0f} thousand instructions a pixel"))
    counts, _ = g.picture(SCENES / "show.nff", "--size", "96x96", "--samples", "quincunx", "--show", "samples")
    panels.append((counts[18:50, 30:78], "where quincunx sends rays\nbright is many\n"))
    g.save("aliasing", "Aliasing and its cures (`show` at 96 x 96, a crop of 48 x 32 pixels; instructions on a Cortex-M3)", panels)


def instructions(g, pattern, size):
    """A pixel's, of scene `show` on an emulated Cortex-M3."""
    work = g.simulator.parent / "bench"
    try:
        workshop = images.Workshop(work, bench_scenes.Scenes(work, g.simulator))
        built = workshop.build(images.Image("m3", f"fixcast-{pattern}", "show", size, size))
        counts = counting.count("m3", built, work, 40_000_000_000).instructions
    except images.Failure as failure:
        sys.exit(f"gallery: {failure}")
    return sum(counts.values()) / size / size


def gamma(g):
    panels = [(g.picture(SCENES / "show.nff", "--transfer", name)[0], caption)
              for name, caption in (("linear", "gamma 1.0: levels proportional to light"), ("gamma22", "gamma 2.2"), ("srgb", "sRGB"))]
    g.save("gamma", "The same light on a display that shows level^2.2", panels)


def falloff(g):
    off = g.changed("box", ("#fc: falloff inverse-square", "#fc: falloff none"))
    lines = off.read_text().splitlines()
    for i, line in enumerate(lines):
        if line.startswith("l "):
            lines[i] = " ".join(line.split()[:4]) + " 0.9 0.88 0.8"
    off.write_text("\n".join(lines) + "\n")
    g.save("falloff", "Kepler's law", [(g.picture(SCENES / "box.nff", "--transfer", "srgb")[0], "inverse square"),
                                       (g.picture(off, "--transfer", "srgb")[0], "no falloff")])


def lenses(g):
    panels = []
    for lens, size, name in (("pinhole", "160x160", "pinhole"), ("orthographic", "160x160", "orthographic"), ("fisheye:180", "160x160", "fisheye, 180 degrees"),
                             ("panorama", "320x160", "panorama, 360 x 180 degrees")):
        panels.append((g.picture(SCENES / "show.nff", "--transfer", "srgb", "--lens", lens, "--samples", "regular:2", "--size", size)[0], name))
    g.save("lenses", "Four cameras at one place", panels)


def shading(g):
    g.save("shading", "Flat, smooth, and Phong's highlight",
           [(g.picture(SCENES / "smooth.nff", "--transfer", "srgb", "--size", "480x200", "--samples", "regular:2")[0], "80 triangles each")])


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: gallery.py SIMULATOR DIRECTORY")
    gallery = Gallery(sys.argv[1], sys.argv[2])
    for make in (acne, cracks, fighting, depth_bits, aliasing, filters, gamma, dither, falloff, culling, lenses, shading):
        make(gallery)
    return 0


if __name__ == "__main__":
    sys.exit(main())
