# docs.mk - prints the blocks of the pages, the card, the slides and the site.

# The reference of the instructions, and the printed blocks of the pages.
shown = $(programs) $(BUILD)/fit205 $(BUILD)/tests/oracle/check_quartic \
	$(BUILD)/tests/unit/test_sample_points $(BUILD)/tests/unit/test_emission \
	$(BUILD)/tests/unit/test_library_functions \
	$(BUILD)/tests/bench_ray_query $(adapter)
docs: $(BUILD)/c205 $(shown) ## prints the reference and the blocks of the pages again
	$< isa --markdown >$(BUILD)/isa.md
	@mv $(BUILD)/isa.md docs/isa.md
	$< isa --grammar >$(BUILD)/grammar.json
	@mv $(BUILD)/grammar.json docs/editors/vscode/c205.tmLanguage.json
	sh tests/check_docs.sh $(BUILD) full --write $(PAGES)
	@$(MAKE) --no-print-directory card

# The instructions on two pages.
card_packages = groff fonts-urw-base35 poppler-utils
card: $(BUILD)/c205 ## the instructions on two pages
	@sh .ci/need $(card_packages)
	sh asm/card/print.sh $< $(BUILD)/card

check-card: card
	sh tests/check_card.sh $(BUILD)/c205 $(BUILD)/card

# The deck of a lecture: for a browser, and in print with and without notes.
slides_packages = python3-markdown chromium poppler-utils
slides = $(BUILD)/slides
slides: ## the deck of a lecture
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
site: card ## the manual as a site
	@sh .ci/need $(site_packages)
	@[ -f $(BUILD)/web/c205.html ] || [ ! -f web/build.mjs ] || \
		$(MAKE) --no-print-directory web
	sh docs/site/lay.sh $(BUILD)
	mkdocs build --quiet --config-file $(BUILD)/mkdocs.yml

check-site: site
	sh tests/check_site.sh $(BUILD)

.PHONY: docs card check-card slides check-slides site check-site
