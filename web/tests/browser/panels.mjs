// panels.mjs - compares the panels with the engine's view after every instruction of a program:
// terms of the time, causes, regions, control bits, and the boxes of the time line. A failure means
// that a panel and the engine show different figures.

import assert from "node:assert/strict";
import { PageDriver } from "./page_driver.mjs";
import { COUNTS, LOOP } from "./texts.mjs";

// The program has control bits, a link, a scalar instruction that waits for a load, and a region.
const PROGRAM = `        .include "vectors.s"
        .regs   r16, xs, ys, zs, at, one, link
        .data
        .vector x, 5, 1.0, -2.0, 3.0, -4.0, 5.0
        .vector y, 5
        .bitvector z, 5
a:      .word   2.5
        .code
        descriptor xs, x, 5
        descriptor ys, y, 5
        descriptor zs, z, 5
        descriptor link, y, 5
        EX      at, a
        LOD     [at], one
        ADDN    one, one, one
        .kernel marked
        CMPGEV  [xs], r0, [zs]
        ADDNV   [xs], [xs], [ys] ? [zs]
        LINKV
        MPYSV   [xs], one, [link]
        ADDNV   [link], [ys], [ys]
        .endkernel
        EXIT
`;
const BITS = "10101";

const open = async ({ browser, page }) => {
  const driver = await PageDriver.open(browser, page);
  await driver.write(PROGRAM);
  return driver;
};

const number = (text) => Number(text.replaceAll(",", ""));
const rows = (driver, selector) => driver.page.$$eval(`${selector} tbody tr`, (list) => list.map((row) =>
  [...row.children].map((cell) => cell.textContent)));

// Executes the program step by step, and passes the view after each step to CHECK.
async function eachStep(driver, check) {
  for (let ended = false; !ended;) {
    await driver.press("step");
    const view = await driver.view();
    await check(view);
    ({ ended } = view);
  }
}

// Returns the clocks of the terms in the N-th formula, such as "3 memory wait + 1 issue".
const terms = (driver, n) => driver.page.$$eval("#instruction .formula", (list, which) =>
  [...list[which]?.querySelectorAll(".term b") ?? []].map((one) => one.textContent), n);

