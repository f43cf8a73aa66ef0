"""A release, made twice in different places from a copy of this tree: the same bytes, complete, and good to build from.

release.py --work DIR --baked DIR
"""
import argparse
import hashlib
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tarfile

HERE = pathlib.Path(__file__).resolve().parent
for place in ("checks", "consumers"):
    sys.path.insert(0, str(HERE.parent / place))

from project import Failure, Project, execute, readme_block  # noqa: E402
from support import ROOT, Report  # noqa: E402

BOARDS = "pico,lm3s6965evb"
LEFT_OUT = "tests/fuzz/corpus/"  # thousands of files that change nothing here
WHO = {"GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@example.invalid", "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@example.invalid",
       "GIT_AUTHOR_DATE": "1700000000 +0000", "GIT_COMMITTER_DATE": "1700000000 +0000", "GIT_CONFIG_GLOBAL": os.devnull}


def copy_tree(place):
    """What git would take of this tree, as one commit in a repository of its own."""
    names = execute(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]).split("\0")
    for name in names:
        if name and not name.startswith(LEFT_OUT) and (ROOT / name).is_file():
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, place / name)
    for command in (["init", "-q"], ["add", "-A"], ["commit", "-q", "-m", "copy"]):
        execute(["git", *command], cwd=place, env={**os.environ, **WHO})


def release(place, baked, zone):
    execute([sys.executable, place / "src/dist/dist.py", "--baked", baked, "--boards", BOARDS, place / "build/dist"],
            env={**os.environ, **WHO, "TZ": zone, "PYTHONDONTWRITEBYTECODE": "1"})
    return place / "build/dist"


def contents(place):
    return {str(path.relative_to(place)): path.read_bytes() for path in sorted(place.rglob("*")) if path.is_file()}


def hex_bytes(text):
    """{address: byte} of an Intel HEX file."""
    memory, base = {}, 0
    for line in text.split():
        record = bytes.fromhex(line[1:])
        if sum(record) & 255:
            raise Failure(f"HEX record with a wrong sum: {line}")
        count, address, kind, data = record[0], int.from_bytes(record[1:3], "big"), record[3], record[4:-1]
        if kind == 4:
            base = int.from_bytes(data, "big") << 16
        elif kind == 2:
            base = int.from_bytes(data, "big") << 4
        elif kind == 0:
            memory.update({base + address + i: data[i] for i in range(count)})
    return memory


def uf2_bytes(image):
    """{address: byte} of a UF2 file."""
    memory = {}
    for at in range(0, len(image), 512):
        address, size = struct.unpack_from("<II", image, at + 12)
        memory.update({address + i: image[at + 32 + i] for i in range(size)})
    return memory


def check_tarball(report, out, files):
    names = [name for name in files if name.endswith(".tar.gz")]
    report.equal("tarballs", 1, len(names))
    with tarfile.open(out / names[0]) as tar:
        entries = tar.getmembers()
        held = {entry.name.split("/", 1)[1]: tar.extractfile(entry).read() for entry in entries}
    report.equal("order of the tarball", sorted(entry.name for entry in entries), [entry.name for entry in entries])
    report.equal("owners and times", {(0, 0, "", "", 1700000000)},
                 {(entry.uid, entry.gid, entry.uname, entry.gname, entry.mtime) for entry in entries})
    report.equal("scripts that can be run", True, next(entry.mode for entry in entries if entry.name.endswith(".ci/install")) == 0o755)
    for path, data in files.items():
        if path not in names and path != "SHA256SUMS":
            report.check(held.get(f"release/{path}") == data, f"the tarball has not the same {path}")
    for path in (ROOT / "src/core").iterdir():
        report.check(held.get(f"src/core/{path.name}") == path.read_bytes(), f"the tarball lacks src/core/{path.name}")
    for line in files["SHA256SUMS"].decode().splitlines():
        digest, path = line.split("  ")
        report.equal(f"SHA-256 of {path}", hashlib.sha256(files[path]).hexdigest(), digest)
    report.equal("files without a sum", {"SHA256SUMS"}, set(files) - {line.split("  ")[1] for line in files["SHA256SUMS"].decode().splitlines()})
    return out / names[0]


