// compare.js - compares two programs. A sentence names the one or two main causes of the
// difference, and tables show causes, regions and figures.

import { choices, count, el, fill, fixed, heading, table } from "./dom.js";
import { named } from "./causes.js";

export function makeCompare(panel, session, comparablePrograms) {
  const first = el("select", { id: "compare-first" });
  const second = el("select", { id: "compare-second" });
  const result = el("div", { class: "result", role: "group", "aria-live": "polite", "aria-label": "Result" });
  fill(panel, el("section", { class: "panel", "aria-labelledby": "compare-heading" },
    heading("compare", "Two programs side by side"),
    el("form", { class: "fields", submit: (event) => { event.preventDefault(); run(); } },
      el("div", { class: "field" }, el("label", { for: "compare-first" }, "First"), first),
      el("div", { class: "field" }, el("label", { for: "compare-second" }, "second"), second),
      el("div", { class: "field" }, el("button", { type: "submit", class: "main" }, "Compare"),
        el("button", { type: "button", click: saveText }, "Save my program for later"))),
    result));

  /** Clears both lists and the result after another program was opened. */
  function reset() {
    fill(first);
    fill(second);
    updateLists();
  }

  // Fills both lists. The default compares the starting text with the program in the editor.
  function updateLists() {
    const [mine, ...list] = comparablePrograms();
    const chosen = first.value;
    choices(first, [...list, mine]);
    choices(second, [mine, ...list]);
    if (chosen !== first.value) fill(result);
  }

  function saveText() {
    session.saveText();
    updateLists();
    fill(result, el("p", {}, "Your program is saved. Both lists show it as “saved”."));
  }

  async function run() {
    if (session.busy) return;
    updateLists();
    const list = comparablePrograms();
    const chosen = [first, second].map(({ value }) => list.find((one) => one.value === value));
    const reply = await session.runRequest({ do: "compare", ...session.setting,
      texts: chosen.map(({ title, text }) => ({ name: title, text })) });
    fill(result, reply.ok && !reply.stopped ? resultElements(reply, chosen)
      : el("p", { class: "fault" }, reply.error ?? "Stopped."));
  }

  /** Compares a program of the list with the program in the editor. */
  function compareWith(value) {
    updateLists();
    first.value = value;
    second.value = "mine";
    return run();
  }

  function resultElements(reply, chosen) {
    const titles = [...chosen.map(({ title }) => title), "second - first", "first / second"];
    const comparisonTable = (caption, key, rows, name = String) => table(caption,
      [[key], ...titles.map((title) => [title, "number"])],
      rows.map((row) => ({ class: row[key] === "all" ? "sum" : null, cells: [name(row[key]),
        figure(row.first, row[key]), figure(row.second, row[key]), row.difference === undefined ? "" : count(row.difference),
        row.ratio == null ? "-" : fixed(row.ratio, 3)] })));
    return [
      el("p", { class: "verdict-words" }, reply.sentence),
      el("div", { class: "scroll", tabindex: 0, role: "group", "aria-label": "Tables" },
        comparisonTable("Clocks by cause", "cause", reply.causes.filter((row) => row.first || row.second),
          (cause) => cause === "all" ? cause : named(cause)),
        reply.regions.length > 1 && comparisonTable("Clocks by region", "region", reply.regions),
        comparisonTable("Figures", "figure", reply.figures)),
    ];
  }

  // Decimal places, as in c205 compare. Figures without an entry are counts.
  const decimals = { milliseconds: 3, "mean vector length": 1, "Mflop/s": 2 };
  const figure = (x, name) => x == null ? "-" : fixed(x, decimals[name] ?? 0);

  return { updateLists, reset, run, compareWith };
}
