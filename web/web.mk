# web.mk - builds the page and the commands for WebAssembly.

WASM_CC ?= clang --target=wasm32-wasi --sysroot=/usr

# Builds vm and asm, the c205 command and the engine of the page for WebAssembly, and
# prints the size of the engine. The engine contains only the titles of lessons, because
# the page contains their texts. A lock prevents concurrent builds.
in_wasm = @mkdir -p $(BUILD)/wasm && TITLES=yes flock $(BUILD)/wasm/lock \
	$(MAKE) --no-print-directory BUILD=$(BUILD)/wasm CC="$(WASM_CC)" AR=llvm-ar \
	$(addprefix $(BUILD)/wasm/,$(1))
wasm-check: ## builds c205 and the engine for WebAssembly
	$(call in_wasm,c205 engine.wasm)
web-engine:
	$(call in_wasm,engine.wasm)
	@mkdir -p $(BUILD)/web
	@cp $(BUILD)/wasm/engine.wasm $(BUILD)/web
	@wc -c $(BUILD)/web/engine.wasm

# The stack is before the data, so an overflow is detected.
$(BUILD)/engine.wasm: $(BUILD)/web/engine/wasm.o $(addprefix $(BUILD)/,\
		libengine.a libc205asm.a libbase.a libc205.a)
	$(CC) -mexec-model=reactor -Wl,--stack-first -Wl,-z,stack-size=262144 \
		-Wl,--max-memory=1073741824 -Wl,--strip-all -o $@ $^ -lm

# Compares the engine in node with c205, if node is installed.
check-web-engine: $(BUILD)/c205 wasm-check
	@$(MAKE) --no-print-directory web-engine
	sh tests/check_web_engine.sh $(BUILD) $(JOBS)

# The page: one file, and a small site. Installs Debian's node and npm if they are
# missing.
web_packages = clang lld llvm wasi-libc libclang-rt-14-dev-wasm32
npm_done = web/node_modules/.package-lock.json
web: ## the page: one file, and a small site
	@sh .ci/need $(web_packages)
	@{ command -v node && command -v npm; } >/dev/null || sh .ci/need nodejs npm
	@$(MAKE) --no-print-directory web-engine
	@$(MAKE) --no-print-directory web-tracer $(npm_done)
	node web/build.mjs $(BUILD)
$(npm_done): web/package.json web/package-lock.json
	cd web && npm ci --ignore-scripts
	@touch $@

# Compares the page in real browsers with c205. BROWSERS="chromium" selects a browser.
# WEB_TESTS=text selects tests whose name contains the text.
browser_packages = chromium firefox-esr
BROWSERS ?= chromium firefox
check-web: ## compares the page in browsers with c205
	@sh .ci/need $(build_packages) $(browser_packages)
	@$(MAKE) --no-print-directory web $(programs) $(adapter)
	node web/tests/browser/run.mjs $(BUILD) "$(BROWSERS)" "$(WEB_TESTS)"

# rt205 for the page. Files in web/tracer/platform/ replace files of rt with the same
# names.
web_tracer_own = $(wildcard web/tracer/platform/*.c)
web_tracer_c = $(filter-out $(addprefix %/,$(notdir $(web_tracer_own))),$(rt_c) \
	$(rt205_c)) $(web_tracer_own) asm/command/repl.c asm/command/line_editor.c
web-tracer: ## builds rt205 for WebAssembly
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

# Compares rt205 in node with rt205, if node is installed. TRACED=text selects runs
# whose command line contains the text.
drawn = $(BUILD)/web/drawn
check-web-tracer: $(BUILD)/rt205 $(adapter) $(BUILD)/tests/oracle/draw_scenes
	@if ! command -v node >/dev/null; then \
		echo "no node: rt205.wasm is not run"; \
	else \
		$(MAKE) --no-print-directory web-tracer && mkdir -p $(drawn) && \
		$(BUILD)/tests/oracle/draw_scenes $(drawn) 1 $(TEXTS) && \
		node web/tests/node/check_tracer.mjs $(BUILD) $(drawn) "$(TRACED)"; \
	fi

.PHONY: web web-engine web-tracer wasm-check check-web
