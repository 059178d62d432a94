// tracing.mjs - the ray tracer in the page says what rt205 says, and its picture grows.

import assert from "node:assert/strict";
import { Visit } from "./visit.mjs";

const finished = (visit) => visit.page.waitForFunction(
  "document.querySelector('#raytracer .accounts').textContent !== ''", { timeout: 120000 });

const SCENE = `camera { location <0, 0, -3> look_at 0 }
light_source { <4, 6, -5> color rgb 1 }
sphere { 0, 1 pigment { color rgb <1, .2, .2> } }
`;

export const tests = {
  async "a frame has the accounts of the command line, byte for byte"({ browser, page, native }) {
    const visit = await Visit.open(browser, page);
    await visit.press("tab-raytracer");
    for (const [stage, queue] of [["vector", "2000"], ["kernels", "500"], ["scalar", "2000"]]) {
      await visit.page.select("#rt-scene", "");
      await visit.page.select("#rt-stage", stage);
      await visit.page.select("#rt-size", "80x60");
      await visit.page.$eval("#rt-text", (text, words) => { text.value = words; }, SCENE);
      await visit.page.$eval("#rt-queue", (input, value) => { input.value = value; }, queue);
      await visit.page.click("#raytracer button[type=submit]");
      await finished(visit);
      const said = await visit.text("#raytracer .accounts");
      const { out } = native.rt205(["render", "scene.pov", "--no-picture", "--accounts", "-W", "80", "-H", "60",
        "--mode", stage, "--queue", queue, "--model", "cyber205-2pipe", "--jobs", "1"], { "scene.pov": SCENE });
      assert.equal(said, out, stage);
    }
    // The sphere is red in the middle.
    const [red, green] = await visit.page.$eval("#raytracer canvas", (canvas) =>
      [...canvas.getContext("2d").getImageData(40, 30, 1, 1).data]);
    assert.ok(red > 60 && green < red / 2, `${red}, ${green}`);
    await visit.close();
  },

  async "a scene that is wrong is told; one that takes long is stopped"({ browser, page }) {
    const visit = await Visit.open(browser, page);
    await visit.press("tab-raytracer");
    await visit.page.select("#rt-scene", "");
    await visit.page.$eval("#rt-text", (text) => { text.value = "sphere { 0, }"; });
    await visit.page.click("#raytracer button[type=submit]");
    await finished(visit);
    assert.match(await visit.text("#raytracer .accounts"), /scene.pov:1:\d+: error/);
    await visit.page.select("#rt-scene", "bracket.pov");
    await visit.page.select("#rt-size", "640x480");
    await visit.page.click("#raytracer button[type=submit]");
    await visit.page.waitForSelector("#raytracer .clocks-so-far b");
    await visit.page.evaluate(() => [...document.querySelectorAll("#raytracer button")]
      .find(({ textContent }) => textContent === "Stop").click());
    assert.equal(await visit.text("#raytracer .note"), "Stopped.");
    await visit.close();
  },
};
