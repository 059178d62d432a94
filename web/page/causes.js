// causes.js - where the clocks went: a bar and a table of causes, and the regions.

import { colour, count, draw, el, fixed, heading, table } from "./dom.js";

/** A bar of {cause, clocks}, each as wide as its share. */
export function bar(causes) {
  const all = causes.reduce((sum, { clocks }) => sum + clocks, 0);
  let at = 0;
  const parts = causes.filter(({ clocks }) => clocks > 0).map(({ cause, clocks }) => {
    const x = 100 * at / all;
    at += clocks;
    return draw("rect", { x: `${x}%`, y: 0, width: `${100 * clocks / all}%`, height: "100%",
      class: colour(cause) }, draw("title", {}, `${cause}: ${count(clocks)} clocks`));
  });
  return draw("svg", { class: "bar-of-causes", "aria-hidden": "true" }, parts);
}

/** The name of a cause, behind a patch of its colour. */
export const named = (cause) => el("span", { class: "cause" },
  el("i", { class: `patch ${colour(cause)}`, "aria-hidden": "true" }), cause);

export function makeCauses(panel, session) {
  session.on("view", ({ accounts }) => {
    const causes = accounts.causes.filter(({ clocks }) => clocks > 0);
    const regions = accounts.regions ?? [];
    panel.replaceChildren(
      heading("causes", "Where the clocks went"),
      ...(causes.length === 0 ? [el("p", { class: "empty" }, "No clock has passed yet.")] : [
        bar(causes),
        table("Clocks by cause",
          [["cause"], ["clocks", "number"], ["%", "number"]],
          [...causes.map(({ cause, clocks, percent }) => ({
            cells: [named(cause), count(clocks), fixed(percent, 1)] })),
          { class: "sum", cells: ["all", count(accounts.clocks), "100.0"] }]),
        regions.length < 2 ? null : table("Clocks by region",
          [["region"], ["instr.", "number"], ["vector", "number"], ["elements", "number"],
            ["clocks", "number"]],
          regions.map((row) => ({ cells: [row.region, count(row.instructions),
            count(row.vector), count(row.elements), count(row.clocks)] }))),
        el("p", { class: "figures" },
          figure(fixed(accounts.mflops, 1), "Mflop/s"),
          figure(fixed(accounts.mean_length, 1), "mean vector length")),
      ].filter(Boolean)));
  });
}

const figure = (value, what) => el("span", {}, el("b", {}, value), ` ${what}`);
