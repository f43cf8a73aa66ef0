"""A board that runs Debian's stock arm64 kernel: the program cross-built for it drives a panel, and its pins are watched from outside.

qemu.py build --work DIR --source ROOT --cli11 DIR --tinyobj DIR     fetches the board's parts and cross-builds the program, once an API
qemu.py test v1|v2 --work DIR --simulator FIXCAST --pins PINS
                                                       boots the board and tries everything; prints what was wrong
"""
import argparse
import concurrent.futures
import pathlib
import random
import re
import shutil
import subprocess
import sys
import zlib

import board
from parts import Parts

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PANEL, SCENE, WIDTH, HEIGHT = "st7789-240", ROOT / "host_sim" / "scenes" / "s1.nff", 240, 240
WIRED = f"--panel {PANEL} --spi /dev/spidev0.0 --dc GPIO25 --reset GPIO27"
BUFSIZ = {"v1": 4096, "v2": 1000}  # spidev's default, and one of the kernel's command line, of which 896 are 7 times 128
TRANSFER = {"v1": 4096, "v2": 896}

INIT = """#!/bin/busybox sh
/bin/busybox --install -s /bin
mount -t proc none /proc
mount -t sysfs none /sys
mount -t devtmpfs none /dev
mount -t debugfs none /sys/kernel/debug
insmod /lib/spi-bitbang.ko
insmod /lib/spi-gpio.ko
chgrp 999 /dev/spidev0.0
chgrp 998 /dev/gpiochip0
chmod 660 /dev/spidev0.0 /dev/gpiochip0
held() { grep -c '|fixcast' /sys/kernel/debug/gpio; }
# A test: what the program says, how it ends, how many lines it has left behind.
try() {
  echo "@begin $1"
  shift
  "$@" 2>&1
  echo "@end $? held $(held)"
}
show() { fixcast show /tmp/scene.nff WIRED "$@"; }
wire() { fixcast show /tmp/scene.nff --panel PANEL --spi "$1" --dc "$2"; }
# Microseconds and a signal: a run that is told to end at that moment. In the foreground: a shell's background programs ignore SIGINT at first.
end_by() {
  rm -f /tmp/pid
  (until [ -s /tmp/pid ]; do usleep 1000; done; usleep $1; kill -$2 $(cat /tmp/pid)) &
  sh -c 'echo $$ >/tmp/pid; exec fixcast show /tmp/scene.nff WIRED' >/tmp/said 2>&1
  code=$?
  wait
  echo "@signal $2 after $1 us: exit $code held $(held)"
}
pull_out() {
  show >/tmp/said 2>&1 &
  sleep 1
  echo spi0.0 >/sys/bus/spi/drivers/spidev/unbind
  wait $!
  code=$?
  cat /tmp/said
  echo spi0.0 >/sys/bus/spi/drivers/spidev/bind
  return $code
}
second() {
  show --frames 1 --keep >/dev/null 2>&1 &
  usleep 200000
  show
  code=$?
  wait $!
  return $code
}
as_user() { su user -s /bin/sh -c "$1"; }
try probe fixcast probe
try frame fixcast show /tmp/scene.nff --panel PANEL --spi /dev/spidev0.0 --dc LABEL:4 --reset LABEL:5 --backlight GPIO18 --frames 1 --crc
try cs wire /dev/spidev0.0 SPI_CE0
try second second
try name wire /dev/spidev0.0 GPIO99
try offset wire /dev/spidev0.0 LABEL:9
try label wire /dev/spidev0.0 pinctrl:4
try device wire /dev/spidev9.9 GPIO25
try null wire /dev/null GPIO25
try user_spi as_user "fixcast show /tmp/scene.nff WIRED"
chmod 666 /dev/spidev0.0
try user_gpio as_user "fixcast show /tmp/scene.nff WIRED"
try gone pull_out
try button show --button reverse=GPIO5 --frames 5 --crc
SIGNALS
echo "@done"
poweroff -f
"""


# ---- build ----

def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{result.stdout[-3000:]}{result.stderr[-3000:]}")
    return result.stdout


