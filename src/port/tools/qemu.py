"""Boards that QEMU emulates: runs an image, stops each time that a frame is on the panel, and gives the panel's picture."""
import json
import pathlib
import re
import socket
import subprocess
import tempfile
import time

from boards import Failure, find
from gdb_remote import Remote
from run import execute

TOOL = "qemu-system-arm"

# One instruction lasts 2^5 ns of the chip's time: at 50 MHz 1.6 cycles. Time then depends on the program alone.
ICOUNT = "shift=5"
SECONDS = 60  # for any one answer


class Machine:
    """An emulated board, halted before its first instruction. Use with `with`."""

    def __init__(self, name, image):
        self.place = tempfile.TemporaryDirectory(prefix="fixcast-")
        place = pathlib.Path(self.place.name)
        self.text = place / "serial"
        self.errors = place / "errors"
        marker = re.search(r"^([0-9a-f]+) T fc_firmware_frame_shown$",
                           execute([f"{find(name).prefix}nm", image], f"reading {image}"), re.M)
        if marker is None:
            raise Failure(f"{image} has no function fc_firmware_frame_shown: build it with `make firmware BOARD={name}`")
        with self.errors.open("wb") as errors:
            self.process = subprocess.Popen(
                [TOOL, "-M", name, "-display", "none", "-nic", "none", "-monitor", "none", "-serial",
                 f"file:{self.text}", "-qmp", f"unix:{place}/qmp,server=on,wait=off", "-gdb",
                 f"unix:{place}/gdb,server=on,wait=off", "-S", "-icount", ICOUNT, "-kernel", str(image)],
                stdin=subprocess.DEVNULL, stdout=errors, stderr=errors)
        try:
            self.remote = Remote(self.socket_of(place / "gdb"), SECONDS)
            self.marker = int(marker.group(1), 16)
            self.remote.stop_at(self.marker)
            self.control = socket.socket(socket.AF_UNIX)
            self.control.settimeout(SECONDS)
            self.control.connect(str(self.socket_of(place / "qmp")))
            self.answers = self.control.makefile("r")
            json.loads(self.answers.readline())
            self.tell("qmp_capabilities")
        except (OSError, ConnectionError, ValueError) as problem:
            self.close()
            raise Failure(f"QEMU does not run {image}: {problem}") from None

    def socket_of(self, path):
        for _ in range(500):
            if path.exists():
                return path
            if self.process.poll() is not None:
                break
            time.sleep(0.01)
        raise ConnectionError(self.errors.read_text(errors="replace").strip() or "it does not answer")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.process.kill()
        self.process.wait()
        self.place.cleanup()

    def tell(self, command, **arguments):
        """A command of QEMU's monitor (QMP), and its result."""
        self.control.sendall(json.dumps({"execute": command, "arguments": arguments}).encode() + b"\n")
        while True:
            answer = json.loads(self.answers.readline())
            if "error" in answer:
                raise Failure(f"QEMU refuses {command}: {answer['error'].get('desc')}")
            if "return" in answer:
                return answer["return"]

    def next_frame(self, keys=()):
        """Runs until the next frame (or the bring-up pattern) is on the panel. `keys`: (QEMU's name of the key that stands for a button, whether it
        goes down), for soon after the start of the run. A board that hangs is a Failure."""
        events = [{"type": "key", "data": {"down": down, "key": {"type": "qcode", "data": key}}} for key, down in keys]
        try:
            self.remote.go(lambda: events and self.tell("input-send-event", events=events))
        except socket.timeout:
            raise Failure(f"no frame within {SECONDS} s; the board said:\n{self.printed()}") from None
        except ConnectionError as problem:
            raise Failure(f"{problem}; the board said:\n{self.printed()}") from None

    def listen(self, pattern):
        """Runs without a stop until the board has printed what the regular expression says; its text. From then on there are no stops."""
        self.remote.stop_no_more(self.marker)
        self.remote.send("c")
        for _ in range(20 * SECONDS):
            if re.search(pattern, self.printed(), re.S):
                return self.printed()
            time.sleep(0.05)
        raise Failure(f"the board did not print {pattern!r} within {SECONDS} s, but:\n{self.printed()}")

    def picture(self):
        """(width, height, RGB bytes) of what QEMU shows, as large as it shows it."""
        path = pathlib.Path(self.place.name) / "screen.ppm"
        self.tell("screendump", filename=str(path))
        data = path.read_bytes()
        match = re.match(rb"P6\n(\d+) (\d+)\n255\n", data)
        if match is None:
            raise Failure("QEMU's picture of the panel is no PPM")
        return int(match.group(1)), int(match.group(2)), data[match.end():]

    def printed(self):
        return self.text.read_text(errors="replace").replace("\r", "")


def run(name, image, frames, show):
    """Shows the pattern and `frames` frames: show(number, picture) for each stop, 0 the pattern. The text the board printed."""
    with Machine(name, image) as machine:
        for number in range(frames + 1):
            machine.next_frame()
            show(number, machine.picture)
        return machine.printed()


NOTE = ("QEMU has no cycles: the time in these figures takes each instruction to last 1.6 cycles of 50 MHz, and what is sent to "
        "take no time but the interrupts'.")
