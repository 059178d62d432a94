// loading.mjs - loads the page from a file, and from a server that is then stopped, and runs
// programs. A failure means that the page loads too slowly, needs the network, or blocks while a
// program runs.

import assert from "node:assert/strict";
import { serve } from "./server.mjs";
import { Visit } from "./visit.mjs";
import { LOOP, PRINTS } from "./texts.mjs";

const FIRST_RUN = 1000; // milliseconds from the start of loading to the end of a run, on an idle machine
const SHARED = 3; // factor on FIRST_RUN for a machine that has other work

async function runs(visit) {
  await visit.write(PRINTS);
  await visit.press("run");
  assert.equal(await visit.text("#output"), "42\n");
}

export const tests = {
  async "the one file, from a file: address"({ browser, page, print }) {
    const visit = await Visit.open(browser, page);
    await runs(visit);
    // Measures a second load of the page, with its first run.
    await visit.choose("lesson", "example:saxpy_vector.s");
    await visit.page.reload();
    await visit.page.waitForSelector("body.ready");
    await visit.page.click("#run");
    await visit.quiet();
    const time = await visit.page.evaluate("performance.now()");
    assert.equal((await visit.view()).ended, true);
    print(`first run ${Math.round(time)} ms after loading began, at most ${FIRST_RUN} wanted`);
    assert.ok(time < SHARED * FIRST_RUN, `${time} ms`);
    await visit.close();
  },

  async "the site's folder, from a server; offline when that has gone"({ browser, site }) {
    const server = await serve(site);
    const visit = await Visit.open(browser, server.address);
    await runs(visit);
    const requested = server.requested.length;
    await server.end();
    await visit.write(PRINTS.replace("42", "43"));
    await visit.press("run");
    assert.equal(await visit.text("#output"), "43\n");
    await visit.press("back");
    assert.equal(server.requested.length, requested);
    await visit.close();
  },

  async "a program without an end leaves the page alive, and is stopped"({ browser, page }) {
    const visit = await Visit.open(browser, page);
    await visit.write(LOOP);
    await visit.page.click("#run");
    const status = "document.getElementById('status').textContent";
    await visit.page.waitForFunction(`/^Running: step [1-9]/.test(${status})`);
    const first = JSON.stringify(await visit.text("#status"));
    // The page reacts to clicks while the program runs.
    await visit.page.click("#tab-console");
    assert.equal(await visit.shown("#console"), true);
    await visit.page.click("#tab-machine");
    await visit.page.waitForFunction(`${status} !== ${first}`);
    await visit.page.click("#stop");
    await visit.quiet();
    const view = await visit.view();
    assert.ok(view.step > 0 && !view.ended);
    assert.equal(await visit.text("#status"), "Stopped by you.");
    await visit.press("step");
    assert.equal((await visit.view()).step, view.step + 1);
    // A change of the text also stops the run.
    await visit.page.click("#run");
    await visit.page.waitForFunction("document.body.classList.contains('busy')");
    await visit.write(PRINTS);
    await visit.press("run");
    assert.equal(await visit.text("#output"), "42\n");
    await visit.close();
  },
};
