// reference.js - the reference of the instructions: a search by name and by effect.

import { el, fill, some, table } from "./dom.js";

// The sources of the rows (docs/isa.md).
const SOURCES = { P: "primary source", S: "secondary source", D: "derived", R: "reconstructed" };

/** Returns the rows whose name, operands or effect contain all words. Rows whose name begins with
 * the first word come first. */
export function search(rows, words) {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  const begins = ({ mnemonic }) => wanted.length > 0 && mnemonic.toLowerCase().startsWith(wanted[0]);
  const found = rows.filter(({ mnemonic, operands, effect, unit }) => {
    const text = `${mnemonic} ${operands} ${effect} ${unit}`.toLowerCase();
    return wanted.every((word) => text.includes(word));
  });
  return [...found.filter(begins), ...found.filter((row) => !begins(row))];
}

/** Fills the panel. Returns a function that searches for words. */
export function makeReference(panel, { instructions }) {
  const input = el("input", { type: "text", id: "reference-words", spellcheck: "false", autocomplete: "off", input: show });
  const number = el("span", { role: "status", class: "note" });
  const result = el("div", { class: "scroll", tabindex: 0, role: "group", "aria-label": "Instructions" });

  function show() {
    const found = search(instructions, input.value);
    number.textContent = some(found.length, "instruction");
    fill(result, table("Instructions", [["instruction"], ["effect"], ["unit"]], found.map((row) => ({
      cells: [[el("code", {}, `${row.mnemonic} ${row.operands}`), row.half_operands != null
        && el("code", { class: "half-form" }, `${row.mnemonic},H ${row.half_operands}`)],
      row.effect, el("abbr", { title: `source: ${SOURCES[row.source]}` }, row.unit)] }))));
  }

  fill(panel, el("section", { class: "panel", "aria-labelledby": "reference-heading" },
    el("div", { class: "heading" }, el("h2", { id: "reference-heading" }, "Instructions")),
    el("div", { class: "fields" }, el("div", { class: "field" },
      el("label", { for: "reference-words" }, "Name or effect"), input), number),
    result));
  show();
  return (words) => { input.value = words; show(); };
}
