// build.mjs BUILD [--write] - builds the page in BUILD/web: c205.html, which is one self-contained
// file, and site/, which is the same page as a small folder. BUILD/web must contain engine.wasm and
// rt205.wasm. The notice of the npm packages in the page is compared with web/NOTICE.md; --write
// writes it.

import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import * as esbuild from "esbuild";
import { readCourse, readExamples } from "./course.mjs";
import { notice } from "./notice.mjs";
import { readScenes } from "./scenes.mjs";

const MAX = 1 << 20; // maximum bytes of c205.html without the tracer

const web = dirname(fileURLToPath(import.meta.url));
const root = dirname(web);
const [out, flag] = process.argv.slice(2);
if (!out) {
  console.error("usage: node web/build.mjs BUILD [--write]");
  process.exit(2);
}
const page = (name) => readFileSync(join(web, "page", name), "utf8");

// Returns an esbuild plugin. Importing "c205:NAME" gives the text with that name.
const made = (texts) => ({
  name: "made",
  setup(build) {
    build.onResolve({ filter: /^c205:/ }, ({ path }) => ({ path, namespace: "made" }));
    build.onLoad({ filter: /.*/, namespace: "made" }, ({ path }) =>
      ({ contents: `export default ${JSON.stringify(texts[path])};` }));
  },
});

async function bundle(entry, format, texts = {}) {
  const { outputFiles, metafile } = await esbuild.build({
    entryPoints: [join(web, "page", entry)], bundle: true, minify: true, write: false,
    metafile: true, format, target: ["chrome123", "firefox120", "safari17.5"], legalComments: "none",
    charset: "utf8", absWorkingDir: web, plugins: [made(texts)], outdir: "out" });
  return { text: outputFiles[0].text, inputs: Object.keys(metafile.inputs) };
}

const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");
const data = (id, bytes) => `<script type="text/plain" id="${id}">${packed(bytes)}</script>`;
const fill = (html, parts) => Object.entries(parts).reduce(
  (text, [name, part]) => text.replace(`<!-- build: ${name} -->`, () => part), html);

const worker = await bundle("worker.js", "iife");
const tracerWorker = await bundle("tracer-worker.js", "iife");
const script = await bundle("main.js", "esm",
  { "c205:worker": worker.text, "c205:tracer-worker": tracerWorker.text });
const style = await bundle("page.css");
const engine = readFileSync(join(out, "web/engine.wasm"));
const tracer = readFileSync(join(out, "web/rt205.wasm"));
const scenes = Buffer.from(JSON.stringify(readScenes(join(root, "scenes"))));
const course = Buffer.from(JSON.stringify({
  lessons: readCourse(join(root, "docs/course")),
  examples: readExamples(join(root, "asm/examples")),
}));

const licences = notice(web, [...worker.inputs, ...script.inputs]);
const stored = join(web, "NOTICE.md");
if (flag === "--write") writeFileSync(stored, licences);
else if (readFileSync(stored, "utf8") !== licences) {
  console.error("web/NOTICE.md is not what is in the page: node web/build.mjs BUILD --write");
  process.exit(1);
}

const html = page("index.html");
const one = fill(html, {
  style: `<style>${style.text}</style>`,
  script: [data("engine", engine), data("course", course), data("notice", licences),
    data("scenes", scenes), data("rt205", tracer),
    `<script type="module">${script.text}</script>`].join("\n"),
});
const site = join(out, "web/site");
rmSync(site, { recursive: true, force: true });
mkdirSync(site, { recursive: true });
writeFileSync(join(out, "web/c205.html"), one);
const files = {
  "index.html": fill(html, { style: '<link rel="stylesheet" href="page.css">',
    script: '<script type="module" src="page.js"></script>' }),
  "page.css": style.text, "page.js": script.text, "engine.wasm": engine, "rt205.wasm": tracer,
  "course.json": course, "scenes.json": scenes, "NOTICE.md": licences,
};
for (const [name, text] of Object.entries(files)) writeFileSync(join(site, name), text);

const size = Buffer.byteLength(one) - packed(tracer).length;
const kb = (bytes) => `${(bytes / 1024).toFixed(0)} KB`;
const both = (bytes) => `${kb(packed(bytes).length)} (${kb(bytes.length)})`;
console.log(`${basename(out)}/web/c205.html: ${kb(size)}, and ${kb(packed(tracer).length)} of the tracer
    in the page (and unpacked): script ${kb(script.text.length)}, style ${kb(style.text.length)}, \
engine ${both(engine)}, course ${both(course)}, scenes ${both(scenes)}, tracer ${both(tracer)}`);
if (size > MAX) {
  console.error(`it is larger than ${kb(MAX)}`);
  process.exit(1);
}
