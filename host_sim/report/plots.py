"""The report's pictures: SVG, the same bytes from the same figures."""
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 - after the choice of backend
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

import bars  # noqa: E402
import rows as bench  # noqa: E402
import stages  # noqa: E402
import wire  # noqa: E402

# Okabe and Ito's colours, told apart with any colour vision; markers differ too.
BLUE, ORANGE, GREEN, RED, PURPLE, SKY, YELLOW, GREY, BLACK = (
    "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#F0E442", "#999999", "#000000")
LOOKS = {"fixcast exact": (BLUE, "o"), "fixcast fast": (SKY, "P"), "fixcast half": (YELLOW, "s"),
         "fixcast interlaced": (SKY, "D"), "fixcast-rays": (PURPLE, "X"), "float": (RED, "^"), "double": (ORANGE, "v"),
         "q16": (GREEN, "s"), "scan float": (BLACK, "*"), "fixed": (GREEN, "D")}
PROFILES = tuple(f"fixcast {profile}" for profile in ("exact", "fast", "half", "interlaced"))
FIELD = "fixcast interlaced"
END = 40  # of the axis of errors, times the largest: room for a name
LEGIBLE = {"font.size": 10, "axes.titlesize": 11, "axes.spines.top": False, "axes.spines.right": False,
           "svg.hashsalt": "fixcast", "svg.fonttype": "path", "figure.dpi": 100, "axes.axisbelow": True}


def short(number, _=None):
    """1500 as 1.5k; for axes and labels."""
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if abs(number) >= size:
            return f"{number / size:.3g}{letter}"
    return f"{number:.3g}"


def save(figure, place, name):
    figure.savefig(pathlib.Path(place) / f"{name}.svg", metadata={"Date": None, "Creator": None}, bbox_inches="tight",
                   pad_inches=0.1)
    plt.close(figure)


def log_axis(axis):
    low, high = axis.get_view_interval()
    if high < 60 * low:  # too few powers of ten to read from
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(short))
    axis.set_minor_formatter(NullFormatter())


def apart(values, gap):
    """The values moved up and down as little as simple passes can, so that neighbours are `gap` apart."""
    order = sorted(range(len(values)), key=lambda i: values[i])
    placed = [values[i] for i in order]
    for _ in range(200):
        for i in range(len(placed) - 1):
            lack = gap - (placed[i + 1] - placed[i])
            if lack > 1e-9:
                placed[i] -= lack / 2
                placed[i + 1] += lack / 2
    result = [0.0] * len(values)
    for rank, i in enumerate(order):
        result[i] = placed[rank]
    return result


def clear_of(spots, i, width, gap):
    """The height of a text of this width right of spot i that passes above or below the spots behind it."""
    x, y = spots[i]
    for other_x, other_y in spots:
        if 0 < other_x - x < width and abs(other_y - y) < gap:
            return other_y + gap if y > other_y else other_y - gap
    return y


def label(axes, items, gap=13, right=9):
    """Texts right of points (x, y, text, colour), moved in height where they would overlap."""
    axes.figure.canvas.draw()
    scale = axes.figure.dpi / 72
    spots = [axes.transData.transform((x, y)) for x, y, _, _ in items]
    heights = [clear_of(spots, i, (right + 6 * len(item[2])) * scale, gap * scale) for i, item in enumerate(items)]
    columns = {}
    for i, (x, _) in enumerate(spots):
        columns.setdefault(round(x / 90), []).append(i)
    for members in columns.values():
        for i, height in zip(members, apart([heights[i] for i in members], gap * scale)):
            x, y, text, colour = items[i]
            moved = (height - spots[i][1]) / scale
            axes.annotate(text, (x, y), (right, moved), textcoords="offset points", va="center", fontsize=9,
                          color=colour, annotation_clip=False, zorder=2,
                          bbox={"boxstyle": "square,pad=0.12", "fc": "white", "ec": "none"},
                          arrowprops=None if abs(moved) < 4 else {"arrowstyle": "-", "color": GREY, "lw": 0.6})


# ---- speed against error ----

