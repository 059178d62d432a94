# make demo         installs missing packages, builds, renders a scene on the
#                   emulated machine and prints the speedup table
# make site         the manual as a site; card, slides: docs/teaching.md
# make check        builds and runs all tests (docs/testing.md lists them)
# make check-quick  the tests that the changed files can affect
# make fit          fits the timing model, writes the fitted models and docs/
# make all | docs | card | slides | web | web-tracer | mpi | bench | san | fuzz | cover |
#      check-long | check-web | check-mutants | wasm-check | format | lint | install | clean

BUILD ?= build
OPT ?= -O3
CFLAGS ?= -g
CXXFLAGS ?= -g
# The version, as defined in vm/c205.h.
VERSION := $(shell sed -n 's/^.define C205_VERSION "\(.*\)"/\1/p' vm/c205.h)
PREFIX ?= /usr/local
LIBDIR = $(PREFIX)/lib/rt205
DOCDIR = $(PREFIX)/share/doc/c205
WASM_CC ?= clang --target=wasm32-wasi --sysroot=/usr

WARN = -Wall -Wextra -Wshadow
C_WARN = $(WARN) -pedantic -Wconversion -Wstrict-prototypes \
	-Wmissing-prototypes
# Doubles follow C99, but the code never reads their exception flags, which allows
# vectorised loops.
C_FLAGS = -std=c99 -D_POSIX_C_SOURCE=200809L $(C_WARN) -ffp-contract=off \
	-fno-trapping-math -fno-math-errno $(OPT) $(CFLAGS) -I. -MMD -MP
CXX_FLAGS = -std=c++17 $(WARN) $(OPT) $(CXXFLAGS) -I. -MMD -MP -fPIC

