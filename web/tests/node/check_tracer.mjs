// check_tracer.mjs - compares rt205.wasm with rt205. Exit status, output and written files must be
// the same, byte for byte. Pictures must have the same pixels.
//
//     node check_tracer.mjs BUILD DRAWN [TEXT]
//
// Run it in the project's folder. BUILD contains rt205 and web/rt205.wasm, DRAWN contains random
// scenes. TEXT selects the runs whose command line contains it, or "table1" or "grow".
//
// The runs are: scenes of scenes/, tests/scenes and DRAWN with random options for stage, queue,
// model and output; the other commands; scene texts with random damage; wrong usage. The rows of
// Table 1 are compared. "grow" checks pictures while they grow and prints their times.
//
// A failure means that page and command compute different results. The page cannot read files that
// need OpenImageIO or FreeType; the test then requires the error that reports this.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import zlib from "node:zlib";

import { cellsOfTable1 } from "../../page/tracer.js";
import { loadTracer } from "../../tracer/tracer.js";

const [build, drawn, only = ""] = process.argv.slice(2);
const out = path.join(build, "web/checked"); // output folder of both programs
const run = await loadTracer(fs.readFileSync(path.join(build, "web/rt205.wasm")));
let passed = 0, failed = 0, unread = 0;

// ---- Comparison of both ----------------------------------------------------

const cannotRead = /(pictures|fonts) cannot be read in the page|no such file(?=[^]*\bttf\b)/;

const filesOf = (folder, names = /./) => Object.fromEntries(
  fs.readdirSync(folder).filter((name) => names.test(name)).sort()
    .map((name) => path.join(folder, name))
    .filter((name) => fs.statSync(name).isFile())
    .map((name) => [name, fs.readFileSync(name)]));

const inputFiles = {
  ...filesOf("scenes"), ...filesOf("tests/scenes"), ...filesOf(drawn),
  [path.join(out, "folder")]: "",
};