def build(work, source, cli11, tinyobj):
    parts = Parts(work)
    parts.zlib()
    parts.libgpiod("v1")
    with concurrent.futures.ThreadPoolExecutor() as meanwhile:  # the kernel is most of what is fetched
        fetched = meanwhile.submit(lambda: (parts.kernel(), parts.busybox()))
        build_programs(parts, work, source, cli11, tinyobj)
        fetched.result()


def build_programs(parts, work, source, cli11, tinyobj):
    headers = work / "headers"  # alone: the directories that have them hold headers of this machine too
    if not (headers / "CLI").exists():
        shutil.copytree(pathlib.Path(cli11) / "CLI", headers / "CLI")
    shutil.copy2(pathlib.Path(tinyobj) / "tiny_obj_loader.h", headers)
    for api in ("v1", "v2"):
        run("cmake", "-S", source, "-B", work / "cross", "--log-level=WARNING", f"-DCMAKE_TOOLCHAIN_FILE={HERE / 'aarch64.cmake'}",
            "-DFIXCAST_ORACLE=OFF", "-DFIXCAST_OPENIMAGEIO=OFF", "-DFIXCAST_SDL2=OFF", "-DFIXCAST_TESTS=OFF", "-DCMAKE_CXX_FLAGS_RELEASE=-O0",
            f"-DFIXCAST_LIBGPIOD={parts.libgpiod(api)}", f"-DCLI11_INCLUDE_DIR={headers}", f"-DTINYOBJLOADER_INCLUDE_DIR={headers}",
            f"-DZLIB_INCLUDE_DIR={parts.zlib()}", f"-DZLIB_LIBRARY={parts.zlib() / 'libz.a'}")
        run("cmake", "--build", work / "cross", "--parallel", "2", "--target", "fixcast_simulator")
        shutil.copy2(work / "cross" / "fixcast", work / f"fixcast-{api}")


# ---- test ----

class Verdict:
    def __init__(self):
        self.checked, self.wrong = 0, []

    def check(self, holds, sentence):
        self.checked += 1
        if not holds:
            self.wrong.append(sentence)


def guest_files(api, parts, work, signals):
    script = INIT.replace("SIGNALS", "\n".join(f"end_by {us} {signal}" for us, signal in signals))
    script = script.replace("WIRED", WIRED).replace("PANEL", PANEL).replace("LABEL", board.LABEL)
    files = {
        "init": script.encode(), "bin/busybox": parts.busybox().read_bytes(), "bin/fixcast": (work / f"fixcast-{api}").read_bytes(),
        "tmp/scene.nff": SCENE.read_bytes(), "etc/passwd": b"root:x:0:0:root:/:/bin/sh\nuser:x:1000:1000:user:/tmp:/bin/sh\n",
        "etc/group": b"root:x:0:\nspi:x:999:\ngpio:x:998:\nuser:x:1000:\n"}
    for module in ("spi-bitbang.ko", "spi-gpio.ko"):
        files[f"lib/{module}"] = (parts.kernel() / module).read_bytes()
    return files


def told(console):
    """{test: (text, exit code, lines held)}"""
    tests = {}
    for match in re.finditer(r"^@begin (\w+)\n(.*?)^@end (\d+) held (\d+)$", "\n".join(console), re.M | re.S):
        tests[match[1]] = (match[2], int(match[3]), int(match[4]))
    return tests


