"""The boards that have firmware: how each is compiled, and which of the tools here emulate and flash it."""
import pathlib
import typing

PORTS = pathlib.Path(__file__).resolve().parents[1]
ROOT = PORTS.parents[1]
BUILD = ROOT / "build"


class Failure(Exception):
    """One sentence for the user: what is wrong, where, and what to do."""


class Board(typing.NamedTuple):
    about: str            # a line for the list of boards
    prefix: str           # of the compiler and its tools
    flags: tuple          # of compiler and linker
    emulator: str         # a module here: see emulate.py
    flasher: str          # function of flash.py
    link: tuple = ()      # further ones of the linker; {port} is the port's directory
    tasks: tuple = ()     # modules with finish(elf), which make what the board is fed with from the program (a UF2)
    port: str = ""        # directory of src/port; "": the board's name
    panel: str = ""       # name of the panel's record, where the emulator has to know it


BOARDS = {
    "lm3s6965evb": Board(
        about="TI Stellaris LM3S6965 evaluation board: Cortex-M3, 50 MHz, SSD0323 grey OLED 128x64",
        prefix="arm-none-eabi-",
        flags=("-mcpu=cortex-m3", "-mthumb", "-O2"),
        link=("-nostartfiles", "-T", "{port}/lm3s6965.ld"),
        emulator="qemu", flasher="openocd_lm3s"),
    "pico": Board(
        about="Raspberry Pi Pico: RP2040 (Cortex-M0+), 125 MHz, ST7789 colour TFT 240x240 on SPI0",
        prefix="arm-none-eabi-",
        flags=("-mcpu=cortex-m0plus", "-mthumb", "-O2"),
        link=("-nostartfiles", "-T", "{port}/pico.ld"),
        emulator="rp2040", flasher="uf2_drive", tasks=("uf2",), panel="st7789-240"),
    "pico-135": Board(
        about="the same with a panel of 135x240",
        prefix="arm-none-eabi-", port="pico",
        flags=("-mcpu=cortex-m0plus", "-mthumb", "-O2", "-DPICO_ST7789_135"),
        link=("-nostartfiles", "-T", "{port}/pico.ld"),
        emulator="rp2040", flasher="uf2_drive", tasks=("uf2",), panel="st7789-135"),
}


def listing():
    return "Boards:\n" + "".join(f"  {name:<14}{board.about}\n" for name, board in BOARDS.items())


def find(name):
    if name not in BOARDS:
        raise Failure(f"there is no board {name!r}: say BOARD=NAME with one of {', '.join(BOARDS)}")
    return BOARDS[name]
