// course.mjs - for every lesson, compares the page's verdict on the starting text and on the
// solution with the JSON report of c205 check: sentences, clocks and result. It also checks the
// lesson texts and the data stored between visits. A failure means that the page grades or stores
// an answer differently.

import assert from "node:assert/strict";
import { PageDriver } from "./page_driver.mjs";
import { PRINTS, SUM, WRONG } from "./texts.mjs";

// Checks that page and c205 have the same verdict on an answer. Returns the verdict of c205.
async function verdict(driver, native, { name }, answer) {
  await driver.write(answer);
  await driver.press("check");
  await driver.page.waitForFunction("!document.getElementById('verdict').hidden");
  const expected = native.json(["check", name, `${name}.s`], { [`${name}.s`]: answer });
  const words = await driver.page.$$eval("#verdict p:not(.tries)", (list) => list.map((p) => p.textContent));
  assert.deepEqual(words, [...expected.report, ...expected.tests.flatMap(({ report }) => report)], name);
  const clocks = await driver.page.$$eval("#verdict h4 small", (list) =>
    list.map((small) => parseInt(small.textContent.replaceAll(",", ""), 10)));
  const ran = (list) => list.filter((n) => n > 0);
  assert.deepEqual(ran(clocks), ran(expected.tests.map((test) => test.clocks)), name);
  const passed = await driver.page.$eval("#verdict", (node) => node.classList.contains("passed"));
  assert.equal(passed, expected.passed, name);
  const reply = await driver.request({ do: "grade", lesson: name, name: `${name}.s`, text: answer });
  for (const [key, value] of Object.entries(expected))
    if (!["status", "answer"].includes(key)) assert.deepEqual(reply[key], value, `${name}: ${key}`);
  return expected;
}