def check_sentences(verdict, tests, api):
    """What the program says, each sentence whole."""
    missing = "there are /dev/spidev0.0"
    free = "GPIO5, GPIO25, GPIO27, GPIO18, GPIO4"
    expected = {
        "cs": (2, "D/C line 'SPI_CE0' (/dev/gpiochip0, offset 2): request: Device or resource busy; it is held by 'spi0 CS0': "
                  "end that, or wire another line"),
        "second": (2, "D/C line 'GPIO25' (/dev/gpiochip0, offset 4): request: Device or resource busy; it is held by 'fixcast': "
                      "end that, or wire another line"),
        "name": (2, f"D/C line 'GPIO99': no line has this name; free are {free}; 'fixcast probe' lists all"),
        "offset": (2, f"D/C line '{board.LABEL}:9': chip '{board.LABEL}' has offsets 0 to 7 only"),
        "label": (2, f"D/C line 'pinctrl:4': no line has this name; free are {free}; 'fixcast probe' lists all"),
        "device": (2, f"/dev/spidev9.9: open: No such file or directory; {missing}"),
        "null": (2, "/dev/null: SPI_IOC_RD_MODE32: Inappropriate ioctl for device; this is no spidev device: 'fixcast probe' lists them"),
        "user_spi": (2, "/dev/spidev0.0: open: Permission denied; members of group 'spi' may open it: "
                        "'sudo usermod -aG spi NAME', then log in again"),
        "user_gpio": (2, "D/C line 'GPIO25': /dev/gpiochip0: open: Permission denied; members of group 'gpio' may open it: "
                         "'sudo usermod -aG gpio NAME', then log in again")}
    for name, (code, sentence) in expected.items():
        text, exit_code, held = tests.get(name, ("", None, None))
        verdict.check(text == f"fixcast: {sentence}\n", f"{name}: said {text!r}, not {sentence!r}")
        verdict.check(exit_code == code and held == 0, f"{name}: exit {exit_code}, {held} lines held")
    text, code, held = tests.get("gone", ("", None, None))
    last = text.splitlines()[-1] if text else ""
    verdict.check(re.fullmatch(r"fixcast: /dev/spidev0\.0: SPI_IOC_MESSAGE of \d+ bytes, after \d+ of \d+: "
                               r"Cannot send after transport endpoint shutdown; "
                               r"the device has gone: is its driver still bound, the overlay still loaded\?", last), f"gone: said {last!r}")
    verdict.check(code == 2 and held == 0, f"gone: exit {code}, {held} lines held")
    text, code, held = tests.get("probe", ("", None, None))
    for line in ("  /dev/spidev0.0  root:spi 0660  you may open it", f"    label '{board.LABEL}', 8 lines",
                 "      2  SPI_CE0              out  held by spi0 CS0", "      4  GPIO25               in   free"):
        verdict.check(line in text.splitlines(), f"probe: no line {line!r} in {text!r}")
    verdict.check(f"libgpiod {'1.6' if api == 'v1' else '2.'}" in text, f"probe: not libgpiod {api}: {text!r}")
    text, code, held = tests.get("frame", ("", None, None))
    verdict.check(code == 0 and held == 0, f"frame: exit {code}, {held} lines held: {text!r}")
    verdict.check(f"on /dev/spidev0.0 in transfers of at most {TRANSFER[api]} bytes\n" in text, f"frame: said {text!r}")


def check_frames(verdict, work, simulator, events):
    """The pixels that came over the wires against the host's."""
    run(simulator, "render", SCENE, "--size", f"{WIDTH}x{HEIGHT}", "--rgb565", work / "host.bin")
    host = (work / "host.bin").read_bytes()
    seen = [(work / f"frame-{event.split()[1]}").read_bytes() for event in events if event.startswith("frame ")]
    verdict.check(len(seen) >= 6, f"{len(seen)} whole frames came over the wires")
    wrong = sum(host[i:i + 2] != seen[0][i:i + 2] for i in range(0, len(host), 2)) if seen else WIDTH * HEIGHT
    verdict.check(wrong == 0 and len(host) == 2 * WIDTH * HEIGHT, f"frame: {wrong} wrong pixels")
    return wrong


def check_button(verdict, text, simulator, work, events):
    """The orbit's steps up to where the button was pressed, then back: in what the program says, and over the wires."""
    dry = run(simulator, "show", SCENE, "--panel", PANEL, "--dry-run", "--crc", "--frames", "4")
    host = re.findall(r"^frame \d+ crc32 (\w+)$", dry, re.M)
    said = re.findall(r"^frame \d+ crc32 (\w+)$", text, re.M)
    steps = [host.index(crc) if crc in host else None for crc in said]
    # Pressed while frame 1 was shown; a button is looked at as a frame begins, and turns the one after that.
    verdict.check(len(set(host)) == 4 and steps in ([0, 1, 2, 1, 0], [0, 1, 2, 3, 2]), f"button: steps {steps} of {host}: {said}")
    wires = [f"{zlib.crc32((work / f'frame-{event.split()[1]}').read_bytes()):08x}" for event in events if event.startswith("frame ")]
    verdict.check(" ".join(said) in " ".join(wires), f"button: frames {said} did not come over the wires: {wires}")