export const tests = {
  async "an instruction's time is the sum of its pieces, and of its phases"(world) {
    const driver = await open(world);
    let vectors = 0;
    await eachStep(driver, async ({ last }) => {
      const pieces = (await terms(driver, 0)).map(number);
      assert.deepEqual(pieces, last.pieces.map(({ clocks }) => clocks), last.text);
      assert.equal(pieces.reduce((sum, clocks) => sum + clocks, 0), last.clocks, last.text);
      if (last.phases.length === 0) return;
      vectors++;
      const phases = (await terms(driver, 1)).map(number);
      assert.deepEqual(phases, last.phases.map(({ begin, end }) => end - begin), last.text);
      assert.match(await driver.text("#instruction .formula:nth-of-type(3)"),
        new RegExp(`works for ${phases.reduce((sum, clocks) => sum + clocks, 0)} clocks`));
    });
    assert.ok(vectors >= 3);
    await driver.close();
  },

  async "causes and regions are the accounts"(world) {
    const driver = await open(world);
    await eachStep(driver, async ({ accounts }) => {
      const expected = accounts.causes.map(({ cause, clocks, percent }) => [cause, clocks, percent.toFixed(1)]);
      const shown = (await rows(driver, "#causes table:nth-of-type(1)"))
        .map(([cause, clocks, percent]) => [cause, number(clocks), percent]);
      assert.deepEqual(shown, [...expected, ["all", accounts.clocks, "100.0"]]);
    });
    const { accounts } = await driver.view();
    const regions = (await rows(driver, "#causes table:nth-of-type(2)"))
      .map(([region, ...figures]) => [region, ...figures.map(number)]);
    assert.deepEqual(regions, accounts.regions.map((row) =>
      [row.region, row.instructions, row.vector, row.elements, row.clocks]));
    await driver.close();
  },

  async "control bits are shown next to the elements that they select"(world) {
    const driver = await open(world);
    const marked = [];
    await eachStep(driver, async ({ vectors }) => {
      const shown = await driver.page.$$eval("#vectors .vector", (list) => Object.fromEntries(list.map((row) =>
        [row.querySelector("code").textContent, [...row.querySelectorAll("li")].map((cell) => ({
          value: cell.lastChild.textContent, bit: cell.querySelector(".bit")?.lastChild.textContent ?? "",
          masked: cell.classList.contains("masked"), changed: cell.classList.contains("changed") }))])));
      assert.deepEqual(Object.keys(shown), vectors.map(({ label }) => label));
      const control = [...vectors.find(({ label }) => label === "z").values];
      for (const { label, kind, values, first, stored } of vectors) {
        const controlled = kind !== "bits" && label !== "a";
        const changed = (i) => stored.some(({ first: from, count }) => i >= from && i < from + count);
        assert.deepEqual(shown[label], [...values].map((value, i) => ({ value,
          bit: controlled ? control[i] : "", masked: controlled && control[i] === "0",
          changed: changed(first + i) })), label);
        if (shown[label].some((cell) => cell.changed)) marked.push(label);
      }
    });
    assert.deepEqual(marked, ["z", "y", "y"]);
    assert.equal((await driver.view()).vectors.find(({ label }) => label === "z").values, BITS);
    await driver.close();
  },

  async "the time line of a million steps shows the last instructions, and all as shares of the causes"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    await driver.write(COUNTS.replace("n, 10", "n, 1200000"));
    await driver.press("run");
    await driver.page.waitForSelector("#timeline g.insn");
    assert.ok((await driver.view()).steps > 1e6);
    await driver.press("timeline button[title='All of the run']");
    await driver.page.waitForSelector("#timeline path");
    assert.equal(await driver.page.$("#timeline g.insn"), null);
    assert.match(await driver.text("#timeline .note"), /^More than 600 instructions: .* shares of the causes/);
    const { accounts, clock } = await driver.view();
    const { shares } = await driver.request({ do: "timeline", from: 0, to: clock, most: 600, columns: 300 });
    const sums = shares.map(({ cause, clocks }) => [cause, clocks.reduce((sum, n) => sum + n, 0)]);
    assert.deepEqual(sums, accounts.causes.map((one) => [one.cause, one.clocks]));
    assert.deepEqual(await driver.page.$$eval("#timeline path title", (list) => list.map((one) => one.textContent)),
      accounts.causes.map(({ cause }) => cause));
    await driver.close();
  },

  async "the reference is searched by name and by effect, and F1 explains the instruction at the cursor"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    const found = async (words) => {
      await driver.page.$eval("#reference-words", (input, text) => {
        input.value = text;
        input.dispatchEvent(new Event("input"));
      }, words);
      return driver.page.$$eval("#reference tbody th code:first-child", (list) => list.map((one) => one.textContent.split(" ")[0]));
    };
    await driver.press("tab-reference");
    const all = await driver.evaluate("about.instructions");
    assert.equal((await found("")).length, all.length);
    assert.equal((await found("addnv"))[0], "ADDNV");
    assert.deepEqual((await found("square root")).sort(),
      all.filter(({ effect }) => effect.includes("square root")).map(({ mnemonic }) => mnemonic).sort());
    assert.equal((await found("no such words")).length, 0);
    await driver.press("tab-machine");
    await driver.evaluate(`editor.toLine(${PROGRAM.split("\n").findIndex((line) => line.includes("MPYSV")) + 1})`);
    await driver.write(PROGRAM);
    await driver.evaluate(`editor.toLine(${PROGRAM.split("\n").findIndex((line) => line.includes("MPYSV")) + 1})`);
    await driver.key("F1");
    assert.equal(await driver.shown("#reference"), true);
    assert.match(await driver.text("#reference tbody th"), /^MPYSV /);
    await driver.evaluate("editor.toLine(1)");
    await driver.key("F1");
    assert.equal(await driver.shown("#keys-dialog"), true);
    await driver.close();
  },

  async "an endless loop is reported after 100,000,000 clocks"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    await driver.write(LOOP);
    await driver.page.click("#run");
    await driver.page.waitForFunction("/^Stopped after 100,000,000 clocks: probably an endless loop\\./.test(document.getElementById('status').textContent)");
    assert.ok((await driver.view()).clock >= 1e8);
    await driver.close();
  },

  async "boxes of the time line are as long as their clocks"(world) {
    const driver = await open(world);
    await driver.press("run");
    for (const button of [null, "Zoom in", "Later", "Earlier", "Zoom out", "All of the run"]) {
      if (button) await driver.page.click(`#timeline button[aria-label="${button}"]`);
      await driver.quiet();
      // Two ticks with their numbers give the scale from clocks to pixels.
      const { boxes, ticks, width: all, range } = await driver.page.$eval("#timeline svg", (svg) => ({
        boxes: [...svg.querySelectorAll("g.insn rect")].map((rect) => ({
          x: Number(rect.getAttribute("x")), width: Number(rect.getAttribute("width")),
          title: rect.textContent })),
        ticks: [...svg.querySelectorAll("text.clock")].map((text) => [Number(text.getAttribute("x")),
          Number(text.textContent.replaceAll(",", ""))]),
        width: svg.clientWidth, range: svg.parentNode.getAttribute("aria-label") }));
      const [[x0, clock0], [x1, clock1]] = [ticks[0], ticks.at(-1)];
      const x = (clock) => x0 + (x1 - x0) * (clock - clock0) / (clock1 - clock0);
      const end = number(/to (\S+)$/.exec(range)[1]);
      assert.ok(x(end) > 0.95 * all && x(end) <= all, `${button}: the range fills the picture`);
      const whole = boxes.map((box) => ({ ...box, clocks: /, (\d+) \.\. (\d+)\n/.exec(box.title).slice(1).map(Number) }))
        .filter(({ clocks: [begin, end] }) => x(begin) >= x0 && x(end) <= x1 && x(end) - x(begin) > 2);
      assert.ok(whole.length > 0, button);
      for (const { x: left, width, clocks: [begin, end], title } of whole) {
        assert.ok(Math.abs(left - x(begin)) < 0.5, `${button}: ${title}`);
        assert.ok(Math.abs(width - (x(end) - x(begin))) < 0.5, `${button}: ${title}`);
      }
    }
    await driver.close();
  },
};
