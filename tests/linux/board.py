"""The emulated board: QEMU's arm64 machine with a bit-banged SPI bus on the lines of its PL061, its pins traced from outside."""
import fcntl
import gzip
import os
import pathlib
import queue
import re
import socket
import subprocess
import threading
import time

LINES = ("SPI_SCLK", "SPI_MOSI", "SPI_CE0", "GPIO5", "GPIO25", "GPIO27", "GPIO18", "GPIO4")  # by offset
GPIO, SPI = "/pl061@9030000", "/spi"
LABEL = "9030000.pl061"


def line(name):
    return LINES.index(name)


def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if result.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))} failed: {result.stderr.strip()}")
    return result.stdout


def device_tree(path):
    """The machine's own device tree, with names for the lines and an SPI bus on three of them."""
    run("qemu-system-aarch64", "-M", f"virt,dumpdtb={path}", "-cpu", "cortex-a53", "-nic", "none", "-display", "none")
    gpio = run("fdtget", "-t", "x", path, GPIO, "phandle").strip()
    run("fdtput", "-r", path, "/gpio-keys")  # a power button on line 3
    run("fdtput", "-t", "s", path, GPIO, "gpio-line-names", *LINES)
    device = SPI + "/display@0"
    run("fdtput", "-c", path, SPI, device)
    for node, name, kind, *values in (
            (SPI, "compatible", "s", "spi-gpio"), (SPI, "#address-cells", "x", "1"), (SPI, "#size-cells", "x", "0"),
            (SPI, "num-chipselects", "x", "1"), (SPI, "sck-gpios", "x", gpio, line("SPI_SCLK"), 0),
            (SPI, "mosi-gpios", "x", gpio, line("SPI_MOSI"), 0), (SPI, "cs-gpios", "x", gpio, line("SPI_CE0"), 1),
            (device, "compatible", "s", "rohm,dh2228fv"), (device, "reg", "x", "0"), (device, "spi-max-frequency", "x", "989680")):
        run("fdtput", "-t", kind, path, node, name, *values)


def initrd(path, files):
    """A cpio archive (format newc) of {name: bytes}, all executable, with the directories that they need."""
    out = bytearray()
    number = 0

    def add(name, mode, data=b""):
        nonlocal number
        number += 1
        fields = (number, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(name) + 1, 0)
        out.extend(b"070701" + b"".join(b"%08X" % field for field in fields) + name.encode() + b"\0")
        out.extend(b"\0" * (-len(out) % 4))
        out.extend(data)
        out.extend(b"\0" * (-len(out) % 4))

    directories = {"bin", "dev", "etc", "lib", "proc", "sys", "tmp"}
    for name in sorted(directories):
        add(name, 0o040755)
    for name, data in files.items():
        add(name, 0o100755, data)
    add("TRAILER!!!", 0)
    path.write_bytes(gzip.compress(bytes(out), 1))


class Board:
    """A board that boots and runs /init; `with` ends it."""

    def __init__(self, work, parts, files, panel, pins, kernel_arguments=""):
        self.work = pathlib.Path(work)
        self.work.mkdir(parents=True, exist_ok=True)
        for old in self.work.glob("frame-*"):
            old.unlink()
        tree, ram_disk, trace = self.work / "board.dtb", self.work / "initrd.gz", self.work / "trace"
        qtest = self.work / "qtest"
        device_tree(tree)
        initrd(ram_disk, files)
        for name in (trace, qtest):
            name.unlink(missing_ok=True)
        os.mkfifo(trace)
        wires = [str(line(name)) for name in ("SPI_SCLK", "SPI_MOSI", "SPI_CE0", "GPIO25", "GPIO27", "GPIO18")]
        with open(trace, "rb+", buffering=0) as opened:  # so that neither end waits for the other
            fcntl.fcntl(opened, fcntl.F_SETPIPE_SZ, 1 << 20)
            self.events = open(self.work / "events", "w+")
            with open(trace, "rb") as read_end:
                self.pins = subprocess.Popen([pins, panel, *wires, self.work], stdin=read_end, stdout=self.events)
            server = socket.socket(socket.AF_UNIX)
            server.bind(os.path.relpath(qtest))
            server.listen(1)
            self.qemu = subprocess.Popen(
                ["qemu-system-aarch64", "-M", "virt", "-cpu", "cortex-a53", "-accel", "tcg", "-m", "256", "-display", "none", "-monitor", "none",
                 "-serial", "stdio", "-nic", "none", "-no-reboot", "-dtb", tree, "-kernel", next(parts.kernel().glob("vmlinuz-*")),
                 "-initrd", ram_disk, "-append", f"console=ttyAMA0 quiet loglevel=1 panic=-1 {kernel_arguments}",
                 "-qtest", f"unix:{os.path.relpath(qtest)}", "-qtest-log", "none", "-msg", "timestamp=on",
                 "-trace", "pl061_set_output", "-D", trace],
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=open(self.work / "qemu.log", "wb"), text=True, errors="replace")
            server.settimeout(30)
            self.control, _ = server.accept()
            server.close()
        self.console = []  # lines so far
        self.queue = queue.Queue()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        for text in self.qemu.stdout:
            self.queue.put(text.rstrip("\r\n"))
        self.queue.put(None)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in (self.qemu, self.pins):
            if process.poll() is None:
                process.kill()
            process.wait()
        self.control.close()
        self.events.close()
        (self.work / "console").write_text("\n".join(self.console) + "\n")

    def wait_for(self, pattern, seconds=60):
        """The match of the next console line that has the pattern."""
        end = time.monotonic() + seconds
        while True:
            try:
                text = self.queue.get(timeout=max(0.01, end - time.monotonic()))
            except queue.Empty:
                text = None
            if text is None:
                log = (self.work / "qemu.log").read_text(errors="replace")[-500:]
                raise SystemExit(f"the board never said {pattern!r} (within {seconds} s); its last words: {self.console[-8:]} {log}")
            self.console.append(text)
            match = re.search(pattern, text)
            if match:
                return match

    def drive(self, name, high):
        """Sets an input line from outside."""
        self.control.sendall(f"set_irq_in {self.gpio()} unnamed-gpio-in {line(name)} {int(high)}\n".encode())
        answer = self.control.recv(200)
        if not answer.startswith(b"OK"):
            raise SystemExit(f"QEMU did not drive line {name}: {answer}")

    def gpio(self):
        """QEMU's name of the PL061, as its trace has told it."""
        return re.search(r"^device (\S+)$", (self.work / "events").read_text(), re.M)[1]

    def finish(self, seconds=60):
        """Until the board has switched itself off; returns the lines that its pins have told."""
        end = time.monotonic() + seconds
        while True:
            text = self.queue.get(timeout=max(0.01, end - time.monotonic()))
            if text is None:
                break
            self.console.append(text)
        self.qemu.wait(timeout=10)
        self.pins.wait(timeout=60)
        self.events.seek(0)
        return self.events.read().splitlines()
