// causes.js - shows the clocks of a run: a bar and a table by cause, and a table by region.

import { colour, count, draw, el, fill, fixed, heading, some, table } from "./dom.js";

/** Returns a stacked bar of {cause, clocks}. The width of a part is proportional to its clocks. */
export function bar(causes) {
  const all = causes.reduce((sum, { clocks }) => sum + clocks, 0);
  let at = 0;
  const parts = causes.filter(({ clocks }) => clocks > 0).map(({ cause, clocks }) => {
    const x = 100 * at / all;
    at += clocks;
    return draw("rect", { x: `${x}%`, y: 0, width: `${100 * clocks / all}%`, height: "100%",
      class: colour(cause) }, draw("title", {}, `${cause}: ${some(clocks, "clock")}`));
  });
  return draw("svg", { class: "bar-of-causes", "aria-hidden": "true" }, parts);
}

/** Returns the name of a cause with a patch of its colour. */
export const named = (cause) => el("span", { class: "cause" },
  el("i", { class: `patch ${colour(cause)}`, "aria-hidden": "true" }), cause);

const figure = (value, what) => el("span", {}, el("b", {}, value), ` ${what}`);

export function makeCauses(panel, session) {
  session.on("view", ({ accounts }) => fill(panel, heading("causes", "Where the clocks went"),
    accounts.clocks === 0 ? el("p", { class: "empty" }, "No clock has passed yet.") : accountTables(accounts)));
}

function accountTables({ causes, regions, clocks, mflops, mean_length: meanLength }) {
  return [
    bar(causes),
    table("Clocks by cause", [["cause"], ["clocks", "number"], ["%", "number"]], [
      ...causes.map((row) => ({ cells: [named(row.cause), count(row.clocks), fixed(row.percent, 1)] })),
      { class: "sum", cells: ["all", count(clocks), fixed(100, 1)] }]),
    regions.length > 1 && table("Clocks by region",
      [["region"], ...["instr.", "vector", "elements", "clocks"].map((title) => [title, "number"])],
      regions.map((row) => ({ cells: [row.region,
        ...[row.instructions, row.vector, row.elements, row.clocks].map(count)] }))),
    el("p", { class: "figures" }, mflops > 0 && figure(fixed(mflops, 2), "Mflop/s"),
      meanLength > 0 && figure(fixed(meanLength, 1), "mean vector length")),
  ];
}
