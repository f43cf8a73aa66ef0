"""The file that a Pico takes by USB: an ELF image as UF2, with the CRC of its second boot stage filled in.

uf2.py IMAGE.elf OUT.uf2

UF2: github.com/microsoft/uf2, family RP2040. CRC: RP2040 data sheet 2.8.1.3.1 (polynomial 04c11db7, from ffffffff, not
reflected; CRC-32/MPEG-2).
"""
import pathlib
import struct
import sys

from boards import Failure
from png import write_whole

FLASH, FLASH_END = 0x10000000, 0x11000000
BOOT2_BYTES = 252
BLOCK_DATA = 256  # a flash page: what the boot ROM programs at a time
MAGIC_START, MAGIC_SECOND, MAGIC_END = 0x0A324655, 0x9E5D5157, 0x0AB16F30
FLAG_FAMILY, FAMILY_RP2040 = 0x2000, 0xE48BFF56
ELF_ARM, ELF_LOAD = 40, 1


class BadImage(Exception):
    """What is wrong with the image, where, and what to do."""


def segments(elf):
    """(physical address, offset in the file, bytes there) of what an ELF file for 32-bit Arm puts into memory."""
    if len(elf) < 52 or elf[:6] != b"\x7fELF\x01\x01" or struct.unpack_from("<H", elf, 18)[0] != ELF_ARM:
        raise BadImage("is no 32-bit little-endian Arm ELF file: link it with arm-none-eabi-gcc")
    offset, = struct.unpack_from("<I", elf, 28)
    size, count = struct.unpack_from("<HH", elf, 42)
    for at in range(offset, offset + size * count, size):
        if at + 32 > len(elf):
            raise BadImage("ends within its program headers: link it again")
        kind, start, _, physical, in_file = struct.unpack_from("<5I", elf, at)
        if kind == ELF_LOAD and in_file > 0:
            if start + in_file > len(elf):
                raise BadImage(f"ends within the segment for {physical:#x}: link it again")
            yield physical, start, in_file


def flash_pages(elf):
    """{address: 256 bytes} of the flash, what is not used being ff as in an erased one."""
    pages = {}
    for address, start, size in segments(elf):
        data = elf[start:start + size]
        if not FLASH <= address <= address + len(data) <= FLASH_END:
            raise BadImage(f"puts {len(data)} bytes at {address:#x}, outside flash: the linker script has to give them "
                           "an address of flash to be loaded from")
        for i, byte in enumerate(data):
            page = pages.setdefault((address + i) // BLOCK_DATA * BLOCK_DATA, bytearray(b"\xff" * BLOCK_DATA))
            page[(address + i) % BLOCK_DATA] = byte
    if FLASH not in pages:
        raise BadImage(f"has no second boot stage at {FLASH:#x}: link boot2.S")
    return pages


def crc32_mpeg2(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ 0x04C11DB7 if crc & 0x80000000 else crc << 1) & 0xFFFFFFFF
    return crc


def sealed(elf):
    """The ELF file with that CRC in it, for programmers that take an ELF file, or a HEX file made of it."""
    crc, file = crc32_mpeg2(flash_pages(elf)[FLASH][:BOOT2_BYTES]), bytearray(elf)
    for address, start, size in segments(elf):
        if address <= FLASH and FLASH + BLOCK_DATA <= address + size:
            struct.pack_into("<I", file, start + FLASH - address + BOOT2_BYTES, crc)
            return bytes(file)
    raise BadImage(f"has a second boot stage of fewer than {BLOCK_DATA} bytes at {FLASH:#x}: link boot2.S with its place for a CRC")


def uf2(elf):
    pages = flash_pages(sealed(elf))
    blocks = [struct.pack("<8I476sI", MAGIC_START, MAGIC_SECOND, FLAG_FAMILY, address, BLOCK_DATA, number, len(pages),
                          FAMILY_RP2040, bytes(pages[address]), MAGIC_END)
              for number, address in enumerate(sorted(pages))]
    return b"".join(blocks)


def file_of(elf):
    """Where the UF2 of a program is: beside it."""
    return pathlib.Path(elf).with_suffix(".uf2")


def finish(elf, out=None):
    """Writes the UF2 file of a program."""
    try:
        write_whole(out or file_of(elf), uf2(pathlib.Path(elf).read_bytes()))
    except BadImage as problem:
        raise Failure(f"{elf} {problem}") from None
    except OSError as problem:
        raise Failure(f"{problem.filename}: {problem.strerror}") from None


def main(arguments):
    if len(arguments) != 2:
        sys.exit("usage: uf2.py IMAGE.elf OUT.uf2")
    try:
        finish(*arguments)
    except Failure as failure:
        sys.exit(str(failure))


if __name__ == "__main__":
    main(sys.argv[1:])
