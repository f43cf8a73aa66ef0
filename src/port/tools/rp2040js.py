"""The RP2040 emulator rp2040js, which npm installs."""
import pathlib
import shutil
import tempfile

from run import execute

PACKAGE = "rp2040js@1.4.1"


def installed(place):
    """The directory `place` with the emulator in its node_modules, installed there once; several may ask at the same time."""
    place = pathlib.Path(place)
    if not (place / "node_modules/rp2040js/package.json").exists():
        place.parent.mkdir(parents=True, exist_ok=True)
        fresh = pathlib.Path(tempfile.mkdtemp(prefix="node-", dir=place.parent))
        try:
            execute(["npm", "install", "--prefix", fresh, "--no-audit", "--no-fund", "--ignore-scripts", PACKAGE],
                    "installing the RP2040 emulator")
            fresh.rename(place)
        except OSError:
            if not (place / "node_modules/rp2040js/package.json").exists():  # nobody was faster
                raise
        finally:
            shutil.rmtree(fresh, ignore_errors=True)
    return place
