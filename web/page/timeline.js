// timeline.js - shows the work of each unit at each clock. The top row shows the cause of each
// clock. Each unit has a lane below it. A click on an instruction goes to it. The keys + and -, and
// the arrow keys, change the visible range.

import { colour, count, draw, duration, el, fill, some } from "./dom.js";
import { named } from "./causes.js";

const MAX = 600; // maximum number of instructions in the drawing
const BOX = 17, GAP = 6, TOP = 22, LEFT = 122; // sizes in pixels
const COLUMN = 2, SHARES = 120; // width of a column, and height of the shares of the causes
const FIRST = 240; // initial range in clocks
const MIN_RANGE = 16; // shortest range in clocks

export function makeTimeline(panel, session) {
  let from = 0;
  let to = FIRST;
  let automatic = true; // the user has not selected a range; a short run is shown completely
  let timeline = null; // the reply of the engine
  let turn = 0;

  const aside = el("p", { class: "aside" });
  const picture = el("div", { class: "picture", tabindex: 0, role: "img", keydown: keys });
  const legend = el("ul", { class: "legend", "aria-label": "Colours of the causes" });
  const note = el("p", { class: "note", hidden: true });
  const button = (text, name, click) =>
    el("button", { type: "button", class: "quiet", "aria-label": name, title: name, click }, text);
  fill(panel,
    el("div", { class: "heading" }, el("h2", { id: "timeline-heading" }, "Time line"), aside,
      el("div", { class: "zoom" },
        button("←", "Earlier", () => shift(-0.5)), button("→", "Later", () => shift(0.5)),
        button("−", "Zoom out", () => zoom(2)), button("+", "Zoom in", () => zoom(0.5)),
        button("All", "All of the run", all))),
    picture, note, legend);

  function keys(event) {
    const act = { ArrowLeft: () => shift(-0.25), ArrowRight: () => shift(0.25), "+": () => zoom(0.5),
      "=": () => zoom(0.5), "-": () => zoom(2), Home: all }[event.key];
    if (!act || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    act();
  }

  const clock = () => session.view?.clock ?? 0;

  function zoom(by) {
    const length = Math.max(Math.round((to - from) * by), MIN_RANGE);
    const middle = clock() >= from && clock() <= to ? clock() : (from + to) / 2;
    const share = (middle - from) / (to - from);
    setRange(Math.round(middle - share * length), length);
  }

  const shift = (by) => setRange(from + Math.round((to - from) * by), to - from);

  function setRange(begin, length) {
    automatic = false;
    from = Math.max(begin, 0);
    to = from + length;
    update();
  }

  function all() {
    automatic = true;
    from = 0;
    to = Math.max(clock(), MIN_RANGE);
    update();
  }

  // Moves the range to the current clock.
  function follow() {
    if (automatic && clock() <= 2 * FIRST) {
      from = 0;
      to = Math.max(clock(), 2 * MIN_RANGE);
    } else if (clock() > to || clock() < from || (automatic && to - from > 2 * FIRST)) {
      const length = automatic ? FIRST : to - from;
      from = Math.max(Math.round(clock() - 0.9 * length), 0);
      to = from + length;
    }
  }

  async function update() {
    const mine = ++turn;
    const columns = Math.min(Math.floor(plotWidth() / COLUMN), to - from);
    const reply = await session.idleRequest({ do: "timeline", from, to, most: MAX, columns }, () => mine === turn);
    if (!reply?.ok) return;
    timeline = reply;
    show();
  }

  function showClock() {
    aside.textContent = `${some(clock(), "clock")} = ${duration(session.view?.microseconds ?? 0)}`;
  }

  function show() {
    if (!timeline) return picture.replaceChildren();
    picture.setAttribute("aria-label",
      `${timeline.shares ? "Shares of the causes" : some(timeline.insns.length, "instruction")} from clock ${count(from)} to ${count(to)}`);
    picture.replaceChildren(drawing());
    const causes = new Set((timeline.shares ?? timeline.spans).map(({ cause }) => cause).filter(Boolean));
    fill(legend, ...[...causes].map((cause) => el("li", {}, named(cause))));
    note.hidden = !timeline.full;
    note.textContent = `More than ${MAX} instructions: each column shows the shares of the causes. Zoom in to see the instructions.`;
  }

  const pictureWidth = () => Math.max(picture.clientWidth, 320);
  const plotWidth = () => pictureWidth() - LEFT - 8;

  // Draws a column for each few clocks. A cause is one path of boxes, which are above those of the
  // earlier causes.
  function drawShares(svg) {
    const [{ clocks: { length } }] = timeline.shares;
    const wide = plotWidth() / length, scale = SHARES / ((to - from) / length);
    const below = new Float64Array(length);
    for (const { cause, clocks } of timeline.shares) {
      const boxes = clocks.map((n, i) => {
        if (n === 0) return "";
        below[i] += n * scale;
        return `M${(LEFT + i * wide).toFixed(2)} ${(TOP + SHARES - below[i]).toFixed(2)}h${wide.toFixed(2)}v${(n * scale).toFixed(2)}h${(-wide).toFixed(2)}z`;
      });
      svg.append(draw("path", { d: boxes.join(""), class: colour(cause) }, draw("title", {}, cause)));
    }
    svg.append(draw("text", { x: LEFT - 10, y: TOP + 12, class: "lane" }, "charged to"));
  }

  function drawing() {
    const width = pictureWidth();
    const tops = [];
    let height = timeline.shares ? TOP + SHARES + GAP : TOP;
    for (const { rows } of timeline.lanes ?? []) {
      tops.push(height);
      height += Math.max(rows, 1) * (BOX + 2) + GAP;
    }
    const x = (at) => LEFT + plotWidth() * (Math.min(Math.max(at, from), to) - from) / (to - from);
    const svg = draw("svg", { width, height, viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" });
    const upright = (at, kind) =>
      draw("line", { x1: x(at), x2: x(at), y1: TOP - 4, y2: height - GAP, class: kind });

    for (const at of ticks(from, to, (width - LEFT) / 70))
      svg.append(upright(at, "tick"), draw("text", { x: x(at), y: TOP - 9, class: "clock" }, count(at)));
    if (timeline.shares?.length > 0) drawShares(svg);
    timeline.lanes?.forEach(({ name }, i) => svg.append(
      draw("text", { x: LEFT - 10, y: tops[i] + BOX - 4, class: "lane" }, name)));
    for (const span of timeline.spans ?? []) {
      const insn = timeline.insns[span.insn];
      const mnemonic = insn.text.split(/\s/)[0];
      const y = tops[span.lane] + span.row * (BOX + 2);
      const wide = x(span.end) - x(span.begin);
      svg.append(draw("g", { class: "insn", click: () => session.go("clock-to", insn.arrived + 1) },
        draw("rect", { x: x(span.begin), y, width: Math.max(wide, 1), height: BOX, rx: Math.min(2, wide / 4),
          class: span.cause ? colour(span.cause) : "work" },
        draw("title", {}, words(span, insn))),
        span.lane > 0 && wide > 7.5 * mnemonic.length + 8
          && draw("text", { x: x(span.begin) + 5, y: y + BOX - 5, class: "name" }, mnemonic)));
    }
    if (clock() >= from && clock() <= to) svg.append(upright(clock(), "now"));
    return svg;
  }

  session.on("loaded", () => { automatic = true; from = 0; to = FIRST; timeline = null; show(); });
  session.on("view", () => { follow(); showClock(); update(); });
  new ResizeObserver(() => { if (timeline && picture.clientWidth > 0) show(); }).observe(picture);
}

// Returns the tooltip of a box.
const words = ({ cause = "active", begin, end }, { text, source, arrived, issued, ready }) =>
  [`${cause}: ${some(end - begin, "clock")}, ${begin} .. ${end}`, text, ...(source ? [source] : []),
    `arrived ${arrived}, issued ${issued}, result ${ready}`].join("\n");

// Returns at most about MAX_COUNT round numbers between two clocks.
function ticks(from, to, maxCount) {
  const minStep = (to - from) / Math.max(maxCount, 2);
  const power = 10 ** Math.floor(Math.log10(Math.max(minStep, 1)));
  const step = [1, 2, 5, 10].map((by) => by * power).find((by) => by >= minStep) ?? power;
  const found = [];
  for (let at = Math.ceil(from / step) * step; at <= to; at += step) found.push(at);
  return found;
}
