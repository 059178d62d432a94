# install.mk - installs programs, libraries, headers and pages.

PREFIX ?= /usr/local
LIBDIR = $(PREFIX)/lib/rt205
DOCDIR = $(PREFIX)/share/doc/c205

# The installed files. Each of the three libraries defines only the names in these
# headers, and contains a copy of the parts of base that it needs and of vm/error.o.
api = $(BUILD)/api
vm_api = $(addprefix vm/,c205.h c205_word.h c205_model.h c205_machine.h c205_time.h \
	c205_history.h insn.def arith.def)
asm_api = $(addprefix asm/,object/disassemble.h object/expectation.h object/object.h \
	object/object_file.h object/warning.def object/warning.h text/assemble.h \
	view/listing.h view/print.h view/state.h view/trap_report.h \
	check/expect.h check/runtime_check.h) base/diagnostic.h base/sink.h
rt_api = $(addprefix rt/,scene/raster.h scene/scene.h scene/image_map.h \
	scene/language/scene_read.h scene/patterns.def shapes/primitive.h shapes/shapes.def \
	layout/layout.h layout/bounding.h jobs/job_set.h jobs/checkpoint_file.h jobs/ranks.h \
	jobs/serialized_result.h picture/picture.h trace/band.h \
	trace/observer.h trace/trace.h trace/vector_use.h) \
	$(addprefix base/,accounts.h arena.h json.h table.h)

$(api)/libc205.a: $(call objects,$(vm_c)) $(BUILD)/vm/model_texts.o
$(api)/libc205asm.a: $(call objects,$(asm_c)) $(BUILD)/asm/library_texts.o \
		$(BUILD)/asm/lesson_texts.o \
		$(BUILD)/libbase.a $(BUILD)/vm/error.o
# Views are excluded, because they need internal names of the assembler's library.
$(api)/librt205.a: $(call objects,$(filter-out rt/view/%,$(rt_c))) \
		$(BUILD)/rt/kernel_texts.o \
		$(BUILD)/rt/scene_texts.o $(BUILD)/libbase.a $(BUILD)/vm/error.o
$(api)/libc205.a: headers = $(vm_api)
$(api)/libc205asm.a: headers = $(asm_api)
$(api)/librt205.a: headers = $(rt_api)
$(api)/%.a: .ci/export.sh
	@mkdir -p $(@D)
	sh .ci/export.sh $@ $(headers) -- $(filter %.o %.a,$^)

# Arguments of pc: name, description, required packages, private libraries.
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
$(api)/%.pc: .ci/install.mk
	@mkdir -p $(@D)
	$(file >$@,$(text))

installed = $(addprefix $(api)/,libc205.a libc205asm.a librt205.a)
installed_pc = $(addprefix $(api)/,c205.pc c205asm.pc rt205.pc)

# The man pages and shell completions, printed by the programs.
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

install: all $(installed) $(installed_pc) $(pages) ## installs programs, libraries, pages
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

.PHONY: install