export const tests = {
  async "every lesson: solution and start are graded as by c205 check"({ browser, page, native, print }) {
    const driver = await PageDriver.open(browser, page);
    const offered = await driver.page.$$eval("#lesson optgroup[label=Course] option",
      (options) => options.map(({ value }) => value.slice("lesson:".length)));
    assert.deepEqual(offered, native.lessons.map(({ name }) => name));
    for (const lesson of native.lessons) {
      await driver.choose("lesson", `lesson:${lesson.name}`);
      assert.equal(await driver.evaluate("editor.text"), lesson.start, lesson.name);
      assert.ok((await driver.page.$$("#lesson-text details")).length >= 3, `${lesson.name}: hints`);
      const begun = await verdict(driver, native, lesson, lesson.start);
      assert.equal(begun.passed, false, lesson.name);
      const done = await verdict(driver, native, lesson, lesson.solution);
      assert.equal(done.passed, true, lesson.name);
    }
    // The first answer cannot be assembled; the second does not solve the exercise.
    for (const answer of [WRONG, SUM]) {
      const graded = await verdict(driver, native, native.lessons.at(-1), answer);
      assert.equal(graded.passed, false);
    }
    const titles = await driver.page.$$eval("#lesson optgroup[label=Course] option", (options) =>
      options.map(({ textContent }) => textContent));
    for (const title of titles) assert.match(title, /✓/);
    print(`${titles.length} lessons`);
    await driver.close();
  },

  async "a passed exercise leads to the next lesson, to the solution and to a comparison with it"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    const [{ name, start, solution }, second] = native.lessons;
    const step = (n) => driver.press(`verdict .steps button:nth-child(${n})`);
    await driver.press("check");
    assert.equal(await driver.page.$("#verdict .steps"), null);
    assert.equal(await driver.page.$(`#lesson option[value="solution:${name}"]`), null);
    await driver.write(solution);
    await driver.press("check");
    await step(3);
    await driver.page.waitForSelector("#compare .verdict-words");
    assert.match(await driver.text("#compare .verdict-words"), /^Both take/);
    await step(2);
    assert.equal(await driver.evaluate("editor.text"), solution);
    await driver.press("exercise");
    await driver.press("check");
    await step(1);
    assert.equal(await driver.evaluate("editor.text"), second.start);
    assert.notEqual(start, second.start);
    await driver.close();
  },

  async "pictures and links of lessons"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    const lessons = await driver.page.$$eval("#lesson optgroup[label=Course] option", (options) =>
      options.map(({ value }) => value));
    for (const lesson of lessons) {
      await driver.choose("lesson", lesson);
      const bad = await driver.page.$eval("#lesson-text", async (text) => {
        const pictures = [...text.querySelectorAll("figure .scroll > svg")];
        return pictures.filter((picture) => picture.viewBox.baseVal.width === 0 || !picture.ariaLabel).length;
      });
      assert.equal(bad, 0, lesson);
      const dead = await driver.page.$$eval("#lesson-text a", (links) => links.map((link) => link.dataset.lesson)
        .filter((name) => name && !window.c205.about.lessons.some((one) => one.name === name)));
      assert.deepEqual(dead, [], lesson);
    }
    await driver.close();
  },

  async "an edited text is stored"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    const [first, second] = native.lessons;
    await driver.choose("lesson", `lesson:${first.name}`);
    await driver.write(`${first.start}; mine\n`);
    await driver.choose("lesson", `lesson:${second.name}`);
    await driver.page.reload();
    await driver.page.waitForSelector("body.ready");
    await driver.quiet();
    assert.equal(await driver.text("#lesson-heading"), await driver.evaluate(
      `((l) => l.number + ' ' + l.title)(about.lessons.find(({ name }) => name === '${second.name}'))`));
    await driver.choose("lesson", `lesson:${first.name}`);
    assert.equal(await driver.evaluate("editor.text"), `${first.start}; mine\n`);
    await driver.press("restore");
    assert.equal(await driver.evaluate("editor.text"), first.start);
    await driver.close();
  },

  async "a text that cannot be stored causes a warning"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    assert.equal(await driver.shown("#unstored"), false);
    await driver.page.evaluate(() => {
      for (let size = 1 << 22, n = 0; size > 0; n++)
        try { localStorage.setItem(`fill${n}`, "x".repeat(size)); } catch { size >>= 1; }
    });
    await driver.write("; lost\n".repeat(100));
    assert.match(await driver.text("#unstored"), /^The storage of this browser is full\. .* copy it, or use Share\.$/);
    assert.equal(await driver.shown("#unstored"), true);
    // A value that fits must not hide the warning about another value.
    await driver.page.evaluate("localStorage.removeItem('fill0')");
    await driver.press("theme");
    assert.equal(await driver.shown("#unstored"), true);
    await driver.write(PRINTS);
    assert.equal(await driver.shown("#unstored"), false);
    await driver.page.evaluateOnNewDocument(() => Object.defineProperty(window, "localStorage",
      { get() { throw new DOMException("off", "SecurityError"); } }));
    await driver.page.reload();
    await driver.page.waitForSelector("body.ready");
    assert.match(await driver.text("#unstored"), /^This browser stores no data for this page\./);
    await driver.close();
  },

  async "what is stored in another form does not stop the page"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    const { name, start } = native.lessons[0];
    const values = ["5", "true", "null", "[1]", "{}", '"own"', "not JSON", "",
      '{"text": 5, "medal": {}, "passed": ""}', '{"text": {"length": 3}, "passed": 1, "medal": ["gold"]}'];
    for (const [i, value] of values.entries()) {
      const at = [value, '"own"', `"lesson:${name}"`][i % 3];
      await driver.page.evaluate((value, at, name) => {
        for (const key of ["own", `lesson.${name}`, "split", "theme"]) localStorage.setItem(`c205.${key}`, value);
        localStorage.setItem("c205.at", at);
      }, value, at, name);
      await driver.page.reload();
      await driver.page.waitForSelector("body.ready");
      await driver.quiet();
      await driver.choose("lesson", `lesson:${name}`);
      assert.equal(await driver.evaluate("editor.text"), start, value);
      assert.ok(!(await driver.text("#lesson")).includes("✓"), value);
      await driver.choose("lesson", "own");
      assert.equal(typeof await driver.evaluate("editor.text"), "string", value);
    }
    await driver.close();
  },

  async "pages begin as the lesson's tests have them"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    for (const { name } of native.lessons) {
      await driver.choose("lesson", `lesson:${name}`);
      const warm = await driver.evaluate(`about.lessons.find((one) => one.name === "${name}").tests.every((test) => test.warm)`);
      assert.equal(await driver.page.$eval("#warm", ({ value }) => value), warm ? "warm" : "", name);
      await driver.press("run");
      const faults = (await driver.view()).accounts.causes.find(({ cause }) => cause === "page fault");
      if (warm) assert.equal(faults?.clocks ?? 0, 0, name);
    }
    // The choice is valid until another program is opened. A program without a lesson has the
    // choice "".
    await driver.choose("warm", "cold");
    await driver.press("run");
    assert.equal(await driver.evaluate("session.warm"), "cold");
    await driver.choose("lesson", "example:saxpy_vector.s");
    assert.equal(await driver.evaluate("session.warm"), "");
    await driver.close();
  },

  async "an example is opened from the text, and left for the exercise"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    for (const { name, start } of native.lessons.slice(0, 5)) {
      await driver.choose("lesson", `lesson:${name}`);
      const examples = await driver.page.$$eval("[data-example]", (list) => list.map(({ dataset }) => dataset.example));
      assert.ok(examples.length > 0, name);
      await driver.page.click("[data-example]");
      await driver.quiet();
      assert.equal(await driver.evaluate("session.name"), examples[0]);
      assert.equal(await driver.page.$eval("#check", ({ disabled }) => disabled), true);
      assert.equal(await driver.shown("#lesson-panel"), true);
      await driver.press("run");
      assert.equal((await driver.view()).ended, true, `${name}: ${examples[0]}`);
      await driver.press("exercise");
      assert.equal(await driver.evaluate("editor.text"), start);
      assert.equal(await driver.shown("#exercise"), false);
    }
    assert.ok(!(await driver.page.$eval("#lesson-text", ({ textContent }) => textContent)).includes("@example-"));
    await driver.close();
  },

  async "a check that takes long is stopped at once, and the page continues"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    await driver.write(native.lessons[0].start.replace(/^ +EXIT/m, "again:  BIM     again"));
    await driver.page.click("#check");
    await driver.page.waitForFunction("document.body.classList.contains('busy')");
    const begun = performance.now();
    await driver.page.click("#stop");
    await driver.page.waitForFunction("document.getElementById('status').textContent === 'Stopped by you.'");
    assert.ok(performance.now() - begun < 2000);
    await driver.press("step");
    assert.equal((await driver.view()).step, 1);
    await driver.write(PRINTS);
    await driver.press("check");
    assert.equal(await driver.shown("#verdict"), true);
    await driver.close();
  },
};
