# build.mk - builds the libraries and programs.

# The version, as defined in vm/c205.h.
VERSION := $(shell sed -n 's/^.define C205_VERSION "\(.*\)"/\1/p' vm/c205.h)

WARN = -Wall -Wextra -Wshadow
C_WARN = $(WARN) -pedantic -Wconversion -Wstrict-prototypes \
	-Wmissing-prototypes
# Doubles follow C99, except that the code never reads their exception flags. This
# allows vectorised loops.
C_FLAGS = -std=c99 -D_POSIX_C_SOURCE=200809L $(C_WARN) -ffp-contract=off \
	-fno-trapping-math -fno-math-errno $(OPT) $(CFLAGS) -I. -MMD -MP
CXX_FLAGS = -std=c++17 $(WARN) $(OPT) $(CXXFLAGS) -I. -MMD -MP -fPIC

# The sources of rooms. The order of the rooms is vm, base, asm, rt.
c_of = $(foreach room,$(1),$(wildcard $(room)/*.c))
vm_c = $(call c_of,vm vm/number vm/time)
base_c = $(call c_of,base)
asm_c = $(call c_of,$(addprefix asm/,object text view check measure debug timeline sweep \
	compare dap lesson))
c205_c = $(call c_of,asm/command)
# Excludes the entry points of a WebAssembly host.
engine_c = $(filter-out %/wasm.c,$(call c_of,web/engine))
rt_c = $(call c_of,$(addprefix rt/,platform jobs scene bvh scene/language shapes layout \
	trace view picture roots study study/sweep heat mass))
rt205_c = $(filter-out %/fit205.c,$(call c_of,rt/command))
# Sources that read observations, and sources of the fit.
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

build_packages = build-essential pkg-config libopenimageio-dev libfreetype-dev
fit_packages = libceres-dev
mpi_packages = openmpi-bin libopenmpi-dev
exact_packages = libmpfr-dev libgmp-dev

# --- Libraries and programs -------------------------------------------------

$(BUILD)/libc205.a: $(call objects,$(vm_c)) $(BUILD)/vm/model_texts.o
$(BUILD)/libbase.a: $(call objects,$(base_c))
$(BUILD)/libc205asm.a: $(call objects,$(asm_c)) $(BUILD)/asm/library_texts.o \
		$(BUILD)/asm/lesson_texts.o
$(engine): $(call objects,$(engine_c))
$(BUILD)/librt205.a: $(call objects,$(rt_c)) $(BUILD)/rt/kernel_texts.o \
	$(BUILD)/rt/scene_texts.o
# Appends members (q) instead of replacing them (r), because files of two folders may
# have the same name.
%.a:
	@rm -f $@
	$(AR) qcs $@ $^

$(BUILD)/c205: $(call objects,$(c205_c)) \
		$(addprefix $(BUILD)/asm/,isa_example_texts.o card_texts.o) \
		$(filter-out %librt205.a,$(libraries))
	$(CC) $(LDFLAGS) -o $@ $^ -lm -ldl
# Both commands contain an interactive debugger.
$(BUILD)/rt205: $(call objects,$(rt205_c) asm/command/repl.c \
		asm/command/line_editor.c) $(libraries)
	$(CC) $(LDFLAGS) -o $@ $^ -lm -ldl -lpthread
$(BUILD)/fit205: $(call objects,$(fit205_c) $(observing_c)) \
		$(BUILD)/rt/study/fit/ceres_fit.o $(libraries)
	$(CXX) $(LDFLAGS) -o $@ $^ -lceres -lglog -lm -ldl -lpthread
$(BUILD)/rt/study/fit/ceres_fit.o: rt/study/fit/ceres_fit.cc
	@mkdir -p $(@D)
	$(CXX) $(CXX_FLAGS) -isystem /usr/include/eigen3 -c -o $@ $<
# Headers of FreeType may cause warnings, which are errors for our code.
$(BUILD)/rt/scene/font.o: override C_FLAGS += \
	$(subst -I,-isystem ,$(shell pkg-config --cflags freetype2))

# The library that passes messages between ranks. demo does not need it.
mpi: ## builds the library for runs over several hosts
	@sh .ci/need $(mpi_packages)
	@$(MAKE) --no-print-directory $(ranks)
$(ranks): rt/jobs/mpi/ranks_mpi.c rt/jobs/ranks.h rt/jobs/serialized_result.h
	@mkdir -p $(@D)
	mpicc $(filter-out -MMD -MP,$(C_FLAGS)) -fPIC -shared -o $@ $<

$(adapter): rt/picture/picture_oiio.cc
	@mkdir -p $(@D)
	$(CXX) $(CXX_FLAGS) $$(pkg-config --cflags OpenImageIO) -shared -o $@ $< \
		$$(pkg-config --libs OpenImageIO)

# Texts that are part of the programs.
$(BUILD)/vm/model_texts.c: texts_in = vm/models
$(BUILD)/vm/model_texts.c: $(wildcard vm/models/*.model)
$(BUILD)/asm/library_texts.c: texts_in = asm/lib
$(BUILD)/asm/library_texts.c: $(wildcard asm/lib/*.s)
$(BUILD)/asm/isa_example_texts.c: texts_in = asm/isa_examples
$(BUILD)/asm/isa_example_texts.c: $(wildcard asm/isa_examples/*.s)
$(BUILD)/asm/card_texts.c: texts_in = asm/card
$(BUILD)/asm/card_texts.c: $(wildcard asm/card/*.roff)
# The page has no fresh tests.
lesson_files = lesson.md start.s test-*.s $(if $(TITLES),,fresh.s solution.s)
$(BUILD)/asm/lesson_texts.c: texts_in = docs/course
$(BUILD)/asm/lesson_texts.c: $(sort $(foreach file,$(lesson_files),\
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

# The compiler vectorises loops that select one of two doubles only if neither can trap.
$(BUILD)/vm/number/lanes.o $(BUILD)/vm/number/halves.o \
	$(BUILD)/vm/number/spans.o: \
	C_FLAGS += -fno-trapping-math

.PHONY: mpi
