// run.mjs BUILD [BROWSERS [TEXT]] - runs the tests of the page in real browsers. TEXT selects tests
// whose name contains it. Exit status: 1 if a test fails, 2 for wrong usage.

import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { startBrowser } from "./browsers.mjs";
import { Native } from "./native.mjs";
import { tests as course } from "./course.mjs";
import { tests as loading } from "./loading.mjs";
import { tests as layout } from "./layout.mjs";
import { tests as stepping } from "./stepping.mjs";
import { tests as programs } from "./programs.mjs";
import { tests as panels } from "./panels.mjs";
import { tests as tracer } from "./tracer.mjs";

const [build, browsers = "chromium firefox", only = ""] = process.argv.slice(2);
if (!build) {
  console.error("usage: node web/tests/browser/run.mjs BUILD [BROWSERS [TEXT]]");
  process.exit(2);
}
const all = { ...loading, ...stepping, ...programs, ...panels, ...course, ...layout, ...tracer };
const native = new Native(resolve(build));
let passed = 0, failed = 0;

for (const kind of browsers.split(" ")) {
  const { browser, end } = await startBrowser(kind);
  const world = { browser, kind, native, site: resolve(build, "web/site"),
    page: pathToFileURL(resolve(build, "web/c205.html")).href,
    print: (words) => console.log(`    ${kind}: ${words}`) };
  for (const [name, test] of Object.entries(all)) {
    if (!name.includes(only)) continue;
    const begun = performance.now();
    try {
      await test(world);
      passed++;
      console.log(`ok ${kind}: ${name} (${Math.round(performance.now() - begun)} ms)`);
    } catch (fault) {
      failed++;
      console.log(`not ok ${kind}: ${name}\n${fault.stack.replace(/^/gm, "    ")}`);
      for (const context of browser.browserContexts().slice(1)) await context.close().catch(() => {});
    }
  }
  await end();
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
