// scenes.mjs - reads the scenes for the ray tracer of the page. Scenes with fonts or pictures are
// excluded, because the page cannot read such files.

import { readFileSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";

const needs = /\bttf\b|\bimage_map\b|\bbump_map\b/;

// Returns the title of a scene, which is in its first line.
function title(path, text) {
  const words = /^\/\/ *(?:[\w.]+ - )?([^:;,.\n]*)/.exec(text)?.[1] ?? "";
  return `${basename(path, ".pov")}: ${words.replace(/^(A|An|The) (?=[a-z])/, (article) => article.toLowerCase())}`;
}

/** Returns { files: texts by path, list: [{ path, title }] }. */
export function readScenes(folder, as = "scenes") {
  const files = {}, list = [];
  for (const name of readdirSync(folder).filter((one) => /\.(pov|inc)$/.test(one)).sort()) {
    const text = readFileSync(join(folder, name), "utf8");
    if (needs.test(text.replace(/\/\/.*|\/\*[^]*?\*\//g, ""))) continue;
    const path = `${as}/${name}`;
    files[path] = text;
    if (name.endsWith(".pov")) list.push({ path, title: title(path, text) });
  }
  return { files, list };
}
