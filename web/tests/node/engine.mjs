// engine.mjs BUILD SHARE OF - compares the engine of the page, in node, with c205 on all programs.
// Output, clocks, causes, final registers, profile and timeline files must be equal, byte for byte.
// After steps forward and backward, the engine must show the state of a run that reaches the step
// directly. A failure means that engine and command differ, or that the replay of the engine is
// wrong. The programs are divided into OF shares, and this run takes share number SHARE.
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, normalize } from "node:path";
import { startEngine } from "../../page/engine.js";

const build = process.argv[2];
const share = Number(process.argv[3] ?? 0), shares = Number(process.argv[4] ?? 1);
const c205 = join(build, "c205");
const module = await WebAssembly.compile(readFileSync(join(build, "web/engine.wasm")));
const engine = await startEngine(module), other = await startEngine(module);
const scratch = mkdtempSync(join(tmpdir(), "engine-"));
const script = join(scratch, "script");
writeFileSync(script, "run\ninfo registers\n");

let passed = 0, failed = 0;

function verdict(good, ...description) {
  if (good) {
    passed++;
  } else {
    failed++;
    console.log("FAIL", ...description);
  }
}

function same(a, b, ...description) {
  const one = typeof a === "string" ? a : JSON.stringify(a);
  const two = typeof b === "string" ? b : JSON.stringify(b);
  let at = 0;
  if (one !== two) while (one?.[at] === two?.[at]) at++;
  const around = (text) => text?.slice(Math.max(0, at - 40), at + 80);
  verdict(one === two, ...description, "\n    c205:   ", around(one), "\n    engine: ", around(two));
}

// ---- c205

function native(...args) {
  const run = spawnSync(c205, args, { encoding: "utf8", maxBuffer: 1 << 28 });
  return { out: run.stdout, stderr: run.stderr, json: run.stdout.startsWith("{") ? JSON.parse(run.stdout) : null };
}

// ---- The engine

/** Sends a request and continues it in slices until it is done. */
function finish(instance, request) {
  let reply = instance.answer(request);
  while (reply.ok && reply.done === false) reply = instance.answer({ do: "more", ms: 20 });
  return reply;
}

/** Returns the files that a text includes, by their names in the text. */
function included(text, folder, files = {}) {
  for (const [, name] of text.matchAll(/\.inc(?:lude|file)\s+"([^"]+)"/gm)) {
    const path = normalize(join(folder, name));
    if (name in files || !existsSync(path)) continue;
    files[name] = readFileSync(path, "utf8");
    included(files[name], dirname(path), files);
  }
  return files;
}

const source = (path) => {
  const text = readFileSync(path, "utf8");
  return { name: path, text, files: included(text, dirname(path)) };
};

// ---- One program

