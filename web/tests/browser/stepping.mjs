// stepping.mjs - steps forward and backward, drags the slider, stops at breakpoints, sends commands
// and opens links. All panels must show the same state at the same step. A failure means that the
// state of a panel depends on how the step was reached.

import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import { deflateRawSync } from "node:zlib";
import { PageDriver } from "./page_driver.mjs";
import { SUM, SUM_LOOP, WRONG } from "./texts.mjs";

const open = async ({ browser, page }, text = SUM) => {
  const driver = await PageDriver.open(browser, page);
  await driver.write(text);
  return driver;
};

// The panels that show the state of the program.
const PANELS = ["where", "instruction", "causes", "registers", "vectors", "output"];
const shown = (driver) => driver.page.evaluate((panels) =>
  panels.map((id) => document.getElementById(id).textContent), PANELS);

async function slide(driver, step) {
  await driver.page.$eval("#slider", (slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event("input"));
  }, step);
  await driver.quiet();
}

// Returns a generator of random numbers below N. The seed determines the sequence.
function dice(seed) {
  let state = seed;
  return (n) => {
    state = (Math.imul(state, 1103515245) + 12345) & 0x7fffffff;
    return (state >>> 8) % n;
  };
}

export const tests = {
  async "steps forth and back show the same"(world) {
    const driver = await open(world);
    const recorded = [];
    for (let i = 0; i < 12; i++) {
      recorded.push(await shown(driver));
      await driver.press("step");
    }
    for (let i = 11; i >= 0; i--) {
      await driver.press("back");
      // The first panel is not compared, because it shows the number of known steps.
      const now = await shown(driver);
      assert.deepEqual(now.slice(1), recorded[i].slice(1));
      assert.equal((await driver.view()).step, i);
    }
    assert.equal(await driver.page.$eval("#back", (button) => button.disabled), true);
    await driver.close();
  },

  async "a random walk shows each step as the first run did"(world) {
    const driver = await open(world);
    const seed = Math.floor(Math.random() * 2 ** 31);
    const random = dice(seed);
    await driver.evaluate(`editor.toLine(${SUM_LOOP})`);
    await driver.key("F9");
    const recorded = [];
    for (let ended = false; !ended; { ended } = await driver.view()) {
      recorded.push(await shown(driver));
      await driver.press("step");
    }
    recorded.push(await shown(driver));
    for (let i = 0; i < 60; i++) {
      const way = ["run", "reset", "reverse-continue", "back", "step", "continue", "slider"][random(7)];
      if (way === "slider") await slide(driver, random(recorded.length));
      else if (await driver.page.$eval(`#${way}`, (button) => !button.disabled)) await driver.press(way);
      const { step } = await driver.view();
      assert.deepEqual((await shown(driver)).slice(1), recorded[step].slice(1),
        `seed ${seed}, move ${i}, ${way}: step ${step}`);
    }
    await driver.close();
  },

  async "what an instruction changed is marked"(world) {
    const driver = await open(world);
    await driver.press("step");
    await driver.press("step");
    assert.equal(await driver.text("#registers tr.changed th"), "r17 one changed");
    await driver.close();
  },

  async "the slider goes to any step"(world) {
    const driver = await open(world);
    await driver.press("run");
    const { steps } = await driver.view();
    assert.equal(await driver.page.$eval("#slider", (slider) => Number(slider.max)), steps);
    for (const step of [3, steps - 1, 0, 7]) {
      await slide(driver, step);
      assert.equal((await driver.view()).step, step);
    }
    await driver.page.focus("#slider");
    await driver.key("ArrowRight");
    assert.equal((await driver.view()).step, 8);
    await driver.close();
  },

  async "breakpoints: in the gutter, by a key, both ways"(world) {
    const driver = await open(world);
    const lines = await driver.page.$$(".cm-lineNumbers .cm-gutterElement");
    for (const line of lines)
      if (await line.evaluate((node) => node.textContent) === String(SUM_LOOP)) await line.click();
    await driver.quiet();
    assert.equal((await driver.page.$$(".mark-break")).length, 1);
    await driver.press("continue");
    const first = await driver.view();
    assert.equal(first.line, SUM_LOOP);
    await driver.press("continue");
    const second = await driver.view();
    assert.equal(second.line, SUM_LOOP);
    assert.ok(second.step > first.step);
    await driver.press("reverse-continue");
    assert.equal((await driver.view()).step, first.step);
    await driver.evaluate(`editor.toLine(${SUM_LOOP})`);
    await driver.key("F9");
    assert.equal((await driver.page.$$(".mark-break")).length, 0);
    assert.equal(await driver.shown("#continue"), false);
    await driver.key("F2");
    assert.equal((await driver.view()).ended, true);
    await driver.close();
  },

  async "keys do what the buttons do"(world) {
    const driver = await open(world);
    const at = async () => (await driver.view()).step;
    await driver.key("F4");
    await driver.key("F4");
    assert.equal(await at(), 2);
    await driver.key("Shift+F4");
    assert.equal(await at(), 1);
    await driver.key("F8");
    assert.equal((await driver.view()).ended, true);
    await driver.key("Shift+F8");
    assert.equal(await at(), 0);
    await driver.key("F1");
    assert.equal(await driver.shown("#keys-dialog"), true);
    await driver.key("Escape");
    assert.equal(await driver.shown("#keys-dialog"), false);
    await driver.close();
  },

  async "a click in the time line goes to the instruction"(world) {
    const driver = await open(world);
    await driver.press("run");
    await driver.page.$eval("#timeline .insn", (group) => group.dispatchEvent(new MouseEvent("click")));
    await driver.quiet();
    assert.equal((await driver.view()).step, 1);
    await driver.close();
  },

  async "the console has the debugger's verbs"(world) {
    const driver = await open(world);
    await driver.press("tab-console");
    await driver.page.type("#console-line", "step 3\n");
    await driver.page.waitForSelector(".transcript pre");
    await driver.quiet();
    assert.equal((await driver.view()).step, 3);
    await driver.page.type("#console-line", "nonsense\n");
    await driver.page.waitForFunction("document.querySelectorAll('.transcript pre').length === 2");
    assert.match(await driver.text(".transcript"), /nonsense/);
    await driver.page.focus("#console-line");
    await driver.key("ArrowUp");
    assert.equal(await driver.page.$eval("#console-line", (line) => line.value), "nonsense");
    await driver.close();
  },

  async "errors are shown at their lines"(world) {
    const driver = await open(world, WRONG);
    assert.match(await driver.text("#status"), /^2 errors/);
    assert.equal((await driver.page.$$("#faults .error")).length, 2);
    assert.equal(await driver.page.$eval("#run", (button) => button.disabled), true);
    await driver.page.click("#faults li:nth-child(2) button");
    const line = await driver.evaluate(
      "(({ doc, selection }) => doc.lineAt(selection.main.head).number)(editor.view.state)");
    assert.equal(line, 3);
    await driver.write(SUM);
    assert.equal(await driver.shown("#faults"), false);
    await driver.close();
  },

  async "warnings and the trap of a run are below the program"(world) {
    const driver = await open(world, " .reg base, r15\n ES r1, 3\n ES r2, 1\n MPYS r1, r2, r3\n"
      + " ES base, 64\n LOD [base], r16\n EXIT\n");
    assert.equal(await driver.shown("#faults"), false);
    await driver.press("run");
    assert.deepEqual(await driver.page.$$eval("#faults li", (all) => all.map(({ className }) => className)),
      ["warning", "error"]);
    assert.match(await driver.text("#faults .warning"), /^line 4 r1 is the integer 3, not 3\.0/);
    assert.match(await driver.text("#faults .error"), /base \(r15\) = X'0000 0000 0000 0040' \(64\)/);
    assert.match(await driver.text("#status"), /^Line 6: trap unmapped-address at [^\n]*there\.$/);
    assert.equal((await driver.page.$$(".cm-lintRange-error")).length, 1);
    await driver.press("reset");
    assert.equal(await driver.shown("#faults"), false);
    await driver.press("tab-laboratory");
    await driver.write(WRONG);
    await driver.press("laboratory button[type=submit]");
    assert.equal((await driver.page.$$("#laboratory .faults .error")).length, 2);
    await driver.close();
  },

  async "a link has all in it"(world) {
    const driver = await open(world, `${SUM}; naïve Ωmega — "quoted" <tags> & more\n`);
    await driver.choose("model", "cyber205-4pipe");
    await driver.choose("warm", "cold");
    await driver.page.click("#share");
    await driver.page.waitForFunction("location.hash.length > 1");
    const address = driver.page.url();
    const text = await driver.evaluate("editor.text");
    await driver.close();

    const other = await PageDriver.open(world.browser, address);
    assert.equal(await other.evaluate("editor.text"), text);
    assert.equal(await other.evaluate("session.model"), "cyber205-4pipe");
    assert.equal(await other.evaluate("session.warm"), "cold");
    await other.close();
  },

  // The programs are below and above the limits, and compress well or poorly.
  async "Share makes only links that it opens"(world) {
    const noise = (length) => randomBytes(length).toString("base64").slice(0, length);
    const MAX = 1 << 20;
    let made = 0, refused = 0;
    for (const text of [";".repeat(MAX), "é".repeat(MAX / 2), "é".repeat(MAX / 2 + 1), noise(MAX),
      ...[5.1e5, 5.3e5, 6e5].map(noise)]) {
      const driver = await open(world, text);
      await driver.page.click("#share");
      await driver.page.waitForFunction(
        "/^The (link is in|program is too long)/.test(document.getElementById('status').textContent)");
      const status = await driver.text("#status"), address = driver.page.url();
      await driver.close();
      if (status.startsWith("The link is in")) {
        const other = await PageDriver.open(world.browser, address);
        assert.ok(await other.evaluate("editor.text") === text);
        await other.close();
        made++;
      } else {
        assert.match(status, /too long for a link: the limit is (1,048,576 bytes|524,288 characters in the link)\.$/);
        assert.ok(!address.includes("#"));
        refused++;
      }
    }
    assert.ok(made > 2 && refused > 2, `${made} made, ${refused} refused`);
  },

  async "a text that is too long is rejected with the limit, however it comes"(world) {
    const driver = await open(world, SUM);
    const limit = /^The text was rejected: .* 30,0\d\d,\d\d\d characters, and the limit is 1,048,576\.$/;
    await driver.page.evaluate(() => {
      const clipboardData = new DataTransfer();
      clipboardData.setData("text/plain", "; pasted\n".repeat(30e6 / 9));
      document.querySelector(".cm-content").dispatchEvent(
        new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
    });
    assert.match(await driver.text("#status"), limit);
    assert.equal(await driver.evaluate("editor.text"), SUM);
    await driver.page.evaluate("window.c205.editor.type('x'.repeat(1 << 20))");
    await driver.quiet();
    assert.equal(await driver.evaluate("editor.text.length"), 1 << 20);
    await driver.page.evaluate("window.c205.editor.type('x'.repeat(1 + (1 << 20)))");
    assert.match(await driver.text("#status"), /^The text was rejected/);
    await driver.write(SUM);
    await driver.press("run");
    assert.equal((await driver.view()).ended, true);
    await driver.close();
  },

  async "a damaged link is reported and does no harm"({ browser, page }) {
    const packed = (bytes) => deflateRawSync(bytes).toString("base64url");
    const mine = "        EXIT    ; a text of mine\n";
    const DAMAGED = "The link is damaged: it contains no program.";
    const ABSENT = "The link names an unknown lesson.";
    for (const [link, message, text] of [
      ["model=x&program=!!", DAMAGED], ["program=", DAMAGED], [`program=${"A".repeat(100000)}`, DAMAGED],
      [`program=${packed(Buffer.alloc(1 << 27, "; much\n"))}`, /^The link cannot be opened: .* limit is 1,048,576 bytes\.$/],
      ["lesson=%3Cimg%20src=x%3E", ABSENT], ["lesson=__proto__", ABSENT],
      [`lesson=none&model=none&pages=none&program=${packed(mine)}`, ABSENT, mine], ["%E0%A4%A", /^Ready/]]) {
      const driver = await PageDriver.open(browser, `${page}#${link}`);
      assert.match(await driver.text("#status"), message instanceof RegExp ? message : new RegExp(`^${message}$`), link.slice(0, 40));
      assert.equal(await driver.evaluate("editor.text"), text ?? await driver.evaluate("window.c205.example('first.s')"));
      assert.equal(await driver.page.$eval("#lesson", ({ value }) => value),
        text ? "own" : "example:first.s");
      await driver.close();
    }
    const driver = await PageDriver.open(browser, page);
    await driver.page.evaluate("location.hash = 'program=' + 'A'.repeat(1 << 19)");
    await driver.page.waitForFunction("/^The link cannot/.test(document.getElementById('status').textContent)");
    assert.match(await driver.text("#status"), /: its program is too long .* 524,288 characters in the link\.$/);
    await driver.close();
  },
};