def colour_error(row):
    """To a hundredth of a level: less is no reason to choose."""
    return None if row["colour_rmse"] is None else round(row["colour_rmse"], 2)


def against_error(axes, found, error_of, title):
    points = [(error_of(row), row["instructions_per_pixel"], bench.name_of(row)) for row in found
              if error_of(row) is not None and row["instructions_per_pixel"] is not None]
    axes.set_title(title)
    if not points:
        axes.text(0.5, 0.5, "not measured", transform=axes.transAxes, ha="center", color=GREY)
        return
    # A field is half of a frame: it beats nobody who draws all of it.
    best = bench.front([(error, cost) for error, cost, name in points if name != FIELD])
    most = max(error for error, _, _ in points)
    right = END * max(most, 1)
    axes.set_yscale("log")
    low, high = min(cost for _, cost, _ in points) / 2.5, max(cost for _, cost, _ in points) * 2.5
    axes.set_ylim(low, high)
    axes.set_xscale("symlog", linthresh=1, linscale=2.2)
    axes.set_xlim(-0.15, right)
    # Above and right of this line everything is beaten.
    xs, ys = [best[0][0]], [high]
    for error, cost in best:
        xs += [error, error]
        ys += [ys[-1], cost]
    axes.plot([*xs, right], [*ys, ys[-1]], color=BLUE, lw=2.5, alpha=0.55, zorder=1)
    items = []
    for error, cost, name in points:
        colour, marker = LOOKS.get(name, (GREY, "X"))
        on_front, ours = (error, cost) in best, name in PROFILES
        axes.plot(error, cost, marker, color=colour, ms=12 if marker == "*" else 9, alpha=1 if on_front or ours else 0.35,
                  mfc="white" if name == FIELD else colour, mec=BLACK if on_front or ours else colour, zorder=3, clip_on=False)
        items.append((error, cost, f"{name.replace('fixcast ', '').replace('fixcast-', '')}  {short(cost)}", BLACK if on_front or ours else "#767676"))
    log_axis(axes.yaxis)
    ticks = [tick for tick in (0, 0.5, 1, 10, 100, 1000, 10000) if tick <= max(2 * most, 1)]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    axes.grid(True, which="major", color="#e8e8e8")
    label(axes, items)


def speed(rows, place, scene, error_of, name, unit):
    figure, grid = plt.subplots(2, 3, figsize=(13, 8.2))
    figure.subplots_adjust(wspace=0.32, hspace=0.36)
    for axes, target in zip(grid.flat, bench.TARGETS):
        found = bench.find(rows, scene=scene, target=target)
        against_error(axes, found, error_of, bench.TARGETS[target])
        axes.set_xlabel(unit)
    for axes in grid[:, 0]:
        axes.set_ylabel("instructions a pixel")
    key = grid[1, 2]
    key.axis("off")
    key.text(0, 0.95, f"Scene {bench.SCENES[scene]}, 128x128.\n\nLower is faster, further left is more exact.\n\n"
             "Blue line: the Pareto front; pale marks are beaten.\n\n"
             "exact, fast, half, interlaced: profiles of fixcast;\nstrong marks, as they are the choices.\n"
             "interlaced, hollow: what a field costs, half the rows;\nits errors are a still picture's.\n"
             "Colours are judged at 8 bits a channel, where fast is\nas exact; at 16 bits a pixel it is within 4/255.\n\n"
             "rays: its definition, a ray a pixel\nfloat, double: plain C, of meshes a rasteriser\nq16: Q16.16, 64-bit products\n"
             "scan float: our algorithm in hardware float\nfixed: an integer rasteriser", va="top", fontsize=10, transform=key.transAxes)
    save(figure, place, name)


# ---- cost by stage ----

STAGE_COLOURS = (GREY, BLUE, SKY, YELLOW, PURPLE, ORANGE, GREEN, RED)


