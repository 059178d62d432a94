# make demo renders a scene on the emulated machine. make check runs all tests. make
# help lists the other targets.

BUILD ?= build
OPT ?= -O3
CFLAGS ?= -g
CXXFLAGS ?= -g
# Maximum number of concurrent compilers, unit tests and scenes.
JOBS ?= 2

.DEFAULT_GOAL = all
include .ci/build.mk docs/docs.mk tests/tests.mk web/web.mk .ci/install.mk

all: $(libraries) $(programs) $(adapter) ## builds the libraries and programs

demo: ## installs missing packages, builds, renders a scene, prints the speedup table
	@sh .ci/need $(build_packages)
	@$(MAKE) --no-print-directory all
	$(BUILD)/rt205 render scenes/bracket.pov -o $(BUILD)/bracket.png -W 600 -H 600
	@echo
	$(BUILD)/rt205 speedup
	@echo "The picture is in $(BUILD)/bracket.png"

# Without debug information on local variables the build takes a quarter less time.
check: ## builds and runs all tests (docs/testing.md)
	@sh .ci/need $(test_packages)
	@mkdir -p $(BUILD) && date +%s >$(BUILD)/check.begin
	-@$(MAKE) --no-print-directory -k -j $(JOBS) CFLAGS="$(patsubst -g,-g1,$(CFLAGS))" \
		all tests $(BUILD)/fit205
	@sh tests/run_all.sh "$(MAKE)" $(JOBS) $(check_parts); code=$$?; \
		sh tests/speed.sh $(BUILD)/check.begin; exit $$code

# Checking an edit takes about a minute, including the build.
check-quick: ## runs the tests that the changed files can affect
	@sh tests/check_quick.sh $(BUILD) "$(MAKE)" 45

check-long: ## runs all tests with ten and more times as many cases
	@sh .ci/need $(test_packages) valgrind dieharder $(card_packages) \
		$(slides_packages) $(site_packages)
	-@$(MAKE) --no-print-directory -k -j $(JOBS) all tests $(BUILD)/fit205
	@sh tests/run_all.sh "$(MAKE)" $(JOBS) check-docs $(check_parts:check-docs=) \
		check-poison check-points check-emission check-timing check-stream \
		check-card check-slides check-site san cover -- check-web check-mpi check-planted

bench: ## measures all benchmarks, or BENCH="growth frames" (tests/bench.sh)
	@sh .ci/need $(build_packages) $(mpi_packages) povray povray-includes clang
	@$(MAKE) --no-print-directory $(benches) $(programs) $(adapter) $(ranks)
	@MAKE="$(MAKE)" sh tests/bench.sh $(BUILD) $(BENCH)

fit: ## fits the timing model, writes the fitted models and the pages
	@sh .ci/need $(build_packages) $(fit_packages) $(exact_packages)
	@$(MAKE) --no-print-directory $(BUILD)/fit205
	$(BUILD)/fit205 --write vm/models/cyber205-2pipe.model \
		--write vm/models/cyber720.model \
		--json $(BUILD)/fit.json
	@$(MAKE) --no-print-directory docs # they contain times of the default model

formatted = $$(git ls-files "*.c" "*.h" "*.cc")
scripts = $$(git ls-files "*.sh") $$(git grep -l "^\#!/bin/sh" -- ":!*.sh")

format: ## formats the C and C++ sources
	@sh .ci/need git clang-format
	clang-format -i $(formatted)

lint: ## checks format, dialect, words and scripts, and runs cppcheck
	@sh .ci/need git clang-format cppcheck shellcheck
	clang-format --dry-run --Werror $(formatted)
	sh tests/check_dialect.sh
	sh tests/check_words.sh
	sh tests/planted/fresh.sh
	shellcheck $(scripts)
	cppcheck --quiet --std=c99 --enable=warning,performance \
		--suppressions-list=.ci/cppcheck.suppressions --error-exitcode=1 \
		-I. vm base asm web/engine rt

clean: ## removes everything that was built
	rm -rf $(BUILD)

help: ## lists these targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1 \2/p' $(MAKEFILE_LIST) | sort | \
		while read -r target text; do printf '%-14s %s\n' "$$target" "$$text"; done

.PHONY: all demo check check-quick check-long bench fit format lint clean help
.SECONDARY:
-include $(shell find $(BUILD) -path $(BUILD)/mutants -prune -o -type f -name '*.d' -print 2>/dev/null)
