"""Which profile to use: tables and sentences made from the figures, so that they change with them."""
import rows as bench
import wire
from against_oracle import table

PAYS = 0.05  # of exact's instructions: a profile that saves less is not worth what it gives up
SCENES = ("s1", "s1r", "s2", "s4")
# What a stranger chooses by, in the order of the profiles' numbers: when to take it, what it gives up.
PROFILES = {
    "exact": ("it must be right, or the same on every chip and build", "nothing"),
    "fast": ("the panel takes 16 bits a pixel and nothing compares frames bit by bit",
             "colours are within 4/255, and shadows may err where a form's error bound leaves them open; objects and depth "
             "are exact"),
    "half": ("things move, pixels are small, or it is a preview",
             "three pixels of four: each block of 2x2 shows one exact sample"),
    "interlaced": ("the panel or a frame buffer keeps the rows that are not sent, and the picture moves slowly",
                   "time: a frame is every other row, exact, and the rows between are a frame old"),
}


def figures(row):
    """An error in words."""
    count = bench.wrong(row)
    pixels = "no wrong pixel" if count == 0 else f"{count} wrong pixel{'s' if count > 1 else ''}"
    return f"{pixels}, colour rmse {row['colour_rmse']:.2f}"


def measured(rows, scene, target, **wanted):
    return [row for row in bench.find(rows, scene=scene, target=target, **wanted)
            if row["instructions_per_pixel"] is not None and bench.wrong(row) is not None]


def profiles(rows, scene, target, **wanted):
    """{profile: its row} of what was measured."""
    return {row["profile"]: row for row in measured(rows, scene, target, **wanted) if row["renderer"] == "fixcast"}


def saved(found, profile):
    """The share of exact's instructions that a profile does without; below 0 when it takes more."""
    return 1 - found[profile]["instructions_per_pixel"] / found["exact"]["instructions_per_pixel"]


def percent(share):
    return f"{100 * share:.0f} %"


def span(shares):
    """From the least to the most, in words."""
    if not shares:
        return "not measured"
    low, high = min(shares), max(shares)
    if round(100 * low) == round(100 * high):
        return percent(low)
    return f"{100 * low:.0f} to {percent(high)}"


def choices(rows):
    """A line a profile: when, at what price, for how much."""
    lines = []
    for profile, (when, price) in PROFILES.items():
        shares = {scene: [saved(found, profile) for target in bench.TARGETS
                          for found in [profiles(rows, scene, target)] if "exact" in found and profile in found]
                  for scene in SCENES}
        lines.append((f"`{profile}`", when, price, *("-" if profile == "exact" else span(shares[scene]) for scene in SCENES)))
    return table(["profile", "take it when", "it gives up", *(f"saves on {bench.SCENES[scene]}" for scene in SCENES)], lines)


def each_chip(rows):
    """Instructions a pixel of every profile on every chip and scene, and which of them pay."""
    lines = []
    for target in bench.TARGETS:
        for scene in SCENES:
            found = profiles(rows, scene, target)
            if "exact" not in found:
                continue
            cells = []
            for profile in PROFILES:
                if profile not in found:
                    cells.append("-")
                    continue
                text = f"{found[profile]['instructions_per_pixel']:.1f}"
                cells.append(text if profile == "exact" else f"{text} ({-100 * saved(found, profile):+.0f} %)")
            paying = [f"`{profile}`" for profile in PROFILES
                      if profile != "exact" and profile in found and saved(found, profile) >= PAYS]
            wrong = ", ".join(f"{bench.wrong(found[profile])} ({profile})" for profile in ("fast", "half")
                              if profile in found and bench.wrong(found[profile]))
            lines.append((bench.TARGETS[target], bench.SCENES[scene], *cells, wrong or "0", ", ".join(paying) or "none"))
    return table(["chip", "scene", *(f"`{profile}`" for profile in PROFILES), "wrong pixels of 16384",
                  f"save {percent(PAYS)} or more"], lines)