def check_signals(verdict, console, events, signals):
    """Every run that was told to end: lines released; what its panel got is whole and ends with display off, sleep in."""
    ends = re.findall(r"^@signal (\w+) after (\d+) us: exit (\d+) held (\d+)$", "\n".join(console), re.M)
    verdict.check(len(ends) == len(signals), f"{len(ends)} of {len(signals)} runs were told to end")
    started = [end for end in ends if end[2] == "0"]
    for signal, us, code, held in ends:
        verdict.check(held == "0", f"{signal} after {us} us: {held} lines held")
        early = {"INT": "130", "TERM": "143"}[signal]  # before the program has looked: nothing was opened
        verdict.check(code in ("0", early), f"{signal} after {us} us: exit {code}")
    verdict.check(len(started) >= len(ends) * 3 // 4, f"only {len(started)} of {len(ends)} runs had begun")
    states = [event for event in events if event.startswith("state ")][-len(started):]
    for state in states:
        verdict.check(re.match(r"state on=0 awake=0 commands=\d+ last=2810 ", state), f"after a signal: {state}")
    drawing = [state for state in states if not state.endswith("pixels=0")]
    partial = [state for state in drawing if int(state.rpartition("=")[2]) % (WIDTH * HEIGHT) != 0]
    verdict.check(len(partial) >= len(started) // 4, f"only {len(partial)} of {len(started)} signals came in mid-frame")
    return len(ends), len(partial)


def test(api, work, simulator, pins, seed, count):
    parts = Parts(work)
    chance = random.Random(seed)
    signals = [(chance.randrange(20000, 1100000), chance.choice(("INT", "INT", "TERM"))) for _ in range(count)]
    verdict = Verdict()
    place = work / api
    with board.Board(place, parts, guest_files(api, parts, work, signals), PANEL, pins, f"spidev.bufsiz={BUFSIZ[api]}") as machine:
        machine.wait_for(r"^@begin button", 300)
        machine.drive("GPIO5", True)   # released
        machine.wait_for(r"^frame 1 ", 300)
        machine.drive("GPIO5", False)  # pressed
        machine.wait_for(r"^@done", 1200)
        events = machine.finish()
        console = machine.console
    tests = told(console)
    check_sentences(verdict, tests, api)
    wrong_pixels = check_frames(verdict, place, simulator, events)
    check_button(verdict, tests.get("button", ("",))[0], simulator, place, events)
    ended, in_frame = check_signals(verdict, console, events, signals)
    for event in events:
        if event.startswith("wrong "):
            verdict.check(False, f"on the wires: {event[6:]}")
    print(f"libgpiod {api}: {wrong_pixels} wrong pixels of {WIDTH * HEIGHT}; {ended} signals, {in_frame} of them in mid-frame (seed {seed})")
    for sentence in verdict.wrong:
        print(f"WRONG: {sentence}")
    print(f"{verdict.checked} checks, {len(verdict.wrong)} wrong; the board's console: {place / 'console'}")
    return 1 if verdict.wrong else 0


def main():
    parser = argparse.ArgumentParser()
    commands = parser.add_subparsers(dest="command", required=True)
    builder = commands.add_parser("build")
    builder.add_argument("--source", type=pathlib.Path, required=True)
    builder.add_argument("--cli11", required=True)
    builder.add_argument("--tinyobj", required=True)
    tester = commands.add_parser("test")
    tester.add_argument("api", choices=("v1", "v2"))
    tester.add_argument("--simulator", type=pathlib.Path, required=True)
    tester.add_argument("--pins", type=pathlib.Path, required=True, help="the program that pins.c makes")
    tester.add_argument("--seed", type=int, default=7)
    tester.add_argument("--signals", type=int, default=50, help="runs that are told to end; both APIs together: 100")
    for command in (builder, tester):
        command.add_argument("--work", type=pathlib.Path, required=True)
    options = parser.parse_args()
    work = options.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    if options.command == "build":
        build(work, options.source.resolve(), options.cli11, options.tinyobj)
        return 0
    return test(options.api, work, options.simulator.resolve(), options.pins.resolve(), options.seed, options.signals)


sys.exit(main())
