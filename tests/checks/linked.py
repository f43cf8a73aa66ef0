"""What an image links of the units that only those pay for who name them: volume tests, rotations, layers of materials, skies, transfer functions,
samples and lenses, kinds of shape.

linked.py --nm NM ARCHIVE SPHERE_ONLY EVERY_UNIT
  ARCHIVE      the library
  SPHERE_ONLY  an image whose scene has spheres only: none of those units' functions may be in it
  EVERY_UNIT   an image that uses every unit: each must be in it, or the list below is not the library's
"""
import re
import subprocess
import sys

from support import Report

UNITS = re.compile(r"(volume(_\w+)?|coat(_\w+)?|rotation|rotate|sine|trackball|reflect|extra_\w+|phong|mirror|emission|smooth|vertex|texture(_\w+)?|"
                   r"mapping_\w+|sky|srgb|gamma22|sample(_\w+)?|lens_\w+|triangle_short|outline)\.")
KINDS = {"fc_kind_plane", "fc_kind_triangle", "fc_kind_triangle_short", "fc_kind_convex"}


def external(nm, *options):
    """(object file or "", name) of every function or table that has external linkage and is defined."""
    lines = subprocess.run([nm, "-A", "-P", "-g", *options], check=True, capture_output=True, text=True).stdout.splitlines()
    for line in lines:
        where, name, kind = line.split()[:3]
        if kind not in "Uwv":
            member = re.search(r"\[([^\]]+)\]:?$", where)
            yield (member.group(1) if member else ""), name


def main(arguments):
    _, nm, archive, sphere_only, every_unit = arguments
    report = Report()
    units = {}
    for member, name in external(nm, archive):
        if UNITS.match(member):
            units.setdefault(member, set()).add(name)
    report.check(len(units) >= 28, f"{archive} has only {len(units)} of the units")
    small = {name for _, name in external(nm, sphere_only)}
    large = {name for _, name in external(nm, every_unit)}
    report.check("fc_kind_sphere" in small and "fc_render_rows_in" in small, f"{sphere_only} is not the image that was meant")
    report.check(not KINDS & small, f"a scene of spheres links {', '.join(KINDS & small)}")
    for member, names in sorted(units.items()):
        report.check(not names & small, f"a scene of spheres links {', '.join(sorted(names & small))} of {member}")
        report.check(names & large, f"no function of {member} is in {every_unit}: it must use each unit")
    return report.finish()


sys.exit(main(sys.argv[1:]))
