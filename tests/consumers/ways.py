"""Every way to use the library, tried outside the tree: each builds README's lines, renders S1, and compares the CRC.

ways.py --work DIR --baked DIR WAY     WAY: a function below that begins with use_
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

from project import HERE, MACHINES, ROOT, TESTS, Failure, Project, environment, execute, readme_block

DIST = ROOT / "src/dist"
SMALL, USUAL = "32x24", "128x128"
STRICT = ["-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wundef", "-pedantic", "-Werror"]
SECTIONS = ["-ffunction-sections", "-fdata-sections"]
FRAME = ["-DSCENE=s1", f"-DWIDTH={SMALL.split('x')[0]}", f"-DHEIGHT={SMALL.split('x')[1]}"]


class Ways:
    def __init__(self, work, baked):
        self.work, self.scene = work, baked / "s1.c"

    def prefix(self, kind):
        return self.work / "moved" / kind

    def amalgamate(self, place):
        execute([sys.executable, DIST / "amalgamate.py", place / "fixcast/fixcast.h"])

    # ---- a PC ----

    def use_add_subdirectory(self):
        project = Project(self.work / "add_subdirectory")
        project.link_tree()
        lines = readme_block("CMakeLists.txt: add_subdirectory")
        # What a project must not get with the library.
        lines += ('foreach(target fixcast_simulator unity_selftest install_test)\n  if(TARGET ${target})\n'
                  '    message(FATAL_ERROR "add_subdirectory brought ${target} along")\n  endif()\nendforeach()\n'
                  'get_target_property(options fixcast COMPILE_OPTIONS)\nif(options MATCHES "-W")\n'
                  '  message(FATAL_ERROR "add_subdirectory imposed warnings: ${options}")\nendif()\n')
        (project.place / "CMakeLists.txt").write_text(lines)
        project.cmake()
        project.expect(USUAL, "build/spheres")

    def use_install(self):
        """Installs a static and a shared build, for the ways after it, and moves them: nothing may remember where they were."""
        shutil.rmtree(self.work / "moved", ignore_errors=True)
        for kind, shared in (("static", "OFF"), ("shared", "ON")):
            build, prefix = self.work / "build" / kind, self.work / "installed" / kind
            execute(["cmake", "-S", ROOT, "-B", build, "-DFIXCAST_TESTS=OFF", "-DFIXCAST_SIMULATOR=OFF", f"-DBUILD_SHARED_LIBS={shared}",
                     "--log-level=WARNING"], env=environment())
            execute(["cmake", "--build", build, "--parallel", "2"], env=environment())
            execute(["cmake", "--install", build, "--prefix", prefix], env=environment())
            self.prefix(kind).parent.mkdir(parents=True, exist_ok=True)
            prefix.rename(self.prefix(kind))
            for file in self.prefix(kind).rglob("*"):
                if file.suffix in (".pc", ".cmake") and str(ROOT) in file.read_text():
                    raise Failure(f"{file} knows where it was built")

    def use_find_package(self):
        for kind in ("static", "shared"):
            project = Project(self.work / f"find_package_{kind}")
            (project.place / "CMakeLists.txt").write_text(readme_block("CMakeLists.txt: find_package"))
            project.cmake(f"-DCMAKE_PREFIX_PATH={self.prefix(kind)}")
            project.expect(USUAL, "build/spheres")
        # A version that is not there is refused.
        (project.place / "CMakeLists.txt").write_text(readme_block("CMakeLists.txt: find_package").replace("fixcast 0.1", "fixcast 0.0"))
        refused = subprocess.run(["cmake", "-S", project.place, "-B", project.place / "old", f"-DCMAKE_PREFIX_PATH={self.prefix('static')}"],
                                 capture_output=True, text=True, env=environment())
        if refused.returncode == 0 or "requested version" not in refused.stderr:
            raise Failure(f"find_package(fixcast 0.0) should have been refused:\n{refused.stderr}")

    def use_pkg_config(self):
        for kind in ("static", "shared"):
            project, library = Project(self.work / f"pkg_config_{kind}"), self.prefix(kind) / "lib"
            project.shell(readme_block("shell: pkg-config"), PKG_CONFIG_PATH=str(library / "pkgconfig"))
            project.expect(USUAL, "./spheres", LD_LIBRARY_PATH=str(library))

    def use_exports(self):
        """What a shared library shows: all that the headers declare, as the compiler reads them, and nothing else."""
        shown = set()
        for library in sorted((self.prefix("shared") / "lib").glob("*.so")):
            lines = execute(["nm", "-D", "--defined-only", library]).splitlines()
            shown |= {line.split()[-1] for line in lines}
        units = "".join(f'#include "fixcast/{header.name}"\n' for header in sorted((ROOT / "include/fixcast").glob("*.h")))
        source = self.work / "declarations.c"
        source.write_text(units)
        tree = json.loads(execute(["clang", "-std=c99", "-fsyntax-only", "-I", ROOT / "include", "-Xclang", "-ast-dump=json", source]))
        declared = {node["name"] for node in tree["inner"] if node["kind"] in ("FunctionDecl", "VarDecl")
                    and node["name"].startswith("fc_") and node.get("storageClass") != "static"}
        if shown != declared or len(shown) < 80:
            raise Failure(f"shown, not declared: {sorted(shown - declared)}; declared, not shown: {sorted(declared - shown)}")
        print(f"{len(shown)} names")

    def use_single_header(self):
        project = Project(self.work / "single_header")
        self.amalgamate(project.place)
        project.shell(readme_block("shell: single header"))
        project.expect(USUAL, "./spheres")
        # No warning (gcc's are errors where the target `amalgamated` is built); no name that is not the library's own, not even a private one.
        execute(["clang", "-std=c99", "-O1", *STRICT, "-c", "-I.", "fixcast.c", "-o", "clang.o"], cwd=project.place)
        names = [line.split()[-1] for line in execute(["nm", project.place / "clang.o"]).splitlines() if " U " not in line]
        foreign = [name for name in names if not name.startswith(("fc_", ".L"))]
        macros = self.macros(project, '#include "fixcast.c"\n') - self.macros(project, "".join(
            f"#include <{header}>\n" for header in ("stdint.h", "stddef.h", "stdbool.h", "string.h", "limits.h")))
        foreign += sorted(name for name in macros if not re.match(r"fc_|FC_|FIXCAST_", name) and name != "FIXCAST_H")
        if foreign or len(names) < 200:
            raise Failure(f"names that programs may use for themselves: {foreign}")
        # C++ programs may include it, and are told where its implementation belongs.
        execute(["g++", "-std=c++11", *STRICT, "-fsyntax-only", "-x", "c++", "-I.", "fixcast/fixcast.h"], cwd=project.place)
        refused = subprocess.run(["g++", "-fsyntax-only", "-x", "c++", "-I.", "fixcast.c"], cwd=project.place, capture_output=True, text=True)
        if "define FIXCAST_IMPLEMENTATION in a .c file" not in refused.stderr:
            raise Failure(f"an implementation in C++ should be refused in a sentence:\n{refused.stderr}")

    @staticmethod
    def macros(project, text):
        (project.place / "macros.c").write_text(text)
        lines = execute(["gcc", "-std=c99", "-I.", "-dM", "-E", "macros.c"], cwd=project.place)
        return set(re.findall(r"^#define (\w+)", lines, re.M))

    def use_cxx(self):
        project = Project(self.work / "cxx", HERE / "cxx/main.cpp", self.scene)
        include = ["-I", self.prefix("static") / "include"]
        library = self.prefix("static") / "lib/libfixcast.a"
        execute(["gcc", "-std=c99", *include, "-c", "s1.c"], cwd=project.place)
        for compiler, standard in (("g++", "c++11"), ("clang++", "c++20")):
            execute([compiler, f"-std={standard}", *STRICT, *include, "main.cpp", "s1.o", library, "-o", compiler],
                    cwd=project.place)
            project.expect(USUAL, f"./{compiler}")

    # ---- chips ----

    def use_avr(self):
        project = Project(self.work / "avr", HERE / "avr/main.c", self.scene)
        self.amalgamate(project.place)
        project.shell(readme_block("shell: single header").splitlines()[0])
        # int has 16 bits here: what the compiler says of that is an error.
        project.shell(readme_block("shell: avr-gcc").replace("-Os", "-Os -Wall -Wextra -Werror"))
        project.expect(SMALL, "spheres.elf", ["simavr", "-m", "atmega2560", "-f", "16000000"])

    def use_arduino(self):
        """The archive as the Arduino program unpacks it, its example built by Arduino's own builder with the official core for AVR."""
        place = self.work / "arduino"
        shutil.rmtree(place, ignore_errors=True)
        execute([sys.executable, DIST / "arduino.py", self.scene, place / "fixcast.zip"])
        with zipfile.ZipFile(place / "fixcast.zip") as archive:
            archive.extractall(place / "libraries")
        sketch = place / "libraries/fixcast/examples/Spheres/Spheres.ino"
        # An emulated chip ends where it sleeps without interrupts, a real one waits for ever.
        sketch.write_text(sketch.read_text().replace("void loop() {}", "#include <avr/sleep.h>\nvoid loop() { cli(); sleep_mode(); }"))
        tools = place / "tools"
        for directory in (tools, place / "build"):
            directory.mkdir()
        output = execute([
            "arduino-builder", "-compile", "-fqbn", "arduino:avr:mega:cpu=atmega2560", "-warnings", "all", "-build-path", place / "build",
            "-hardware", "/usr/share/arduino/hardware", "-hardware", "/usr/share/arduino-builder", "-tools", "/usr/share/arduino-builder",
            "-tools", tools, "-libraries", place / "libraries", "-prefs", "runtime.tools.avr-gcc.path=/usr",
            # Debian's core wants a newer compiler than Debian's.
            "-prefs", "compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__", sketch])
        own = [line for line in output.splitlines() if "warning:" in line and "libraries/fixcast" in line]
        if own:
            raise Failure("the library warns under Arduino:\n" + "\n".join(own))
        project = Project(self.work / "arduino_run")
        project.expect(SMALL, place / "build/Spheres.ino.elf", ["simavr", "-m", "atmega2560", "-f", "16000000"])

    def on_chip(self, name, machine, library, include):
        """Links a library that a framework's rules made with the program that prints a CRC, and runs it on an emulated chip."""
        chip = MACHINES[machine]
        project = Project(self.work / f"{name}_run", TESTS / "golden/frame_crc.c", self.scene)
        execute([f"{chip.prefix}gcc", "-std=c99", "-Os", *SECTIONS, *chip.flags, *FRAME, "-I", include, "frame_crc.c", "s1.c", *chip.port,
                 library, *chip.link, "-o", "program"], cwd=project.place)
        project.expect(SMALL, project.place / "program", chip.run)

    def framework(self, name, machine, *options):
        """Builds with CMake what stands in the directory of a framework's name here: its rules, and a project."""
        chip, build = MACHINES[machine], self.work / name
        flags = " ".join(map(str, [*chip.flags, "-Os", *SECTIONS]))
        execute(["cmake", "-S", HERE / name, "-B", build, "-DCMAKE_SYSTEM_NAME=Generic", f"-DCMAKE_C_COMPILER={chip.prefix}gcc",
                 "-DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY", f"-DCMAKE_C_FLAGS={flags}", f"-DFIXCAST_DIR={ROOT}", *options,
                 "--log-level=WARNING"], env=environment())
        execute(["cmake", "--build", build, "--parallel", "2"], env=environment())
        return build

    def use_esp_idf(self):
        """An ESP32-C3's instructions; idf_component_register as ESP-IDF documents it."""
        block = readme_block("main/CMakeLists.txt: ESP-IDF")
        if "idf_component_register(" not in block or "REQUIRES fixcast" not in block:
            raise Failure("README's component for ESP-IDF does not require fixcast")
        shutil.rmtree(self.work / "esp_idf", ignore_errors=True)
        build = self.framework("esp_idf", "rv32")
        self.on_chip("esp_idf", "rv32", build / "libfixcast.a", ROOT / "include")

    def use_zephyr(self):
        """A Cortex-M3; the functions of Zephyr's build as it documents them."""
        if "-DZEPHYR_EXTRA_MODULES=" not in readme_block("shell: Zephyr"):
            raise Failure("README's line for Zephyr does not name the module")
        shutil.rmtree(self.work / "zephyr", ignore_errors=True)
        if (self.framework("zephyr", "m3", "-DCONFIG_FIXCAST=OFF") / "libfixcast.a").exists():
            raise Failure("without CONFIG_FIXCAST nothing should be built")
        for panel in ("OFF", "ON"):
            build = self.framework("zephyr", "m3", "-DCONFIG_FIXCAST=ON", f"-DCONFIG_FIXCAST_PANEL={panel}")
            names = execute(["arm-none-eabi-nm", build / "libfixcast.a"])
            if ("fc_panel_start" in names) != (panel == "ON"):
                raise Failure(f"CONFIG_FIXCAST_PANEL={panel} and the panels' code do not go together")
        self.on_chip("zephyr", "m3", build / "libfixcast.a", ROOT / "include")

    def use_platformio(self):
        """A Cortex-M0; library.json read as PlatformIO documents it."""
        if "lib_deps" not in readme_block("platformio.ini"):
            raise Failure("README's platformio.ini has no lib_deps")
        chip, build = MACHINES["m0"], json.loads((ROOT / "library.json").read_text())["build"]
        place = self.work / "platformio"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        sources = filtered(ROOT / build["srcDir"], build["srcFilter"])
        execute(["arm-none-eabi-gcc", "-Os", *SECTIONS, *chip.flags, *" ".join(build["flags"]).replace("-I ", f"-I{ROOT}/").split(),
                 "-I", ROOT / build["includeDir"], "-c", *sources], cwd=place)
        execute(["arm-none-eabi-ar", "rcs", "libfixcast.a", *sorted(path.name for path in place.glob("*.o"))], cwd=place)
        self.on_chip("platformio", "m0", place / "libfixcast.a", ROOT / build["includeDir"])


def filtered(place, rules):
    """The sources that a srcFilter leaves: rules in order, + takes and - drops what a pattern matches, a directory's all."""
    chosen = set()
    for rule in rules:
        sign, pattern = re.fullmatch(r"([+-])<(.+)>", rule).groups()
        pattern = pattern + "**/*" if pattern.endswith("/") else "**/*" if pattern == "*" else pattern
        found = {path for path in place.glob(pattern) if path.suffix in (".c", ".cpp", ".S")}
        chosen = chosen | found if sign == "+" else chosen - found
    return sorted(chosen)


def main():
    names = [name[4:] for name in vars(Ways) if name.startswith("use_")]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", required=True, metavar="DIR")
    parser.add_argument("--baked", required=True, metavar="DIR")
    parser.add_argument("way", choices=names, metavar="WAY")
    options = parser.parse_args()
    work, baked = pathlib.Path(options.work).resolve(), pathlib.Path(options.baked).resolve()
    work.mkdir(parents=True, exist_ok=True)
    try:
        getattr(Ways(work, baked), f"use_{options.way}")()
    except Failure as failure:
        print(f"{options.way}: {failure}")
        return 1
    return 0


sys.exit(main())
