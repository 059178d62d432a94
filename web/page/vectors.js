// vectors.js - shows the data of the program, one row for each label. The bits of a control vector
// are next to the elements that they select.

import { count, el, fill, heading, some } from "./dom.js";

export function makeVectors(panel, session) {
  let chosen = null; // label of the selected control bits; "": none
  let shown = [];

  const bits = () => shown.filter(({ kind }) => kind === "bits");
  const control = () => chosen === "" ? undefined
    : bits().find(({ label }) => label === chosen) ?? bits()[0];

  function picker() {
    const select = el("select", { "aria-label": "Control bits of the elements",
      change: () => { chosen = select.value; show(); panel.querySelector("select").focus(); } },
    el("option", { value: "" }, "without control bits"),
    bits().map(({ label }) => el("option", { value: label, selected: control()?.label === label },
      `with the bits of ${label}`)));
    return select;
  }

  function show() {
    const top = panel.querySelector(".vectors")?.scrollTop ?? 0;
    fill(panel,
      heading("vectors", "Memory", bits().length > 0 ? picker() : null),
      shown.length === 0 ? el("p", { class: "empty" }, "The program declares no data.")
        : el("div", { class: "vectors scroll", tabindex: 0, role: "group",
          "aria-label": "Labels and their elements" },
          shown.map((one) => row(one, control(), () => session.showMoreElements()))));
    const scroll = panel.querySelector(".vectors");
    if (scroll) scroll.scrollTop = top;
  }

  session.on("loaded", (reply) => { if (reply.ok) chosen = null; });
  session.on("view", ({ vectors }) => { shown = vectors; show(); });
}

// Returns the row of a label: its name, its length, its elements, and a button that calls MORE.
function row(vector, control, more) {
  const { label, kind, count: length, first, values, stored } = vector;
  const controlBits = control && kind !== "bits" && control.count === length ? control.values : "";
  const changed = (i) => stored.some(({ first: from, count: n }) => i >= from && i < from + n);
  const cells = [...values].map((value, i) => {
    const bit = controlBits[i];
    const kinds = [changed(first + i) && "changed", bit === "0" && "masked"].filter(Boolean);
    return el("li", { class: kinds.join(" ") || null, title: `${label}, element ${first + i}` },
      bit && el("span", { class: `bit bit-${bit}` }, el("span", { class: "visually-hidden" }, "control bit "), bit),
      value);
  });
  const left = length - first - values.length;
  return el("div", { class: `vector${vector.changed ? " changed" : ""}` },
    el("div", { class: "vector-name" }, el("code", {}, label),
      el("small", {}, some(length, kind.replace(/s$/, "")))),
    el("div", {}, el("ol", { class: `cells${kind === "bits" ? " bits" : ""}` }, cells),
      left > 0 && el("button", { type: "button", class: "quiet", click: more },
        `${count(left)} more of ${label}`)));
}
