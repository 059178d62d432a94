// course.mjs - reads the texts of the page: lessons, as HTML, and programs.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { basename, dirname, join, normalize } from "node:path";
import { Marked } from "marked";

const read = (path) => readFileSync(path, "utf8");
const escaped = (text) => text.replace(/[&<>"]/g, (letter) =>
  ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[letter]);
const folderName = /^\d\d-(.*)$/;

// Returns a picture as a data URL.
function inlined(path) {
  if (!path.endsWith(".svg")) throw new Error(`${path}: only .svg is carried in the page`);
  return `data:image/svg+xml;base64,${Buffer.from(read(path)).toString("base64")}`;
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
        return `<img src="${inlined(normalize(join(folder, href)))}" alt="${escaped(alternative)}">`;
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

/** Returns an object with {html, examples, results} for each lesson, by name. The results are the
 * labels that the exercise requires. */
export function readCourse(folder) {
  if (!existsSync(folder)) return {};
  return Object.fromEntries(readdirSync(folder).filter((name) => folderName.test(name)
    && existsSync(join(folder, name, "lesson.md"))).sort().map((name) => {
    const examples = programs(join(folder, name), /^example-.*\.s$/);
    return [folderName.exec(name)[1], { html: lessonHtml(join(folder, name), examples), examples,
      results: results(join(folder, name)) }];
  }));
}

/** Returns the example programs of the assembler. */
export const readExamples = (folder) => ["", "debugging", "profiling"]
  .flatMap((part) => programs(join(folder, part), /\.s$/));