def stage_bars(rows, place):
    scenes = ("s1b", "s1", "s1r", "s5s64", "s2", "s5f21", "s4")
    names = ("S1, spheres only", "S1", "S1r", "S5, 64 spheres", "S2, 1016 triangles", "S5, 882 triangles", "S4: S2, shadows")
    figure, grid = plt.subplots(1, 2, figsize=(12, 4.6), sharey=True)
    figure.subplots_adjust(wspace=0.06)
    for axes, target in zip(grid, ("m0plus", "m3")):
        for y, scene in enumerate(scenes):
            row = bench.one(rows, scene=scene, target=target)
            shares = stages.by_stage(row) if row and row["stages"] else dict.fromkeys(stages.STAGES, 0.0)
            whole, left = sum(shares.values()), 0.0
            for (stage, share), colour in zip(shares.items(), STAGE_COLOURS):
                width = 100 * share / whole if whole else 0
                axes.barh(y, width, left=left, color=colour, edgecolor="white", lw=0.5, height=0.7,
                          label=stage if y == 0 else None)
                if width >= 6:
                    axes.text(left + width / 2, y, short(share), ha="center", va="center", fontsize=8,
                              color="white" if colour in (BLUE, GREEN, RED) else BLACK)
                left += width
            axes.text(101 if whole else 1, y, short(whole) if whole else "over the bench's limit" if row else "not measured",
                      va="center", fontsize=10)
        axes.set_xlim(0, 112)
        axes.set_xticks(range(0, 101, 20))
        axes.set_title(f"{bench.TARGETS[target]}: share and instructions a pixel")
        axes.set_xlabel("% of the frame's instructions, 128x128")
        axes.set_yticks(range(len(names)), names)
    grid[0].invert_yaxis()
    handles, labels = grid[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncol=len(labels), bbox_to_anchor=(0.5, 1.06), frameon=False,
                  columnspacing=1.2, handlelength=1.2)
    save(figure, place, "stages")


# ---- cost against primitives and pixels ----

def lines(axes, curves):
    """curves: (points, text, colour, marker); each text stands at its line's end."""
    items = []
    for points, text, colour, marker in curves:
        points = [(x, y) for x, y in points if y is not None]
        if points:
            axes.plot(*zip(*points), marker=marker, color=colour, lw=1.8, ms=5)
            items.append((*points[-1], text, colour))
    axes.set_xscale("log")
    axes.set_yscale("log")
    if not items:
        axes.text(0.5, 0.5, "not measured", transform=axes.transAxes, ha="center", color=GREY)
        return
    for axis in (axes.xaxis, axes.yaxis):
        log_axis(axis)
    axes.grid(True, which="major", color="#e8e8e8")
    label(axes, items)


def curve(rows, scenes, target, **wanted):
    """[(primitives, instructions a pixel)]"""
    return [(count, found[0]["instructions_per_pixel"]) for scene, count in scenes
            for found in [bench.find(rows, scene=scene, target=target, **wanted)] if found]


def primitives(rows, place):
    spheres = [(f"s5s{n}", n) for n in (1, 8, 64, 512)]
    flat, lit = ([(f"s5{kind}{g}", 2 * g * g) for g in (5, 10, 21, 45)] for kind in "ft")
    exact = {"renderer": "fixcast", "profile": "exact"}
    figure, grid = plt.subplots(2, 3, figsize=(13, 8))
    figure.subplots_adjust(wspace=0.42, hspace=0.34)
    for column, target in zip(range(3), ("m0plus", "m3", "m4f")):
        upper, lower = grid[0, column], grid[1, column]
        lines(upper, [(curve(rows, spheres, target, **exact), "fixcast", BLUE, "o")] +
              [(curve(rows, spheres, target, renderer=name), name.replace("_", " "), *LOOKS[name.replace("_", " ")])
               for name in ("float", "q16", "scan_float")])
        lines(lower, [(curve(rows, flat, target, **exact), "fixcast", BLUE, "o"),
                      (curve(rows, lit, target, **exact), "fixcast, lit", SKY, "s")] +
              [(curve(rows, flat, target, renderer=name), name, *LOOKS[name]) for name in ("fixed", "float")])
        upper.set_title(f"{bench.TARGETS[target]}: spheres, shadows")
        lower.set_title(f"{bench.TARGETS[target]}: triangles")
        upper.set_xlabel("spheres")
        lower.set_xlabel("triangles")
    for axes in grid[:, 0]:
        axes.set_ylabel("instructions a pixel, 128x128")
    save(figure, place, "primitives")


