// loading.mjs - loads the page from a file, and from a server that is then stopped, and runs
// programs. A failure means that the page loads too slowly, needs the network, or blocks while a
// program runs.

import assert from "node:assert/strict";
import { serve } from "./server.mjs";
import { PageDriver } from "./page_driver.mjs";
import { LOOP, PRINTS } from "./texts.mjs";

const FIRST_RUN = 1000; // maximum milliseconds from the start of loading to the end of a run, on an
                        // idle machine
const SHARED = 3; // factor for FIRST_RUN on a machine with other work

async function runs(driver) {
  await driver.write(PRINTS);
  await driver.press("run");
  assert.equal(await driver.text("#output"), "42\n");
}

export const tests = {
  async "the one file, from a file: address"({ browser, page, print }) {
    const driver = await PageDriver.open(browser, page);
    await runs(driver);
    // Measures the second load of the page and its first run.
    await driver.choose("lesson", "example:saxpy_vector.s");
    await driver.page.reload();
    await driver.page.waitForSelector("body.ready");
    await driver.page.click("#run");
    await driver.quiet();
    const time = await driver.page.evaluate("performance.now()");
    assert.equal((await driver.view()).ended, true);
    print(`first run ${Math.round(time)} ms after loading began, at most ${FIRST_RUN} wanted`);
    assert.ok(time < SHARED * FIRST_RUN, `${time} ms`);
    await driver.close();
  },

  async "the site's folder, from a server; offline when that has gone"({ browser, site }) {
    const server = await serve(site);
    const driver = await PageDriver.open(browser, server.address);
    await runs(driver);
    const requested = server.requested.length;
    await server.end();
    await driver.write(PRINTS.replace("42", "43"));
    await driver.press("run");
    assert.equal(await driver.text("#output"), "43\n");
    await driver.press("back");
    assert.equal(server.requested.length, requested);
    await driver.close();
  },

  async "a program without an end leaves the page alive, and is stopped"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    await driver.write(LOOP);
    await driver.page.click("#run");
    const status = "document.getElementById('status').textContent";
    await driver.page.waitForFunction(`/^Running: step [1-9]/.test(${status})`);
    const first = JSON.stringify(await driver.text("#status"));
    // The page reacts to clicks while a program runs.
    await driver.page.click("#tab-console");
    assert.equal(await driver.shown("#console"), true);
    await driver.page.click("#tab-machine");
    await driver.page.waitForFunction(`${status} !== ${first}`);
    await driver.page.click("#stop");
    await driver.quiet();
    const view = await driver.view();
    assert.ok(view.step > 0 && !view.ended);
    assert.equal(await driver.text("#status"), "Stopped by you.");
    await driver.press("step");
    assert.equal((await driver.view()).step, view.step + 1);
    // A change of the text also stops the run.
    await driver.page.click("#run");
    await driver.page.waitForFunction("document.body.classList.contains('busy')");
    await driver.write(PRINTS);
    await driver.press("run");
    assert.equal(await driver.text("#output"), "42\n");
    await driver.close();
  },
};
