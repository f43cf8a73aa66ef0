"""A release of the last commit: one tarball with the sources, baked scenes, firmware images, the single header, and the Arduino library.

dist.py --baked DIR [--boards NAME,...] OUT     `make dist` calls it; DIR holds the scenes that `fixcast bake` made of this tree

OUT gets fixcast-VERSION.tar.gz, what it holds besides sources (to fetch one by one), and SHA256SUMS of all. The same commit gives the
same bytes wherever it is built: names in order, times of the commit, no owner, no path of the machine.
"""
import argparse
import gzip
import hashlib
import io
import pathlib
import subprocess
import sys
import tarfile

import arduino
from amalgamate import Amalgamation
from tree import ROOT, Failure, version, write_whole
from zip_file import zip_of

import boards
import build
import run
import uf2


def git(*arguments):
    code, output = run.attempt(["git", "-C", ROOT, *arguments])
    if code != 0:
        raise Failure(f"a release is made of a git checkout; git {arguments[0]} says: {output.strip()}")
    return output


def commit_time():
    """Seconds since 1970 of the last commit: the one clock of a release (SOURCE_DATE_EPOCH)."""
    return int(git("log", "-1", "--format=%ct"))


def sources():
    """{path: (bytes, is it to run)} of the last commit, which has to be what stands in the tree."""
    changed = git("status", "--porcelain").splitlines()
    if changed:
        raise Failure(f"a release is made of a commit, and {len(changed)} files differ from the last one, first '{changed[0]}': commit, then "
                      "repeat")
    archive = subprocess.run(["git", "-C", ROOT, "archive", "--format=tar", "HEAD"], stdout=subprocess.PIPE, check=True).stdout
    with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
        return {entry.name: (tar.extractfile(entry).read(), bool(entry.mode & 0o100)) for entry in tar if entry.isfile()}


def firmware(name):
    """{file name: bytes} of a board's images: ELF, HEX, and UF2 where the board takes it."""
    elf = build.build(name)
    what, prefix = f"the release's firmware of {name}", boards.find(name).prefix
    slim, text = elf.with_name("release.elf"), elf.with_name("release.hex")
    run.execute([f"{prefix}objcopy", "--strip-debug", elf, slim], what)
    if "uf2" in boards.find(name).tasks:
        write_whole(slim, uf2.sealed(slim.read_bytes()))
    run.execute([f"{prefix}objcopy", "-O", "ihex", slim, text], what)
    images = {f"firmware/{name}.elf": slim.read_bytes(), f"firmware/{name}.hex": text.read_bytes()}
    if "uf2" in boards.find(name).tasks:
        images[f"firmware/{name}.uf2"] = uf2.file_of(elf).read_bytes()
    return images


def made(baked, names):
    """{path: bytes} of what is made from the sources."""
    scenes = sorted(pathlib.Path(baked).glob("*.c"))
    if not scenes:
        raise Failure(f"{baked} holds no baked scenes: the CMake target baked_scenes makes them")
    parts = {f"scenes/{path.name}": path.read_bytes() for path in scenes}
    parts["fixcast/fixcast.h"] = Amalgamation().text().encode()
    parts[f"fixcast-arduino-{version()}.zip"] = zip_of(arduino.files(pathlib.Path(baked) / "s1.c"))
    for name in names:
        parts.update(firmware(name))
    return parts


def sums(parts):
    """What `sha256sum --check` reads."""
    return "".join(f"{hashlib.sha256(parts[path]).hexdigest()}  {path}\n" for path in sorted(parts)).encode()


def tarball(top, files, seconds):
    """The bytes of a .tar.gz with {path: (bytes, is it to run)} below `top`."""
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for path in sorted(files):
            data, runs = files[path]
            entry = tarfile.TarInfo(f"{top}/{path}")
            entry.size, entry.mtime, entry.mode = len(data), seconds, 0o755 if runs else 0o644
            tar.addfile(entry, io.BytesIO(data))
    packed = io.BytesIO()
    with gzip.GzipFile(filename="", mode="wb", fileobj=packed, mtime=0, compresslevel=9) as stream:
        stream.write(plain.getvalue())
    return packed.getvalue()


def release(baked, names, out):
    top, files = f"fixcast-{version()}", sources()
    parts = made(baked, names)
    listed = {**parts, "SHA256SUMS": sums(parts)}
    files.update({f"release/{path}": (data, False) for path, data in listed.items()})
    parts[f"{top}.tar.gz"] = tarball(top, files, commit_time())
    parts["SHA256SUMS"] = sums(parts)
    for path, data in parts.items():
        write_whole(pathlib.Path(out) / path, data)
    return parts


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--baked", required=True, metavar="DIR")
    parser.add_argument("--boards", default=",".join(boards.BOARDS), metavar="NAME,...")
    parser.add_argument("out", metavar="OUT")
    options = parser.parse_args(arguments)
    try:
        parts = release(options.baked, options.boards.split(","), options.out)
    except Failure as failure:
        sys.exit(f"dist: {failure}")
    except OSError as problem:
        sys.exit(f"dist: {problem.filename}: {problem.strerror}")
    for path in sorted(parts):
        print(f"{len(parts[path]):>9} {pathlib.Path(options.out) / path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
