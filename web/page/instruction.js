// instruction.js - shows the last instruction: its time as a sum of terms, the reasons of its
// waits, and the sources of the constants.

import { colour, count, el, fill, heading, some } from "./dom.js";

// The sources of constants of the model (docs/timing.md).
const SOURCES = {
  P: "read in a primary source",
  S: "read in a secondary source",
  D: "derived from primary sources",
  R: "reconstructed, a prior to be fitted",
  F: "fitted to published times",
};

export function makeInstruction(panel, session) {
  session.on("view", ({ last, next }) => fill(panel,
    heading("instruction", "This instruction",
      last && `arrived at clock ${count(last.arrived)}, issued at ${count(last.issued)}`),
    last ? lastInstruction(last, sourceLine(session.text, last.line))
      : el("p", { class: "empty" }, "No instruction has been executed yet."),
    next && el("p", { class: "next" }, "Next: ", el("code", {}, next))));
}

// Returns a sum such as "7 memory wait + 1 issue". Each term is underlined in its colour.
function sum(parts, waits = true) {
  return parts.map(({ clocks, cause, wait }, i) => [i > 0 && " + ",
    el("span", { class: `term ${colour(cause)}` },
      el("span", {}, el("b", {}, count(clocks)), ` ${cause}`, waits && wait && `, ${wait}`))]);
}

// Returns a line of the program without its comment.
const sourceLine = (text, line) => text.split("\n")[line - 1]?.replace(/;.*/, "").trim().replace(/\s+/g, " ");

function lastInstruction(last, written) {
  const phases = last.phases.map(({ begin, end, cause }) => ({ clocks: end - begin, cause }));
  const work = last.phases.length > 0 && last.phases.at(-1).end - last.phases[0].begin;
  return [
    el("p", { class: "operation" }, el("code", { class: "text" }, written || last.text),
      written && el("code", {}, last.text),
      el("span", { class: "effect-of" }, last.effect)),
    el("p", { class: "formula" }, "The clock advanced by ", el("b", {}, some(last.clocks, "clock")),
      last.pieces.length > 0 && [" = ", sum(last.pieces)]),
    work && el("p", { class: "formula" }, "The vector unit works for ", el("b", {}, some(work, "clock")),
      " = ", sum(phases), last.elements > 0 && `, for ${some(last.elements, "element")}`,
      `, from ${count(last.phases[0].begin)} to ${count(last.phases.at(-1).end)}`),
    last.constants.length > 0 && el("ul", { class: "constants" }, last.constants.map(
      ({ name, value, unit, source }) => el("li", {}, el("code", {}, name), ` = ${value} ${unit}`,
        el("abbr", { class: "source-letter", title: SOURCES[source] }, source), SOURCES[source]))),
    last.in_flight?.length > 0 && el("p", { class: "formula" },
      "Until the last result was ready: ", sum(last.in_flight, false)),
  ];
}
