// programs.mjs - compares output, clocks, sweeps and comparisons of the page with c205 run, sweep
// and compare, for all examples. A failure means that the page and the command show different
// figures.

import assert from "node:assert/strict";
import { COUNTS, PRINTS_MUCH } from "./texts.mjs";
import { PageDriver } from "./page_driver.mjs";

const PLAIN = ["--model", "cyber205-2pipe"];

export const tests = {
  async "examples have the output and clocks of c205 run"({ browser, page, native, print }) {
    const driver = await PageDriver.open(browser, page);
    const examples = await driver.page.$$eval("#lesson optgroup[label=Examples] option",
      (options) => options.map(({ value }) => value));
    assert.ok(examples.length > 5);
    for (const example of examples) {
      await driver.choose("lesson", example);
      await driver.press("run");
      const text = await driver.evaluate("editor.text");
      const { out } = native.c205(["run", ...PLAIN, "example.s"], { "example.s": text });
      const view = await driver.view();
      const printed = await driver.text("#output");
      const clocks = /^(\d+) clocks/m.exec(out.slice(printed.length))[1];
      assert.equal(out.slice(0, printed.length), printed, example);
      assert.equal(view.clock, Number(clocks), example);
    }
    print(`${examples.length} programs`);
    await driver.close();
  },

  async "the laboratory shows the figures of c205 sweep"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    await driver.choose("lesson", "example:saxpy_vector.s");
    await driver.press("tab-laboratory");
    await driver.page.focus("#lab-second");
    await driver.page.select("#lab-second", "example:saxpy_scalar.s");
    await driver.press("laboratory button[type=submit]");
    await driver.page.waitForSelector("#laboratory .chart svg");
    const text = await driver.evaluate("editor.text");
    const other = await driver.evaluate("window.c205.example('saxpy_scalar.s')");
    const expected = native.json(["sweep", "--warm", ...PLAIN, "a.s", "b.s", "--define", "n=1:1000",
      "--points", "25"], { "a.s": text, "b.s": other });
    const rows = await driver.page.$$eval("#laboratory details tbody tr", (list) => list.map((row) =>
      [...row.children].map((cell) => cell.textContent.replaceAll(",", ""))));
    assert.deepEqual(rows.map(([n, first, , second]) => [n, first, second].map(Number)),
      expected.points.map((point) => [point.value, point.first_clocks, point.second_clocks]));
    const lines = await driver.page.$$eval("#laboratory .result > table tbody tr", (list) => list.map((row) =>
      [...row.children].slice(1).map((cell) => Number(cell.textContent.replaceAll(",", "").replace("−", "-")))));
    const to = (places, value) => Number(value.toFixed(places)) || 0;
    assert.deepEqual(lines, expected.lines.map((line) => [to(1, line.startup), to(4, line.per_element),
      to(2, line.mflops), to(1, line.n_half), to(2, line.off_percent)]));
    await driver.close();
  },

  async "the comparison shows the sentence of c205 compare"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    await driver.choose("lesson", "example:saxpy_linked.s");
    await driver.press("tab-compare");
    await driver.page.focus("#compare-first");
    await driver.page.select("#compare-first", "example:saxpy_vector.s");
    await driver.page.select("#compare-second", "mine");
    await driver.press("compare button[type=submit]");
    await driver.page.waitForSelector("#compare .verdict-words");
    const { out } = native.c205(["compare", ...PLAIN, "a.s", "b.s"], {
      "a.s": await driver.evaluate("window.c205.example('saxpy_vector.s')"),
      "b.s": await driver.evaluate("editor.text") });
    assert.equal(await driver.text("#compare .verdict-words"), /^The second .*$/m.exec(out)[0]);
    await driver.close();
  },

  async "the laboratory shows clocks of a program without a rate"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    await driver.write(COUNTS);
    await driver.press("tab-laboratory");
    await driver.press("laboratory button[type=submit]");
    await driver.page.waitForSelector("#laboratory .chart svg");
    const result = await driver.text("#laboratory .result");
    assert.ok(!result.includes("Mflop/s"), result);
    assert.ok(!result.includes("check that the program uses"));
    // The page reports that no clocks depend on the constant, although the program uses it.
    await driver.write(COUNTS.replace("        EXIT", "        .ifdef other\n        ES      r60, other\n        .endif\n        EXIT"));
    await driver.page.$eval("#lab-constant", (input) => { input.value = "other"; });
    await driver.press("laboratory button[type=submit]");
    await driver.page.waitForSelector("#laboratory .steady");
    await driver.close();
  },

  async "a comparison begins with the starting text and the opened program"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    await driver.choose("lesson", "example:saxpy_vector.s");
    await driver.choose("lesson", `lesson:${native.lessons[1].name}`);
    await driver.press("to-compare");
    assert.deepEqual(await driver.page.$$eval("#compare select", (list) => list.map(({ value }) => value)), ["start", "mine"]);
    assert.match(await driver.text("#compare .verdict-words"), /^Both take/);
    await driver.close();
  },

  async "the program of the first visit prints, and its results are in sight"({ browser, page }) {
    for (const [width, height] of [[1366, 768], [390, 844]]) {
      const driver = await PageDriver.open(browser, page, { width, height, first: true });
      await driver.press("run");
      assert.equal(await driver.text("#output"), "12 14 16 18 20\n");
      assert.match(await driver.text("#status"), /^Finished in 1,146 clocks: 87 % page fault\.$/);
      assert.match(await driver.text("#costliest"), /line 12 MPYSV \[x\], two, \[x\] 1,087 of 1,146 clocks \(95 %\)$/);
      assert.ok(await driver.page.$eval("#costliest", (node) => node.getBoundingClientRect().bottom <= innerHeight), `${width}`);
      await driver.press("costliest button");
      assert.equal(await driver.evaluate(
        "(({ doc, selection }) => doc.lineAt(selection.main.head).number)(editor.view.state)"), 12);
      await driver.close();
    }
  },

  async "a run shows the data that it changed, the labels of the exercise first"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    const rows = () => driver.page.$$eval(".result-row", (list) => list.map((row) => ({
      label: row.querySelector("code").textContent, note: row.querySelector("small").textContent,
      cells: [...row.querySelectorAll("li")].map((cell) => [cell.textContent, cell.classList.contains("changed")]) })));
    const { solution, start } = native.lessons[0];
    await driver.press("run");
    assert.deepEqual((await rows()).map(({ label, note }) => [label, note]), [["fahrenheit", "unchanged"], ["whole", "unchanged"]]);
    await driver.write(start.replace(/^( +)\.code/m, "another: .space 40\n$1.code")
      .replace("; your code here", " EX floor, another+20*64\n STO [floor], nine\n ; ")
      .replace("ES      floor, 0", "ES      floor, 7"));
    await driver.press("run");
    assert.deepEqual(await rows(), [
      { label: "whole", note: "1 changed", cells: [["7", true]] },
      { label: "fahrenheit", note: "unchanged", cells: [["0", false]] },
      { label: "another", note: "1 changed, elements 20 to 35 of 40",
        cells: [["9", true], ...Array.from({ length: 15 }, () => ["0", false])] }]);
    await driver.press("reset");
    assert.equal(await driver.shown("#results"), false);
    assert.equal(await driver.shown("#costliest"), false);
    // EXIT is not the costliest instruction, although it waits for the result.
    await driver.write(solution);
    await driver.press("run");
    assert.ok(!(await driver.text("#costliest")).includes("EXIT"));
    await driver.close();
  },

  async "output is shown as text, and long output is cut with a message"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    const html = "<script>window.bad = 1</script><img src=x onerror='window.bad = 1'>";
    await driver.write(PRINTS_MUCH.replace("TEXT", html));
    await driver.press("run");
    const printed = await driver.text("#output");
    assert.ok(printed.startsWith(`${html}${html}`), printed.slice(0, 200));
    assert.ok(printed.length > 1e6 && printed.length < 1.1e6);
    assert.match(await driver.text("#ending"), /only a part of the output is stored/);
    await driver.press("back");
    assert.equal(await driver.page.evaluate("window.bad"), undefined);
    await driver.close();
  },
};