def sizes(rows, place):
    scenes = (("s1", "S1", BLUE, "o"), ("s1r", "S1r", SKY, "s"), ("s2", "S2", ORANGE, "^"), ("s4", "S4", RED, "v"),
              ("s5s8", "8 spheres", GREEN, "D"), ("s5t10", "200 triangles, lit", PURPLE, "P"))
    figure, grid = plt.subplots(1, 2, figsize=(12, 4.8))
    figure.subplots_adjust(wspace=0.35)
    for axes, target in zip(grid, ("m0plus", "m3")):
        curves = []
        for scene, name, colour, marker in scenes:
            found = bench.ours(rows, scene=scene, target=target, size=["64x64", "128x128", "240x240", "320x240"])
            points = sorted((bench.pixels(row), row["instructions_per_pixel"]) for row in found
                            if row["instructions_per_pixel"] is not None)
            curves.append((points, name, colour, marker))
        lines(axes, curves)
        axes.set_xticks([4096, 16384, 57600, 76800], ["64x64", "128x128", "240x240", "\n320x240"])
        axes.minorticks_off()
        axes.set_title(bench.TARGETS[target])
        axes.set_xlabel("size of the frame, pixels")
    grid[0].set_ylabel("instructions a pixel, set-up included")
    save(figure, place, "sizes")


# ---- memory ----

def grouped(axes, groups, series, unit):
    """series: (name, colour, values); None is written as n/a."""
    width = 0.8 / len(series)
    for i, (name, colour, values) in enumerate(series):
        xs = [group + (i - (len(series) - 1) / 2) * width for group in range(len(groups))]
        axes.bar(xs, [value or 0 for value in values], width * 0.94, color=colour, label=name)
        for x, value in zip(xs, values):
            axes.text(x, value or 0, "n/a" if value is None else f" {value:.3g}", ha="center", va="bottom", fontsize=8,
                      rotation=90 if len(series) * len(groups) > 12 else 0)
    axes.set_xticks(range(len(groups)), groups, fontsize=9)
    axes.set_ylabel(unit)
    axes.grid(True, axis="y", color="#e8e8e8")
    axes.margins(y=0.2)
    axes.legend(frameon=False, ncol=len(series), loc="lower center", bbox_to_anchor=(0.5, 1.0), columnspacing=1)


def in_kb(row, key):
    return None if row is None or row[key] is None else row[key] / 1024


def memory(rows, place):
    figure, grid = plt.subplots(1, 3, figsize=(14, 4.4), gridspec_kw={"width_ratios": (1.4, 1.2, 1.2)})
    figure.subplots_adjust(wspace=0.25)
    chips = ["M0+", "M3", "M4", "M4F", "RV32"]
    scenes = (("s1b", "spheres", SKY), ("s1", "spheres, planes", BLUE), ("s2", "triangles", ORANGE))
    grouped(grid[0], chips, [(name, colour, [in_kb(bench.one(rows, scene=scene, target=target), "flash_bytes")
                                             for target in bench.TARGETS]) for scene, name, colour in scenes],
            "flash: code and tables, KB")
    which = (("s1", "S1"), ("s5s64", "64\nspheres"), ("s5s512", "512\nspheres"), ("s2", "S2"), ("s5f45", "4050\ntriangles"))
    grouped(grid[1], [name for _, name in which],
            [("Cortex-M0+", BLUE, [in_kb(bench.one(rows, scene=scene, target="m0plus"), "ram_bytes")
                                   for scene, _ in which])], "RAM beyond the strip, KB")
    grouped(grid[2], ["S1", "S1r", "512\nspheres", "S2"],
            [(bench.TARGETS[target], colour, [in_kb(bench.one(rows, scene=scene, target=target), "stack_bytes")
                                              for scene in ("s1", "s1r", "s5s512", "s2")])
             for target, colour in (("m0plus", BLUE), ("m3", SKY))], "stack, KB")
    save(figure, place, "memory")


# ---- the wire ----

