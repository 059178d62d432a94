// page_driver.mjs - opens the page and operates it like a learner. Each driver has a separate
// browser context, so drivers share no stored data.

import assert from "node:assert/strict";

const PAGE_TIMEOUT = 20000; // milliseconds

export class PageDriver {
  faults = [];
  requests = [];

  constructor(page) {
    this.page = page;
    page.setDefaultTimeout(PAGE_TIMEOUT);
    page.on("pageerror", (error) => this.faults.push(error.message));
    page.on("console", (message) => {
      if (["error", "warn"].includes(message.type())) this.faults.push(message.text());
    });
    page.on("request", (request) => this.requests.push(request.url()));
  }

  /** Opens the page with the first lesson, with the program of a link, or with the program of the
   * FIRST visit. SIDE: what is next to the machine. */
  static async open(browser, address, { width = 1280, height = 900, scheme = "light", first = false, side = "both" } = {}) {
    const context = await browser.createBrowserContext();
    const driver = new PageDriver(await context.newPage());
    driver.context = context;
    await driver.page.setViewport({ width, height });
    await driver.setScheme(scheme);
    await driver.page.goto(address);
    await driver.page.waitForSelector("body.ready");
    await driver.quiet();
    await driver.page.$eval(`#side-${side}`, (radio) => radio.click());
    if (!first && !address.includes("#"))
      await driver.choose("lesson", await driver.evaluate("`lesson:${about.lessons[0].name}`"));
    return driver;
  }

  /** Sets the colour scheme of the system. If the browser cannot set it, the switch of the page is
   * used. */
  async setScheme(scheme) {
    try {
      await this.page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
    } catch {
      this.scheme = scheme;
    }
  }

  /** Closes the page. Fails if the page reported an error or requested data of another origin. */
  async close(own = ["file:", "blob:", "data:", "http://127.0.0.1:"]) {
    await this.context.close();
    assert.deepEqual(this.faults, []);
    assert.deepEqual(this.requests.filter((url) => !own.some((start) => url.startsWith(start))), []);
  }

  /** Evaluates an expression on the objects in window.c205. */
  evaluate(expression) {
    return this.page.evaluate(`(async ({ session, editor, about, request }) => ${expression})(window.c205)`);
  }

  /** Sends a request to the engine and returns its reply. */
  request(message) {
    return this.evaluate(`request(${JSON.stringify(message)})`);
  }

  view() {
    return this.request({ do: "view" });
  }

  /** Waits until no operation is active. */
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

  /** Replaces the text of the program like typing. */
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
