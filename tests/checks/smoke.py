"""Each command of the simulator once, on a small frame: for builds that are slow because they watch memory.

smoke.py SIMULATOR
"""
import pathlib
import subprocess
import sys
import tempfile

from support import GOLDEN, SCENES, Report, fixcast_json, read_golden


def main(simulator):
    report = Report()
    scene = SCENES / "s1.nff"
    compared = fixcast_json(simulator, "compare", scene, "--size", "64x48")
    report.equal("CRC of s1 64x48", read_golden(GOLDEN)["s1", "64x48"], compared["crc32"])
    report.equal("wrong_id", 0, compared["wrong_id"])
    report.equal("wrong_shadow", 0, compared["wrong_shadow"])
    for other in ("box", "flake", "s1r"):
        fixcast_json(simulator, "compare", SCENES / f"{other}.nff", "--size", "24x24")
    picked = fixcast_json(simulator, "pick", scene, 64, 120)
    report.equal("object at 64 120", 4, picked["id"])

    with tempfile.TemporaryDirectory() as directory:
        frame, depth, code = (pathlib.Path(directory, name) for name in ("frame.ppm", "depth.pgm", "scene.c"))
        fixcast_json(simulator, "render", scene, "--size", "64x48", "-o", frame, "--depth", depth)
        report.equal("frame.ppm", b"P6\n64 48\n255\n", frame.read_bytes()[:13])
        report.equal("size of frame.ppm", 13 + 64 * 48 * 3, frame.stat().st_size)
        report.equal("depth.pgm", b"P5\n64 48\n65535\n", depth.read_bytes()[:15])
        report.equal("size of depth.pgm", 15 + 64 * 48 * 2, depth.stat().st_size)
        subprocess.run([simulator, "bake", str(scene), "-o", str(code)], check=True, stdout=subprocess.DEVNULL)
        report.check("s1_camera" in code.read_text(), "scene.c names no s1_camera")

        # A PNG, or in a build without OpenImageIO a PPM and a word about it.
        run = subprocess.run([simulator, "render", str(scene), "-o", f"{directory}/picture.png"],
                             capture_output=True, text=True, check=True)
        written = sorted(path.name for path in pathlib.Path(directory).glob("picture.*"))
        if written == ["picture.png"]:
            start = pathlib.Path(directory, "picture.png").read_bytes()[:8]
            report.equal("picture.png", b"\x89PNG\r\n\x1a\n", start)
        else:
            report.equal("pictures", ["picture.ppm"], written)
            report.check("without OpenImageIO" in run.stderr, "did not say why there is no PNG")
    return report.finish()


sys.exit(main(sys.argv[1]))