# Layers of the rooms, from the lowest: vm, base, asm, rt.
c_of = $(foreach room,$(1),$(wildcard $(room)/*.c))
vm_c = $(call c_of,vm vm/number vm/time)
base_c = $(call c_of,base)
asm_c = $(call c_of,asm asm/debug asm/timeline asm/sweep asm/compare asm/dap asm/lesson)
c205_c = $(call c_of,asm/command)
# Excludes the entry points of a WebAssembly host.
engine_c = $(filter-out %/wasm.c,$(call c_of,web/engine))
rt_c = $(call c_of,$(addprefix rt/,platform jobs scene scene/language shapes layout \
	trace view picture roots study study/sweep study/plot heat mass))
rt205_c = $(filter-out %/fit205.c,$(call c_of,rt/command))
# Sources that read observations, and sources that fit them.
observing_c = $(addprefix rt/study/fit/,csv.c run.c observations.c constants.c \
	unidentifiable.c)
fit205_c = rt/command/fit205.c \
	$(filter-out $(observing_c),$(call c_of,rt/study/fit))
objects = $(patsubst %.c,$(BUILD)/%.o,$(1))

libraries = $(addprefix $(BUILD)/,librt205.a libc205asm.a libbase.a libc205.a)
engine = $(BUILD)/libengine.a
programs = $(BUILD)/c205 $(BUILD)/rt205
adapter = $(BUILD)/rt205_oiio.so
ranks = $(BUILD)/rt205_mpi.so
# The installed files: three libraries, each with only the names of these headers, and
# with its own copy of the parts of base that it needs.
api = $(BUILD)/api
vm_api = vm/c205.h vm/insn.def vm/arith.def
asm_api = $(addprefix asm/,assemble.h disassemble.h expect.h listing.h object.h \
	print.h runtime_check.h state.h trap_report.h warning.def warning.h) \
	base/diagnostic.h base/sink.h
rt_api = $(addprefix rt/,scene/raster.h scene/scene.h scene/image_map.h \
	scene/language/scene_read.h shapes/primitive.h shapes/shapes.def \
	layout/layout.h layout/bounding.h jobs/job_set.h jobs/checkpoint_file.h jobs/ranks.h \
	jobs/serialized_result.h picture/picture.h trace/band.h \
	trace/observer.h trace/trace.h trace/order.h trace/vector_use.h trace/visible.h) \
	$(addprefix base/,accounts.h arena.h json.h table.h)
unit_tests = $(addprefix $(BUILD)/tests/unit/,$(UNITS))
oracles = $(BUILD)/tests/oracle/check_arithmetic \
	$(BUILD)/tests/oracle/check_narrow \
	$(BUILD)/tests/oracle/check_sample \
	$(BUILD)/tests/oracle/check_scene $(BUILD)/tests/oracle/check_random \
	$(BUILD)/tests/oracle/check_quartic $(BUILD)/tests/oracle/check_faces \
	$(BUILD)/tests/oracle/check_regions $(BUILD)/tests/oracle/check_standing \
	$(BUILD)/tests/oracle/check_lines \
	$(BUILD)/tests/oracle/check_mass $(BUILD)/tests/oracle/check_heat \
	$(BUILD)/tests/oracle/digest \
	$(BUILD)/tests/oracle/check_language_scenes \
	$(BUILD)/tests/oracle/draw_scenes \
	$(BUILD)/tests/oracle/draw_words
fuzz_targets = $(patsubst tests/fuzz/%.c,$(BUILD)/tests/fuzz/%,\
	$(wildcard tests/fuzz/fuzz_*.c))
replays = $(subst /fuzz_,/replay_,$(fuzz_targets))
# The scripts call bench_trace, one of these.
benches = $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/bench_*.c))

build_packages = build-essential pkg-config libopenimageio-dev libfreetype-dev
fit_packages = libceres-dev
mpi_packages = openmpi-bin libopenmpi-dev
exact_packages = libmpfr-dev libgmp-dev
test_packages = $(build_packages) $(fit_packages) $(exact_packages) $(mpi_packages) \
	libcmocka-dev groff-base povray povray-includes gnuplot-nox \
	clang lld llvm wasi-libc libclang-rt-14-dev-wasm32

# The parts of check and their sizes: cases per operation, pairs of narrow words, random
# programs, polynomials per kind, scenes of solids, of many regions, with lines and
# masses, and as texts, tries per row of the table, compilers. The slowest parts come
# first.
check_parts = check-unit check-scenes check-commands check-hosts check-web-tracer \
	check-uses check-bench check-web-engine check-faces check-random check-docs \
	check-language-scenes check-course check-regions check-fit check-arithmetic \
	check-adaptive check-library check-heat check-mass check-texts check-lines \
	check-language check-quartic check-standing check-install check-programs check-isa \
	check-bugs check-narrow check-rooms
CASES ?= 500000
PAIRS ?= some
PROGRAMS ?= 8000
POLYNOMIALS ?= 300
FACES ?= 150
REGIONS ?= 100
STANDING ?= 16
SEEN ?= 60
MASSES ?= 24
HEATS ?= 16
USES ?= some
LANGUAGE ?= 100
TEXTS ?= 10
TRIES ?= 300
# FIRST=1: a generator stops at its first failure without reducing it.
first = $(if $(FIRST),--first)
HOSTS ?= quick
DOCS ?= quick
# The selected unit tests, scenes, scenes for heat and mass, and pages.
UNITS ?= $(patsubst tests/unit/%.c,%,$(wildcard tests/unit/test_*.c))
SCENES ?= $(wildcard scenes/*.pov tests/scenes/*.pov)
# Named scenes are traced with all methods; otherwise each with a third of them.
WAYS ?= $(if $(filter file,$(origin SCENES)),some,all)
USED ?= $(wildcard scenes/*.pov)
PAGES ?= $(wildcard README.md docs/*.md docs/*/*.md docs/course/*/*.md)
# Number of concurrent compilers, unit tests and scenes.
JOBS ?= 2

sanitizers = address,undefined

# --- Commands for users -----------------------------------------------------

all: $(libraries) $(programs) $(adapter)

demo:
	@sh .ci/need $(build_packages)
	@$(MAKE) --no-print-directory all
	$(BUILD)/rt205 render scenes/bracket.pov -o $(BUILD)/bracket.png -W 600 -H 600
	@echo
	$(BUILD)/rt205 speedup
	@echo "The picture is in $(BUILD)/bracket.png"

# Freed memory stays in the process, as in rt205 (rt/command/rt205.c), and uses large
# pages if the host has them: a compiler or a test takes a tenth less time.
export MALLOC_MMAP_THRESHOLD_ = 33554432
export MALLOC_TRIM_THRESHOLD_ = 536870912
export GLIBC_TUNABLES = glibc.malloc.hugetlb=1

# Debug information without local variables makes the build a quarter faster.
check:
	@sh .ci/need $(test_packages)
	-@$(MAKE) --no-print-directory -k -j $(JOBS) CFLAGS="$(patsubst -g,-g1,$(CFLAGS))" \
		all tests $(BUILD)/fit205
	@sh tests/run_all.sh "$(MAKE)" $(JOBS) $(check_parts)

check-quick: export CASES = 20000
check-quick: export PROGRAMS = 400
check-quick: export POLYNOMIALS = 20
check-quick: export FACES = 8
check-quick: export REGIONS = 8
check-quick: export STANDING = 2
check-quick: export SEEN = 4
check-quick: export MASSES = 2
check-quick: export HEATS = 1
check-quick: export LANGUAGE = 6
# Checks an edit within a minute, including the build.
check-quick:
	@sh tests/check_quick.sh $(BUILD) "$(MAKE)" 45

check-long: export CASES = 10000000
check-long: export PAIRS = all
check-long: export PROGRAMS = 200000
check-long: export POLYNOMIALS = 10000
check-long: export FACES = 20000
check-long: export REGIONS = 10000
check-long: export STANDING = 2000
check-long: export SEEN = 5000
check-long: export MASSES = 1000
check-long: export HEATS = 1000
check-long: export MASS_RAYS = 262144
check-long: export HEAT_POINTS = 4096
check-long: export HISTORY_JUMPS = 1000
check-long: export SIGNALS = 20
check-long: export USES = all
check-long: export KILLS = 20
check-long: export WAYS = all
check-long: export USED = $(SCENES)
check-long: export LANGUAGE = 5000
check-long: export TEXTS = 300
check-long: export PROFILED = all
check-long: export TRIES = 3000
check-long: export HOSTS = full
check-long: export DOCS = full
check-long: export THOROUGH = 1
check-long:
	@sh .ci/need $(test_packages) valgrind dieharder $(card_packages) \
		$(slides_packages) $(site_packages)
	-@$(MAKE) --no-print-directory -k -j $(JOBS) all tests $(BUILD)/fit205
	@sh tests/run_all.sh "$(MAKE)" $(JOBS) check-docs $(check_parts:check-docs=) \
		check-poison check-points check-emission check-timing check-stream \
		check-card check-slides check-site san cover -- check-web check-mpi check-planted

fit:
	@sh .ci/need $(build_packages) $(fit_packages) $(exact_packages)
	@$(MAKE) --no-print-directory $(BUILD)/fit205
	$(BUILD)/fit205 --write vm/models/cyber205-2pipe.model \
		--write vm/models/cyber720.model \
		--json $(BUILD)/fit.json
	@$(MAKE) --no-print-directory docs # they contain the default model's times

# --- Libraries and programs -------------------------------------------------

$(BUILD)/libc205.a: $(call objects,$(vm_c)) $(BUILD)/vm/model_texts.o
$(BUILD)/libbase.a: $(call objects,$(base_c))
$(BUILD)/libc205asm.a: $(call objects,$(asm_c)) $(BUILD)/asm/library_texts.o \
		$(BUILD)/asm/lesson_texts.o
$(engine): $(call objects,$(engine_c))
$(BUILD)/librt205.a: $(call objects,$(rt_c)) $(BUILD)/rt/kernel_texts.o \
	$(BUILD)/rt/scene_texts.o
# With q, not r: files of two folders may have the same name.
%.a:
	@rm -f $@
	$(AR) qcs $@ $^

$(BUILD)/c205: $(call objects,$(c205_c)) \
		$(addprefix $(BUILD)/asm/,isa_example_texts.o card_texts.o) \
		$(filter-out %librt205.a,$(libraries))
	$(CC) $(LDFLAGS) -o $@ $^ -lm -ldl
# Both commands have an interactive debugger.
$(BUILD)/rt205: $(call objects,$(rt205_c) asm/command/repl.c \
		asm/command/line_editor.c) $(libraries)
	$(CC) $(LDFLAGS) -o $@ $^ -lm -ldl -lpthread
$(BUILD)/fit205: $(call objects,$(fit205_c) $(observing_c)) \
		$(BUILD)/rt/study/fit/ceres_fit.o $(libraries)
	$(CXX) $(LDFLAGS) -o $@ $^ -lceres -lglog -lm -ldl -lpthread
$(BUILD)/rt/study/fit/ceres_fit.o: rt/study/fit/ceres_fit.cc
	@mkdir -p $(@D)
	$(CXX) $(CXX_FLAGS) -isystem /usr/include/eigen3 -c -o $@ $<
# FreeType's headers may cause warnings that are errors for our code.
$(BUILD)/rt/scene/font.o: override C_FLAGS += \
	$(subst -I,-isystem ,$(shell pkg-config --cflags freetype2))

# The library that carries messages between ranks; demo does not need it.
mpi:
	@sh .ci/need $(mpi_packages)
	@$(MAKE) --no-print-directory $(ranks)
$(ranks): rt/jobs/mpi/ranks_mpi.c rt/jobs/ranks.h rt/jobs/serialized_result.h
	@mkdir -p $(@D)
	mpicc $(filter-out -MMD -MP,$(C_FLAGS)) -fPIC -shared -o $@ $<

$(adapter): rt/picture/picture_oiio.cc
	@mkdir -p $(@D)
	$(CXX) $(CXX_FLAGS) $$(pkg-config --cflags OpenImageIO) -shared -o $@ $< \
		$$(pkg-config --libs OpenImageIO)

# Texts that are compiled into the programs.
$(BUILD)/vm/model_texts.c: texts_in = vm/models
$(BUILD)/vm/model_texts.c: $(wildcard vm/models/*.model)
$(BUILD)/asm/library_texts.c: texts_in = asm/lib
$(BUILD)/asm/library_texts.c: $(wildcard asm/lib/*.s)
$(BUILD)/asm/isa_example_texts.c: texts_in = asm/isa_examples
$(BUILD)/asm/isa_example_texts.c: $(wildcard asm/isa_examples/*.s)
$(BUILD)/asm/card_texts.c: texts_in = asm/card
$(BUILD)/asm/card_texts.c: $(wildcard asm/card/*.roff)
# Solutions are excluded.
$(BUILD)/asm/lesson_texts.c: texts_in = docs/course
$(BUILD)/asm/lesson_texts.c: $(sort $(foreach file,lesson.md start.s test-*.s,\
	$(wildcard docs/course/*/$(file)))) $(wildcard docs/course/ docs/course/*/)
$(BUILD)/rt/kernel_texts.c: texts_in = rt/kernels
$(BUILD)/rt/kernel_texts.c: $(wildcard rt/kernels/*/*.s)
$(BUILD)/rt/scene_texts.c: texts_in = rt/scene/library
$(BUILD)/rt/scene_texts.c: $(wildcard rt/scene/library/*.inc)
$(BUILD)/%_texts.c: vm/embed.sh
	@mkdir -p $(@D)
	sh vm/embed.sh $(@F:.c=) $(texts_in) $(filter-out %/ vm/embed.sh,$^) > $@.new
	@mv $@.new $@

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(C_FLAGS) -c -o $@ $<
$(BUILD)/%.o: $(BUILD)/%.c
	$(CC) $(C_FLAGS) -c -o $@ $<

# Loops that select one of two doubles are vectorised only if neither can trap.
$(BUILD)/vm/number/lanes.o $(BUILD)/vm/number/halves.o \
	$(BUILD)/vm/number/spans.o: \
	C_FLAGS += -fno-trapping-math

# The reference of the instructions, and the printed blocks of the pages.
shown = $(programs) $(BUILD)/fit205 $(BUILD)/tests/oracle/check_quartic \
	$(BUILD)/tests/unit/test_points $(BUILD)/tests/unit/test_emission \
	$(BUILD)/tests/unit/test_functions \
	$(BUILD)/tests/bench_lines $(adapter)
docs: $(BUILD)/c205 $(shown)
	$< isa --markdown >$(BUILD)/isa.md
	@mv $(BUILD)/isa.md docs/isa.md
	$< isa --grammar >$(BUILD)/grammar.json
	@mv $(BUILD)/grammar.json docs/editors/vscode/c205.tmLanguage.json
	sh tests/check_docs.sh $(BUILD) full --write $(PAGES)
	@$(MAKE) --no-print-directory card

# The instructions on two pages.
card_packages = groff fonts-urw-base35 poppler-utils
card: $(BUILD)/c205
	@sh .ci/need $(card_packages)
	sh asm/card/print.sh $< $(BUILD)/card

check-card: card
	sh tests/check_card.sh $(BUILD)/c205 $(BUILD)/card

# The deck of a lecture: for a browser, and in print with and without notes.
slides_packages = python3-markdown chromium poppler-utils
slides = $(BUILD)/slides
slides:
	@sh .ci/need $(slides_packages)
	@mkdir -p $(slides)
	sh docs/slides/deck.sh docs/slides/vector.md >$(slides)/vector.html
	sh docs/slides/browser.sh $(slides)/vector.html --no-pdf-header-footer \
		--print-to-pdf=$(slides)/vector.pdf
	sh docs/slides/browser.sh "$(slides)/vector.html#notes" --no-pdf-header-footer \
		--print-to-pdf=$(slides)/vector-notes.pdf

check-slides: slides
	sh tests/check_slides.sh docs/slides/vector.md $(slides)

# The manual as a site, for a server or a local folder.
site_packages = mkdocs mkdocs-material python3-markdown
site: card
	@sh .ci/need $(site_packages)
	@[ -f $(BUILD)/web/c205.html ] || [ ! -f web/build.mjs ] || \
		$(MAKE) --no-print-directory web
	sh docs/site/lay.sh $(BUILD)
	mkdocs build --quiet --config-file $(BUILD)/mkdocs.yml

check-site: site
	sh tests/check_site.sh $(BUILD)

# --- Tests ------------------------------------------------------------------

# Test programs are not in the folder of the dynamic library.
export RT205_LIBDIR = $(abspath $(BUILD))

# Test programs are built fast, with only the lines of a stack trace; the other debug
# information remains in the objects.
$(BUILD)/tests/%.o: override CFLAGS := $(patsubst -g,-g1,$(CFLAGS))
$(BUILD)/tests/unit/%.o: OPT = -O1
lld := $(if $(shell command -v ld.lld),-fuse-ld=lld)
test_link = $(LDFLAGS) $(lld) $(if $(findstring sanitize,$(CFLAGS)),,-Wl,-S)

# A unit test and its main, which is generated from its TEST lines (tests/unit/unit.h).
$(BUILD)/tests/unit/%.main.c: tests/unit/%.c tests/unit/main.awk
	@mkdir -p $(@D)
	awk -f tests/unit/main.awk $< >$@.new
	@mv $@.new $@
$(call objects,$(wildcard tests/unit/test_*.c)): %.o: %.main.c
	$(CC) $(C_FLAGS) -c -o $@ $<

# Objects that unit tests and oracles share.
helpers = $(BUILD)/tests/libhelpers.a
$(helpers): $(call objects,$(filter-out tests/unit/test_% $(oracles:$(BUILD)/%=%.c),\
	$(wildcard tests/unit/*.c tests/oracle/*.c)))

# Assembled kernels are cached (saved_programs.c), except where memory is limited.
keeping = -Wl,--wrap=program_assemble,--wrap=object_free,-u,__wrap_object_free
$(BUILD)/tests/unit/test_allocation: keeping =
# This test counts unfreed allocations itself.
$(BUILD)/tests/unit/test_allocation: leaks =
# All allocations go through the test, which makes them fail.
$(BUILD)/tests/unit/test_allocation: override LDFLAGS += \
	-Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free
# A unit test that leaks memory fails, if a program with a leak fails when it is linked
# this way. Tests that run machines, and those that mention the leak sanitizer, are
# linked without it: their large blocks are mapped again each time, which takes up to
# ten times as long.
leaks = $(if $(shell grep -lE "traced_frame|machine|model|debugger|session|engine|lesson|leak sanitizer" $(@:$(BUILD)/%=%.c)),,$(file <$(BUILD)/leaks))
$(BUILD)/leaks:
	@mkdir -p $(@D)
	@echo 'int main(void) { return __builtin_malloc(9) == (void *)1; }' | \
		$(CC) $(LDFLAGS) -O0 -fsanitize=leak -x c - -o $@.bin 2>$@.log && \
		! $@.bin 2>$@.log && grep -q '9 byte.* leaked' $@.log && \
		echo -fsanitize=leak >$@ || : >$@
$(BUILD)/tests/unit/%: $(BUILD)/tests/unit/%.o $(helpers) $(engine) $(libraries) \
		| $(BUILD)/leaks
	$(CC) $(test_link) $(keeping) $(leaks) -o $@ $^ -lcmocka -lmpfr -lgmp -lm -ldl \
		-lpthread -Wl,--trace >$@.objects
# The client starts the command.
$(filter $(BUILD)/tests/unit/test_dap%,$(unit_tests)) \
		$(BUILD)/tests/unit/test_breakpoints: | $(BUILD)/c205
# These tests run all commands.
$(BUILD)/tests/unit/test_signals $(BUILD)/tests/unit/test_terminal: | \
		$(programs) $(adapter)
# objective.c alone: the test defines the functions of the fit that it calls.
$(BUILD)/tests/unit/test_objective: $(BUILD)/tests/unit/test_objective.o \
		$(BUILD)/rt/study/fit/objective.o $(BUILD)/libbase.a \
		$(BUILD)/libc205.a
	$(CC) $(LDFLAGS) -o $@ $^ -lcmocka -lm
$(BUILD)/tests/unit/test_fit: $(BUILD)/tests/unit/test_fit.o \
		$(call objects,$(observing_c)) $(BUILD)/tests/oracle/points.o \
		$(libraries)
	$(CC) $(LDFLAGS) -o $@ $^ -lcmocka -lm -ldl -lpthread
$(BUILD)/tests/oracle/check_sample: $(BUILD)/tests/timed_program.o
# Random programs and the plain interpreter, without the tracer. check_hosts.sh links
# them also with the machine as built by other compilers.
digest_parts = $(BUILD)/tests/oracle/digest.o $(call objects,$(wildcard \
	$(addprefix tests/oracle/,random_*.c reference*.c operand*.c plain_memory.c \
	*_oracle.c))) $(BUILD)/libc205asm.a $(BUILD)/libbase.a
link_digest = $(CC) $(LDFLAGS) -o $@ $^ -lmpfr -lgmp -lm
$(BUILD)/tests/oracle/digest: $(digest_parts) $(BUILD)/libc205.a
	$(link_digest)
$(BUILD)/hosts/%/digest: $(digest_parts) $(BUILD)/hosts/%/libc205.a
	$(link_digest)
$(BUILD)/tests/oracle/%: $(BUILD)/tests/oracle/%.o $(helpers) $(libraries)
	$(CC) $(test_link) $(keeping) -o $@ $^ -lmpfr -lgmp -lm -ldl -lpthread \
		-Wl,--trace >$@.objects
$(fuzz_targets): $(BUILD)/tests/fuzz/fuzz_%: \
		$(BUILD)/tests/fuzz/fuzz_%.o $(engine) $(libraries)
	$(CC) $(LDFLAGS) -fsanitize=fuzzer -o $@ $^ -lm -ldl -lpthread
$(replays): $(BUILD)/tests/fuzz/replay_%: $(BUILD)/tests/fuzz/fuzz_%.o \
		$(BUILD)/tests/fuzz/replay.o $(engine) $(libraries)
	$(CC) $(LDFLAGS) -o $@ $^ -lm -ldl -lpthread
$(BUILD)/tests/bench_lanes: $(BUILD)/tests/bench_lanes.o $(BUILD)/libc205.a
	$(CC) $(LDFLAGS) -o $@ $^ -lm
$(BUILD)/tests/bench_%: $(BUILD)/tests/bench_%.o \
		$(BUILD)/tests/timed_program.o $(libraries)
	$(CC) $(LDFLAGS) -o $@ $^ -lm -ldl -lpthread

tests: $(unit_tests) $(oracles) $(replays) $(benches) $(ranks)

check-unit: $(unit_tests) $(adapter)
	@printf '%s\n' $(unit_tests) | xargs -n 1 -P $(JOBS) sh -c \
		'$$0 >$$0.log 2>&1; code=$$?; cat $$0.log; exit $$code'

check-rooms: $(engine) $(libraries)
	sh tests/check_rooms.sh
	sh tests/check_state.sh $(BUILD)
	sh tests/check_names.sh $(BUILD)
	sh tests/check_words.sh
	sh tests/mutants/check.sh

check-programs: $(BUILD)/c205
	sh tests/run_programs.sh $(BUILD)/c205

check-isa: $(BUILD)/c205
	sh tests/check_isa.sh $(BUILD)/c205

check-docs: $(shown)
	sh tests/check_docs.sh $(BUILD) $(DOCS) $(PAGES)

check-bugs: $(replays) $(BUILD)/c205
	sh tests/run_bugs.sh $(BUILD)

check-arithmetic: $(BUILD)/tests/oracle/check_arithmetic
	$< $(CASES)

check-narrow: $(BUILD)/tests/oracle/check_narrow
	$< $(PAIRS)

check-random: $(BUILD)/tests/oracle/check_random
	$< $(PROGRAMS) $(first)

# The random stream, tested by dieharder; a part of check-long. TESTS=0,205 selects
# tests.
check-stream: $(BUILD)/tests/oracle/draw_words
	@sh .ci/need dieharder
	sh tests/check_stream.sh $(BUILD)

check-quartic: $(BUILD)/tests/oracle/check_quartic
	$< $(POLYNOMIALS)

# A scene that fails is left in the build's folder.
by_shares = @seq 0 $$(($(JOBS) - 1)) | (cd $(BUILD) && xargs -I{} -P $(JOBS) \
	tests/oracle/$(subst -,_,$@) $(1) $(JOBS) {} $(first))

check-faces: $(BUILD)/tests/oracle/check_faces
	$(call by_shares,$(FACES))

check-regions: $(BUILD)/tests/oracle/check_regions
	$(call by_shares,$(REGIONS))

# Solids with coincident faces; transparent ones are also compared with POV-Ray.
check-standing: $(BUILD)/tests/oracle/check_standing $(adapter)
	$(call by_shares,$(STANDING))

check-lines: $(BUILD)/tests/oracle/check_lines
	$(call by_shares,$(SEEN))

check-heat: $(BUILD)/tests/oracle/check_heat
	$(call by_shares,$(HEATS))

check-mass: $(BUILD)/tests/oracle/check_mass
	$(call by_shares,$(MASSES))

# Each text is compared with POV-Ray's picture of it.
check-language-scenes: $(BUILD)/tests/oracle/check_language_scenes $(adapter)
	$(call by_shares,$(LANGUAGE))

# This is a part of check-unit, here with more tries.
check-poison: $(BUILD)/tests/unit/test_poison
	$< $(TRIES)

check-points: $(BUILD)/tests/unit/test_points
	$< $(TRIES)

check-emission: $(BUILD)/tests/unit/test_emission
	$< $$(($(TRIES) / 20))

check-timing: $(BUILD)/tests/unit/test_timing $(BUILD)/tests/unit/test_renaming
	$(BUILD)/tests/unit/test_timing $(TRIES)
	$(BUILD)/tests/unit/test_renaming $(PROGRAMS)

# Runs over several processes; not a part of check.
check-mpi: $(programs) $(adapter)
	@sh .ci/need $(test_packages)
	@$(MAKE) --no-print-directory mpi
	sh tests/check_mpi.sh $(BUILD)

# Not a part of check: N random faults in the sources, drawn with SEED, that the parts
# of check should find, in all rooms or in ONLY one (tests/mutants/run.sh).
N ?= 100
SEED ?= 1
covered_parts = $(UNITS:%=check-unit:UNITS=%) $(SCENES:%=check-scenes:SCENES=%) \
	$(filter-out check-unit check-scenes check-hosts check-web-% check-language \
		check-install check-rooms,$(check_parts))
check-mutants:
	@sh .ci/need $(test_packages)
	@sh tests/mutants/run.sh $(BUILD) "$(MAKE)" $(JOBS) $(N) $(SEED) "$(ONLY)" \
		$(covered_parts)

# Not a part of check: earlier faults of the project; ONLY=text selects those whose
# description contains the text.
check-planted:
	@sh .ci/need $(test_packages)
	@sh tests/mutants/run.sh $(BUILD) "$(MAKE)" $(JOBS) planted 0 "$(ONLY)"

# Every compiler must give the same bits and clocks.
check-hosts: $(BUILD)/tests/bench_lanes $(BUILD)/tests/oracle/digest
	@sh .ci/need $(test_packages) $(if $(filter full,$(HOSTS)),valgrind)
	sh tests/check_hosts.sh $(BUILD) "$(MAKE)" $(HOSTS)
	MAKE="$(MAKE)" sh tests/check_bench.sh $(BUILD) hosts

check-scenes: $(adapter) $(BUILD)/tests/oracle/check_scene
	@printf '%s\n' $(SCENES) | \
		xargs -n 26 -P $(JOBS) $(BUILD)/tests/oracle/check_scene $(WAYS)

# Heat and mass of scenes.
check-uses: $(programs)
	@printf '%s\n' $(USED) | \
		USES="$(USES)" xargs -n 1 -P $(JOBS) sh tests/check_uses.sh $(BUILD)

# Adaptive sampling, compared with POV-Ray's.
check-adaptive: $(BUILD)/tests/oracle/check_sample $(adapter)
	sh tests/check_adaptive.sh $(BUILD)

check-language:
	sh tests/check_language.sh

check-library: $(BUILD)/rt205 $(adapter)
	sh tests/check_library.sh $(BUILD)

# POV-Ray's sample scenes; slow, and not a part of check-long.
check-samples:
	@sh .ci/need $(test_packages) povray-examples
	@$(MAKE) --no-print-directory all $(BUILD)/tests/oracle/check_sample
	sh tests/check_samples.sh $(BUILD)

check-commands: $(programs) $(adapter) $(BUILD)/fit205 \
		$(BUILD)/tests/unit/test_debugger_scripts
	sh tests/check_commands.sh $(BUILD)
	sh tests/check_overwrite.sh $(BUILD)
	sh tests/check_plurals.sh $(BUILD)
	sh tests/check_pages.sh $(BUILD)
	sh tests/check_replay.sh $(BUILD)

check-texts: $(programs) $(adapter)
	sh tests/check_texts.sh $(BUILD)

check-course: $(BUILD)/c205
	sh tests/check_course.sh $(BUILD)
	sh tests/check_grading.sh $(BUILD)

check-fit: $(BUILD)/fit205 $(BUILD)/rt205 $(BUILD)/c205
	sh tests/check_fit.sh $(BUILD)

check-install: all
	sh tests/check_install.sh $(BUILD) "$(MAKE)"

# For WebAssembly: vm and asm, the c205 command, and the engine of the page, with its
# size. The page contains the texts of lessons itself. A lock prevents concurrent
# builds.
in_wasm = @mkdir -p $(BUILD)/wasm && TITLES=yes flock $(BUILD)/wasm/lock \
	$(MAKE) --no-print-directory BUILD=$(BUILD)/wasm CC="$(WASM_CC)" AR=llvm-ar \
	$(addprefix $(BUILD)/wasm/,$(1))
wasm-check:
	$(call in_wasm,c205 engine.wasm)
web-engine:
	$(call in_wasm,engine.wasm)
	@mkdir -p $(BUILD)/web
	@cp $(BUILD)/wasm/engine.wasm $(BUILD)/web
	@wc -c $(BUILD)/web/engine.wasm

# The stack is before the data, so that an overflow is detected.
$(BUILD)/engine.wasm: $(BUILD)/web/engine/wasm.o $(addprefix $(BUILD)/,\
		libengine.a libc205asm.a libbase.a libc205.a)
	$(CC) -mexec-model=reactor -Wl,--stack-first -Wl,-z,stack-size=262144 \
		-Wl,--max-memory=1073741824 -Wl,--strip-all -o $@ $^ -lm

# The engine in node is compared with c205, if node is installed.
check-web-engine: $(BUILD)/c205 wasm-check
	@$(MAKE) --no-print-directory web-engine
	sh tests/check_web_engine.sh $(BUILD) $(JOBS)

# The page: one file, and a small site. Debian's node and npm are installed if missing.
web_packages = clang lld llvm wasi-libc libclang-rt-14-dev-wasm32
npm_done = web/node_modules/.package-lock.json
web:
	@sh .ci/need $(web_packages)
	@{ command -v node && command -v npm; } >/dev/null || sh .ci/need nodejs npm
	@$(MAKE) --no-print-directory web-engine
	@$(MAKE) --no-print-directory web-tracer $(npm_done)
	node web/build.mjs $(BUILD)
$(npm_done): web/package.json web/package-lock.json
	cd web && npm ci --ignore-scripts
	@touch $@

# The page in real browsers is compared with c205. BROWSERS="chromium" selects one;
# WEB_TESTS=text selects tests whose name contains the text.
browser_packages = chromium firefox-esr
BROWSERS ?= chromium firefox
check-web:
	@sh .ci/need $(build_packages) $(browser_packages)
	@$(MAKE) --no-print-directory web $(programs)
	node web/tests/browser/run.mjs $(BUILD) "$(BROWSERS)" "$(WEB_TESTS)"

# rt205 for the page: files in web/tracer/platform/ replace the files of rt with the same
# names.
web_tracer_own = $(wildcard web/tracer/platform/*.c)
web_tracer_c = $(filter-out $(addprefix %/,$(notdir $(web_tracer_own))),$(rt_c) \
	$(rt205_c)) $(web_tracer_own) asm/command/repl.c asm/command/line_editor.c
web-tracer:
	$(call in_wasm,rt205.wasm)
	@mkdir -p $(BUILD)/web
	@cp $(BUILD)/wasm/rt205.wasm $(BUILD)/web
	@wc -c $(BUILD)/web/rt205.wasm
	@gzip -9 <$(BUILD)/web/rt205.wasm | wc -c | sed 's/$$/ gzipped/'
$(BUILD)/rt205.wasm: $(call objects,$(web_tracer_c)) $(BUILD)/rt/kernel_texts.o \
		$(BUILD)/rt/scene_texts.o $(addprefix $(BUILD)/,\
		libc205asm.a libbase.a libc205.a)
	$(CC) -Wl,--stack-first -Wl,-z,stack-size=1048576 \
		-Wl,--max-memory=1073741824 -Wl,--strip-all -o $@ $^ -lm

# rt205 in node is compared with rt205, if node is installed; TRACED=text selects runs
# whose command lines contain the text.
drawn = $(BUILD)/web/drawn
check-web-tracer: $(BUILD)/rt205 $(adapter) $(BUILD)/tests/oracle/draw_scenes
	@if ! command -v node >/dev/null; then \
		echo "no node: rt205.wasm is not run"; \
	else \
		$(MAKE) --no-print-directory web-tracer && mkdir -p $(drawn) && \
		$(BUILD)/tests/oracle/draw_scenes $(drawn) 1 $(TEXTS) && \
		node web/tests/node/check_tracer.mjs $(BUILD) $(drawn) "$(TRACED)"; \
	fi

# The leak checker would look for thread-local variables of OpenImageIO's libraries
# where there are none.
san: export ASAN_OPTIONS = intercept_tls_get_addr=0
san:
	@sh .ci/need $(test_packages)
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/san OPT=-O1 \
		CFLAGS="-g -fsanitize=$(sanitizers) -fno-sanitize-recover=$(sanitizers)" \
		LDFLAGS="-fsanitize=$(sanitizers)" \
		check-unit check-programs check-bugs

# The coverage of vm, base and asm by lines and branches.
cover: export LLVM_PROFILE_FILE = $(abspath $(BUILD))/cover/profile/%m.profraw
cover:
	@sh .ci/need $(test_packages) libclang-rt-14-dev
	@rm -rf $(BUILD)/cover/profile
	@sh tests/run_all.sh "$(MAKE)" 1 cover-tests
	sh tests/cover.sh $(BUILD)/cover

cover-tests:
	@$(MAKE) -k --no-print-directory BUILD=$(BUILD)/cover CC=clang CXX=clang++ \
		OPT=-O1 CASES=20000 PROGRAMS=5000 \
		CFLAGS="-g -fprofile-instr-generate -fcoverage-mapping" \
		LDFLAGS=-fprofile-instr-generate check-unit check-programs \
		check-isa check-bugs check-commands check-course check-arithmetic \
		check-random

# All benchmarks, or BENCH="growth frames"; tests/bench.sh lists the names.
bench:
	@sh .ci/need $(build_packages) $(mpi_packages) povray povray-includes clang
	@$(MAKE) --no-print-directory $(benches) $(programs) $(adapter) $(ranks)
	@MAKE="$(MAKE)" sh tests/bench.sh $(BUILD) $(BENCH)

# Each benchmark in its smallest size; hosts is a part of check-hosts, which builds its
# variants.
check-bench: $(benches) $(programs) $(adapter) $(ranks)
	sh tests/check_bench.sh $(BUILD) machine frames jobs ranks stages visible lines \
		growth goals

fuzz:
	@sh .ci/need $(build_packages) clang libclang-rt-14-dev
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/fuzz CC=clang OPT=-O1 \
		CFLAGS="-g -DTABLE_BITS=6 -DBLOCK_SIZE=256 \
			-fsanitize=fuzzer-no-link,$(sanitizers) \
			-fno-sanitize-recover=$(sanitizers)" \
		LDFLAGS="-fsanitize=$(sanitizers)" fuzz-targets $(BUILD)/fuzz/c205
	sh tests/fuzz/run.sh $(BUILD)/fuzz $(SECONDS)

fuzz-targets: $(fuzz_targets) $(replays)

formatted = $$(git ls-files "*.c" "*.h" "*.cc")
scripts = $$(git ls-files "*.sh") $$(git grep -l "^\#!/bin/sh" -- ":!*.sh")

format:
	@sh .ci/need git clang-format
	clang-format -i $(formatted)

lint:
	@sh .ci/need git clang-format cppcheck shellcheck
	clang-format --dry-run --Werror $(formatted)
	sh tests/check_dialect.sh
	sh tests/check_words.sh
	sh tests/planted/fresh.sh
	shellcheck $(scripts)
	cppcheck --quiet --std=c99 --enable=warning,performance \
		--suppressions-list=.ci/cppcheck.suppressions --error-exitcode=1 \
		-I. vm base asm web/engine rt

$(api)/libc205.a: $(call objects,$(vm_c)) $(BUILD)/vm/model_texts.o
$(api)/libc205asm.a: $(call objects,$(asm_c)) $(BUILD)/asm/library_texts.o \
		$(BUILD)/asm/lesson_texts.o \
		$(BUILD)/libbase.a
# Views need internal names of the assembler's library, so they are excluded.
$(api)/librt205.a: $(call objects,$(filter-out rt/view/%,$(rt_c))) \
		$(BUILD)/rt/kernel_texts.o \
		$(BUILD)/rt/scene_texts.o $(BUILD)/libbase.a
$(api)/libc205.a: headers = $(vm_api)
$(api)/libc205asm.a: headers = $(asm_api)
$(api)/librt205.a: headers = $(rt_api)
$(api)/%.a: .ci/export.sh
	@mkdir -p $(@D)
	sh .ci/export.sh $@ $(headers) -- $(filter %.o %.a,$^)

# Arguments of pc: the name, the description, the required packages, the private
# libraries.
define pc
prefix=$(PREFIX)
libdir=$${prefix}/lib
includedir=$${prefix}/include/c205

Name: $(1)
Description: $(2)
Version: $(VERSION)
Requires: $(3)
Libs: -L$${libdir} -l$(1)
Libs.private: $(4)
Cflags: -I$${includedir} -I$${includedir}/vm
endef
$(api)/c205.pc: text = $(call pc,c205,A CYBER 205 style machine,,-lm)
$(api)/c205asm.pc: text = $(call pc,c205asm,Its assembler,c205,)
$(api)/rt205.pc: text = $(call pc,rt205,A ray tracer on it,c205asm,-lm -ldl -lpthread)
$(api)/%.pc: Makefile
	@mkdir -p $(@D)
	$(file >$@,$(text))

installed = $(addprefix $(api)/,libc205.a libc205asm.a librt205.a)
installed_pc = $(addprefix $(api)/,c205.pc c205asm.pc rt205.pc)

# The man pages and shell completions, as the programs print them.
share = $(BUILD)/share
pages = $(foreach program,$(notdir $(programs)),$(addprefix $(share)/,\
	man/man1/$(program).1 bash-completion/completions/$(program) \
	zsh/site-functions/_$(program) fish/vendor_completions.d/$(program).fish))
tell = @mkdir -p $(@D) && $< help $(1) >$@.new && mv $@.new $@
$(share)/man/man1/%.1: $(BUILD)/%
	$(call tell,--man)
$(share)/bash-completion/completions/%: $(BUILD)/%
	$(call tell,--completion bash)
$(share)/zsh/site-functions/_%: $(BUILD)/%
	$(call tell,--completion zsh)
$(share)/fish/vendor_completions.d/%.fish: $(BUILD)/%
	$(call tell,--completion fish)

install: all $(installed) $(installed_pc) $(pages)
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(LIBDIR) \
		$(DESTDIR)$(PREFIX)/lib/pkgconfig
	install $(programs) $(DESTDIR)$(PREFIX)/bin
	for page in $(pages:$(share)/%=%); do \
		install -D -m 644 $(share)/$$page \
			$(DESTDIR)$(PREFIX)/share/$$page; done
	install -m 644 $(adapter) $(wildcard $(ranks)) $(DESTDIR)$(LIBDIR)
	install -m 644 $(installed) $(DESTDIR)$(PREFIX)/lib
	install -m 644 $(installed_pc) $(DESTDIR)$(PREFIX)/lib/pkgconfig
	for header in $(vm_api) $(asm_api) $(rt_api); do \
		install -D -m 644 $$header \
			$(DESTDIR)$(PREFIX)/include/c205/$$header; done
	for file in README.md LICENSE web/NOTICE.md rt/kernels/shapes/sphere_*.s \
		docs/*.md docs/*.sbatch docs/pictures/* docs/editors/*.* docs/editors/vscode/* \
		$$(find docs/course -type f); do \
		install -D -m 644 $$file $(DESTDIR)$(DOCDIR)/$$file; done
	for file in asm/examples/* scenes/*; do \
		install -D -m 644 $$file $(DESTDIR)$(DOCDIR)/$$file; done

clean:
	rm -rf $(BUILD)

.PHONY: $(check_parts) all mpi demo tests check check-quick check-long check-planted \
	check-mutants check-mpi \
	check-samples check-poison check-points check-stream check-emission check-timing \
	check-site check-card check-slides check-web fit cover cover-tests web web-engine \
	web-tracer docs site card slides san bench fuzz fuzz-targets format lint install clean
.SECONDARY:
-include $(shell find $(BUILD) -path $(BUILD)/mutants -prune -o -type f -name '*.d' -print 2>/dev/null)
