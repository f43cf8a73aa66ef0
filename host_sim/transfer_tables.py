"""Writes src/core/srgb.c and src/core/gamma22.c: the light at which a display's level changes, for 31, 63 and 255 levels."""
import decimal
import pathlib

decimal.getcontext().prec = 40
D = decimal.Decimal


def srgb(value):
    """IEC 61966-2-1: a signal 0..1 as light."""
    return value / D("12.92") if value <= D("0.04045") else ((value + D("0.055")) / D("1.055")) ** D("2.4")


def gamma22(value):
    return value ** D("2.2")


def thresholds(decode, most):
    """Level k shows from the light of signal (k - 1/2) / most on; Q24, rounded up."""
    return [int((decode((D(k) - D("0.5")) / most) * 2**24).to_integral_value(decimal.ROUND_CEILING)) for k in range(1, most + 1)]


def table(name, values):
    rows = [", ".join(f"{v}" for v in values[i:i + 12]) for i in range(0, len(values), 12)]
    return f"static const uint32_t {name}[] FC_ROM = {{\n    " + ",\n    ".join(rows) + "};\n"


def write(path, name, what, decode):
    text = f"/* {what}: made by host_sim/transfer_tables.py. */\n#include \"fixcast/transfer.h\"\n\n#include \"fixcast/config.h\"\n\n"
    for most in (31, 63, 255):
        text += table(f"level{most}", thresholds(decode, most)) + "\n"
    path.write_text(text + f"const fc_transfer {name} FC_ROM = {{level31, level63, level255}};\n")


if __name__ == "__main__":
    core = pathlib.Path(__file__).resolve().parent.parent / "src" / "core"
    write(core / "srgb.c", "fc_transfer_srgb", "The sRGB transfer function", srgb)
    write(core / "gamma22.c", "fc_transfer_gamma22", "A display of gamma 2.2", gamma22)
