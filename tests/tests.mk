# tests.mk - the parts of make check, and other tests (docs/testing.md).

unit_tests = $(addprefix $(BUILD)/tests/unit/,$(UNITS))
oracles = $(BUILD)/tests/oracle/check_arithmetic \
	$(BUILD)/tests/oracle/check_narrow \
	$(BUILD)/tests/oracle/check_sample \
	$(BUILD)/tests/oracle/check_scene $(BUILD)/tests/oracle/check_random \
	$(BUILD)/tests/oracle/check_quartic $(BUILD)/tests/oracle/check_faces \
	$(BUILD)/tests/oracle/check_regions $(BUILD)/tests/oracle/check_coincident \
	$(BUILD)/tests/oracle/check_ray_query \
	$(BUILD)/tests/oracle/check_mass $(BUILD)/tests/oracle/check_heat \
	$(BUILD)/tests/oracle/digest \
	$(BUILD)/tests/oracle/check_language_scenes \
	$(BUILD)/tests/oracle/draw_scenes \
	$(BUILD)/tests/oracle/draw_words
fuzz_targets = $(patsubst tests/fuzz/%.c,$(BUILD)/tests/fuzz/%,\
	$(wildcard tests/fuzz/fuzz_*.c))
replays = $(subst /fuzz_,/replay_,$(fuzz_targets))
# Benchmarks that scripts call, such as bench_trace.
benches = $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/bench_*.c))

test_packages = $(build_packages) $(fit_packages) $(exact_packages) $(mpi_packages) \
	libcmocka-dev groff-base povray povray-includes \
	clang lld llvm wasi-libc libclang-rt-14-dev-wasm32

# The parts of check, the slowest first, and their sizes: cases per operation, pairs of
# narrow words, random programs, polynomials per kind, scenes of solids, scenes of many
# regions, scenes with lines and masses, scenes as texts, tries per row of the table,
# compilers.
check_parts = check-unit check-scenes check-commands check-hosts check-web-tracer \
	check-uses check-bench check-web-engine check-faces check-random check-docs \
	check-language-scenes check-course check-regions check-fit check-arithmetic \
	check-adaptive check-library check-heat check-mass check-texts check-ray-query \
	check-language check-quartic check-coincident check-install check-programs check-isa \
	check-bugs check-narrow check-rooms
