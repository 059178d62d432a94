// notice.mjs - lists the packages in the page with their versions and licences.

import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const ALLOWED = ["MIT", "ISC", "BSD-2-Clause", "BSD-3-Clause", "Apache-2.0"];

function licenceText(folder) {
  const name = readdirSync(folder).find((one) => /^licen[cs]e/i.test(one));
  return name ? readFileSync(join(folder, name), "utf8").trim() : null;
}

/** Returns the notice of the packages of INPUTS, which are paths relative to the folder WEB. */
export function notice(web, inputs) {
  const names = new Set(inputs.map((path) => /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(path)?.[1])
    .filter(Boolean));
  const packages = [...names].sort().map((name) => {
    const folder = join(web, "node_modules", name);
    const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const text = licenceText(folder);
    if (!ALLOWED.includes(license) || !text)
      throw new Error(`${name} ${version}: the licence ${license} is none that is allowed, or has no text`);
    return { name, version, license, text };
  });
  const texts = byText(packages);
  return ["# Third-party software in the page", "",
    "The page has these packages in it. Written by `node web/build.mjs BUILD --write`, "
      + "checked by `make web`.", "",
    "| package | version | licence |", "|---|---|---|",
    ...packages.map(({ name, version, license }) => `| ${name} | ${version} | ${license} |`),
    ...[...texts].flatMap(([text, of]) => ["", `## ${of.map(({ name }) => name).join(", ")}`, "",
      ...text.split("\n").map((line) => `    ${line}`.trimEnd())]), ""].join("\n");
}

// Groups the packages by the text of their licence.
function byText(packages) {
  const texts = new Map();
  for (const one of packages) texts.set(one.text, [...(texts.get(one.text) ?? []), one]);
  return texts;
}