/** Returns the header and the pixels of an 8-bit RGB picture in PNG format (ISO/IEC 15948). */
function pixels(png) {
  const chunks = {};
  for (let at = 8; at < png.length;) {
    const length = png.readUInt32BE(at);
    const type = png.toString("latin1", at + 4, at + 8);
    const sum = png.readUInt32BE(at + 8 + length);
    if (zlib.crc32 && zlib.crc32(png.subarray(at + 4, at + 8 + length)) !== sum)
      throw new Error(`${type}: its sum is wrong`);
    (chunks[type] ??= []).push(png.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const width = chunks.IHDR[0].readUInt32BE(0), row = 3 * width;
  const lines = zlib.inflateSync(Buffer.concat(chunks.IDAT));
  const all = Buffer.alloc(lines.length / (row + 1) * row);
  for (let y = 0; y * (row + 1) < lines.length; y++)
    for (let i = 0; i < row; i++) {
      const left = i < 3 ? 0 : all[y * row + i - 3];
      const up = y ? all[(y - 1) * row + i] : 0;
      const corner = y && i >= 3 ? all[(y - 1) * row + i - 3] : 0;
      const [a, b, c] = [left, up, corner]
        .map((from) => Math.abs(left + up - corner - from));
      const nearest = a <= b && a <= c ? left : b <= c ? up : corner;
      all[y * row + i] = lines[y * (row + 1) + 1 + i]
        + [0, left, up, left + up >> 1, nearest][lines[y * (row + 1)]];
    }
  return Buffer.concat([chunks.IHDR[0], all]);
}

function native(args) {
  fs.rmSync(out, { recursive: true, force: true });
  fs.mkdirSync(out, { recursive: true });
  const ended = spawnSync(path.join(build, "rt205"), [...args, "--jobs", "1"],
    { input: "", maxBuffer: 1 << 28 });
  return {
    code: ended.status, stdout: ended.stdout.toString(),
    stderr: ended.stderr.toString(), files: filesOf(out),
  };
}

function inPage(args, more = {}) {
  const printed = { stdout: "", stderr: "" };
  const ended = run([...args, "--jobs", "1"], { ...inputFiles, ...more }, {
    stdout: (text) => printed.stdout += text,
    stderr: (text) => printed.stderr += text,
  });
  return { ...ended, ...printed };
}

/** Returns a description of the first difference, or "". */
function difference(one, other) {
  for (const key of ["code", "stderr", "stdout"])
    if (one[key] !== other[key])
      return `${key}: ${one[key]}\nbut in the page: ${other[key]}`;
  for (const name of new Set([...Object.keys(one.files), ...Object.keys(other.files)])) {
    const [a, b] = [one.files[name], other.files[name]];
    if (!a || !b)
      return `${name} is ${a ? "not written in the page" : "written there alone"}`;
    const of = name.endsWith(".png") ? pixels : (bytes) => bytes;
    if (!of(a).equals(of(Buffer.from(b))))
      return `${name} is another one`;
  }
  return "";
}

function check(args, more) {
  const line = `rt205 ${args.join(" ")}`;
  if (!line.includes(only))
    return;
  let why;
  try {
    const other = inPage(args, more);
    if (cannotRead.test(other.stderr)) {
      unread++;
      why = other.code === 1 && other.stdout === "" ? "" : "it continues without a file";
    } else {
      why = difference(native(args), other);
    }
  } catch (fault) {
    why = fault.stack;
  }
  if (!why) {
    passed++;
    return;
  }
  failed++;
  console.log(`FAIL ${line}\n${why.slice(0, 2000)}`);
}

// ---- Random cases -------------------------------------------------------------

let state = 205;
const draw = (count) => { // 0 .. count - 1; a linear congruential generator of Knuth's, modulus 2^31
  state = (Math.imul(state, 1103515245) + 12345) & 0x7fffffff;
  return (state >>> 8) % count;
};
const one = (list) => list[draw(list.length)];

const methods = [
  [], ["--flat"], ["--no-bounds"], ["--order", "rows"], ["--order", "tiles"],
  ["--samples", "2"], ["--samples", "2", "--threshold", "0.1"], ["--visible", "every"],
  ["--visible", "stepping"], ["--historical"],
];
const reportOptions = [
  [], ["--accounts"], ["--profile"], ["--profile", "--in-order"],
  ["--accounts", "--format", "csv"], ["--accounts", "--format", "json"],
  ["--format", "md"], ["--provenance"],
];
const models = [
  "cyber205-2pipe", "cyber205-2pipe", "cyber205-1pipe", "cyber205-4pipe",
  "cyber205-2pipe-32bit", "cyber205-2pipe-small", "cyber205-4pipe-prior", "eta10g",
];
const size = () => ["-W", `${1 + draw(24)}`, "-H", `${1 + draw(18)}`];
const randomOptions = () => [
  "--mode", one(["scalar", "vector", "vector", "kernels"]),
  "--queue", `${one([1, 2, 7, 64, 77, 500, 2000, 65535])}`,
  "--model", one(models), ...one(methods), ...one(reportOptions), ...size(),
];

// ---- The runs --------------------------------------------------------------

const scenes = Object.keys(inputFiles).filter((name) => name.endsWith(".pov"));
// Runs every third scene, or all scenes if THOROUGH is set.
const part = process.env.THOROUGH ? 1 : 3;
for (const scene of scenes.filter((name, i) => i % part === 0))
  check(["render", scene, ...draw(4) === 0 ? ["-o", path.join(out, "a.png")] : ["--no-picture"],
    "--json", path.join(out, "a.json"), ...randomOptions()]);

const json = ["--json", path.join(out, "a.json")];
const small = ["-W", "24", "-H", "16"];
for (const args of [
  ["speedup", "-W", "20", "-H", "12", "--details"],
  ["speedup", "-W", "20", "-H", "12", "--queue", "100", "--passes", "--model", "cyber205-4pipe"],
  ["profile", "scenes/bracket.pov", ...small],
  ["profile", "scenes/glass.pov", "--queue", "300", ...small],
  ["sweep", "queue", "sphere", "--points", "3,64,2000", ...small],
  ["sweep", "length", "torus", "--points", "10,1000", ...small],
  ["sweep", "hits", "cylinder", ...small],
  ["sweep", "pipes", "scenes/first.pov", ...small],
  ["mass", "scenes/pipe_flange.pov", "--density", "default=7.85", "--rays", "1024"],
  ["mass", "scenes/bracket.pov", "--density", "default=2.7", "--rays", "1024",
    "--mode", "scalar", "--overlaps"],
  ["heat", "scenes/tube_row.pov", "--rays", "64", "--repeats", "2"],
  ["heat", "scenes/burner.pov", "--rays", "64", "--repeats", "2", "--mode", "scalar"],
  ["timeline", "scenes/first.pov", "--pixel", "5,4", "-W", "12", "-H", "9",
    "-o", path.join(out, "a.svg")],
  ["quartic", path.join(out, "p.csv"), "--first"],
  ["quartic", path.join(out, "p.csv"), "--falsi", "all"],
])
  check([...args, ...(args[0] === "timeline" ? [] : json)]);

// Wrong usage and missing files.
for (const args of [
  [], ["--help"], ["--version"], ["render"], ["render", "--help"], ["paint", "a.pov"],
  ["render", "scenes/none.pov", "--no-picture"], ["render", "scenes", "--no-picture"],
  ["render", "scenes/first.pov", "--no-picture", "--queue", "0"],
  ["render", "scenes/first.pov", "--no-picture", "--model", "cyber206"],
  ["render", "scenes/first.pov", "--no-picture", "--model", "cyber720"],
  ["render", "scenes/first.pov", "-o", "none/a.png"],
  ["render", "scenes/first.pov", "-o", "a.bmp"],
  ["render", "scenes/first.pov", "-o", "a.png", "--no-picture"],
  ["render", "scenes/first.pov", "--no-picture", ...small, "--json", "none/a.json"],
  ["render", "scenes/first.pov", "--debug", "1,2", ...small],
])
  check(args);

// Returns a text in which bytes were removed, repeated, inserted or copied.
function damaged(text) {
  const at = draw(text.length), length = 1 + draw(one([2, 20, 400]));
  const from = draw(text.length);
  return one([
    () => text.slice(0, at),
    () => text.slice(0, at) + text.slice(at + length),
    () => text.slice(0, at + length) + text.slice(at),
    () => text.slice(0, at) + text.slice(from, from + length) + text.slice(at),
    () => text.slice(0, at) + one(["{", "}", "#end", "<", "\"", "1e999", "\u00e9", "#while (1)"])
      + text.slice(at),
  ])();
}
const broken = path.join(drawn, "broken.pov");
for (let i = 0; i < 60 / part; i++) {
  const text = damaged(inputFiles[one(scenes)].toString());
  fs.writeFileSync(broken, text);
  check(["render", broken, "--no-picture", "-W", "6", "-H", "5"], { [broken]: text });
}
// Nesting beyond the limit of the parser.
for (const [open, close] of [["union { ", " }"], ["(", ")"], ["#if (1) ", " #end"], ["{", "}"]]) {
  const text = `#declare A = ${open.repeat(100000)} 1 ${close.repeat(100000)};`;
  fs.writeFileSync(broken, text);
  check(["render", broken, "--no-picture", "-W", "6", "-H", "5"], { [broken]: text });
}
// The case of a file name differs. The parser finds the file in the listing of the folder.
{
  const text = '#include "STEINER.inc" sphere { 0, 1 }';
  fs.writeFileSync(broken, text);
  check(["render", broken, "-I", "scenes", "--no-picture", ...small], { [broken]: text });
}
fs.rmSync(broken, { force: true });

// ---- Table 1 of the page -----------------------------------------------------

// The page formats the figures of the JSON output. The digits must be the same as in rt205.
if (only === "" || only === "table1") {
  const printed = (format) => spawnSync(path.join(build, "rt205"),
    ["speedup", "-W", "16", "-H", "10", "--format", format]).stdout.toString();
  const rows = printed("md").split("\n").filter((line) => /\| (ours|paper|error %) *\|/.test(line))
    .map((line) => line.slice(1, -1).split("|").map((cell) => cell.trim() || "-"));
  const { table1 } = JSON.parse(printed("json"));
  for (const [i, row] of table1.map(cellsOfTable1).entries())
    if (row.join() === rows[i].join())
      passed++;
    else
      console.log(`FAIL the page shows ${row}, rt205 prints ${rows[i]}`), failed++;
}

// ---- Pictures that grow ------------------------------------------------------

// Checks that the rows add up to the final picture and that the clocks are complete. Prints the
// time.
function watch(scene, width, height) {
  const seen = Buffer.alloc(3 * width * height);
  const begin = performance.now();
  let stdout = "", views = 0, last;
  const { files } = run(["render", scene, "-o", "a.png", "--format", "json", "-W", `${width}`,
    "-H", `${height}`], inputFiles, {
    stdout: (text) => { stdout += text; },
    rows: (view) => {
      views++;
      last = view;
      view.rgba.filter((byte, i) => i % 4 !== 3).forEach((byte, i) => {
        seen[3 * width * view.first + i] = byte;
      });
    },
  });
  const seconds = ((performance.now() - begin) / 1000).toFixed(2);
  console.log(`${scene}, ${width} x ${height}: ${seconds} s, ${views} views`);
  const sum = Object.values(last?.causes ?? {}).reduce((one, other) => one + other, 0);
  if (pixels(Buffer.from(files["a.png"])).subarray(13).equals(seen)
    && last.clocks === JSON.parse(stdout).clocks && sum === last.clocks)
    passed++;
  else
    console.log("FAIL what is shown last is not the picture, or its clocks are others"), failed++;
}
if (only === "" || only === "grow") {
  watch("scenes/bracket.pov", 160, 120);
  watch("scenes/first.pov", 256, 160); // two bands
}
fs.rmSync(out, { recursive: true, force: true });
if (passed === 0)
  failed++;
console.log(`${unread} with files that the page cannot read`);
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
