// laboratory.js - measures one or two programs for many values of a constant. It shows the rate in
// Mflop/s (clocks, if a program has no arithmetic), the straight line through the clocks, and
// n-half. The engine computes all figures.

import { choices, count, draw, el, fill, fixed, heading, some, table } from "./dom.js";
import { faultItem } from "./faults.js";

const POINTS = 25;
const WIDTH = 720, HEIGHT = 300, LEFT = 56, RIGHT = 96, TOP = 16, BOTTOM = 40;

export function makeLaboratory(panel, session, comparablePrograms) {
  let sweep = null;
  let names = [];
  let at = 0; // index of the selected point

  const first = el("select", { id: "lab-first" });
  const second = el("select", { id: "lab-second" });
  const field = (id, label, input) => el("div", { class: "field" }, el("label", { for: id }, label), input);
  const constant = el("input", { id: "lab-constant", value: "n", size: 8, spellcheck: "false" });
  const from = el("input", { id: "lab-from", type: "number", min: 1, value: 1 });
  const to = el("input", { id: "lab-to", type: "number", min: 2, max: 65535, value: 1000 });
  const warm = el("input", { id: "lab-warm", type: "checkbox", checked: true });
  const start = el("button", { type: "submit", class: "main" }, "Measure");
  const stop = el("button", { type: "button", hidden: true, click: () => session.stop() }, "Stop");
  const progress = el("p", { class: "note", role: "status" });
  const result = el("div", { class: "result" });

  fill(panel, el("section", { class: "panel", "aria-labelledby": "laboratory-heading" },
    heading("laboratory", "Laboratory: speed against length"),
    el("p", { class: "note" }, "A program is assembled and run for many values of one of its constants. ",
      "If the program defines a value of its own, put that between ", el("code", {}, ".ifndef n"),
      " and ", el("code", {}, ".endif"), "."),
    el("form", { class: "fields", submit: measure },
      field("lab-first", "Program", first), field("lab-second", "compared with", second),
      field("lab-constant", "constant", constant), field("lab-from", "from", from), field("lab-to", "to", to),
      field("lab-warm", "pages in memory", warm), el("div", { class: "field" }, start, stop)),
    progress, result));

  function updateLists() {
    choices(first, comparablePrograms());
    choices(second, [{ value: "", title: "no second program" }, ...comparablePrograms()]);
  }
  panel.addEventListener("focusin", (event) => {
    if (event.target === first || event.target === second) updateLists();
  });
  updateLists();

  async function measure(event) {
    event.preventDefault();
    if (session.busy) return;
    const pick = (value) => comparablePrograms().find((one) => one.value === value);
    const chosen = [pick(first.value), pick(second.value)].filter(Boolean);
    start.hidden = true;
    stop.hidden = false;
    progress.textContent = "Measuring ..";
    const reply = await session.runRequest({ do: "sweep", text: chosen[0].text,
      ...(chosen[1] && { other: chosen[1].text }), constant: constant.value.trim(),
      from: Number(from.value), to: Number(to.value), points: POINTS, model: session.model,
      warm: warm.checked },
    ({ part }) => { progress.textContent = `Measuring .. ${Math.round(100 * part)} %`; });
    start.hidden = false;
    stop.hidden = true;
    if (!reply.ok || reply.stopped) {
      progress.textContent = reply.error ?? "Stopped.";
      fill(result, reply.diagnostics && el("ul", { class: "faults" },
        reply.diagnostics.map((fault) => faultItem(fault, null))));
      return;
    }
    progress.textContent = "";
    sweep = reply;
    names = chosen.map(({ title }) => title);
    at = Math.floor(reply.points.length / 2);
    show();
  }

  // Returns true if a point has a rate.
  const rated = () => sweep.points.some((point) => series().some((one) => point[`${one}mflops`] > 0));
  const steady = () => sweep.points.length > 1
    && series().every((one) => new Set(sweep.points.map((point) => point[`${one}clocks`])).size === 1);

  // Prefixes of the figures, as in c205 sweep: "first_" and "second_" for two programs.
  const series = () => names.length > 1 ? ["first_", "second_"] : [""];

  function show() {
    const slider = el("input", { type: "range", id: "lab-at", min: 0, max: sweep.points.length - 1, value: at,
      input: () => { at = Number(slider.value); mark(); } });
    const reading = el("output", { for: "lab-at", class: "reading" });
    const chart = el("div", { class: "chart" });
    const mark = () => {
      fill(chart, drawing());
      const point = sweep.points[at];
      fill(reading, el("b", {}, `${sweep.constant} = ${count(point.value)}`), ...series().map((one, i) =>
        el("span", {}, el("i", { class: `patch series-${i}`, "aria-hidden": "true" }),
          some(point[`${one}clocks`], "clock"),
          rated() && `, ${fixed(point[`${one}mflops`], 1)} Mflop/s`)));
      slider.setAttribute("aria-valuetext", `${sweep.constant} = ${point.value}`);
    };
    fill(result,
      el("p", { class: "legend" }, names.map((name, i) => el("span", {},
        el("i", { class: `patch series-${i}`, "aria-hidden": "true" }), name))),
      chart, el("div", { class: "field slide" }, el("label", { for: "lab-at" }, sweep.constant), slider), reading,
      steady() && el("p", { class: "steady" }, `The clocks are the same for every ${sweep.constant}: `
        + "check that the program uses this constant."),
      ...(sweep.crossings ?? []).map(crossing), lines(),
      el("details", {}, el("summary", {}, "All points"), points()));
    mark();
  }

  // Names the program that is faster from this value of the constant on.
  function crossing({ value, faster, first_clocks: a, second_clocks: b }) {
    const [mine, other] = faster === "first" ? [0, 1] : [1, 0];
    return el("p", {}, `From ${sweep.constant} = ${count(value)} on ${names[mine]} is faster: `
      + `${some([a, b][mine], "clock")}, and ${names[other]} ${count([a, b][other])}.`);
  }

  function lines() {
    return table("The straight line through the clocks",
      [["program"], ["start-up, clk", "number"], [`clk/${sweep.constant}`, "number"],
        ...(rated() ? [["r∞, Mflop/s", "number"]] : []), ["n½", "number"], ["off, %", "number"]],
      sweep.lines.map((line, i) => ({ cells: [
        [el("i", { class: `patch series-${i}`, "aria-hidden": "true" }), names[i]], fixed(line.startup, 1),
        fixed(line.per_element, 4), ...(rated() ? [fixed(line.mflops, 2)] : []), fixed(line.n_half, 1),
        fixed(line.off_percent, 2)] })));
  }

  function points() {
    return table("All points", [[sweep.constant, "number"],
      ...names.flatMap((name) => [[`${name}, clk`, "number"], ...(rated() ? [["Mflop/s", "number"]] : [])])],
    sweep.points.map((point) => ({ cells: [count(point.value), ...series().flatMap((one) =>
      [count(point[`${one}clocks`]), ...(rated() ? [fixed(point[`${one}mflops`], 2)] : [])])] })));
  }

  // Draws Mflop/s or clocks as a function of the constant, whose axis is logarithmic.
  function drawing() {
    const { points } = sweep;
    const [low, high] = [points[0].value, points.at(-1).value];
    const [key, unit] = rated() ? ["mflops", "Mflop/s"] : ["clocks", "clocks"];
    const heights = points.flatMap((point) => series().map((one) => point[`${one}${key}`]));
    const top = 1.08 * Math.max(...heights);
    const x = (n) => LEFT + (WIDTH - LEFT - RIGHT) * Math.log(n / low) / Math.log(high / low || 2);
    const y = (rate) => HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * rate / top;
    const text = (px, py, kind, words) => draw("text", { x: px, y: py, class: kind }, words);
    const svg = draw("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img",
      "aria-label": `${unit} of ${names.join(" and ")} against ${sweep.constant}` });

    for (let power = 1; power <= high; power *= 10)
      for (const n of [power, 2 * power, 5 * power].filter((one) => one >= low && one <= high))
        svg.append(draw("line", { x1: x(n), x2: x(n), y1: TOP, y2: HEIGHT - BOTTOM, class: "tick" }),
          text(x(n), HEIGHT - BOTTOM + 16, "clock", count(n)));
    const rough = 10 ** Math.floor(Math.log10(top / 4));
    const step = [1, 2, 5, 10].map((by) => by * rough).find((by) => top / by <= 6);
    for (let rate = 0; rate <= top; rate += step)
      svg.append(draw("line", { x1: LEFT, x2: WIDTH - RIGHT, y1: y(rate), y2: y(rate), class: "tick" }),
        text(LEFT - 8, y(rate) + 4, "lane", count(Number(rate.toPrecision(6)))));
    svg.append(text(LEFT, HEIGHT - 6, "axis", `${sweep.constant} →`),
      text(LEFT + 6, TOP + 2, "axis", unit));

    const here = points[at].value;
    svg.append(draw("line", { x1: x(here), x2: x(here), y1: TOP, y2: HEIGHT - BOTTOM, class: "now" }));
    series().forEach((one, i) => {
      const rate = (point) => point[`${one}${key}`];
      svg.append(draw("polyline", { class: `curve curve-${i}`,
        points: points.map((point) => `${x(point.value)},${y(rate(point))}`).join(" ") }),
      draw("circle", { cx: x(here), cy: y(rate(points[at])), r: 4, class: `dot dot-${i}` }));
      const half = sweep.lines[i]?.n_half;
      if (rated() && half > low && half < high)
        svg.append(draw("line", { x1: x(half), x2: x(half), y1: y(sweep.lines[i].mflops / 2), y2: HEIGHT - BOTTOM, class: `half half-${i}` }),
          text(x(half) + 6, y(sweep.lines[i].mflops / 2) + 14, "half-name", `n½ = ${fixed(half, 0)}`));
    });
    return svg;
  }

  return { updateLists };
}
