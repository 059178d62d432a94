// visit.mjs - a page as a learner has it before him: open it, do things, look.  Nothing is
// kept from one visit to the next.

import assert from "node:assert/strict";

const PATIENCE = 20000; // milliseconds

export class Visit {
  faults = [];
  requests = [];

  constructor(page) {
    this.page = page;
    page.setDefaultTimeout(PATIENCE);
    page.on("pageerror", (error) => this.faults.push(error.message));
    page.on("console", (message) => {
      if (["error", "warn"].includes(message.type())) this.faults.push(message.text());
    });
    page.on("request", (request) => this.requests.push(request.url()));
  }

  static async open(browser, address, { width = 1280, height = 900, scheme = "light" } = {}) {
    const context = await browser.createBrowserContext();
    const visit = new Visit(await context.newPage());
    visit.context = context;
    await visit.page.setViewport({ width, height });
    await visit.like(scheme);
    await visit.page.goto(address);
    await visit.page.waitForSelector("body.ready");
    await visit.quiet();
    return visit;
  }

  /** The system's liking; by the page's own switch where the browser cannot be told. */
  async like(scheme) {
    try {
      await this.page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
    } catch {
      this.scheme = scheme;
    }
  }

  /** Closes it; nothing may have gone wrong, and nothing been asked of anybody else. */
  async close(own = ["file:", "blob:", "data:", "http://127.0.0.1:"]) {
    await this.context.close();
    assert.deepEqual(this.faults, []);
    assert.deepEqual(this.requests.filter((url) => !own.some((start) => url.startsWith(start))), []);
  }

  /** What the page has for those who look behind it (window.c205). */
  look(what) {
    return this.page.evaluate(`(async ({ session, editor, about, ask }) => ${what})(window.c205)`);
  }

  /** The engine's own reply. */
  ask(request) {
    return this.look(`ask(${JSON.stringify(request)})`);
  }

  view() {
    return this.ask({ do: "view" });
  }

  /** Until nothing is under way any more. */
  async quiet() {
    await this.page.waitForFunction("window.c205.quiet()");
  }

  async press(id) {
    await this.page.click(`#${id}`);
    await this.quiet();
  }

  async key(name) {
    const keys = name.split("+");
    for (const held of keys.slice(0, -1)) await this.page.keyboard.down(held);
    await this.page.keyboard.press(keys.at(-1));
    for (const held of keys.slice(0, -1)) await this.page.keyboard.up(held);
    await this.quiet();
  }

  async choose(id, value) {
    await this.page.select(`#${id}`, value);
    await this.quiet();
  }

  /** As if typed: the text in place of what there is. */
  async write(text) {
    await this.page.evaluate((words) => window.c205.editor.type(words), text);
    await this.quiet();
  }

  text(selector) {
    return this.page.$eval(selector, (node) => node.textContent);
  }

  async shown(selector) {
    return this.page.$eval(selector, (node) => node.checkVisibility());
  }
}
