// tracer.js - the panel of the ray tracer. It draws a scene, and shows the finished rows and their
// clocks. rt205 computes all figures.

import { bar, named } from "./causes.js";
import { choices, count, duration, el, fill, fixed, heading, table } from "./dom.js";

const OWN = "own"; // key of the learner's scene
const SCENE = "scenes/bracket.pov";
const SIZES = [[80, 60], [160, 120], [320, 240], [640, 480]];
const STAGES = [["vector", "vector: a queue of rays at a time"], ["scalar", "scalar: ray by ray"],
  ["kernels", "kernels: as in the paper of 1984"]];
const QUEUE = 2000, MAX_QUEUE = 65535; // in rays
const MODEL = "cyber205-2pipe";
const PAPER = [400, 250], SMALL = [80, 50]; // rays of Table 1: as in the paper, and for a quick
                                            // measurement with two queues
const ALL = "all";
// Rows of Table 1: the name, and a pattern that counts its objects in a scene.
const ROWS = [["sphere", /\bsphere\b/g], ["cylinder", /\bcylinder\b/g],
  ["Steiner", /\bsteiner\w*/gi], ["torus", /\btorus\b/g]];

/** rt205 in a worker. The first run starts the worker; a stop terminates it. */
class Tracer {
  #source; #wasm; #bytes; #worker; #end;

  constructor(source, wasm) {
    this.#source = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.#wasm = wasm;
  }

  /** Returns { code, files, stdout, stderr }, { stopped } or { lost }. ONMESSAGE receives all
   * messages before the end. */
  async run(args, files, onMessage) {
    const wasm = await (this.#bytes ??= this.#wasm());
    return new Promise((resolve) => {
      this.#end = resolve;
      if (!this.#worker) {
        this.#worker = new Worker(this.#source);
        this.#worker.postMessage({ wasm });
      }
      this.#worker.onmessage = ({ data }) => {
        if (data.ended) resolve(data.ended);
        else if (data.lost) this.stop({ lost: data.lost });
        else onMessage(data);
      };
      this.#worker.onerror = ({ message }) => this.stop({ lost: message });
      this.#worker.postMessage({ args, files });
    });
  }

  stop(how = { stopped: true }) {
    this.#worker?.terminate();
    this.#worker = null;
    this.#end?.(how);
  }
}

/**
 * Creates the panel. source is the text of the worker. wasm returns a promise of the bytes of rt205
 * and is called at the first run. scenes is { files: texts by path, list: [{ path, title }] }.
 * models is [{ name, title }], the models on which programs run.
 */
