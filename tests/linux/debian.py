"""Debian packages of another architecture or release, fetched once into a cache; the machine's own apt is left as it is."""
import io
import pathlib
import re
import subprocess
import tarfile

KEYRING = pathlib.Path("/usr/share/keyrings/debian-archive-keyring.gpg")


class Archive:
    """The archive that the machine's own apt uses, seen as a machine of `architecture` and `release` would see it."""

    def __init__(self, cache, architecture, release):
        self.directory = pathlib.Path(cache).resolve() / f"{release}-{architecture}"
        self.release = release
        self.options = []
        settings = {
            "APT::Architecture": architecture, "APT::Architectures": architecture, "APT::Sandbox::User": "root",
            "Dir::State": self.directory / "state", "Dir::State::status": self.directory / "status",
            "Dir::Cache": self.directory / "cache", "Dir::Etc::SourceList": self.directory / "sources.list",
            "Dir::Etc::SourceParts": "/dev/null", "Acquire::Retries": "3", "Acquire::Languages": "none"}
        for name, value in settings.items():
            self.options += ["-o", f"{name}={value}"]

    def apt(self, program, *arguments):
        run = subprocess.run([program, "-qq", *self.options, *arguments], cwd=self.directory, capture_output=True, text=True)
        if run.returncode != 0:
            raise SystemExit(f"{program} {' '.join(arguments)} for {self.directory.name} failed: {run.stderr.strip()}; is the network there?")
        return run.stdout

    def update(self):
        """The lists of packages, unless they are there."""
        done = self.directory / "updated"
        if done.exists():
            return
        for name in ("state/lists/partial", "cache/archives/partial"):
            (self.directory / name).mkdir(parents=True, exist_ok=True)
        (self.directory / "status").touch()
        own = subprocess.run(["apt-get", "indextargets", "--format", "$(REPO_URI)", "Created-By: Packages"],
                             capture_output=True, text=True, check=True).stdout.split()
        archives = [uri for uri in own if "security" not in uri]
        if not archives:
            raise SystemExit("apt knows no archive: run 'apt-get update' first")
        (self.directory / "sources.list").write_text(f"deb [signed-by={KEYRING}] {archives[0]} {self.release} main\n")
        self.apt("apt-get", "update")
        done.touch()

    def depends(self, package):
        """The first package that this one depends on: what a meta-package stands for."""
        self.update()
        return re.search(r"^Depends: ([^ ,]+)", self.apt("apt-cache", "show", package), re.M)[1]

    def fetch(self, package):
        """The path of the package's file."""
        found = sorted(self.directory.glob(f"{package}_*.deb"))
        if not found:
            self.update()
            self.apt("apt-get", "download", package)
            found = sorted(self.directory.glob(f"{package}_*.deb"))
        return found[-1]


def unpack(package, to, wanted):
    """Writes the files of a package whose path matches `wanted` to `to`, all into that one directory; returns their names."""
    to.mkdir(parents=True, exist_ok=True)
    names = []
    process = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", package], stdout=subprocess.PIPE)
    with tarfile.open(fileobj=io.BufferedReader(process.stdout, 1 << 20), mode="r|") as archive:
        for member in archive:
            if member.isfile() and re.search(wanted, member.name):
                name = pathlib.PurePosixPath(member.name).name
                part = to / (name + ".part")
                part.write_bytes(archive.extractfile(member).read())
                part.chmod(member.mode & 0o777)
                part.rename(to / name)
                names.append(name)
    if process.wait() != 0 or not names:
        raise SystemExit(f"{package}: nothing in it matches {wanted}; is the file whole? Remove it and repeat")
    return names
