# SPDX-License-Identifier: LGPL-2.1-or-later
# make run     set up what is missing, build, mesh and solve a real solid, show where it is
# make test    set up, build, and run everything that can fail
# make test-current  tests in FreeCAD of today (1.1): Debian forky in a chroot, made once in ~/.cache/hexcon or CURRENT
# make lint    what linters say of C, Python, shell and the type stub, and what compilers warn of; .ci/run calls it
# make bench   time and memory of every stage, and how they grow
# make gallery the examples drawn stage by stage, into output/gallery; GALLERY_METHOD: how they are filled
# make screenshots the pictures of docs/guide.md, from FreeCAD's window under Xvfb
# make bench-window how fast large meshes are opened and cut in FreeCAD's window
# make compare method diced beside gmsh's own hexes on fifteen solids; COMPARE_QUADS: sizes of the surfaces
# make compare-optimizer  hn.optimize beside gmsh's and hexsmoothing's on scattered hex meshes; OPTIMIZER_MESHES: a folder of
#              hex meshes (none: made by formula), OPTIMIZER_SMOOTHER: hexsmoothing's innerSmoother
# make parts   named parts with holes, cavities and notches: meshed, patch-tested and solved in FreeCADCmd
# make csg     random CSG parts from solid to certificate, from seed CSG_FIRST on; goes on where it was stopped
# make scoreboard  public quad surfaces filled, beside public hex meshes of them; SCOREBOARD_SURFACES: their folder,
#              SCOREBOARD_LIMIT: processor seconds for each, SCOREBOARD_JOBS: how many at once; writes docs/scoreboard.md;
#              goes on where it was stopped
# make solids  the CAD files of the folder SOLIDS from solid to certificate; SOLIDS_METHOD: by which surface method
# make grid-beside  FEM on the grid's hexes beside diced ones and quadratic tetrahedra, and its hexes beside gmsh's and, where it is
#              installed, OpenFOAM's snappyHexMesh; goes on where it was stopped
# make second-order  convergence of order 2, with its picture, and FEM on eighteen bodies beside quadratic tetrahedra (hours)
# make measured  bench, compare, parts and csg, one after the other (hours), and docs/measured.md from their results
# make fuzz    libFuzzer on the core's calls, with the sanitizers (clang); FUZZ_SECONDS: how long, FUZZ_RUNS: how often
# make build   the core alone, in place
# make release HexCon-x.y.z.zip in build/zip: an addon that needs no compiler, for Linux (x86_64, aarch64) and Windows
# make link    the core, and a link to this folder where FreeCAD looks for addons, which differs between its versions
# FREECADCMD and PYTHON may name another FreeCAD and its interpreter.

FREECADCMD ?= freecadcmd
export FREECADCMD
# Searched once, and only by the rules that need it: FreeCAD may have to be installed first.
python = $(eval python := $(shell scripts/find-python.sh))$(python)
build = build/release
linted = build/lint
sanitized = build/sanitized
sanitized_package = $(sanitized)/package/hexcon_native
fuzzed = build/fuzz
sources = $(shell git ls-files 'hexcon_native/*.[ch]' 'tests/native/*.[ch]' 'examples/*.[ch]' 2>/dev/null || \
            find hexcon_native tests/native examples -name '*.[ch]')