CASES ?= 500000
PAIRS ?= some
PROGRAMS ?= 8000
POLYNOMIALS ?= 300
FACES ?= 150
REGIONS ?= 100
COINCIDENT ?= 16
QUERIES ?= 60
MASSES ?= 24
HEATS ?= 16
USES ?= some
LANGUAGE ?= 100
TEXTS ?= 10
TRIES ?= 300
# FIRST=1 stops a generator at its first failure, which is then not reduced.
first = $(if $(FIRST),--first)
HOSTS ?= quick
DOCS ?= quick
# The selected unit tests, scenes, scenes for heat and mass, and pages.
UNITS ?= $(patsubst tests/unit/%.c,%,$(wildcard tests/unit/test_*.c))
SCENES ?= $(wildcard scenes/*.pov tests/scenes/*.pov)
# A named scene is traced with all methods; without names each scene is traced with a
# third of them.
WAYS ?= $(if $(filter file,$(origin SCENES)),some,all)
USED ?= $(wildcard scenes/*.pov)
PAGES ?= $(wildcard README.md docs/*.md docs/*/*.md docs/course/*/*.md)

sanitizers = address,undefined


# Freed memory remains in the process, as in rt205 (rt/command/rt205.c), and uses large
# pages if the host has them. Compilers and tests then take a tenth less time.
export MALLOC_MMAP_THRESHOLD_ = 33554432
export MALLOC_TRIM_THRESHOLD_ = 536870912
export GLIBC_TUNABLES = glibc.malloc.hugetlb=1

check-quick: export CASES = 20000
check-quick: export PROGRAMS = 400
check-quick: export POLYNOMIALS = 20
check-quick: export FACES = 8
check-quick: export REGIONS = 8
check-quick: export COINCIDENT = 2
check-quick: export QUERIES = 4
check-quick: export MASSES = 2
check-quick: export HEATS = 1
check-quick: export LANGUAGE = 6

check-long: export CASES = 5000000
check-long: export PAIRS = all
check-long: export PROGRAMS = 80000
check-long: export POLYNOMIALS = 5000
check-long: export FACES = 1500
check-long: export REGIONS = 1000
check-long: export COINCIDENT = 160
check-long: export QUERIES = 600
check-long: export MASSES = 240
check-long: export HEATS = 160
check-long: export MASS_RAYS = 262144
check-long: export HEAT_POINTS = 4096
check-long: export HISTORY_JUMPS = 1000
check-long: export SIGNALS = 20
check-long: export USES = all
check-long: export KILLS = 20
check-long: export WAYS = all
check-long: export USED = $(SCENES)
check-long: export LANGUAGE = 1000
check-long: export TEXTS = 100
check-long: export PROFILED = all
check-long: export TRIES = 3000
check-long: export HOSTS = full
check-long: export DOCS = full
check-long: export THOROUGH = 1

# --- Tests ------------------------------------------------------------------

# Test programs are not in the folder of the dynamic libraries.
export RT205_LIBDIR = $(abspath $(BUILD))

# Test programs are built fast, with debug information only for the lines of a stack
# trace. The objects contain the other debug information.
$(BUILD)/tests/%.o: override CFLAGS := $(patsubst -g,-g1,$(CFLAGS))
$(BUILD)/tests/unit/%.o: OPT = -O1
lld := $(if $(shell command -v ld.lld),-fuse-ld=lld)
test_link = $(LDFLAGS) $(lld) $(if $(findstring sanitize,$(CFLAGS)),,-Wl,-S)

# A unit test and its main function, which is generated from its TEST lines
# (tests/unit/unit.h).
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

# Assembled kernels are cached (saved_programs.c). Tests with limited memory have no
# cache.
keeping = -Wl,--wrap=program_assemble,--wrap=object_free,-u,__wrap_object_free
$(BUILD)/tests/unit/test_allocation: keeping =
# This test counts unfreed allocations without the leak sanitizer.
$(BUILD)/tests/unit/test_allocation: leaks =
# This test makes allocations fail, so all allocations pass through it.
$(BUILD)/tests/unit/test_allocation: override LDFLAGS += \
	-Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free
# A unit test that leaks memory fails. It is linked with the leak sanitizer, if the
# sanitizer detects leaks on this host. Tests that run machines, and tests that mention
# the leak sanitizer, are linked without it. Their large blocks would be mapped again
# each time, which takes up to ten times as long.
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
# The client starts the command c205.
$(filter $(BUILD)/tests/unit/test_dap%,$(unit_tests)) \
		$(BUILD)/tests/unit/test_breakpoints: | $(BUILD)/c205
# These tests run all commands.
$(BUILD)/tests/unit/test_signals $(BUILD)/tests/unit/test_terminal: | \
		$(programs) $(adapter)
# Links objective.c alone, because the test defines the functions of the fit that it
# calls.
$(BUILD)/tests/unit/test_objective: $(BUILD)/tests/unit/test_objective.o \
		$(BUILD)/rt/study/fit/objective.o $(BUILD)/libbase.a \
		$(BUILD)/libc205.a
	$(CC) $(LDFLAGS) -o $@ $^ -lcmocka -lm
$(BUILD)/tests/unit/test_fit: $(BUILD)/tests/unit/test_fit.o \
		$(call objects,$(observing_c)) $(helpers) $(libraries)
	$(CC) $(LDFLAGS) -o $@ $^ -lcmocka -lmpfr -lgmp -lm -ldl -lpthread
$(BUILD)/tests/oracle/check_sample: $(BUILD)/tests/timed_program.o
# Random programs and the plain interpreter, without the tracer. check_hosts.sh also
# links them with the machine as built by other compilers.
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
	sh tests/check_rooms.sh $(BUILD)
	sh tests/check_state.sh $(BUILD)
	sh tests/check_names.sh $(BUILD)
	sh tests/check_words.sh
	sh tests/mutants/check.sh
	@$(MAKE) --no-print-directory -n mutants-whole >/dev/null

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

# Tests the random stream by dieharder; a part of check-long. TESTS=0,205 selects tests.
check-stream: $(BUILD)/tests/oracle/draw_words
	@sh .ci/need dieharder
	sh tests/check_stream.sh $(BUILD)

check-quartic: $(BUILD)/tests/oracle/check_quartic
	$< $(POLYNOMIALS)

# A scene that fails remains in the folder of the build.
by_shares = @seq 0 $$(($(JOBS) - 1)) | (cd $(BUILD) && xargs -I{} -P $(JOBS) \
	tests/oracle/$(subst -,_,$@) $(1) $(JOBS) {} $(first))

check-faces: $(BUILD)/tests/oracle/check_faces
	$(call by_shares,$(FACES))

check-regions: $(BUILD)/tests/oracle/check_regions
	$(call by_shares,$(REGIONS))

# Solids with coincident faces. Transparent solids are also compared with POV-Ray.
check-coincident: $(BUILD)/tests/oracle/check_coincident $(adapter)
	$(call by_shares,$(COINCIDENT))

check-ray-query: $(BUILD)/tests/oracle/check_ray_query
	$(call by_shares,$(QUERIES))

check-heat: $(BUILD)/tests/oracle/check_heat
	$(call by_shares,$(HEATS))

check-mass: $(BUILD)/tests/oracle/check_mass
	$(call by_shares,$(MASSES))

# Compares each text with the picture by POV-Ray.
check-language-scenes: $(BUILD)/tests/oracle/check_language_scenes $(adapter)
	$(call by_shares,$(LANGUAGE))

# The test is a part of check-unit; this target makes more tries.
check-poison: $(BUILD)/tests/unit/test_poison
	$< $(TRIES)

check-points: $(BUILD)/tests/unit/test_sample_points
	$< $(TRIES)

check-emission: $(BUILD)/tests/unit/test_emission
	$< $$(($(TRIES) / 20))

check-timing: $(BUILD)/tests/unit/test_timing $(BUILD)/tests/unit/test_renaming
	$(BUILD)/tests/unit/test_timing $(TRIES)
	$(BUILD)/tests/unit/test_renaming $(PROGRAMS)

# Runs over several processes. Not a part of check.
check-mpi: $(programs) $(adapter) ## runs over several processes
	@sh .ci/need $(test_packages)
	@$(MAKE) --no-print-directory mpi
	sh tests/check_mpi.sh $(BUILD)

# Makes N random faults in the sources, drawn with SEED, in all rooms or in ONLY one
# room. The parts of check should find them. With WITHIN=25, each fault is tried by six
# parts, and by further parts until 25 s of processor time have passed
# (tests/mutants/run.sh). Not a part of check.
N ?= 100
SEED ?= 1
WITHIN ?= 0
covered_parts = $(UNITS:%=check-unit:UNITS=%) $(SCENES:%=check-scenes:SCENES=%) \
	$(filter-out check-unit check-scenes check-hosts check-web-% check-language \
		check-install check-rooms,$(check_parts))
# Builds the sources without a fault.
mutants-whole: all $(BUILD)/fit205 $(engine) $(helpers) \
		$(call objects,$(wildcard $(foreach kind,unit oracle fuzz,tests/$(kind)/*.c)))
check-mutants: ## makes N random faults, which the tests should find
	@sh .ci/need $(test_packages)
	@sh tests/mutants/run.sh $(BUILD) "$(MAKE)" $(JOBS) $(N) $(SEED) "$(ONLY)" \
		$(WITHIN) $(covered_parts)

# Makes earlier faults of the project again. ONLY=text selects faults whose description
# contains the text. Not a part of check.
check-planted: ## makes the faults of tests/planted again
	@sh .ci/need $(test_packages)
	@sh tests/mutants/run.sh $(BUILD) "$(MAKE)" $(JOBS) planted 0 "$(ONLY)" 0

# The results and clocks of all compilers must be the same.
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

# Compares adaptive sampling with POV-Ray.
check-adaptive: $(BUILD)/tests/oracle/check_sample $(adapter)
	sh tests/check_adaptive.sh $(BUILD)

check-language:
	sh tests/check_language.sh

check-library: $(BUILD)/rt205 $(adapter)
	sh tests/check_library.sh $(BUILD)

# Traces POV-Ray's sample scenes. It is slow and not a part of check-long.
check-samples: ## compares POV-Ray's sample scenes
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

# Lists all messages of the programs and the page for reading. Not a part of check.
messages: ## lists all messages with their places
	@awk -f tests/messages.awk $(sort $(vm_c) $(base_c) $(asm_c) $(c205_c) $(engine_c) \
		$(rt_c) $(rt205_c) $(fit205_c) $(observing_c)) vm/rules.def \
		asm/object/warning.def $(wildcard web/page/*.js web/tracer/*.js)

# Otherwise the leak checker would look for thread-local variables of OpenImageIO's
# libraries at invalid addresses.
san: export ASAN_OPTIONS = intercept_tls_get_addr=0
san: ## runs tests with the sanitizers
	@sh .ci/need $(test_packages)
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/san OPT=-O1 \
		CFLAGS="-g -fsanitize=$(sanitizers) -fno-sanitize-recover=$(sanitizers)" \
		LDFLAGS="-fsanitize=$(sanitizers)" \
		check-unit check-programs check-bugs

# Measures the coverage of vm, base and asm by lines and branches.
cover: export LLVM_PROFILE_FILE = $(abspath $(BUILD))/cover/profile/%m.profraw
cover: ## measures the coverage of vm, base and asm
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

# Runs each benchmark in its smallest size. hosts is a part of check-hosts, which builds
# its variants.
check-bench: $(benches) $(programs) $(adapter) $(ranks)
	sh tests/check_bench.sh $(BUILD) machine frames jobs ranks stages visible ray_query \
		growth goals

fuzz: ## runs the fuzzers for SECONDS each
	@sh .ci/need $(build_packages) clang libclang-rt-14-dev
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/fuzz CC=clang OPT=-O1 \
		CFLAGS="-g -DTABLE_BITS=6 -DBLOCK_SIZE=256 \
			-fsanitize=fuzzer-no-link,$(sanitizers) \
			-fno-sanitize-recover=$(sanitizers)" \
		LDFLAGS="-fsanitize=$(sanitizers)" fuzz-targets $(BUILD)/fuzz/c205
	sh tests/fuzz/run.sh $(BUILD)/fuzz $(SECONDS)

fuzz-targets: $(fuzz_targets) $(replays)

.PHONY: $(check_parts) tests mutants-whole check-planted check-mutants check-mpi \
	check-samples check-poison check-points check-stream check-emission check-timing \
	messages san cover cover-tests fuzz fuzz-targets
