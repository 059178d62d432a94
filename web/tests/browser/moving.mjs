// moving.mjs - steps forward and backward, drags the slider, stops at breakpoints, sends commands
// and opens links. All panels must show the same state at the same step. A failure means that the
// state of a panel depends on how the step was reached.

import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import { deflateRawSync } from "node:zlib";
import { Visit } from "./visit.mjs";
import { SUM, SUM_LOOP, WRONG } from "./texts.mjs";

const open = async ({ browser, page }, text = SUM) => {
  const visit = await Visit.open(browser, page);
  await visit.write(text);
  return visit;
};

// Returns the texts of the panels that show the state of the program.
const PANELS = ["where", "instruction", "causes", "registers", "vectors", "output"];
const shown = (visit) => visit.page.evaluate((panels) =>
  panels.map((id) => document.getElementById(id).textContent), PANELS);

async function slide(visit, step) {
  await visit.page.$eval("#slider", (slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event("input"));
  }, step);
  await visit.quiet();
}

// Returns a function that yields random numbers below N. The seed determines the sequence.
function dice(seed) {
  let state = seed;
  return (n) => {
    state = (Math.imul(state, 1103515245) + 12345) & 0x7fffffff;
    return (state >>> 8) % n;
  };
}

export const tests = {
  async "steps forth and back show the same"(world) {
    const visit = await open(world);
    const seen = [];
    for (let i = 0; i < 12; i++) {
      seen.push(await shown(visit));
      await visit.press("step");
    }
    for (let i = 11; i >= 0; i--) {
      await visit.press("back");
      // PANELS[0] differs: it shows the number of known steps.
      const now = await shown(visit);
      assert.deepEqual(now.slice(1), seen[i].slice(1));
      assert.equal((await visit.view()).step, i);
    }
    assert.equal(await visit.page.$eval("#back", (button) => button.disabled), true);
    await visit.close();
  },

  async "a random walk shows each step as the way there did"(world) {
    const visit = await open(world);
    const seed = Math.floor(Math.random() * 2 ** 31);
    const random = dice(seed);
    await visit.evaluate(`editor.toLine(${SUM_LOOP})`);
    await visit.key("F9");
    const seen = [];
    for (let ended = false; !ended; { ended } = await visit.view()) {
      seen.push(await shown(visit));
      await visit.press("step");
    }
    seen.push(await shown(visit));
    for (let i = 0; i < 60; i++) {
      const way = ["run", "reset", "before", "back", "step", "on", "slider"][random(7)];
      if (way === "slider") await slide(visit, random(seen.length));
      else if (await visit.page.$eval(`#${way}`, (button) => !button.disabled)) await visit.press(way);
      const { step } = await visit.view();
      assert.deepEqual((await shown(visit)).slice(1), seen[step].slice(1),
        `seed ${seed}, move ${i}, ${way}: step ${step}`);
    }
    await visit.close();
  },

  async "what an instruction changed is marked"(world) {
    const visit = await open(world);
    await visit.press("step");
    await visit.press("step");
    assert.equal(await visit.text("#registers tr.changed th"), "r17 one changed");
    await visit.close();
  },

  async "the slider goes to any step"(world) {
    const visit = await open(world);
    await visit.press("run");
    const { steps } = await visit.view();
    assert.equal(await visit.page.$eval("#slider", (slider) => Number(slider.max)), steps);
    for (const step of [3, steps - 1, 0, 7]) {
      await slide(visit, step);
      assert.equal((await visit.view()).step, step);
    }
    await visit.page.focus("#slider");
    await visit.key("ArrowRight");
    assert.equal((await visit.view()).step, 8);
    await visit.close();
  },

  async "breakpoints: in the gutter, by a key, both ways"(world) {
    const visit = await open(world);
    const lines = await visit.page.$$(".cm-lineNumbers .cm-gutterElement");
    for (const line of lines)
      if (await line.evaluate((node) => node.textContent) === String(SUM_LOOP)) await line.click();
    await visit.quiet();
    assert.equal((await visit.page.$$(".mark-break")).length, 1);
    await visit.press("on");
    const first = await visit.view();
    assert.equal(first.line, SUM_LOOP);
    await visit.press("on");
    const second = await visit.view();
    assert.equal(second.line, SUM_LOOP);
    assert.ok(second.step > first.step);
    await visit.press("before");
    assert.equal((await visit.view()).step, first.step);
    await visit.evaluate(`editor.toLine(${SUM_LOOP})`);
    await visit.key("F9");
    assert.equal((await visit.page.$$(".mark-break")).length, 0);
    await visit.press("on");
    assert.equal((await visit.view()).ended, true);
    await visit.close();
  },

  async "keys do what the buttons do"(world) {
    const visit = await open(world);
    const at = async () => (await visit.view()).step;
    await visit.key("F4");
    await visit.key("F4");
    assert.equal(await at(), 2);
    await visit.key("Shift+F4");
    assert.equal(await at(), 1);
    await visit.key("F8");
    assert.equal((await visit.view()).ended, true);
    await visit.key("Shift+F8");
    assert.equal(await at(), 0);
    await visit.key("F1");
    assert.equal(await visit.shown("#keys-dialog"), true);
    await visit.key("Escape");
    assert.equal(await visit.shown("#keys-dialog"), false);
    await visit.close();
  },

  async "a click in the time line goes to the instruction"(world) {
    const visit = await open(world);
    await visit.press("run");
    await visit.page.$eval("#timeline .insn", (group) => group.dispatchEvent(new MouseEvent("click")));
    await visit.quiet();
    assert.equal((await visit.view()).step, 1);
    await visit.close();
  },

  async "the console has the debugger's verbs"(world) {
    const visit = await open(world);
    await visit.press("tab-console");
    await visit.page.type("#console-line", "step 3\n");
    await visit.page.waitForSelector(".transcript pre");
    await visit.quiet();
    assert.equal((await visit.view()).step, 3);
    await visit.page.type("#console-line", "nonsense\n");
    await visit.page.waitForFunction("document.querySelectorAll('.transcript pre').length === 2");
    assert.match(await visit.text(".transcript"), /nonsense/);
    await visit.page.focus("#console-line");
    await visit.key("ArrowUp");
    assert.equal(await visit.page.$eval("#console-line", (line) => line.value), "nonsense");
    await visit.close();
  },

  async "errors are shown at their lines"(world) {
    const visit = await open(world, WRONG);
    assert.match(await visit.text("#status"), /^2 errors/);
    assert.equal((await visit.page.$$("#faults .error")).length, 2);
    assert.equal(await visit.page.$eval("#run", (button) => button.disabled), true);
    await visit.page.click("#faults li:nth-child(2) button");
    const line = await visit.evaluate(
      "(({ doc, selection }) => doc.lineAt(selection.main.head).number)(editor.view.state)");
    assert.equal(line, 3);
    await visit.write(SUM);
    assert.equal(await visit.shown("#faults"), false);
    await visit.close();
  },

  async "a link has all in it"(world) {
    const visit = await open(world, `${SUM}; naïve Ωmega — "quoted" <tags> & more\n`);
    await visit.choose("model", "cyber205-4pipe");
    await visit.choose("warm", "cold");
    await visit.page.click("#share");
    await visit.page.waitForFunction("location.hash.length > 1");
    const address = visit.page.url();
    const text = await visit.evaluate("editor.text");
    await visit.close();

    const other = await Visit.open(world.browser, address);
    assert.equal(await other.evaluate("editor.text"), text);
    assert.equal(await other.evaluate("session.model"), "cyber205-4pipe");
    assert.equal(await other.evaluate("session.warm"), "cold");
    await other.close();
  },

  // Programs up to the limits and beyond, with good and with poor compression.
  async "Share makes only links that it opens"(world) {
    const noise = (length) => randomBytes(length).toString("base64").slice(0, length);
    const MAX = 1 << 20;
    let made = 0, refused = 0;
    for (const text of [";".repeat(MAX), "é".repeat(MAX / 2), "é".repeat(MAX / 2 + 1), noise(MAX),
      ...[5.1e5, 5.3e5, 6e5].map(noise)]) {
      const visit = await open(world, text);
      await visit.page.click("#share");
      await visit.page.waitForFunction(
        "/^The (link is in|program is too long)/.test(document.getElementById('status').textContent)");
      const status = await visit.text("#status"), address = visit.page.url();
      await visit.close();
      if (status.startsWith("The link is in")) {
        const other = await Visit.open(world.browser, address);
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
    const visit = await open(world, SUM);
    const limit = /^The text was rejected: .* 30,0\d\d,\d\d\d characters, and the limit is 1,048,576\.$/;
    await visit.page.evaluate(() => {
      const clipboardData = new DataTransfer();
      clipboardData.setData("text/plain", "; pasted\n".repeat(30e6 / 9));
      document.querySelector(".cm-content").dispatchEvent(
        new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
    });
    assert.match(await visit.text("#status"), limit);
    assert.equal(await visit.evaluate("editor.text"), SUM);
    await visit.page.evaluate("window.c205.editor.type('x'.repeat(1 << 20))");
    await visit.quiet();
    assert.equal(await visit.evaluate("editor.text.length"), 1 << 20);
    await visit.page.evaluate("window.c205.editor.type('x'.repeat(1 + (1 << 20)))");
    assert.match(await visit.text("#status"), /^The text was rejected/);
    await visit.write(SUM);
    await visit.press("run");
    assert.equal((await visit.view()).ended, true);
    await visit.close();
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
      const visit = await Visit.open(browser, `${page}#${link}`);
      assert.match(await visit.text("#status"), message instanceof RegExp ? message : new RegExp(`^${message}$`), link.slice(0, 40));
      assert.equal(await visit.evaluate("editor.text"), text ?? await visit.evaluate("about.lessons[0].start"));
      assert.equal(await visit.page.$eval("#lesson", ({ value }) => value),
        text ? "own" : `lesson:${await visit.evaluate("about.lessons[0].name")}`);
      await visit.close();
    }
    const visit = await Visit.open(browser, page);
    await visit.page.evaluate("location.hash = 'program=' + 'A'.repeat(1 << 19)");
    await visit.page.waitForFunction("/^The link cannot/.test(document.getElementById('status').textContent)");
    assert.match(await visit.text("#status"), /: its program is too long .* 524,288 characters in the link\.$/);
    await visit.close();
  },
};
