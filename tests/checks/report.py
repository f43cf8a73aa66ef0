"""The report is made from a small bench.json, says what to run where there is none, and docs/REPORT.md has its sections.

report.py SOURCE_DIRECTORY
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from support import Report

HERE = pathlib.Path(__file__).resolve().parent
ROWS, ACCURACY = HERE / "report_bench.json", HERE / "report_accuracy.json"


def headings(text):
    return re.findall(r"^##? .*$", text, re.MULTILINE)


def bar_of(text, what):
    """The cells of a line of the table of bars."""
    line = next((line for line in text.splitlines() if line.startswith(f"| {what} |")), "")
    return [cell.strip() for cell in line.split("|")[1:-1]]


def check_methods(source, place, run, report):
    """The table of methods: counts beside wrong pixels, and no counts of other sources."""
    sys.path.insert(0, str(source / "tests/bench"))
    import measured
    rivals, counted, bench, output = (place / name for name in ("rivals.json", "methods.json", "bench.json", "REPORT.md"))
    bench.write_text(ROWS.read_text())
    rivals.write_text(json.dumps({"scenes": {"box": [
        {"method": "ours", "numbers": "integer", "wrong_objects": 0}, {"method": "painter", "numbers": "float", "wrong_objects": 184},
        {"method": "painter", "numbers": "double", "wrong_objects": 183}]}}))
    rows = [{"scene": "box", "method": method, "target": chip, "instructions_per_pixel": cost} for method, chip, cost in (
        ("ours, by scan lines", "m0plus", 71.4), ("ours, by scan lines", "m3", 40.2), ("painter", "m0plus", 8000.6), ("painter", "m3", None))]
    for digest, found in ((measured.digest(source), True), ("another", False)):
        counted.write_text(json.dumps({"digest": digest, "rows": rows}))
        run(bench, output, "--stale", "--rivals", rivals, "--methods", counted)
        text = output.read_text()
        report.equal("ours and painter in the table", [found, found],
                     ["| box | ours, by scan lines | 0 | 71 | 40 |" in text, "| box | painter | 184 | 8001 | over the limit |" in text])
        report.equal("old counts are refused", not found, "Counted from other sources" in text)
    run(bench, output, "--stale", "--rivals", rivals, "--methods", place / "none.json")
    report.check("Not counted here" in output.read_text(), "a report without counts does not say so")


def main(source):
    source = pathlib.Path(source)
    report = Report()

    def run(bench, output, *options):
        return subprocess.run([sys.executable, source / "host_sim/report/report.py", "--bench", bench, "--accuracy", ACCURACY,
                               "--output", output, "--no-plots", *options], capture_output=True, text=True)

    with tempfile.TemporaryDirectory() as directory:
        place = pathlib.Path(directory)
        output, bench = place / "REPORT.md", place / "bench.json"

        def refused(what, *options):
            made = run(bench, output, *options)
            report.equal(f"exit code for {what}", 2, made.returncode)
            report.check(made.stderr.count("\n") == 1 and "run `make bench`" in made.stderr, f"{what}: {made.stderr}")
            report.check(not output.exists(), f"{what}: a report was written")

        refused("no bench.json")
        bench.write_text("[]")
        refused("an empty bench.json", "--stale")
        bench.write_text('[{"scene": "s1"}]')
        refused("rows without figures", "--stale")
        bench.write_text(ROWS.read_text())
        refused("other sources")

        made = run(bench, output, "--stale")
        report.equal(f"exit code ({made.stderr.strip()})", 0, made.returncode)
        text = output.read_text() if output.exists() else ""
        report.equal("sections of docs/REPORT.md", headings(text), headings((source / "docs/REPORT.md").read_text()))
        report.check("have changed since" in text, "a stale figure is not called stale")
        report.equal("a bar missed", ["275.4", "**MISSED**"], bar_of(text, "S1 on Cortex-M0+")[-2:])
        report.equal("a row that gave up", ["over the bench's limit", "**MISSED**"], bar_of(text, "S4 on Cortex-M0+")[-2:])
        report.equal("a row that is not there", ["-", "not measured"], bar_of(text, "S2 on M3")[-2:])
        report.equal("an aim met", ["344", "aim met"], bar_of(text, "RAM beyond the strip, S1")[-2:])

        rows = json.loads(ROWS.read_text())
        exact = next(row for row in rows if row["renderer"] == "fixcast" and row["scene"] == "s1")
        cost = exact["instructions_per_pixel"]
        fast = dict(exact, profile="fast", instructions_per_pixel=cost * 0.98)
        half = dict(exact, profile="half", instructions_per_pixel=cost / 2, wrong_id=7, colour_rmse=1.5)
        field = dict(exact, profile="interlaced", instructions_per_pixel=cost * 1.1)
        bench.write_text(json.dumps([*rows, fast, half, field]))
        run(bench, output, "--stale")
        text = output.read_text()
        report.check("`half` saves 50 % (138 instructions; 7 wrong pixels, colour rmse 1.50)" in text,
                     "a profile that is faster is not recommended")
        report.check("`fast` saves" not in text and "`interlaced` saves" not in text, "a profile that does not pay is recommended")
        report.equal("a profile's line", ["50 %", "not measured"], bar_of(text, "`half`")[3:5])
        report.equal("a chip's line", ["S1", "275.4", "269.9 (-2 %)", "137.7 (-50 %)", "302.9 (+10 %)", "7 (half)", "`half`"],
                     bar_of(text, "Cortex-M0+")[1:])
        report.equal("headings with profiles", headings((source / "docs/REPORT.md").read_text()), headings(text))
        report.equal("the promise is exact's alone", False, "BROKEN" in text)

        for row in rows:
            row["wrong_id"] = 1 if row["renderer"] == "fixcast" and row["wrong_id"] is not None else row["wrong_id"]
        bench.write_text(json.dumps(rows))
        run(bench, output, "--stale")
        report.check("BROKEN" in output.read_text(), "a wrong pixel of the exact profile does not show")
        report.equal("a wrong id", ["1", "**MISSED**"], bar_of(output.read_text(), "Wrong ids on S1, S1r, S2")[-2:])

        check_methods(source, place, run, report)

    for picture in re.findall(r"\]\((report/[^)]+)\)", (source / "docs/REPORT.md").read_text()):
        report.check((source / "docs" / picture).exists(), f"docs/REPORT.md shows {picture}, which does not exist")
    return report.finish()


sys.exit(main(sys.argv[1]))