def against_float(found, exact):
    plain = next((row for row in found if row["renderer"] == "float"), None)
    if plain is None:
        return ""
    ratio = plain["instructions_per_pixel"] / exact["instructions_per_pixel"]
    times = f"{ratio:.1f} times fewer than" if ratio >= 1 else f"{1 / ratio:.1f} times more than"
    return f", {times} plain float ({figures(plain)})"


def other_profiles(found):
    """A sentence a profile that buys speed."""
    text = ""
    for profile in PROFILES:
        if profile == "exact" or profile not in found or saved(found, profile) < PAYS:
            continue
        row = found[profile]
        what = f"{row['instructions_per_pixel']:.0f} instructions" + (" a field" if profile == "interlaced" else "")
        still = " of a still picture" if profile == "interlaced" else ""
        text += f" `{profile}` saves {percent(saved(found, profile))} ({what}; {figures(row)}{still})."
    return text


def rivals(found, exact):
    """Who is faster, and at what price."""
    faster = [row for row in found if not row["renderer"].startswith("fixcast")
              and row["instructions_per_pixel"] < exact["instructions_per_pixel"]]
    return "".join(f" Faster: {bench.name_of(row)}, {row['instructions_per_pixel']:.0f} instructions, {figures(row)}."
                   for row in sorted(faster, key=lambda row: row["instructions_per_pixel"]))


def line(rows, target):
    found = measured(rows, "s1", target)
    ours = profiles(rows, "s1", target)
    exact = ours.get("exact")
    if exact is None:
        return f"- **{bench.TARGETS[target]}**: not measured."
    return (f"- **{bench.TARGETS[target]}**: `exact` draws S1 in {exact['instructions_per_pixel']:.0f} instructions a pixel "
            f"({figures(exact)}){against_float(found, exact)}.{other_profiles(ours)}{rivals(found, exact)}")


def on_a_panel(rows):
    """Frames a second on the chip whose cycles are known."""
    found = profiles(rows, "s1", "rp2040", size="240x240")
    rates = [f"{125e6 / (row['cycles_per_pixel'] * bench.pixels(row)):.0f} by `{profile}`"
             for profile, row in ((profile, found[profile]) for profile in PROFILES if profile in found) if row["cycles_per_pixel"]]
    if not rates:
        return ""
    display = next(display for display in wire.DISPLAYS if (display.width, display.height) == (240, 240))
    return (f"One core of an RP2040 at 125 MHz draws S1 on a 240x240 panel so many times a second: {', '.join(rates)}; the bus "
            f"takes {wire.bus_frames(display):.0f} whole frames. (Interlaced frames are fields.)")


def text(rows):
    others = sorted({row["profile"] for row in rows if row["renderer"] == "fixcast"} - {"exact", None})
    start = ("Start with `exact`." if others else "There is one profile to use, `exact`; no other was measured.")
    drawn = [row for row in bench.ours(rows, size=["64x64", "128x128", "240x240", "320x240"], target=list(bench.TARGETS))
             if bench.wrong(row) is not None]
    broken = sorted({row["scene"] for row in drawn if bench.wrong(row) or row["colour_max"] > 1})
    kept = ("Every frame that it finished here has no wrong id, no wrong shadow and no colour more than one level off."
            if not broken else f"Its promise of exact pictures is BROKEN here on {', '.join(broken)}.")
    parts = [f"{start} {kept}"]
    if others:
        parts += [choices(rows), "On S1, chip by chip:"]
    parts.append("\n".join(line(rows, target) for target in bench.TARGETS))
    if others:
        parts += [on_a_panel(rows), f"Instructions a pixel of the frame and what a profile adds or saves, by scene. Where none saves "
                  f"{percent(PAYS)}, the set-up of triangles and their shadows cost more than pixels do: use `exact`.",
                  each_chip(rows)]
    return "\n\n".join(part for part in parts if part)
