"""What package managers read of this library, against their published rules: Arduino's library.properties, PlatformIO's library.json, ESP-IDF's
idf_component.yml, Zephyr's module.yml and Kconfig; and that all of them, and CHANGELOG.md, say the version of include/fixcast/version.h.

metadata.py               checks the tree
metadata.py --self-test   proves on broken copies that each rule is noticed
"""
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile

from project import ROOT, system_python
from support import Report

try:
    import kconfiglib
    import yaml
except ImportError:  # Debian's modules belong to Debian's Python
    python = system_python("kconfiglib, yaml")
    if python == sys.executable:
        raise
    os.execv(python, [python, *sys.argv])

sys.path.insert(0, str(ROOT / "src/dist"))
import arduino  # noqa: E402

SEMVER = r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)"
# Arduino library specification, "library.properties file format" and "Layout of folders and files".
ARDUINO_NEEDED = {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures"}
ARDUINO_KNOWN = ARDUINO_NEEDED | {"depends", "dot_a_linkage", "includes", "precompiled", "ldflags"}
ARDUINO_CATEGORIES = {"Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing", "Data Storage",
                      "Data Processing", "Other"}
ARDUINO_PLACES = r"(src|examples|extras)/.+|library\.properties|keywords\.txt|LICENSE|README\.md"
# PlatformIO manual, "library.json".
PLATFORMIO_KNOWN = {"$schema", "name", "version", "description", "keywords", "homepage", "repository", "authors", "license", "frameworks",
                    "platforms", "headers", "examples", "dependencies", "export", "scripts", "build"}
PLATFORMIO_BUILD = {"extraScript", "flags", "unflags", "includeDir", "srcDir", "srcFilter", "libArchive", "libLDFMode", "libCompatMode",
                    "builder"}
# ESP-IDF component manager, "idf_component.yml Manifest File Format Reference".
IDF_KNOWN = {"version", "description", "license", "maintainers", "targets", "tags", "url", "repository", "repository_info", "documentation",
             "issues", "discussion", "dependencies", "files", "examples"}
# Zephyr manual, "Modules (External projects)"; scripts/zephyr_module.py has the schema.
ZEPHYR_KNOWN = {"name", "build", "tests", "samples", "boards", "blobs", "security", "package-managers", "runners"}
ZEPHYR_BUILD = {"cmake", "kconfig", "cmake-ext", "kconfig-ext", "sysbuild-cmake", "sysbuild-kconfig", "sysbuild-cmake-ext",
                "sysbuild-kconfig-ext", "depends", "settings"}


def properties(text):
    """{key: value} of a library.properties; a line that is none is a key of its own."""
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    return dict(line.split("=", 1) if "=" in line else (line, "") for line in lines)


def check_arduino(report, files, version):
    """`files`: {path: text} of the archive."""
    report.equal("Arduino: directories at the top of the archive", {"fixcast"}, {path.split("/")[0] for path in files})
    inside = {path.split("/", 1)[1]: text for path, text in files.items()}
    for path in inside:
        report.check(re.fullmatch(ARDUINO_PLACES, path), f"Arduino: {path} has no place in a library")
        if path.endswith(".ino"):
            report.equal(f"Arduino: directory of {path}", pathlib.PurePath(path).stem, pathlib.PurePath(path).parent.name)
    report.check(any(path.endswith(".ino") for path in inside), "Arduino: there is no example")
    say = properties(inside["library.properties"])
    report.equal("library.properties: missing", set(), ARDUINO_NEEDED - {key for key, value in say.items() if value.strip()})
    report.equal("library.properties: unknown", set(), set(say) - ARDUINO_KNOWN)
    name = say.get("name", "")
    report.check(re.fullmatch(r"[A-Za-z0-9][\w .-]{0,62}", name) and not name.lower().startswith("arduino"), f"library.properties: name {name}")
    report.equal("library.properties: version", version, say.get("version"))
    report.check(say.get("category") in ARDUINO_CATEGORIES, f"library.properties: category {say.get('category')}")
    report.check(re.fullmatch(r"https?://\S+", say.get("url", "")), f"library.properties: url {say.get('url')}")
    sentence = say.get("sentence", "")
    report.check(0 < len(sentence) <= 120 and not re.match(r"(?i)(an? )?(arduino )?library", sentence), f"library.properties: sentence '{sentence}'")
    report.check(re.fullmatch(r"\*|[a-z0-9_-]+(,[a-z0-9_-]+)*", say.get("architectures", "")), "library.properties: architectures")
    for header in say.get("includes", "").split(","):
        report.check(f"src/{header.strip()}" in inside, f"library.properties: includes {header}, which src has not")


def check_platformio(report, root, version):
    say = json.loads((root / "library.json").read_text())
    build = say.get("build", {})
    report.equal("library.json: unknown", set(), (set(say) - PLATFORMIO_KNOWN) | (set(build) - PLATFORMIO_BUILD))
    report.equal("library.json: version", version, say.get("version"))
    report.check(re.fullmatch(r"[^:;/,@<>]{1,50}", say.get("name", "")), "library.json: name of 1 to 50 characters, none of :;/,@<>")
    report.check(0 < len(say.get("description", "")) <= 255, "library.json: description of 1 to 255 characters")
    report.equal("library.json: license", "MIT", say.get("license"))
    for word in say.get("keywords", []):
        report.check(re.fullmatch(r"[a-z\d\- ]+", word), f"library.json: keyword '{word}' is not a-z, 0-9, - and blank")
    place = root / build.get("includeDir", "include")
    headers = say.get("headers", [])
    for header in [headers] if isinstance(headers, str) else headers:
        report.check((place / header).is_file(), f"library.json: headers names {header}, which {place.name} has not")
    for path in say.get("export", {}).get("include", []):
        report.check((root / path).exists(), f"library.json: exports {path}, which does not exist")
    for flag in build.get("flags", []):
        match = re.fullmatch(r"-I (.+)", flag)
        report.check(match and (root / match.group(1)).is_dir(), f"library.json: flag {flag} names no directory")
    rules = build.get("srcFilter", [])
    taken = {re.sub(r"^\+<(.*)/>$", r"\1", rule) for rule in rules if rule.startswith("+")}
    report.equal("library.json: directories of sources", {"core", "extra", "panel"}, taken)
    report.equal("library.json: first rule of sources", "-<*>", rules[0] if rules else None)


def check_idf(report, root, version):
    say = yaml.safe_load((root / "idf_component.yml").read_text())
    report.equal("idf_component.yml: unknown", set(), set(say) - IDF_KNOWN)
    report.equal("idf_component.yml: version", version, say.get("version"))
    report.equal("idf_component.yml: license", "MIT", say.get("license"))
    report.check(isinstance(say.get("description"), str) and say["description"], "idf_component.yml: no description")
    for name, wanted in say.get("dependencies", {}).items():
        report.check(isinstance(wanted, str) and re.fullmatch(r"(\*|(==|!=|>=|<=|>|<|~|\^|~=)?\d+(\.\d+){0,2})", wanted),
                     f"idf_component.yml: dependency {name}: {wanted}")
    for pattern in say.get("files", {}).get("exclude", []):
        report.check(any(root.glob(pattern)), f"idf_component.yml: excludes {pattern}, which matches nothing")
    needed = re.findall(r"idf_component_register\(([^)]*)\)", (root / "CMakeLists.txt").read_text())
    report.equal("CMakeLists.txt: components registered", 1, len(needed))


def check_zephyr(report, root):
    say = yaml.safe_load((root / "zephyr/module.yml").read_text())
    build = say.get("build", {})
    report.equal("module.yml: unknown", set(), (set(say) - ZEPHYR_KNOWN) | (set(build) - ZEPHYR_BUILD))
    report.check(re.fullmatch(r"[a-zA-Z0-9_-]+", say.get("name", "")), "module.yml: name")
    report.check((root / build.get("cmake", ".") / "CMakeLists.txt").is_file(), "module.yml: cmake names no directory with CMakeLists.txt")
    kconfig = root / build.get("kconfig", "")
    if not report.check(kconfig.is_file(), "module.yml: kconfig names no file"):
        return
    os.environ["KCONFIG_WARN_UNDEF"] = "y"
    try:
        options = kconfiglib.Kconfig(str(kconfig), warn=True, warn_to_stderr=False)
    except kconfiglib.KconfigError as problem:
        report.check(False, f"Kconfig: {problem}")
        return
    report.equal("Kconfig: warnings", [], options.warnings)
    asked = set(re.findall(r"CONFIG_(\w+)", (root / "zephyr/CMakeLists.txt").read_text()))
    report.equal("Kconfig: options that CMakeLists.txt asks for", asked, {symbol.name for symbol in options.unique_defined_syms})
    for name in asked & set(options.syms):
        report.equal(f"Kconfig: {name} without being asked for", "n", options.syms[name].str_value)
    if "FIXCAST_PANEL" in options.syms:
        options.syms["FIXCAST_PANEL"].set_value("y")
        report.equal("Kconfig: panels without the library", "n", options.syms["FIXCAST_PANEL"].str_value)


def check_changelog(report, root, version):
    text = (root / "CHANGELOG.md").read_text()
    heads = re.findall(r"^## (.*)$", text, re.M)
    report.equal("CHANGELOG.md: first heading", "[Unreleased]", heads[0] if heads else None)
    known = [match.group(1) for match in (re.fullmatch(rf"\[({SEMVER})\] - \d{{4}}-\d\d-\d\d", head) for head in heads[1:]) if match]
    report.equal("CHANGELOG.md: headings that are '[VERSION] - YYYY-MM-DD'", len(heads) - 1, len(known))
    report.check(not known or known[0] == version or f"next is {version}" in text, f"CHANGELOG.md does not tell of {version}")
    for kind in re.findall(r"^### (.*)$", text, re.M):
        report.check(kind in ("Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"), f"CHANGELOG.md: heading '{kind}'")


def check(report, root, files):
    version = "{}.{}.{}".format(*re.findall(r"^#define FC_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$",
                                            (root / "include/fixcast/version.h").read_text(), re.M))
    report.check(re.fullmatch(SEMVER, version), f"version {version}")
    check_arduino(report, files, version)
    check_platformio(report, root, version)
    check_idf(report, root, version)
    check_zephyr(report, root)
    check_changelog(report, root, version)


def scene():
    """Any text does for the example's scene: its place in the archive is what is checked."""
    return ROOT / "host_sim/scenes/s1.h"


# (file, what stands there, what would be wrong). The first path names are the archive's.
BROKEN = [
    ("arduino:library.properties", "category=Display", "category=Graphics"),
    ("arduino:library.properties", "name=fixcast", "name=Arduino fixcast"),
    ("arduino:library.properties", "sentence=", "sentense="),
    ("arduino:library.properties", "includes=fixcast.h", "includes=raycast.h"),
    ("arduino:library.properties", "version=", "version=1"),
    ("library.json", '"license": "MIT"', '"licence": "MIT"'),
    ("library.json", '"srcFilter": ["-<*>", "+<core/>"', '"srcFilter": ["-<*>", "+<cores/>"'),
    ("library.json", "-I src/core", "-I src/cores"),
    ("library.json", '"3d"', '"3D"'),
    ("library.json", '"version": "', '"version": "1'),
    ("idf_component.yml", 'version: "', 'version: "1'),
    ("idf_component.yml", "license: MIT", "licence: MIT"),
    ("idf_component.yml", '">=4.4"', '"4.4 or so"'),
    ("idf_component.yml", "tests/**/*", "test/**/*"),
    ("zephyr/module.yml", "kconfig: zephyr/Kconfig", "kconfig: Kconfig"),
    ("zephyr/module.yml", "cmake: zephyr", "cmake: src"),
    ("zephyr/module.yml", "name: fixcast", "title: fixcast"),
    ("zephyr/Kconfig", "depends on FIXCAST", "depends on FIXCAST_CORE"),
    ("zephyr/Kconfig", "config FIXCAST\n\tbool", "config FIXCAST\n\tdefault y\n\tbool"),
    ("zephyr/Kconfig", "config FIXCAST_PANEL", "config FIXCAST_PANELS"),
    ("zephyr/CMakeLists.txt", "CONFIG_FIXCAST_PANEL", "CONFIG_FIXCAST_DISPLAY"),
    ("CHANGELOG.md", "## [Unreleased]", "## Unreleased"),
    ("CHANGELOG.md", "### Added", "### New"),
    ("include/fixcast/version.h", "FC_VERSION_PATCH 0", "FC_VERSION_PATCH 1"),
]


def self_test():
    archive = arduino.files(scene())
    for name, old, new in [(None, "", "")] + BROKEN:
        with tempfile.TemporaryDirectory() as directory:
            root, files = pathlib.Path(directory) / "tree", dict(archive)
            for path in ("library.json", "idf_component.yml", "CHANGELOG.md", "CMakeLists.txt", "LICENSE", "README.md"):
                (root / path).parent.mkdir(exist_ok=True)
                shutil.copy(ROOT / path, root / path)
            for path in ("zephyr", "include", "src", "examples", "docs"):
                shutil.copytree(ROOT / path, root / path)
            for path in ("tests", "host_sim"):
                (root / path / "some").mkdir(parents=True)
                (root / path / "some/file").touch()
            if name and name.startswith("arduino:"):
                path = "fixcast/" + name[8:]
                assert old in files[path], (name, old)
                files[path] = files[path].replace(old, new)
            elif name:
                text = (root / name).read_text()
                assert old in text, (name, old)
                (root / name).write_text(text.replace(old, new))
            report = Report()
            check(report, root, files)
            if bool(report.wrong) != (name is not None):
                sys.exit(f"{name} with {new!r}: {len(report.wrong)} complaints")
    print("self-test passed: the failures above were meant")
    return 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    report = Report()
    check(report, ROOT, arduino.files(scene()))
    return report.finish()


sys.exit(main(sys.argv[1:]))