def check_images(report, files):
    pico = hex_bytes(files["firmware/pico.hex"].decode())
    flashed = uf2_bytes(files["firmware/pico.uf2"])
    report.equal("bytes of pico.hex that pico.uf2 has otherwise", [], [hex(at) for at in pico if flashed.get(at) != pico[at]][:4])
    report.equal("bytes of pico.uf2 that pico.hex lacks", set(), {byte for at, byte in flashed.items() if at not in pico} - {255})
    for name in BOARDS.split(","):
        report.equal(f"{name}.elf", b"\x7fELF", files[f"firmware/{name}.elf"][:4])
        report.check(len(hex_bytes(files[f"firmware/{name}.hex"].decode())) > 10000, f"{name}.hex is almost empty")


def check_builds(work, archive):
    """From what was unpacked: README's first way, and the single header with a scene of the release."""
    place = work / "unpacked"
    shutil.rmtree(place, ignore_errors=True)
    with tarfile.open(archive) as tar:
        tar.extractall(place)
    tree = next(place.iterdir())
    project = Project(work / "from_tarball")
    (project.place / "fixcast").symlink_to(tree)
    (project.place / "CMakeLists.txt").write_text(readme_block("CMakeLists.txt: add_subdirectory"))
    project.cmake()
    project.expect("128x128", "build/spheres")
    single = Project(work / "from_header", HERE.parent / "golden/frame_crc.c", tree / "release/scenes/s1.c")
    single.copy(tree / "release/fixcast/fixcast.h", "fixcast/fixcast.h")
    single.shell('printf \'#define FIXCAST_IMPLEMENTATION\\n#include "fixcast/fixcast.h"\\n\' >fixcast.c\n'
                 "cc -std=c99 -O1 -I. -DSCENE=s1 -DWIDTH=128 -DHEIGHT=128 frame_crc.c s1.c fixcast.c -o frame")
    single.expect("128x128", "./frame")


def check_refusal(report, place, baked):
    """A tree that differs from its commit makes no release, and leaves the last one as it is."""
    before = contents(place / "build/dist")
    (place / "src/core/depth.c").open("a").write("\n")
    run = subprocess.run([sys.executable, place / "src/dist/dist.py", "--baked", baked, place / "build/dist"], capture_output=True, text=True)
    report.check(run.returncode == 1 and "src/core/depth.c" in run.stderr and "Traceback" not in run.stderr,
                 f"a changed tree should be refused in a sentence: {run.returncode} {run.stderr}")
    report.equal("the release after a refusal", True, contents(place / "build/dist") == before)


def check(report, work, baked):
    places = [work / "a", work / "somewhere/else"]
    outs = []
    for place, zone in zip(places, ("UTC", "Asia/Tokyo")):
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        copy_tree(place)
        outs.append(release(place, baked, zone))
    one, two = map(contents, outs)
    report.equal("names of both releases", sorted(one), sorted(two))
    for path in one:
        report.check(one[path] == two.get(path), f"{path} differs between two builds of one commit")
        report.check(str(work).encode() not in one[path], f"{path} knows where it was built")
    archive = check_tarball(report, outs[0], one)
    check_images(report, one)
    check_builds(work, archive)
    check_refusal(report, places[0], baked)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", required=True, metavar="DIR")
    parser.add_argument("--baked", required=True, metavar="DIR")
    options = parser.parse_args()
    work = pathlib.Path(options.work).resolve()
    work.mkdir(parents=True, exist_ok=True)
    report = Report()
    try:
        check(report, work, pathlib.Path(options.baked).resolve())
    except Failure as failure:
        report.check(False, str(failure))
    return report.finish()


sys.exit(main())
