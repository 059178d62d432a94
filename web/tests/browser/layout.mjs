// layout.mjs - checks layout and accessibility: axe finds no violation in any view, nothing is cut
// off at widths from 320 to 1920 pixels, and keys reach all controls. A failure means that some
// users cannot see or reach a part of the page.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { PageDriver } from "./page_driver.mjs";
import { PRINTS, WRONG } from "./texts.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

async function faults(driver) {
  const found = await driver.page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
    return violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3)
      .map(({ html, any }) => `${html.slice(0, 160)} ${any[0]?.message ?? ""}`).join(" | ")}`);
  });
  return found;
}

const wide = { width: 1440, height: 900 };
const narrow = { width: 390, height: 844 };

// Returns the elements that reach beyond the width of the page.
const beyond = (driver) => driver.page.evaluate(() => {
  const width = document.documentElement.clientWidth;
  return [document.documentElement.scrollWidth > width && "the page scrolls sideways",
    ...[...document.querySelectorAll("button, select, h2, h3, label, p, input")]
      .filter((node) => node.checkVisibility()
        && !node.closest(".visually-hidden, .scroll, pre, .cm-editor, .skip, .source .aside"))
      .map((node) => ({ node, box: node.getBoundingClientRect() }))
      .filter(({ box }) => box.left < -1 || box.right > width + 1)
      .map(({ node }) => node.outerHTML.slice(0, 120))].filter(Boolean);
});

// Returns the visible texts that are smaller than 12 pixels. A figure may be reduced.
const small = (driver) => driver.page.evaluate(() => {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const found = [];
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = node.parentElement;
    if (!node.textContent.trim() || !parent.checkVisibility() || parent.closest(".visually-hidden, option, script, style")) continue;
    const scale = parent.ownerSVGElement?.getScreenCTM().a ?? 1;
    const size = parseFloat(getComputedStyle(parent).fontSize) * scale;
    if (size < 11.9) found.push(`${size} ${node.textContent}`);
  }
  return found;
});

const inSight = (driver, selector) => driver.page.$eval(selector, (node) => {
  const { top, bottom, height } = node.getBoundingClientRect();
  return height > 0 && top >= 0 && bottom <= innerHeight;
});

export const tests = {
  async "axe finds nothing, in light and dark, wide and narrow, in each view"({ browser, page }) {
    for (const scheme of ["light", "dark"])
      for (const size of [wide, narrow]) {
        const driver = await PageDriver.open(browser, page, { ...size, scheme });
        if (driver.scheme === "dark") await driver.press("theme");
        await driver.page.evaluate(axe);
        const checkView = async (where) =>
          assert.deepEqual(await faults(driver), [], `${scheme}, ${size.width}: ${where}`);
        await checkView("a lesson");
        if (await driver.page.$eval("#check", (button) => !button.disabled)) {
          await driver.press("check");
          await checkView("a verdict");
        }
        await driver.choose("lesson", "example:saxpy_vector.s");
        await driver.press("run");
        await checkView("a run");
        await driver.press("tab-reference");
        await checkView("the reference");
        await driver.press("tab-laboratory");
        await driver.press("laboratory button[type=submit]");
        await checkView("the laboratory");
        await driver.press("to-compare");
        await checkView("a comparison");
        await driver.press("tab-console");
        await driver.page.type("#console-line", "info registers\n");
        await driver.quiet();
        await checkView("the console");
        await driver.press("tab-tracer");
        await checkView("the ray tracer");
        await driver.press("tab-machine");
        await driver.write(WRONG);
        await checkView("errors");
        await driver.press("keys");
        await checkView("the keys");
        await driver.close();
      }
  },

  async "nothing is cut off on narrow and wide screens"({ browser, page }) {
    for (const width of [320, 390, 600, 800, 960, 1100, 1440, 1920]) {
      const driver = await PageDriver.open(browser, page, { width, height: 800 });
      assert.deepEqual(await beyond(driver), [], `${width}: a lesson`);
      await driver.choose("lesson", "example:saxpy_vector.s");
      await driver.press("run");
      assert.deepEqual(await beyond(driver), [], `${width}: a run`);
      for (const view of ["reference", "laboratory", "compare", "console", "tracer"]) {
        await driver.press(`tab-${view}`);
        assert.deepEqual(await beyond(driver), [], `${width}: ${view}`);
      }
      await driver.close();
    }
  },

  async "a wide page never scrolls, and has all of its bars in sight"({ browser, page }) {
    for (const size of [wide, { width: 1920, height: 1080 }, { width: 1280, height: 600 }]) {
      const driver = await PageDriver.open(browser, page, size);
      const still = async (where) => assert.deepEqual(await driver.page.evaluate(() => [
        document.documentElement.scrollHeight - innerHeight, window.scrollY]), [0, 0], `${size.width}: ${where}`);
      await still("a lesson");
      await driver.press("check");
      await still("a verdict");
      for (const example of ["example:calls.s", "example:saxpy_vector.s"]) {
        await driver.choose("lesson", example);
        await driver.press("run");
        await still(example);
      }
      for (const view of ["reference", "laboratory", "compare", "console", "tracer"]) {
        await driver.press(`tab-${view}`);
        if (["laboratory", "compare"].includes(view)) await driver.press(`${view} button[type=submit]`);
        await still(view);
      }
      await driver.close();
    }
  },

  async "by keys alone: everything is reached and shows that it has the focus"({ browser, page }) {
    const driver = await PageDriver.open(browser, page);
    await driver.write(PRINTS);
    await driver.evaluate("editor.toLine(3)");
    await driver.key("F9");
    await driver.key("F4");
    await driver.page.focus("#share");
    const reached = [];
    for (let i = 0; i < 80; i++) {
      // Tab indents the text of the program unless Escape was pressed before.
      if (await driver.page.evaluate("document.activeElement.classList.contains('cm-content')"))
        await driver.page.keyboard.press("Escape");
      await driver.page.keyboard.press("Tab");
      const { name, outlined } = await driver.page.evaluate(() => {
        const node = document.activeElement;
        const { outlineStyle, outlineWidth } = getComputedStyle(node);
        return { name: node.id || node.className || node.tagName,
          outlined: node === document.body || node.closest("#source") !== null
            || (outlineStyle !== "none" && parseFloat(outlineWidth) >= 1) };
      });
      if (name === "BODY" || name === reached[0]) break;
      assert.ok(outlined, `${name} has the focus and no outline`);
      reached.push(name);
    }
    for (const name of ["lesson", "share", "keys", "theme", "run", "reset", "reverse-continue", "back",
      "step", "continue", "slider", "check", "side-both", "lesson-text", "restore", "cm-content", "outcome",
      "tab-machine", "machine"])
      assert.ok(reached.some((one) => one.split(" ").includes(name)), `${name} is not reached: ${reached}`);
    // F6 moves between the panels.
    await driver.page.focus("#run");
    const panels = [];
    for (let i = 0; i < 4; i++) {
      await driver.key("F6");
      panels.push(await driver.page.evaluate("document.activeElement.id || document.activeElement.className.split(' ')[0]"));
    }
    assert.deepEqual(panels, ["lesson-text", "cm-content", "outcome", "machine"]);
    await driver.key("Shift+F6");
    assert.equal(await driver.page.evaluate("document.activeElement.id"), "outcome");
    // Arrow keys select tabs.
    await driver.page.focus("#tab-machine");
    await driver.key("ArrowRight");
    assert.equal(await driver.shown("#laboratory"), true);
    await driver.key("End");
    assert.equal(await driver.shown("#tracer"), true);
    await driver.close();
  },

  // The lessons are walked as a learner does: the text, a run, a check.
  async "no text is smaller than 12 pixels, and results and figures are in sight"({ browser, page, native }) {
    for (const size of [{ width: 1366, height: 768 }, narrow]) {
      const driver = await PageDriver.open(browser, page, { ...size, side: "lesson" });
      for (const { name } of native.lessons.slice(0, 8)) {
        const where = `${size.width}: ${name}`;
        await driver.choose("lesson", `lesson:${name}`);
        assert.equal(await driver.shown("#lesson-text"), true, where);
        assert.equal(await driver.shown(".source"), false, where);
        assert.deepEqual(await small(driver), [], where);
        assert.deepEqual(await beyond(driver), [], where);
        await driver.press("run");
        assert.deepEqual(await small(driver), [], `${where}: run`);
        assert.ok(await inSight(driver, "#outcome"), `${where}: the results`);
        assert.ok(await inSight(driver, "#status"), `${where}: the status`);
        assert.ok(await driver.page.$eval(".cm-scroller", (box) => box.clientHeight) >= 200, where);
        await driver.press("check");
        assert.deepEqual(await small(driver), [], `${where}: check`);
        assert.ok(await inSight(driver, "#verdict h3"), `${where}: the verdict`);
      }
      await driver.close();
    }
  },

  async "the lesson has the whole height, the program is at the exercise, and the choice is kept"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page, { width: 1366, height: 768, side: "lesson" });
    const [width, height] = await driver.page.$eval("#lesson-text", (text) => [text.clientWidth, text.clientHeight]);
    assert.ok(height > 500 && width > 650, `${width} x ${height}`);
    await driver.choose("lesson", `lesson:${native.lessons[5].name}`);
    await driver.press("side-program");
    assert.equal(await driver.shown("#lesson-text"), false);
    await driver.page.waitForFunction(() => {
      const box = document.querySelector(".cm-scroller").getBoundingClientRect();
      return [...document.querySelectorAll(".cm-line")].some((line) => {
        const { top, bottom } = line.getBoundingClientRect();
        return line.textContent.includes("your code here") && top >= box.top && bottom <= box.bottom;
      });
    });
    await driver.page.reload();
    await driver.page.waitForSelector("body.ready");
    assert.equal(await driver.shown(".source"), true);
    await driver.press("side-lesson");
    // A figure is in the colours of the theme, and a click enlarges it.
    const colour = () => driver.page.$eval("figure rect", (rect) => getComputedStyle(rect).fill);
    const light = await colour();
    await driver.press("theme");
    assert.notEqual(await colour(), light);
    await driver.page.click("figure svg");
    const widths = await driver.page.$$eval("figure .scroll > svg, #figure-dialog .scroll > svg", (list) => list.map((svg) => svg.clientWidth));
    assert.ok(widths.at(-1) > widths[0], `${widths}`);
    await driver.close();
  },

  async "from Run to the program are at most 10 tab stops"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page, { side: "program" });
    for (const { name } of native.lessons) {
      await driver.choose("lesson", `lesson:${name}`);
      await driver.press("step");
      await driver.page.focus("#run");
      let stops = 0;
      do await driver.page.keyboard.press("Tab");
      while (++stops < 20 && await driver.page.evaluate("!document.activeElement.classList.contains('cm-content')"));
      assert.ok(stops <= 10, `${name}: ${stops}`);
    }
    await driver.close();
  },

  async "controls are shown in the lessons that need them, and medals have a unit"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page);
    const shown = async (name) => {
      await driver.choose("lesson", name);
      return Promise.all(["#model", "#warm", "#to-compare"].map((id) => driver.shown(id)));
    };
    assert.deepEqual(await shown("lesson:numbers"), [false, false, false]);
    assert.match(await driver.text("#goals"), /^gold at most \d+ clocks, silver \d+, bronze \d+$/);
    assert.deepEqual(await shown("lesson:first-vector"), [false, false, true]);
    assert.deepEqual(await shown("lesson:crossover"), [true, false, false]);
    assert.deepEqual(await shown("lesson:paging"), [false, true, false]);
    assert.deepEqual(await shown("own"), [true, true, true]);
    await driver.choose("model", "cyber205-4pipe");
    assert.deepEqual(await shown("lesson:numbers"), [true, false, false]);
    await driver.close();
  },

  async "light and dark, by the system and by the switch"({ browser, page }) {
    const driver = await PageDriver.open(browser, page, { scheme: "dark" });
    const paper = () => driver.page.evaluate("getComputedStyle(document.body).backgroundColor");
    const first = await paper();
    await driver.press("theme");
    const second = await paper();
    assert.notEqual(first, second);
    await driver.page.reload();
    await driver.page.waitForSelector("body.ready");
    assert.equal(await paper(), second);
    await driver.close();
  },

  async "a narrow page stays where it is while the program moves"({ browser, page, native }) {
    const driver = await PageDriver.open(browser, page, narrow);
    const top = () => driver.page.evaluate("window.scrollY");
    assert.equal(await top(), 0);
    await driver.choose("lesson", `lesson:${native.lessons[2].name}`);
    assert.equal(await top(), 0);
    // The current line is visible in the editor in spite of this.
    assert.ok(await driver.page.$eval(".cm-line.current-line", (line) => {
      const { top: above, bottom } = line.getBoundingClientRect();
      const box = line.closest(".cm-scroller").getBoundingClientRect();
      return above >= box.top && bottom <= box.bottom;
    }));
    await driver.page.evaluate("document.getElementById('vectors').scrollIntoView()");
    assert.ok(await top() > 1000);
    const place = () => driver.page.$eval("#causes", (panel) => panel.getBoundingClientRect().top);
    const low = await place();
    for (const id of ["step", "step", "back", "run", "reset"]) {
      await driver.press(id);
      assert.ok(Math.abs(await place() - low) < 100, `${id}: from ${low} to ${await place()}`);
    }
    // The status line is always visible, and a verdict is shown from its first line.
    assert.ok(await driver.page.$eval("#status", (node) => node.getBoundingClientRect().top >= 0));
    await driver.press("check");
    assert.ok(await driver.page.$eval("#verdict h3", (node) => {
      const { bottom } = document.getElementById("status").getBoundingClientRect();
      return node.getBoundingClientRect().top >= bottom && node.getBoundingClientRect().bottom < innerHeight;
    }));
    await driver.close();
  },

  async "the height of the lesson is chosen by pointer and by keys, and stored"({ browser, page }) {
    const driver = await PageDriver.open(browser, page, { width: 1280, height: 720 });
    const height = () => driver.page.$eval("#lesson-panel", (panel) => panel.getBoundingClientRect().height);
    const before = await height();
    await driver.page.focus("#split");
    await driver.key("ArrowDown");
    const after = await height();
    assert.ok(after > before + 10);
    const { x, y } = await driver.page.$eval("#split", (bar) => {
      const box = bar.getBoundingClientRect();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    });
    await driver.page.mouse.move(x, y);
    await driver.page.mouse.down();
    await driver.page.mouse.move(x, y - 150, { steps: 4 });
    await driver.page.mouse.up();
    const drawn = await height();
    assert.ok(Math.abs(after - 150 - drawn) < 12, `${after} ${drawn}`);
    await driver.page.reload();
    await driver.page.waitForSelector("body.ready");
    await driver.quiet();
    assert.ok(Math.abs(await height() - drawn) < 1);
    await driver.close();
  },

  async "at 200 % the program and the line that is typed are visible, also with reported errors"({ browser, page }) {
    // At 200 % the page has half the width and height of a large screen or of a laptop.
    for (const size of [{ width: 960, height: 540 }, { width: 640, height: 360 }, { width: 1280, height: 600 }]) {
      const driver = await PageDriver.open(browser, page, { ...size, side: "program" });
      assert.deepEqual(await beyond(driver), []);
      const height = () => driver.page.$eval(".cm-scroller", (box) => box.clientHeight);
      assert.ok(await height() >= 100, `${size.width}: ${await height()}`);
      await driver.evaluate(`editor.toLine(editor.text.split("\\n").length)`);
      await driver.page.keyboard.type("\n        FOO\n        BAR");
      await driver.quiet();
      assert.equal(await driver.shown("#faults"), true);
      assert.ok(await driver.page.$eval(".cm-activeLine", (line) => {
        const { top, bottom } = line.getBoundingClientRect();
        const box = line.closest(".cm-scroller").getBoundingClientRect();
        return top >= box.top - 1 && bottom <= box.bottom + 1;
      }), `${size.width}: the line is out of sight`);
      await driver.close();
    }
  },
};
