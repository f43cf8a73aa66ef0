"""How wrong a renderer's picture is: its frame, drawn on the host, against the exact oracle of the simulator."""
import hashlib
import json
import pathlib
import tempfile

from images import execute

KEYS = ("wrong_id", "wrong_shadow", "colour_rmse", "colour_max")


def exact(errors):
    """What the exact profile promises."""
    return errors["wrong_id"] == 0 and errors["wrong_shadow"] == 0 and errors["colour_max"] <= 1


def measure(workshop, image):
    """{key: figure}. The oracle's verdict on a frame is kept by content: the same frame is not judged twice."""
    program, _, _ = workshop.build(image._replace(target="host", opt="-O2", dump=True))
    source = workshop.scenes.source(image.scene)
    size = f"{image.width}x{image.height}"
    verdicts = pathlib.Path(workshop.work) / "verdicts"
    verdicts.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as place:
        frame = pathlib.Path(place) / "frame"
        execute([program, frame], 600)
        digest = hashlib.sha256(b"\0".join((frame.read_bytes(), source.read_bytes(), size.encode()))).hexdigest()[:20]
        kept = verdicts / f"{image.scene}-{size}-{digest}.json"
        if not kept.exists():
            judged = execute([workshop.scenes.simulator, "compare", source, "--size", size, "--frame", frame, "--json"],
                             600)
            fresh = pathlib.Path(place) / "verdict"
            fresh.write_text(json.dumps({key: json.loads(judged)[key] for key in KEYS}))
            kept.write_text(fresh.read_text())
    return json.loads(kept.read_text())
