// raytracer.js - the ray tracer: a scene, how its rays are traced, the picture as its
// bands come, and what rt205 itself says of the clocks.

import { choices, count, duration, el, fill, fixed, heading, table } from "./dom.js";
import { bar, named } from "./causes.js";

const SIZES = ["80x60", "160x120", "320x240", "640x480"];
const STAGES = [["vector", "all in vector form"], ["kernels", "kernels in vector form, as in 1984"],
  ["scalar", "all in scalar form"]];
const TABLE = ["speedup", "-W", "80", "-H", "50"]; // 4,000 rays a primitive, for 100,000

/** SOURCE: text of the worker; BYTES: gives a promise of rt205.wasm. */
export function makeRaytracer(panel, { scenes, includes, models, model, source, bytes }) {
  let worker = null;
  let wasm = null;
  let said = "";

  const select = (id, list, value) => {
    const node = el("select", { id });
    choices(node, list.map(([one, title]) => ({ value: one, title })));
    node.value = value;
    return node;
  };
  const field = (label, input) => el("div", { class: "field" }, el("label", { for: input.id }, label), input);
  const scene = select("rt-scene", [...scenes.map(({ name, title }) => [name, title]), ["", "one of my own"]], "bracket.pov");
  const stage = select("rt-stage", STAGES, "vector");
  const size = select("rt-size", SIZES.map((one) => [one, one.replace("x", " × ")]), SIZES[1]);
  const machine = select("rt-model", models.map((one) => [one.name, one.title]), model);
  const queue = el("input", { id: "rt-queue", type: "number", min: 1, max: 65535, value: 2000 });
  const text = el("textarea", { id: "rt-text", rows: 12, spellcheck: "false", "aria-label": "Text of the scene" });
  const trace = el("button", { type: "submit", class: "main" }, "Trace");
  const paper = el("button", { type: "button", click: () => start(TABLE, {}) }, "Table 1");
  const stop = el("button", { type: "button", hidden: true, click: () => end("Stopped.") }, "Stop");
  const canvas = el("canvas", { width: 160, height: 120, role: "img", "aria-label": "The picture" });
  const status = el("p", { class: "note", role: "status" });
  const clocks = el("div", { class: "clocks-so-far" });
  const output = el("pre", { class: "accounts", tabindex: 0, role: "group", "aria-label": "What rt205 says" });

  scene.addEventListener("change", show);
  fill(panel, el("section", { class: "panel", "aria-labelledby": "raytracer-heading" },
    heading("raytracer", "Ray tracer", "every ray is traced by programs of the emulated machine"),
    el("form", { class: "fields", submit: render },
      field("Scene", scene), field("Form", stage), field("Queue", queue), field("Size", size),
      field("Model", machine), el("div", { class: "field" }, trace, stop, paper)),
    el("details", {}, el("summary", {}, "Text of the scene"), text),
    status, el("div", { class: "tracing" }, canvas, clocks), output));
  show();

  function show() {
    const found = scenes.find(({ name }) => name === scene.value);
    if (found) text.value = found.text;
    else panel.querySelector("details").open = true;
  }

  function render(event) {
    event.preventDefault();
    const [width, height] = size.value.split("x");
    const name = scene.value || "scene.pov";
    canvas.width = width;
    canvas.height = height;
    start(["render", name, "--no-picture", "--accounts", "-W", width, "-H", height, "--mode", stage.value,
      "--queue", queue.value, "--model", machine.value], { ...includes, [name]: text.value });
  }

  async function start(args, files) {
    if (worker) return;
    for (const button of [trace, paper]) button.hidden = true;
    stop.hidden = false;
    said = "";
    fill(output);
    fill(clocks);
    status.textContent = "Tracing ..";
    worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
    worker.onmessage = ({ data }) => told(data);
    worker.onerror = ({ message }) => end(message);
    wasm ??= bytes();
    worker.postMessage({ wasm: await wasm, args, files });
  }

  function told({ text: part, done, all, rows, code }) {
    if (part !== undefined) said += part;
    if (all) status.textContent = `Tracing .. ${Math.round(100 * done / all)} %`;
    if (rows) place(rows);
    if (code !== undefined) end(code === 0 ? "" : "It could not be traced.");
  }

  function place({ width, first, rows, rgba, clocks: so, seconds, causes }) {
    canvas.getContext("2d").putImageData(new ImageData(rgba, width, rows), 0, first);
    const parts = Object.entries(causes).map(([cause, n]) => ({ cause, clocks: n }));
    fill(clocks, el("p", {}, el("b", {}, `${count(so)} clocks`), ` = ${duration(1e6 * seconds)} on the machine`),
      bar(parts), table("Clocks by cause", [["cause"], ["%", "number"]], parts.map(({ cause, clocks: n }) =>
        ({ cells: [named(cause), fixed(100 * n / so, 1)] }))));
  }

  function end(words) {
    worker?.terminate();
    worker = null;
    for (const button of [trace, paper]) button.hidden = false;
    stop.hidden = true;
    status.textContent = words;
    output.textContent = said;
  }
}
