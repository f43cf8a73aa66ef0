"""What `make bench` measures: which renderers draw which scenes on which chips."""
from images import Image

PROFILES = ("exact", "fast", "half", "interlaced")  # by number: fc_profile

CHIPS = ("m0plus", "m3", "m4", "m4f", "rv32")
SPHERES = ("s5s1", "s5s8", "s5s64", "s5s512")
LIT_FIELDS = ("s5t5", "s5t10", "s5t21", "s5t45")
FLAT_FIELDS = ("s5f5", "s5f10", "s5f21", "s5f45")
CULLED_FIELDS = ("s5c10", "s5c45")
LAYERED = ("s1p", "s1rt", "balls", "balls_smooth", "s3")  # with S1 and S1r: pairs with and without a layer
SIZES = ((64, 64), (240, 240), (320, 240))


def plan():
    """All images, those first that are looked at most."""
    square = (128, 128)

    def each(scenes, chips, renderers, sizes=(square,), opts=("-O2",), profiles=("exact",)):
        return [Image(chip, renderer, scene, *size, opt, PROFILES.index(profile)) for scene in scenes for size in sizes
                for chip in chips for opt in opts for renderer in renderers for profile in profiles]

    todo = each(("s1", "s1r"), CHIPS, ("fixcast", "float", "double", "q16"))
    todo += each(("s1", "s1r"), ("m4f",), ("scan_float",))
    todo += each(("s1", "s1r", "s2", "s4"), CHIPS, ("fixcast",), profiles=PROFILES[1:])
    todo += each(("s1",), ("rp2040",), ("fixcast",), ((240, 240),), profiles=PROFILES[1:])
    todo += each(("s5s64",), ("m0plus", "m3"), ("fixcast",), profiles=PROFILES[1:])
    todo += each(("s1",), CHIPS, ("fixcast",), opts=("-Os", "-O3"))
    todo += each(("s1",), ("m0plus", "m3"), ("fixcast-rays",))
    todo += each(("s1b",), CHIPS, ("fixcast",))
    todo += each(LAYERED, ("m0plus", "m3"), ("fixcast",))
    todo += each(("s2",), CHIPS, ("fixcast", "float", "double", "fixed"))
    todo += each(("s4",), CHIPS, ("fixcast",))
    todo += each(SPHERES, CHIPS, ("fixcast",))
    todo += each(SPHERES, ("m0plus", "m3", "m4f"), ("float",)) + each(SPHERES, ("m0plus", "m3"), ("q16",))
    todo += each(SPHERES, ("m4f",), ("scan_float",))
    todo += each(LIT_FIELDS + FLAT_FIELDS + CULLED_FIELDS, ("m0plus", "m3"), ("fixcast",))
    todo += each(FLAT_FIELDS, ("m0plus", "m3"), ("fixed",)) + each(FLAT_FIELDS, ("m4f",), ("fixcast", "float"))
    todo += each(("s1", "s1r", "s2", "s4", "s5s8", "s5t10"), ("m0plus", "m3"), ("fixcast",), SIZES)
    todo += each(("s1", "s1r", "s2", "s4"), ("rp2040",), ("fixcast",), ((240, 240),))
    todo += each(("s1",), ("rp2040",), ("fixcast", "q16", "float"))
    todo += each(("s2",), ("rp2040",), ("fixcast", "fixed"))
    return todo
