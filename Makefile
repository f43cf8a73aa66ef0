# The front door for people. How things are built stands in CMakeLists.txt alone.
.DEFAULT_GOAL := help
.PHONY: help build single dist demo test matrix firmware emulate flash report gallery bench bench-update budgets budgets-update doc fuzz torture mutants golden-check golden-update clean
BUILD := build
FUZZ_SECONDS := 600
MAKEFLAGS += --no-print-directory
JOBS := $(shell nproc 2>/dev/null || echo 2)
CONFIGURE := cmake -S . -B $(BUILD) --log-level=NOTICE

# What stands in src/port/tools; packages only once there is a board to build for.
board = $(if $(strip $(BOARD)),.ci/install $(2) &&) python3 src/port/tools/board.py $(1) "$(BOARD)"

help: ## show this list
	@echo "make TARGET:"
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1|\2/p' Makefile | awk -F'|' '{ printf "  %-14s %s\n", $$1, $$2 }'

build: ## build the simulator, build/fixcast (installs what is missing with apt-get, as the next three do)
	@.ci/install build
	@$(CONFIGURE) >/dev/null
	@cmake --build $(BUILD) --parallel $(JOBS) --target fixcast_simulator

single: ## write the whole library as one header, build/single/fixcast/fixcast.h
	@python3 src/dist/amalgamate.py $(BUILD)/single/fixcast/fixcast.h

dist: ## make a release of the last commit in build/dist: a tarball with scenes, firmware, single header and Arduino library
	@.ci/install dist
	@$(MAKE) build
	@$(CONFIGURE) >/dev/null
	@cmake --build $(BUILD) --parallel $(JOBS) --target baked_scenes >/dev/null
	@python3 src/dist/dist.py --baked $(BUILD)/baked $(BUILD)/dist

demo: ## render three scenes into build/demo and print how exact they are
	@.ci/install demo
	@$(MAKE) build
	@python3 host_sim/demo.py $(BUILD)/fixcast $(BUILD)/demo

test: ## build everything and run all tests, those on emulated chips too (some minutes)
	@.ci/install test
	@$(CONFIGURE) >/dev/null
	@cmake --build $(BUILD) --parallel $(JOBS)
	@cd $(BUILD) && ctest --output-on-failure -j $(JOBS)

matrix: ## a table of the CRCs that every compiler, option and machine gives (two minutes of compiling once)
	@.ci/install matrix
	@$(CONFIGURE) >/dev/null
	@cmake --build $(BUILD) --parallel $(JOBS) --target baked_scenes >/dev/null
	@python3 tests/matrix/matrix.py --baked $(BUILD)/baked --work $(BUILD)/matrix --jobs $(JOBS)

firmware: ## build the demo for a board, BOARD=NAME (without: the list), into build/firmware/NAME
	@$(call board,build,firmware)

emulate: ## run a board's demo in an emulator: build/emulate/NAME.png is what its panel shows, NAME.log what it says
	@$(call board,emulate,firmware)

flash: ## bring a board's demo onto the board that is connected
	@$(call board,flash,firmware)

report: ## rewrite docs/REPORT.md and its plots from what `make bench` counted, and the accuracy of every scene
	@.ci/install report
	@$(MAKE) build
	@$(BUILD)/fixcast report

gallery: ## rewrite docs/gallery: what goes wrong in a ray caster and the cure, in pictures with numbers (two minutes)
	@.ci/install report
	@.ci/install bench
	@$(MAKE) build
	@python3 host_sim/gallery.py $(BUILD)/fixcast docs/gallery

bench: ## count what frames cost on chips, ours and other renderers', into build/bench/bench.json (several minutes)
	@.ci/install bench
	@$(MAKE) build
	@python3 tests/bench/suite.py --simulator $(BUILD)/fixcast --work $(BUILD)/bench --jobs $(JOBS)
	@cmake --build $(BUILD) --parallel $(JOBS) --target rivals >/dev/null && $(BUILD)/tests/rivals -o $(BUILD)/rivals.json >/dev/null
	@python3 tests/bench/methods.py --simulator $(BUILD)/fixcast --work $(BUILD)/bench --rivals $(BUILD)/rivals.json --jobs $(JOBS)

bench-update: ## rewrite tests/bench/recorded.txt: the counts that the test bench_s1 lets grow by 3 % at most
	@.ci/install bench
	@$(MAKE) build
	@python3 tests/bench/recorded.py --simulator $(BUILD)/fixcast --work $(BUILD)/bench --update

doc: ## write the API reference into build/doc/html
	@.ci/install checks
	@mkdir -p $(BUILD)/doc
	@doxygen docs/Doxyfile 2>/dev/null
	@echo "$(BUILD)/doc/html/index.html"

budgets: ## flash, RAM and stack of boards and least programs, with the change since what is recorded
	@.ci/install bench
	@$(MAKE) build
	@cmake --build $(BUILD) --parallel $(JOBS) --target baked_scenes >/dev/null
	@python3 tests/bench/budgets.py --baked $(BUILD)/baked --work $(BUILD)/budgets

budgets-update: ## rewrite tests/bench/budgets.txt: the figures that the test budgets lets grow by 3 % at most
	@.ci/install bench
	@$(MAKE) build
	@cmake --build $(BUILD) --parallel $(JOBS) --target baked_scenes >/dev/null
	@python3 tests/bench/budgets.py --baked $(BUILD)/baked --work $(BUILD)/budgets --update

fuzz: ## search for inputs that break the core or the scene reader, FUZZ_SECONDS (600) each
	@.ci/install fuzz
	@cmake -S tests/fuzz -B $(BUILD)/fuzz --log-level=WARNING >/dev/null
	@cmake --build $(BUILD)/fuzz --parallel $(JOBS) >/dev/null
	@python3 tests/fuzz/run.py --seconds $(FUZZ_SECONDS) --jobs $(JOBS) $(BUILD)/fuzz nff obj mtl view options scene strips

torture: ## a thousand million seeded hard cases against exact oracles, resumable (about 20 minutes)
	@.ci/install test
	@$(CONFIGURE) >/dev/null
	@cmake --build $(BUILD) --parallel $(JOBS) --target torture acne
	@$(BUILD)/tests/acne 10000000
	@$(BUILD)/tests/torture --full --jobs 2 --state $(BUILD)/torture.state

mutants: ## change the core in 48 places, one at a time, and list what no test noticed; docs/MUTANTS.md has the reasons (an hour)
	@.ci/install test
	@$(CONFIGURE) >/dev/null
	@cmake --build $(BUILD) --parallel $(JOBS) --target baked_scenes >/dev/null
	@python3 tests/mutants/mutants.py --work $(BUILD)/mutants

golden-check: ## compare every scene with tests/golden; old, new and difference of what changed go to build/golden/SCENE.png
	@.ci/install demo
	@$(MAKE) build
	@python3 tests/checks/golden_pictures.py $(BUILD)/fixcast $(BUILD)/golden && python3 tests/checks/golden.py $(BUILD)/fixcast

golden-update: ## take what the simulator renders now as tests/golden, and show what changed in build/golden/SCENE.png
	@.ci/install demo
	@$(MAKE) build
	@python3 tests/checks/golden_pictures.py --update $(BUILD)/fixcast $(BUILD)/golden
	@python3 tests/checks/golden.py --update $(BUILD)/fixcast

clean: ## remove everything that was built
	@rm -rf $(BUILD)
