"""Which stage of drawing a function of the core belongs to.

By the function's name where bench.json has it, else by its file alone. What the compiler inlines counts where it went.
"""
import collections
import re

STAGES = ("set-up", "silhouette, spans", "depth", "light", "shadows", "colour", "long arithmetic", "exact fallback")
# The first that is found in file:function. Set-up is a region of its own and not looked up.
RULES = (
    ("shadows", r"^(triangle_shadow|bvh\w*|search)\.c|shadow|occlu|between|blocked|ahead|wants_light"
                r"|planar\.c:(fc_planar_ask|cast\w*|fc_ball_to_plane)"),
    ("light", r"^(planar|shade)\.c|scan_sphere\.c:(facing|shade|set_light|refined)|averted"),
    ("depth", r"^depth\.c|coder|facet_depth|affine|code_|start_depth|scan_far"),
    ("colour", r"^pixel\.c|tint|unlit|fill|lit$|clear|levels|:put|:fetch|:finish"),
    ("exact fallback", r"^(rays?|root|wide|segment|sphere|triangle|plane)\.c|slowly|exact|meet|surface_at"),
    ("long arithmetic", r"^(num|i128|quick|libgcc|libc|libm)\b"),
)


def stage_of(name):
    for stage, rule in RULES:
        if re.search(rule, name):
            return stage
    return "silhouette, spans"


def by_stage(row):
    """{stage: instructions a pixel}"""
    found = row.get("functions") or row["stages"]
    sums = collections.Counter({"set-up": sum(found.get("setup", {}).values())})
    for name, share in found.get("strips", {}).items():
        sums[stage_of(name)] += share
    return {stage: sums[stage] for stage in STAGES}
