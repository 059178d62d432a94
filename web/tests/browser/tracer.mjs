// tracer.mjs - compares the page's ray tracer with rt205: its output for both stages, a scene with
// an error, and Table 1. A failure means that the page passes wrong options or shows wrong figures.

import assert from "node:assert/strict";
import { PageDriver } from "./page_driver.mjs";

const RUN_TIMEOUT = 120000; // limit for a run in milliseconds

/** Returns the output of rt205, stderr first. */
function rt205(native, args, files) {
  const { out, err } = native.rt205([...args, "--jobs", "1"], files);
  return err + out;
}

const scene = `camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -6> rgb 1 }
sphere { 0, 1 pigment { rgb <1, .5, .2> } finish { reflection .3 } }
plane { y, -1 pigment { checker rgb .2, rgb .9 } }
`;

async function openTracer(browser, page) {
  const driver = await PageDriver.open(browser, page);
  await driver.press("tab-tracer");
  await driver.page.waitForSelector("#tracer form");
  return driver;
}

// Waits for a status text. WHICH is 0 for the picture and 1 for the table.
const waitForStatus = (driver, words, which = 0) => driver.page.waitForFunction(
  `document.querySelectorAll("#tracer [role=status]")[${which}].textContent === ${JSON.stringify(words)}`,
  { timeout: RUN_TIMEOUT });

async function write(driver, text) {
  await driver.page.$eval("#tracer-text", (area, words) => {
    area.value = words;
    area.dispatchEvent(new Event("input"));
  }, text);
}

/** Returns the number of colours of the picture, and whether the downloaded file has the same
 * pixels. */
const picture = (driver) => driver.page.evaluate(async () => {
  const pixels = async (image) => {
    const bitmap = await createImageBitmap(image);
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    canvas.drawImage(bitmap, 0, 0);
    return canvas.getImageData(0, 0, bitmap.width, bitmap.height).data;
  };
  const shown = await pixels(document.querySelector("#tracer canvas"));
  const saved = await pixels(await (await fetch(document.querySelector("#tracer a.button").href)).blob());
  return { colours: new Set(new Uint32Array(shown.buffer)).size,
    same: shown.length === saved.length && shown.every((byte, i) => byte === saved[i]) };
});

export const tests = {
  async "a picture is drawn, with what rt205 prints"({ browser, page, native }) {
    const driver = await openTracer(browser, page);
    for (const stage of ["vector", "scalar"]) {
      await driver.page.select("#tracer-size", "80x60");
      await driver.page.select("#tracer-stage", stage);
      await write(driver, scene);
      await driver.page.click("#tracer button[type=submit]");
      await waitForStatus(driver, "Done.");
      const queue = stage === "scalar" ? [] : ["--queue", "2000"];
      assert.equal(await driver.text("#tracer pre"), rt205(native, ["render", "my.pov", "-o", "picture.png",
        "-W", "80", "-H", "60", "--accounts", "--mode", stage, "--model", "cyber205-2pipe", ...queue],
      { "my.pov": scene }));
      const { colours, same } = await picture(driver);
      assert.ok(colours > 50, `${colours} colours`);
      assert.ok(same, "the picture to download is another one");
    }
    await driver.close();
  },

  async "a scene with a fault is reported, and a run can be stopped"({ browser, page, native }) {
    const driver = await openTracer(browser, page);
    const broken = scene.replace("sphere", "spere");
    await write(driver, broken);
    await driver.page.click("#tracer button[type=submit]");
    await waitForStatus(driver, "rt205 failed. Its output gives the reason.");
    assert.equal(await driver.text("#tracer pre"), rt205(native, ["render", "my.pov", "--no-picture"],
      { "my.pov": broken }));
    await driver.page.select("#tracer-scene", "scenes/bracket.pov");
    await driver.page.select("#tracer-size", "640x480");
    await driver.page.click("#tracer button[type=submit]");
    await driver.page.waitForSelector("#tracer .clocks table", { timeout: RUN_TIMEOUT });
    await driver.page.click("#tracer form button[type=button]");
    await waitForStatus(driver, "Stopped.");
    await driver.page.select("#tracer-size", "80x60");
    await driver.page.click("#tracer button[type=submit]");
    await waitForStatus(driver, "Done.");
    await driver.close();
  },

  async "Table 1 is that of rt205"({ browser, page, native }) {
    const driver = await openTracer(browser, page);
    await driver.page.$eval("#tracer-queue", (input) => { input.value = "500"; });
    // Objects of the scene select a single row, with the rays of the paper. All rows together use
    // few rays.
    await write(driver, "torus { 1, 0.2 } torus { 2, 0.2 } sphere { 0, 1 }");
    assert.equal(await driver.page.$eval("#tracer-row", ({ value }) => value), "torus");
    await write(driver, scene);
    assert.equal(await driver.page.$eval("#tracer-row", ({ value }) => value), "sphere");
    for (const [choice, args] of [["sphere", ["sphere"]], ["all", ["-W", "80", "-H", "50"]]]) {
      await driver.page.select("#tracer-row", choice);
      await driver.page.click("form:has(#tracer-row) button");
      await driver.page.waitForFunction("document.querySelector('form:has(#tracer-row) button').hidden");
      await waitForStatus(driver, "Done.", 1);
      const rows = await driver.page.$$eval("#tracer .result tbody tr", (list) =>
        list.map((row) => [...row.cells].map((cell) => cell.textContent)));
      const printed = rt205(native, ["speedup", ...args, "--queue", "500", "--format", "md"]).split("\n")
        .filter((line) => /^\| .*\| (ours|paper|error %) *\|/.test(line))
        .map((line) => line.slice(1, -1).split("|").map((cell) => cell.trim() || "-"));
      assert.deepEqual(rows, printed);
    }
    await driver.close();
  },
};