const below = (() => {
  let state = 0x205n;
  return (end) => {
    state = (state * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn;
    return Number((state >> 33n) % BigInt(end));
  };
})();

/** Returns the complete view without the number of known steps. */
function completeView(instance) {
  const view = instance.answer({ do: "view", "all-registers": true });
  delete view.steps;
  return view;
}

function checkWalk(path, program, steps) {
  const WALKS = 4;
  for (let i = 0; i < WALKS; i++) {
    const step = below(steps + 1);
    finish(engine, { do: "go", how: "step-to", n: step, ms: 20 });
    if (i % 2 && step > 3) finish(engine, { do: "go", how: "back", n: 3 });
    const { step: here, ended } = engine.answer({ do: "view" });
    other.answer({ do: "load", ...program });
    finish(other, { do: "go", how: "step", n: here + (ended ? 1 : 0) });
    same(completeView(other), completeView(engine), `${path}: at step ${here}`);
  }
}

function checkRegisters(path, model) {
  const lines = native("debug", path, "-x", script, "--model", model).out;
  const printed = lines.slice(lines.indexOf("info registers\n") + "info registers\n".length);
  same(printed.trimEnd(), engine.answer({ do: "say", line: "info registers" }).text.trimEnd(), `${path}: registers`);
}

function checkTimeline(path, model) {
  for (const ending of ["json", "kanata", "svg"]) {
    const file = join(scratch, `x.${ending}`);
    rmSync(file, { force: true });
    const { stderr } = native("timeline", path, "--model", model, "-o", file);
    const reply = finish(engine, { do: "timeline", file: `x.${ending}`, most: 50000, ms: 20 });
    if (existsSync(file)) same(readFileSync(file, "utf8"), reply.file, `${path}: timeline as ${ending}`);
    else verdict(reply.full || stderr.includes("no instruction is active in this range"), `${path}: only the engine has a timeline`);
  }
}

// c205 run prints the warnings and the trap that the page lists.
function checkWarnings(path, model, diagnostics) {
  const { stderr } = native("run", path, "--model", model);
  for (const { severity, message } of diagnostics) {
    const [first] = message.split("\n");
    verdict(stderr.includes(`${severity}: ${first}\n`), `${path}: only the engine reports: ${message}`);
  }
  const count = diagnostics.filter(({ severity }) => severity === "warning").length;
  same(stderr.split(": warning: ").length - 1, count, `${path}: number of warnings`);
}

function checkProgram(path) {
  const program = source(path);
  const loaded = engine.answer({ do: "load", ...program });
  if (!loaded.ok) return verdict(!native("run", path, "--json", "-").json, path, loaded.error);
  const { model } = loaded;
  const end = finish(engine, { do: "go", how: "end", ms: 20 });
  const { json, stderr } = native("run", path, "--model", model, "--profile", "--json", "-", "-Wno-all");
  const view = engine.answer({ do: "view" });
  const accounts = engine.answer({ do: "accounts" });

  same(json.stop.trap, view.trap, `${path}: trap`);
  same(json.stop.status, view.status, `${path}: status`);
  same(json.clocks, view.clock, `${path}: clocks`);
  same(json.causes, accounts.causes, `${path}: causes`);
  same(json.regions, accounts.regions, `${path}: regions`);
  same(stderr.slice(0, view.printed.length), view.printed, `${path}: printed`);
  if (view.trap === "none" && view.status === 0) same(stderr, view.printed, `${path}: printed`);
  same(json.lines, finish(engine, { do: "profile", ms: 20 }).lines, `${path}: profile`);
  checkWarnings(path, model, [...loaded.diagnostics, ...view.diagnostics]);
  checkRegisters(path, model);
  checkTimeline(path, model);
  checkWalk(path, program, end.step);
}

// ---- Two programs, and lessons

function checkSideBySide() {
  const [one, two] = ["asm/examples/saxpy_vector.s", "asm/examples/saxpy_scalar.s"];
  const texts = [one, two].map((path) => source(path));
  const { files } = texts[0];
  const model = "cyber205-2pipe";
  const compared = native("compare", one, two, "--json", "-", "--model", model).json;
  const comparison = finish(engine, { do: "compare", texts, files, model, ms: 5 });
  for (const key of ["causes", "regions", "figures"]) same(compared[key], comparison[key], `compare: ${key}`);
  verdict(native("compare", one, two, "--model", model).out.includes(comparison.sentence), "compare: sentence");

  const picture = join(scratch, "sweep.svg");
  const swept = native("sweep", one, two, "--define", "n=1:1000", "--json", "-", "-o", picture, "--model", model).json;
  const sweep = finish(engine, { do: "sweep", text: texts[0].text, name: one,
    other: texts[1].text, "other-name": two, files, model, constant: "n", from: 1, to: 1000, ms: 5 });
  for (const key of ["points", "lines", "causes", "crossings"]) same(swept[key], sweep[key], `sweep: ${key}`);
  same(readFileSync(picture, "utf8"), sweep.svg, "sweep: picture");
}

function checkAnswer(path, lesson) {
  const expected = native("check", lesson, path, "--format", "json").json;
  const { ok, words, ...graded } = finish(engine, { do: "grade", lesson, name: path, text: readFileSync(path, "utf8") });
  if (!expected) return verdict(!ok, `${path}: only the engine grades it`);
  for (const key of Object.keys(expected)) same(expected[key], graded[key], `${path}: ${key} of the verdict`);
}

// ---- All programs

const folders = ["tests/programs", "tests/programs/traps", "asm/examples", "asm/examples/debugging",
  "asm/examples/profiling", "asm/isa_examples"];
const course = "docs/course";
const programs = folders.flatMap((folder) =>
  readdirSync(folder).filter((file) => file.endsWith(".s")).sort().map((file) => join(folder, file)));
const lessons = existsSync(course)
  ? readdirSync(course).sort().filter((name) => statSync(join(course, name)).isDirectory()) : [];
const answers = lessons.flatMap((name) => ["solution.s", "start.s"].map((file) => ({ path: join(course, name, file), name })))
  .filter(({ path }) => existsSync(path));

[...programs, ...answers.map(({ path }) => path)]
  .forEach((path, i) => i % shares === share && checkProgram(path));
answers.forEach(({ path, name }, i) => i % shares === share && checkAnswer(path, name));
if (share === 0) checkSideBySide();

rmSync(scratch, { recursive: true });
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
