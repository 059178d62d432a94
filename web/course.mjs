// course.mjs - reads the texts of the page: lessons, as HTML, and programs.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { basename, dirname, join, normalize } from "node:path";
import { Marked } from "marked";

const read = (path) => readFileSync(path, "utf8");
const escaped = (text) => text.replace(/[&<>"]/g, (letter) =>
  ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[letter]);
const folderName = /^\d\d-(.*)$/;

// The colours of the figures, and the variables of page.css that replace them.
const COLOURS = { "#fff": "panel", "#ffffff": "panel", "#000": "ink", "#222": "ink", "#222222": "ink",
  "#444": "soft", "#555": "soft", "#777": "soft", "#bbb": "edge", "#ddd": "line", "#e0e0e0": "line", "#eee": "well",
  "#c9dcef": "figure-blue", "#cfe6cf": "figure-green", "#f3d9b1": "figure-sand",
  "#2b6cb0": "series-0", "#0072b2": "series-0", "#c1531f": "series-1", "#d55e00": "series-1",
  "#8c8c8c": "issue", "#e0a030": "operandwait", "#c07818": "unitbusy", "#b04a9a": "branch",
  "#d8503c": "memorywait", "#5b9bd5": "vectorstartup", "#3f9b5f": "vectorstream", "#8a6d3b": "bankconflict",
  "#7a5ac8": "translationmiss", "#4b3a8f": "pagefault", "#b9c4d0": "work" };
const SHOWN = 660, MIN_TEXT = 12; // pixels: width of a figure in the page, and its smallest text
const FITTING = 900; // a wider figure, such as a time line, is not reduced to the page: it scrolls
const ROOM = 40; // for enlarged text at the right edge

// Returns a figure in the colours of the page. Its smallest text is enlarged as required. Its style
// sheet applies to this figure only.
function figure(path, alternative) {
  if (!path.endsWith(".svg")) throw new Error(`${path}: only .svg is carried in the page`);
  const name = `figure-${basename(path, ".svg")}`;
  const text = read(path);
  const drawn = Number(/width="(\d+)"/.exec(text)[1]);
  const width = drawn > FITTING ? drawn : drawn + ROOM;
  const smallest = width > FITTING ? MIN_TEXT : Math.ceil(MIN_TEXT * width / SHOWN);
  const shown = Math.ceil(width * MIN_TEXT / smallest);
  const svg = text.replace(/(font-size[:=]"?)(\d+)/g, (_, start, size) => `${start}${Math.max(size, smallest)}`)
    .replace(/#[0-9a-f]{3,6}\b/gi, (found) => {
    const colour = found.toLowerCase();
    if (!COLOURS[colour]) throw new Error(`${path}: the page has no variable for ${colour}`);
    return `var(--${COLOURS[colour]})`;
  }).replace(/<style>(.*)<\/style>/s, (all, rules) => `<style>${rules.replace(/([^{}]+)\{/g, (_, selectors) =>
    `${selectors.split(",").map((one) => `.${name} ${one.trim()}`).join(",")}{`)}</style>`)
    .replace(/viewBox="0 0 \d+/, `viewBox="0 0 ${width}`)
    .replace(/^[^]*?<svg([^>]*?) width="\d+" height="\d+"/, (_, start) =>
      `<svg${start} class="${name}" role="img" aria-label="${escaped(alternative)}" style="min-width:${shown}px"`);
  return `<figure><div class="scroll" tabindex="0">${svg.trim()}</div><button type="button" class="quiet">Enlarge</button></figure>`;
}

// Marks a block with the example that it shows or that prints it: the name becomes the first line
// of the block. An empty comment remains, because two adjacent blocks would become one.
const MARK = /^@(example-[\w-]+\.s)\n/;
const marked = (text) => text.replace(/^<!--([^]*?)-->\n+    /gm, (all, words) => {
  const example = /(example-[\w-]+\.s)/.exec(words);
  return `<!-- -->\n\n    ${example ? `@${example[1]}\n    ` : ""}`;
});

// Returns the HTML of the lesson in FOLDER. The title and the commands above blocks are removed. A
// block of an example gets a button that opens the example. Headings are one level lower, because
// the page has headings above them. Links to lessons and to the web remain; other links become
// plain text.
function lessonHtml(folder, examples) {
  const text = marked(read(join(folder, "lesson.md")).replace(/^# .*\n/, ""))
    .replace(/^<!-- [^]*?[^-] -->\n/gm, "");
  let last = null; // a program has one button for consecutive blocks
  const reader = new Marked({
    renderer: {
      image({ href, text: alternative }) {
        return figure(normalize(join(folder, href)), alternative);
      },
      link({ href, tokens }) {
        const words = this.parser.parseInline(tokens);
        const lesson = folderName.exec(basename(dirname(normalize(join(folder, href)))));
        if (lesson && /lesson\.md(#.*)?$/.test(href))
          return `<a href="#lesson=${lesson[1]}" data-lesson="${lesson[1]}">${words}</a>`;
        if (/^https?:/.test(href)) return `<a href="${escaped(href)}" rel="noreferrer">${words}</a>`;
        return `<cite title="${escaped(basename(href))}">${words}</cite>`;
      },
      heading({ tokens, depth }) {
        const level = Math.min(depth + 1, 6);
        last = null;
        return `<h${level}>${this.parser.parseInline(tokens)}</h${level}>\n`;
      },
      code({ text: words }) {
        const name = MARK.exec(words)?.[1];
        const block = `<pre tabindex="0"><code>${escaped(words.replace(MARK, ""))}</code></pre>`;
        if (!name || name === last || !examples.some((one) => one.name === name)) return `${block}\n`;
        last = name;
        return `<div class="block"><p><code>${name}</code> <button type="button" class="quiet" data-example="${name}"`
          + ` aria-label="Open ${name}">Open</button></p>${block}</div>\n`;
      },
      table({ header, rows }) {
        const cell = ({ tokens, align }, name) =>
          `<${name}${align === "right" ? ' class="number"' : ""}>${this.parser.parseInline(tokens)}</${name}>`;
        const cells = (row, name) => row.map((one) => cell(one, name)).join("");
        return `<div class="scroll" tabindex="0"><table><thead><tr>${cells(header, "th")}</tr></thead><tbody>`
          + `${rows.map((row) => `<tr>${cells(row, "td")}</tr>`).join("")}</tbody></table></div>\n`;
      },
    },
  });
  return reader.parse(text);
}

// Returns a program in which the contents of .inc files replace each .include. The files are in its
// folder or the parent folder. Returns null if the program needs data files.
function program(path) {
  const text = read(path).replace(/^[ \t]*\.include\s+"([^"]+)".*\n/gm, (line, name) => {
    const found = [dirname(path), dirname(dirname(path))].map((folder) => join(folder, name))
      .find(existsSync);
    return found ? read(found) : line;
  });
  return /^[^;\n]*\.incfile\b/m.test(text) ? null : { name: basename(path), text };
}

const programs = (folder, wanted) => readdirSync(folder).filter((name) => wanted.test(name)).sort()
  .map((name) => program(join(folder, name))).filter(Boolean);

// Returns the labels of the results that the tests of a lesson require.
const results = (folder) => [...new Set(readdirSync(folder).filter((name) => /^test-.*\.s$/.test(name))
  .flatMap((name) => [...read(join(folder, name)).matchAll(/^(?:[^;\n]*\s)?want_([\w$.]*[\w$])/gm)].map(([, label]) => label)))];

// Returns the controls of the page that the text of a lesson needs, as the ids of their elements.
const controls = (folder) => Object.entries({ "to-compare": /c205 compare/, model: /--model|[14]pipe/, warm: /\bcold\b|page fault/i })
  .filter(([, words]) => words.test(read(join(folder, "lesson.md")))).map(([id]) => id);

/** Returns an object with {html, examples, solution, results, controls} for each lesson, by name.
 * The results are the labels that the exercise requires. The controls are those that not all lessons need. */
export function readCourse(folder) {
  if (!existsSync(folder)) return {};
  return Object.fromEntries(readdirSync(folder).filter((name) => folderName.test(name)
    && existsSync(join(folder, name, "lesson.md"))).sort().map((name) => {
    const examples = programs(join(folder, name), /^example-.*\.s$/);
    return [folderName.exec(name)[1], { html: lessonHtml(join(folder, name), examples), examples,
      solution: program(join(folder, name, "solution.s"))?.text, results: results(join(folder, name)), controls: controls(join(folder, name)) }];
  }));
}

/** Returns the example programs of the assembler. */
export const readExamples = (folder) => ["", "debugging", "profiling"]
  .flatMap((part) => programs(join(folder, part), /\.s$/));