def wire_bars(rows, place):
    figure, grid = plt.subplots(1, len(wire.DISPLAYS), figsize=(14, 4.8))
    figure.subplots_adjust(wspace=0.28)
    colours = (GREY, SKY, BLUE)
    for axes, display in zip(grid, wire.DISPLAYS):
        limit = wire.bus_frames(display)
        for x, scene in enumerate(bench.SCENES):
            for i, (clock, cores) in enumerate(wire.CHIPS):
                drawn = wire.drawn(rows, display, scene, clock, cores)
                place_x = x + (i - 1) * 0.27
                axes.bar(place_x, drawn[0] if drawn else 0, 0.25, color=colours[i],
                         label=f"{clock} MHz, {cores} core{'s, inferred' if cores > 1 else ''}" if x == 0 else None)
                axes.annotate(f"{drawn[0]:.3g}" if drawn else "n/a", (place_x, drawn[0] if drawn else 0), (0, 3),
                              textcoords="offset points", rotation=90, ha="center", va="bottom", fontsize=8, zorder=4,
                              bbox={"boxstyle": "square,pad=0.05", "fc": "white", "ec": "none"})
        axes.axhline(limit, color=RED, lw=2)
        axes.text(3.45, limit, f"bus: {limit:.1f}", color=RED, va="bottom", ha="right", fontsize=9)
        axes.set_xticks(range(len(bench.SCENES)), bench.SCENES.values())
        axes.set_title(f"{display.width}x{display.height}, {display.name}\n{display.mhz:g} MHz")
        axes.grid(True, axis="y", color="#e8e8e8")
        axes.set_ylim(0, max(limit, *(bar.get_height() for bar in axes.patches)) * 1.2)
    grid[0].set_ylabel("frames a second")
    handles, labels = grid[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncol=3, bbox_to_anchor=(0.5, 1.1), frameon=False)
    save(figure, place, "wire")


def bar_chart(rows, place):
    """How far each figure is from what was asked for. What may not differ from 0 has no such measure."""
    known = [(bar, value, verdict) for bar, value, verdict in bars.judged(rows) if verdict != "not measured" and bar["bar"]]
    figure, axes = plt.subplots(figsize=(11, 0.4 * len(known) + 1.2))
    colours = {"aim met": GREEN, "bar met": SKY, "MISSED": RED}
    most = 4 * max([value / bar["bar"] for bar, value, _ in known if value is not None] + [1])
    for y, (bar, value, verdict) in enumerate(known):
        ratio = most / 2 if value is None else value / bar["bar"]
        axes.barh(y, ratio, color=colours[verdict], height=0.62, hatch="//" if value is None else None, ec="white", lw=0)
        axes.plot([bar["aim"] / bar["bar"]] * 2, [y - 0.38, y + 0.38], color=BLACK, lw=2)
        text = "over the bench's limit" if value is None else f"{short(value)} of {short(bar['bar'])}"
        axes.text(max(ratio, 1) * 1.05, y, f"{text}  {verdict}", va="center", fontsize=9)
    axes.axvline(1, color=BLACK, lw=1, ls="--")
    axes.set_xscale("log")
    axes.set_xlim(0.05, most * 5)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.set_yticks(range(len(known)), [bar["what"] for bar, _, _ in known])
    axes.invert_yaxis()
    axes.set_xlabel("measured / bar (log); dashed line: the bar, short black line: the aim")
    save(figure, place, "bars")


def draw(rows, place):
    place = pathlib.Path(place)
    place.mkdir(parents=True, exist_ok=True)
    with plt.rc_context(LEGIBLE):
        for scene in ("s1", "s1r"):
            speed(rows, place, scene, bench.wrong, f"wrong-{scene}", "wrong ids and shadows, of 16384 pixels")
            speed(rows, place, scene, colour_error, f"colour-{scene}", "colour error, rmse, 8-bit levels")
        speed(rows, place, "s2", bench.wrong, "wrong-s2", "wrong ids, of 16384 pixels")
        for plot in (stage_bars, primitives, sizes, memory, wire_bars, bar_chart):
            plot(rows, place)
