"""What the emulated board is made of: Debian's stock arm64 kernel, busybox, and the libraries that the program is linked with."""
import pathlib

import debian

RELEASE = "bookworm"
LIBGPIOD = {"v1": "bookworm", "v2": "bookworm-backports"}  # 1.6.3 and 2.1.3


class Parts:
    """Paths in `work`; a part is fetched when it is first asked for."""

    def __init__(self, work):
        self.work = pathlib.Path(work).resolve()
        self.cache = self.work / "packages"

    def archive(self, release=RELEASE):
        return debian.Archive(self.cache, "arm64", release)

    def once(self, name, make):
        """The directory `name`, made by make(directory) unless that has been done."""
        directory, done = self.work / name, self.work / f"{name}.done"
        if not done.exists():
            make(directory)
            done.touch()
        return directory

    def kernel(self):
        """A directory with vmlinuz-* and the modules of the bit-banged SPI bus."""
        def make(directory):
            archive = self.archive()
            image = archive.depends("linux-image-arm64")
            debian.unpack(archive.fetch(image), directory, r"/boot/vmlinuz-|/(spi-gpio|spi-bitbang)\.ko(\.xz)?$")
        return self.once("kernel", make)

    def busybox(self):
        def make(directory):
            debian.unpack(self.archive().fetch("busybox-static"), directory, r"/bin/busybox$")
        return self.once("busybox", make) / "busybox"

    def libgpiod(self, api):
        """A directory with include and lib, of API v1 or v2."""
        def make(directory):
            file = self.archive(LIBGPIOD[api]).fetch("libgpiod-dev")
            debian.unpack(file, directory / "include", r"/include/gpiod\.h$")
            debian.unpack(file, directory / "lib", r"/libgpiod\.a$")
        return self.once(f"libgpiod-{api}", make)

    def zlib(self):
        """A directory with zlib's headers and library."""
        def make(directory):
            debian.unpack(self.archive().fetch("zlib1g-dev"), directory, r"/include/.*(zlib|zconf)\.h$|/libz\.a$")
        return self.once("zlib", make)
