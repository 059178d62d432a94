// compare.js - two programs side by side, and the one or two causes that make the
// difference, in words.

import { choices, count, el, fixed, heading, table } from "./dom.js";
import { named } from "./causes.js";

export function makeCompare(panel, session, others) {
  const first = el("select", { id: "compare-first" });
  const second = el("select", { id: "compare-second" });
  const result = el("div", { class: "result", role: "group", "aria-live": "polite", "aria-label": "Result" });
  panel.replaceChildren(el("section", { class: "panel", "aria-labelledby": "compare-heading" },
    heading("compare", "Two programs side by side"),
    el("form", { class: "fields", submit: (event) => { event.preventDefault(); run(); } },
      el("div", { class: "field" }, el("label", { for: "compare-first" }, "First"), first),
      el("div", { class: "field" }, el("label", { for: "compare-second" }, "second"), second),
      el("div", { class: "field" }, el("button", { type: "submit", class: "main" }, "Compare"),
        el("button", { type: "button", click: keep }, "Keep my program for later"))),
    result));

  function offer() {
    const list = others();
    const [one, two] = [first.value, second.value];
    choices(first, list);
    choices(second, list);
    const has = (value) => list.some((entry) => entry.value === value);
    first.value = has(one) && one ? one : list[1]?.value ?? list[0].value;
    second.value = has(two) && two ? two : list[0].value;
  }

  function keep() {
    session.keep();
    offer();
    result.replaceChildren(el("p", {}, "Kept: it stands in both lists as “kept”."));
  }

  async function run() {
    if (session.busy) return;
    offer();
    const list = others();
    const chosen = [first, second].map(({ value }) => list.find((one) => one.value === value));
    const reply = await session.longer({ do: "compare", ...session.setting,
      texts: chosen.map(({ title, text }) => ({ name: title, text })) });
    result.replaceChildren(...(reply.ok && !reply.stopped ? told(reply, chosen)
      : [el("p", { class: "fault" }, reply.error ?? "Stopped.")]));
  }

  function told(reply, chosen) {
    const beside = (caption, key, rows, name, places) => table(caption,
      [[key], [chosen[0].title, "number"], [chosen[1].title, "number"], ["difference", "number"], ["ratio", "number"]],
      rows.map((row) => ({ class: row[key] === "all" ? "sum" : null, cells: [name(row[key]),
        fixed(row.first, places), fixed(row.second, places),
        row.difference === undefined ? fixed(row.second - row.first, places) : count(row.difference),
        row.ratio == null ? "-" : fixed(row.ratio, 3)] })));
    return [
      el("p", { class: "verdict-words" }, reply.sentence),
      beside("Clocks by cause", "cause", reply.causes.filter(({ first: a, second: b }) => a || b),
        (cause) => cause === "all" ? cause : named(cause), 0),
      reply.regions.length > 1 && beside("Clocks by region", "region", reply.regions, String, 0),
      beside("Figures", "figure", reply.figures, String, 2),
    ].filter(Boolean);
  }

  offer();
  return { offer, run };
}
