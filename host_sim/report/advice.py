"""Which profile to use: sentences made from the figures, so that they change with them."""
import rows as bench

GAIN = 0.9  # another profile is worth a word when it takes at most this share of exact's instructions


def figures(row):
    """An error in words."""
    count = bench.wrong(row)
    pixels = "no wrong pixel" if count == 0 else f"{count} wrong pixel{'s' if count > 1 else ''}"
    return f"{pixels}, colour rmse {row['colour_rmse']:.2f}"


def measured(rows, scene, target):
    return [row for row in bench.find(rows, scene=scene, target=target)
            if row["instructions_per_pixel"] is not None and bench.wrong(row) is not None]


def against_float(found, exact):
    plain = next((row for row in found if row["renderer"] == "float"), None)
    if plain is None:
        return ""
    ratio = plain["instructions_per_pixel"] / exact["instructions_per_pixel"]
    times = f"{ratio:.1f} times fewer than" if ratio >= 1 else f"{1 / ratio:.1f} times more than"
    return f", {times} plain float ({figures(plain)})"


def other_profiles(found, exact):
    """A sentence a profile that buys speed."""
    text = ""
    for row in found:
        share = row["instructions_per_pixel"] / exact["instructions_per_pixel"]
        if row["renderer"] == "fixcast" and row["profile"] != "exact" and share <= GAIN:
            text += (f" `{row['profile']}` saves {100 * (1 - share):.0f} % ({row['instructions_per_pixel']:.0f} instructions; "
                     f"{figures(row)}): take it where that may be seen.")
    return text


def rivals(found, exact):
    """Who is faster, and at what price."""
    faster = [row for row in found if not row["renderer"].startswith("fixcast")
              and row["instructions_per_pixel"] < exact["instructions_per_pixel"]]
    return "".join(f" Faster: {bench.name_of(row)}, {row['instructions_per_pixel']:.0f} instructions, {figures(row)}."
                   for row in sorted(faster, key=lambda row: row["instructions_per_pixel"]))


def line(rows, target):
    found = measured(rows, "s1", target)
    exact = next((row for row in found if bench.name_of(row) == "fixcast exact"), None)
    if exact is None:
        return f"- **{bench.TARGETS[target]}**: not measured."
    return (f"- **{bench.TARGETS[target]}**: `exact` draws S1 in {exact['instructions_per_pixel']:.0f} instructions a pixel "
            f"({figures(exact)}){against_float(found, exact)}.{other_profiles(found, exact)}{rivals(found, exact)}")


def text(rows):
    profiles = sorted({row["profile"] for row in rows if row["renderer"] == "fixcast"} - {"exact", None})
    start = ("Start with `exact`." if profiles else "There is one profile to use, `exact`; no other was measured.")
    drawn = [row for row in bench.ours(rows, size=["64x64", "128x128", "240x240", "320x240"], target=list(bench.TARGETS))
             if bench.wrong(row) is not None]
    broken = sorted({row["scene"] for row in drawn if bench.wrong(row) or row["colour_max"] > 1})
    kept = ("Every frame that it finished here has no wrong id, no wrong shadow and no colour more than one level off."
            if not broken else f"Its promise of exact pictures is BROKEN here on {', '.join(broken)}.")
    return "\n".join([f"{start} {kept}", "", *(line(rows, target) for target in bench.TARGETS)])
