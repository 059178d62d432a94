// results.js - shows the results of a run below the program: the labels whose data differ from the
// program's text, the labels of the exercise, and the instruction with the most clocks.

import { $, count, el, fill, fixed, some } from "./dom.js";

const MAX = 24; // maximum number of labels

/** EXPECTED returns the labels that the exercise requires. SHOWLINE goes to a line. */
export function makeResults(session, expected, showLine) {
  let ended = false; // the results of a run are not yet in sight

  function show(results) {
    const changed = new Map(results.map((one) => [one.label, one]));
    const wanted = expected().filter((label) => !changed.has(label))
      .map((label) => session.view.vectors.find((one) => one.label === label)).filter(Boolean);
    const first = results.filter(({ label }) => expected().includes(label));
    const others = results.filter((one) => !first.includes(one));
    const all = [...first, ...wanted.map((one) => ({ ...one, differs: 0, changed: [] })), ...others];
    const list = session.view.step === 0 ? [] : all;
    $("results").hidden = list.length === 0;
    fill($("results"), list.slice(0, MAX).map(result),
      list.length > MAX && el("p", { class: "empty" }, `${some(list.length - MAX, "more label")} in the panel Memory`));
    if (session.view.step === 0) $("costliest").hidden = true;
  }

  function showCostliest(rows) {
    const line = session.view.ended && costliest(rows);
    $("costliest").hidden = !line;
    if (!line) return;
    const { clocks, percent, source } = line;
    fill($("costliest"), "Most clocks: ",
      el("button", { type: "button", class: "link", click: () => showLine(line.line) }, `line ${line.line}`),
      " ", el("code", {}, source.replace(/;.*/, "").replace(/\s+/g, " ").trim()),
      ` ${count(clocks)} of ${some(session.view.clock, "clock")} (${fixed(percent, 0)} %)`);
  }

  session.on("loaded", () => { $("results").hidden = $("costliest").hidden = true; });
  session.on("results", show);
  session.on("moved", ({ why }) => { ended = why === "end"; });
  session.on("profile", (rows) => {
    showCostliest(rows);
    if (ended) bringIntoSight($("outcome").parentNode);
    ended = false;
  });
}

// Scrolls a narrow page down to a panel, but not up.
function bringIntoSight(panel) {
  if (panel.getBoundingClientRect().bottom > innerHeight) panel.scrollIntoView({ block: "end" });
}

// Returns the line with the most clocks in all its forms. EXIT is not considered, because its
// clocks are those of the results that are not complete.
function costliest(rows) {
  const lines = new Map();
  for (const row of rows.filter(({ source }) => !/^([\w$.]+:\s*)*EXIT\b/i.test(source))) {
    const { clocks = 0, percent = 0 } = lines.get(row.line) ?? {};
    lines.set(row.line, { ...row, clocks: clocks + row.clocks, percent: percent + row.percent });
  }
  return [...lines.values()].sort((a, b) => b.clocks - a.clocks)[0];
}

function result({ label, kind, count: length, first, values, changed, differs }) {
  const last = first + values.length - 1;
  const range = first > 0 ? `elements ${count(first)} to ${count(last)} of ${count(length)}`
    : last + 1 < length ? `first ${count(last + 1)} of ${count(length)}` : "";
  return el("div", { class: "result-row" },
    el("code", {}, label),
    el("ol", { class: `cells${kind === "bits" ? " bits" : ""}` }, [...values].map((value, i) =>
      el("li", { class: changed[i] ? "changed" : null, title: `${label}, element ${count(first + i)}` }, value))),
    el("small", {}, differs === 0 ? "unchanged" : `${count(differs)} changed`, range && `, ${range}`));
}