native = $(wildcard hexcon_native/src/*/*.c hexcon_native/src/*/*/*.c)

.PHONY: run test test-current build release link bench bench-window compare compare-optimizer parts csg solids scoreboard grid-beside second-order measured gallery screenshots setup-run setup-test setup-lint setup-fuzz setup-release \
  lint lint-c lint-python lint-shell sanitized-build native-test hostile-test python-test fuzz clean

run: setup-run build
	@command -v $(FREECADCMD) >/dev/null || { echo "HexCon: there is no $(FREECADCMD); set FREECADCMD to FreeCAD's command line program" >&2; exit 1; }
	@echo "HexCon: $$(command -v $(FREECADCMD)), Python $(python)"
	@PYTHONPATH=.:workbench HEXCON_GMSH_PYTHON=$(python) $(FREECADCMD) resources/examples/run_bracket.py </dev/null

# Where FreeCAD of today cannot be had it fails: no green without it.
test-current:
	@scripts/test_current.sh $(CURRENT)

test: setup-test build native-test fuzz hostile-test python-test

setup-run setup-test setup-lint setup-fuzz setup-release:
	@env FREECADCMD=$(filter-out freecadcmd,$(FREECADCMD)) scripts/setup.sh $(@:setup-%=%)

build:
	@[ -f $(build)/build.ninja ] || cmake -S hexcon_native -B $(build) -G Ninja \
	  -DPython3_EXECUTABLE=$(python) >/dev/null
	@ninja -C $(build) --quiet

release: setup-release
	@scripts/release.sh build/zip

link: build
	@folder=$$($(FREECADCMD) scripts/mod_folder.py </dev/null 2>/dev/null | sed -n 's/^FREECAD_MOD=//p') && [ -n "$$folder" ] || \
	  { echo "HexCon: $(FREECADCMD) does not tell where it looks for addons" >&2; exit 1; }; \
	if [ -e "$$folder/HexCon" ] && [ ! "$$folder/HexCon" -ef . ]; then \
	  echo "HexCon: $$folder/HexCon is there already and is another folder: take it away first" >&2; exit 1; fi; \
	mkdir -p "$$folder" && ln -sfn "$(CURDIR)" "$$folder/HexCon" && echo "HexCon: $$folder/HexCon; start FreeCAD anew"

# Not of make test: another version of a linter, or of a compiler, may find more, and that is no fault of who builds.
lint: setup-lint lint-c lint-python lint-shell

lint-c:
	@clang-format --dry-run --Werror $(sources)
	@cppcheck --quiet --error-exitcode=1 --std=c11 --enable=warning,performance,portability \
	  --inline-suppr -Ihexcon_native/include -Ihexcon_native/src $(native)
	@[ -f $(linted)/build.ninja ] || cmake -S hexcon_native -B $(linted) -G Ninja -DHEXCON_WERROR=ON -DHEXCON_TESTS=ON \
	  -DHEXCON_MODULE_FOLDER=$(CURDIR)/$(linted) -DPython3_EXECUTABLE=$(python) >/dev/null
	ninja -C $(linted) --quiet all hexcon_bench hexcon_template_search
	@scripts/tidy.sh $(linted) $(filter %.c,$(sources))

lint-python:
	@$(python) scripts/lint_python.py
	@mkdir -p build/stubs/hexcon_native && cp hexcon_native/__init__.pyi build/stubs/hexcon_native && \
	  for one in errors core_builds; do cp hexcon_native/$$one.py build/stubs/hexcon_native/$$one.pyi; done
	@cd build/stubs && PYTHONPATH=$(CURDIR) MYPYPATH=. $(python) -m mypy.stubtest --concise hexcon_native \
	  --allowlist $(CURDIR)/scripts/stubtest.txt
	PYTHONPATH=.:workbench $(python) scripts/make_docs.py --check
	PYTHONPATH=.:workbench $(python) scripts/translations.py --check

lint-shell:
	shellcheck scripts/*.sh scripts/release/*.sh .ci/run bin/hexcon

sanitized-build:
	@[ -f $(sanitized)/build.ninja ] && [ -d $(sanitized_package) ] || { mkdir -p $(sanitized_package) && cmake -S hexcon_native -B $(sanitized) -G Ninja \
	  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DHEXCON_SANITIZE=ON -DHEXCON_TESTS=ON -DHEXCON_PYTHON=ON \
	  -DPython3_EXECUTABLE=$(python) -DHEXCON_MODULE_FOLDER=$(CURDIR)/$(sanitized_package) >/dev/null; }
	ninja -C $(sanitized) --quiet

native-test: sanitized-build
	ctest --test-dir $(sanitized) --output-on-failure --parallel 2

# The package with the sanitized module comes first where it is the working folder.
hostile-test: sanitized-build
	@cp hexcon_native/*.py $(sanitized_package)/
	cd $(sanitized)/package && HEXCON_SANITIZED=1 LD_PRELOAD=$$(gcc -print-file-name=libasan.so) PYTHONMALLOC=malloc \
	  ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 PYTHONPATH= \
	  $(python) -m pytest -q -p no:cacheprovider $(CURDIR)/tests/python/test_hostile_calls.py

python-test:
	@echo "HexCon: testing with $(python) and $$(command -v $(FREECADCMD))"
	PYTHONPATH=.:workbench $(python) -m pytest -q -p no:cacheprovider -n 2 tests

# By the number of runs from the committed corpus alone; by time, what was met goes on growing.
FUZZ_RUNS ?= 2000
FUZZ_SECONDS ?= 0
fuzz: setup-fuzz
	@[ -f $(fuzzed)/build.ninja ] || cmake -S hexcon_native -B $(fuzzed) -G Ninja -DCMAKE_C_COMPILER=clang \
	  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DHEXCON_FUZZ=ON -DHEXCON_PYTHON=OFF >/dev/null
	ninja -C $(fuzzed) --quiet hexcon_fuzz
	@rm -rf $(fuzzed)/scratch; mkdir -p $(fuzzed)/scratch $(fuzzed)/corpus $(fuzzed)/findings
	$(fuzzed)/tests/hexcon_fuzz -seed=15 -len_control=0 -max_len=160 -timeout=300 -rss_limit_mb=2500 \
	  -artifact_prefix=$(fuzzed)/findings/ -print_final_stats=1 -verbosity=0 \
	  $$([ $(FUZZ_SECONDS) = 0 ] && echo -runs=$(FUZZ_RUNS) $(fuzzed)/scratch \
	     || echo -max_total_time=$(FUZZ_SECONDS) $(fuzzed)/corpus) tests/native/fuzz_corpus

bench: setup-run build
	ninja -C $(build) --quiet hexcon_bench
	$(build)/hexcon_bench

GALLERY_METHOD ?= pyramid
gallery: setup-run build
	@for name in $$(PYTHONPATH=.:workbench $(python) -c 'import hexcon; print(*hexcon.example_names())'); do \
	  HEXCON_PYTHON=$(python) bin/hexcon example $$name --method $(GALLERY_METHOD) \
	    --gallery output/gallery/$$name || exit; done

screenshots: setup-test build
	@scripts/in_window.sh tests/gui/screenshots.py docs

bench-window: setup-test build
	@scripts/in_window.sh tests/gui/bench_inside.py output

COMPARE_QUADS ?= 200 1000 4000
compare: setup-run build
	@PYTHONPATH=.:workbench $(python) tests/python/diced_table.py --quads $(COMPARE_QUADS)

compare-optimizer: setup-run build
	@PYTHONPATH=.:workbench $(python) tests/python/optimizer_table.py $(OPTIMIZER_MESHES) \
	  $(if $(OPTIMIZER_SMOOTHER),--smoother $(OPTIMIZER_SMOOTHER))

parts: setup-run build
	@mkdir -p output
	@PYTHONPATH=.:workbench HEXCON_GMSH_PYTHON=$(python) $(FREECADCMD) tests/freecad/parts_table.py -- \
	  --result output/parts.txt </dev/null >output/parts.log 2>&1; status=$$?; cat output/parts.txt; exit $$status

CSG_FIRST ?= 0
csg: setup-run build
	@PYTHONPATH=.:workbench $(python) tests/freecad/csg_table.py --first $(CSG_FIRST) --result output/csg.jsonl

SCOREBOARD_SURFACES ?= ../shared/surfaces
SCOREBOARD_LIMIT ?= 60
SCOREBOARD_JOBS ?= 1
scoreboard: setup-run build
	@PYTHONPATH=.:workbench $(python) scripts/scoreboard.py $(SCOREBOARD_SURFACES) --limit $(SCOREBOARD_LIMIT) \
	  --jobs $(SCOREBOARD_JOBS) --page

SOLIDS_METHOD ?= auto
solids: setup-run build
	@PYTHONPATH=.:workbench $(python) scripts/solids.py $(SOLIDS) --surface-method $(SOLIDS_METHOD) --result output/solids.jsonl

grid-beside: setup-test build
	@PYTHONPATH=.:workbench $(python) scripts/grid_beside/mesher_table.py --result output/meshers.jsonl
	@PYTHONPATH=.:workbench $(python) scripts/grid_beside/fem_table.py grid
	@$(python) scripts/measured.py

second-order: setup-test build
	@mkdir -p output
	@PYTHONPATH=.:workbench $(python) scripts/second_order/convergence.py --picture docs/convergence.png >output/convergence.new && \
	  mv output/convergence.new output/convergence.txt
	@PYTHONPATH=.:workbench $(python) scripts/grid_beside/fem_table.py round
	@PYTHONPATH=.:workbench $(python) scripts/grid_beside/fem_table.py machined
	@$(python) scripts/measured.py

# Each writes its result file first: what is there already of csg is kept (remove the file to measure anew).
measured: setup-run build
	@mkdir -p output
	@$(MAKE) --no-print-directory bench >output/bench.new && mv output/bench.new output/bench.txt
	@$(MAKE) --no-print-directory compare >output/compare.new && mv output/compare.new output/compare.txt
	@$(MAKE) --no-print-directory parts
	@$(MAKE) --no-print-directory csg
	@$(python) scripts/measured.py

clean:
	rm -rf build output hexcon_native/*.abi3.so