export function tracerPanel(panel, { source, wasm, scenes, models }) {
  const tracer = new Tracer(source, wasm);
  let busy = false;
  let picture = null; // URL of the current picture

  const field = (id, label, input) => el("div", { class: "field" }, el("label", { for: id }, label), input);
  const scene = el("select", { id: "tracer-scene", change: () => show(scene.value) });
  const stage = el("select", { id: "tracer-stage", change: () => { queue.disabled = stage.value === "scalar"; } });
  const queue = el("input", { id: "tracer-queue", type: "number", min: 1, max: MAX_QUEUE, value: QUEUE, required: true });
  const model = el("select", { id: "tracer-model" });
  const size = el("select", { id: "tracer-size" });
  // Returns the start and stop buttons, the status text and the progress bar of a run.
  const work = (words, kind, name) => ({
    start: el("button", { type: "submit", class: kind }, words),
    stop: el("button", { type: "button", hidden: true, click: () => tracer.stop() }, "Stop"),
    status: el("p", { class: "note", role: "status" }),
    part: el("progress", { max: 1, value: 0, "aria-label": name }) });
  const drawing = work("Draw", "main", "Finished part of the picture");
  const measuring = work("Measure", null, "Finished part of the table");
  const text = el("textarea", { id: "tracer-text", rows: 16, spellcheck: "false", "aria-label": "Text of the scene",
    input: () => { scene.value = OWN; row.value = rowOf(text.value); } });
  const canvas = el("canvas", { width: 160, height: 120, role: "img", "aria-label": "The picture" });
  const save = el("a", { class: "button", download: "picture.png", hidden: true }, "Download picture");
  const clocks = el("div", { class: "clocks" });
  const output = el("pre", { tabindex: 0, role: "group", "aria-label": "Output of rt205", hidden: true });
  const row = el("select", { id: "tracer-row" });
  const result = el("div", { class: "result" });

  choices(scene, [...scenes.list.map(({ path, title }) => ({ value: path, title })),
    { value: OWN, title: "my own scene" }]);
  choices(stage, STAGES.map(([value, title]) => ({ value, title })));
  choices(model, models.map(({ name, title }) => ({ value: name, title: title ?? name })));
  choices(row, [...ROWS.map(([name]) => ({ value: name, title: name })), { value: ALL, title: "all rows" }]);
  choices(size, SIZES.map(([across, down]) => ({ value: `${across}x${down}`, title: `${across} × ${down}` })));
  model.value = MODEL;
  size.value = "160x120";
  scene.value = scenes.list.some(({ path }) => path === SCENE) ? SCENE : scenes.list[0].path;
  show(scene.value);

  fill(panel, el("section", { class: "panel", "aria-labelledby": "tracer-heading" },
    heading("tracer", "Ray tracer: a picture computed by the machine"),
    el("p", { class: "note" }, "Programs of the 205 trace every ray. The picture shows the contents of the ",
      "machine's memory, and each clock is charged to a cause."),
    el("form", { class: "fields", submit: draw },
      field("tracer-scene", "Scene", scene), field("tracer-stage", "stage", stage),
      field("tracer-queue", "queue, rays", queue), field("tracer-model", "model", model),
      field("tracer-size", "size", size),
      el("div", { class: "field" }, drawing.start, drawing.stop)),
    el("details", {}, el("summary", {}, "Text of the scene"), text),
    drawing.status,
    el("div", { class: "pair" },
      el("div", { class: "drawn" }, canvas, drawing.part, el("p", {}, save)), clocks),
    output,
    el("h3", {}, "The paper's Table 1"),
    el("p", { class: "note" }, `A single row is measured with the paper's ${count(PAPER[0] * PAPER[1])} rays, `,
      `all rows together with ${count(SMALL[0] * SMALL[1])}; with the queue and the model above.`),
    el("form", { class: "fields", submit: measure }, field("tracer-row", "Row", row),
      el("div", { class: "field" }, measuring.start, measuring.stop)),
    measuring.status, measuring.part, result));
  measuring.part.hidden = true;

  function show(path) {
    if (path === OWN) return;
    text.value = scenes.files[path];
    row.value = rowOf(text.value);
  }

  const options = () => ["--model", model.value, ...(stage.value === "scalar" ? [] : ["--queue", queue.value])];

  // Runs rt205 to its end. Returns null if another run is active.
  async function run({ start, stop, status, part }, args, files, words, rows) {
    if (busy) return null;
    const otherButtons = [drawing.start, measuring.start].filter((one) => one !== start);
    const setBusy = (isBusy) => {
      busy = start.hidden = isBusy;
      stop.hidden = !isBusy;
      part.hidden = false;
      for (const other of otherButtons) other.disabled = isBusy;
    };
    const focused = document.activeElement;
    setBusy(true);
    if (focused === start) stop.focus();
    status.textContent = words;
    part.value = 0;
    const ended = await tracer.run([...args, "--jobs", "1"], files, ({ view, part: done }) => {
      if (view) rows?.(view);
      else part.value = done;
    });
    const last = document.activeElement;
    setBusy(false);
    if (last === stop) start.focus();
    if (ended.code === 0) part.value = 1;
    status.textContent = ended.lost ? `rt205 has failed: ${ended.lost}.` : ended.stopped ? "Stopped."
      : ended.code === 0 ? "Done." : "rt205 failed. Its output gives the reason.";
    return ended;
  }

  async function draw(event) {
    event.preventDefault();
    const [across, down] = size.value.split("x");
    const path = scene.value === OWN ? "my.pov" : scene.value;
    clear(Number(across), Number(down));
    const ended = await run(drawing, ["render", path, "-o", "picture.png", "-W", across, "-H", down, "--accounts",
      "--mode", stage.value, ...options()], { ...scenes.files, [path]: text.value }, "Drawing ..", showRows);
    if (!ended) return;
    output.textContent = (ended.stderr ?? "") + (ended.stdout ?? "");
    output.hidden = output.textContent === "";
    if (ended.code === 0) setDownload(ended.files["picture.png"]);
  }

  function clear(across, down) {
    canvas.width = across;
    canvas.height = down;
    output.hidden = save.hidden = true;
    fill(clocks);
  }

  function showRows({ width, rows, first, rgba, clocks: sum, seconds, causes }) {
    const list = Object.entries(causes).map(([cause, of]) => ({ cause, clocks: of }));
    canvas.getContext("2d").putImageData(new ImageData(rgba, width, rows), 0, first);
    fill(clocks, el("p", { class: "figures" }, el("span", {}, el("b", {}, count(sum)), sum === 1 ? " clock," : " clocks,"),
      el("span", {}, el("b", {}, duration(1e6 * seconds)), " on the machine")),
    bar(list),
    table("Clocks by cause so far", [["cause"], ["clocks", "number"], ["%", "number"]],
      list.map(({ cause, clocks: of }) => ({ cells: [named(cause), count(of), fixed(100 * of / sum, 1)] }))));
  }

  function setDownload(bytes) {
    URL.revokeObjectURL(picture);
    picture = URL.createObjectURL(new Blob([bytes], { type: "image/png" }));
    save.href = picture;
    save.hidden = false;
  }

  // Measures Table 1 of the paper. The result has a row for each primitive and each kind of figure.
  async function measure(event) {
    event.preventDefault();
    const all = row.value === ALL;
    const [across, down] = all ? SMALL : PAPER;
    const ended = await run(measuring, ["speedup", ...(all ? [] : [row.value]), "-W", across, "-H", down,
      "--format", "json", "--queue", queue.value, "--model", model.value].map(String),
      {}, `Measuring ${all ? "Table 1" : row.value} with ${count(across * down)} rays ..`);
    if (!ended) return;
    if (ended.code !== 0) return void fill(result, ended.stderr && el("pre", { class: "fault" }, ended.stderr));
    fill(result, el("div", { class: "scroll", tabindex: 0, role: "group", "aria-label": "Table 1" },
      table(`Table 1, a queue of ${queue.value}`,
        [["primitive"], ["figures"], ["205 scalar, s", "number"], ["205 vector, s", "number"], ["720, s", "number"],
          ["over scalar", "number"], ["over 720", "number"]],
        JSON.parse(ended.stdout).table1.map((one) => ({ cells: cellsOfTable1(one) })))),
    el("p", { class: "note" }, `CPU seconds for ${count(PAPER[0] * PAPER[1])} rays, of which ${count(across * down)} `
      + "were traced, and how much faster the vector form of the 205 is."));
  }
}

/** Returns the cells of a row of Table 1, with the same digits as in rt205 speedup. */
export function cellsOfTable1(row) {
  const places = { scalar: 3, vector: 4, cyber720: 2, vector_over_scalar: 2, vector_over_720: 0 };
  const error = row.figures.endsWith("%"); // if the figures are errors, all cells are percentages
  return [row.primitive, row.figures, ...Object.entries(places).map(([key, n]) =>
    row[key] == null ? "-" : fixed(row[key], error ? 1 : n, error))];
}

// Returns the row with the most matches in the scene, or the first row without any match.
function rowOf(text) {
  const found = ROWS.map(([name, words]) => ({ name, times: text.match(words)?.length ?? 0 }));
  return found.reduce((best, one) => one.times > best.times ? one : best).name;
}
