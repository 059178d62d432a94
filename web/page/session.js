// session.js - the loaded program and its state. Panels listen to the events "loaded" (the reply of
// the engine), "view" (the data of all panels), "results" (changed data), "profile" (clocks by line), "moved" (the end of a
// run or a step), "busy", "progress" and "breaks".

const COMMAND_TIMEOUT = 2000; // limit for a command of the debugger, in milliseconds
const MAX_CLOCKS = 1e8; // of one run; more are probably an endless loop
const ELEMENTS = 64, MAX_ELEMENTS = 4096; // number of elements of each vector in a view

export class Session {
  #listeners = {};
  #turn = 0;
  #target = null;
  #stale = true;

  name = "program.s";
  text = "";
  model = "";
  warm = ""; // "warm" or "cold"; "": the program determines it
  breaks = [];
  loaded = null;
  view = null;
  busy = false;
  elements = ELEMENTS;
  savedText = ""; // a program that was stored for a comparison

  constructor(machine) {
    this.machine = machine;
  }

  on(kind, listener) {
    (this.#listeners[kind] ??= []).push(listener);
  }

  #notify(kind, what) {
    for (const listener of this.#listeners[kind] ?? []) listener(what);
  }

  /** The settings of a request. "warm" is missing if the program determines it. */
  get setting() {
    return { model: this.model, ...(this.warm && { warm: this.warm === "warm" }) };
  }

  /** Sends a request that may take long. The session is busy until the reply. */
  async runRequest(request, progress) {
    this.#setBusy(true);
    const reply = await this.machine.request(request, progress);
    this.#setBusy(false);
    return reply;
  }

  /** Sends a request that other requests stop, again and again until it is complete or no longer
   * wanted. Returns null if it is no longer wanted. */
  async idleRequest(request, wanted) {
    for (;;) {
      const reply = await this.machine.request({ ...request, idle: true });
      if (!wanted() || this.machine.lost) return null;
      if (!reply.stopped) return reply;
    }
  }

  #setBusy(busy) {
    this.busy = busy;
    this.#notify("busy", busy);
  }

  saveText() {
    this.savedText = this.text;
  }

  stop() {
    this.machine.stop();
  }

  /** Sets the text. The loaded program is then out of date. */
  change(text) {
    this.text = text;
    this.#stale = true;
  }

  /** Assembles the text and goes to the start of the program. */
  async load() {
    const turn = ++this.#turn;
    if (this.busy) this.stop();
    this.#stale = this.machine.lost = false;
    const reply = await this.machine.request(
      { do: "load", name: this.name, text: this.text, ...this.setting });
    if (turn !== this.#turn) return;
    this.loaded = reply;
    this.view = null;
    this.elements = ELEMENTS;
    this.#notify("loaded", reply);
    if (!reply.ok) return;
    await this.setBreaks(this.breaks);
    await this.updateView();
  }

  /** Sets breakpoints at lines of the text. The reply contains the lines that can have one. */
  async setBreaks(lines) {
    this.breaks = lines;
    if (!this.loaded?.ok) return;
    const reply = await this.machine.request({ do: "breaks", lines });
    if (reply.ok) this.breaks = reply.lines.filter(({ line }) => line).map(({ line }) => line);
    this.#notify("breaks", this.breaks);
  }

  async updateView() {
    const turn = this.#turn;
    const view = await this.machine.request({ do: "view", elements: this.elements });
    if (turn !== this.#turn || !view.ok) return;
    this.view = view;
    this.#notify("view", view);
    this.#updateDetails(view);
  }

  // Reports the changed data, and then the clocks of lines.
  async #updateDetails(view) {
    const { ok, results } = await this.machine.request({ do: "results" });
    if (view !== this.view || !ok) return;
    this.#notify("results", results);
    this.#updateProfile(view);
  }

  // Reports the clocks of the lines of this text. "program.s:12" is line 12.
  async #updateProfile(view) {
    const profile = await this.idleRequest({ do: "profile" }, () => view === this.view);
    if (!profile?.ok) return;
    const start = `${this.name}:`;
    this.#notify("profile", profile.lines.filter(({ line }) => line.startsWith(start))
      .map((row) => ({ ...row, line: Number(row.line.slice(start.length)) })));
  }

  /** Requests four times as many elements of each vector, up to a limit. */
  showMoreElements() {
    this.elements = Math.min(4 * this.elements, MAX_ELEMENTS);
    return this.updateView();
  }

  /** Runs or steps. HOW is "end", "step", "back" and so on, or "step-to" with the step N. */
  async go(how, n) {
    if (this.busy) return;
    if (this.#stale || this.machine.lost) await this.load();
    if (!this.loaded?.ok) return;
    const turn = this.#turn;
    const reply = await this.runRequest({ do: "go", how, limit: MAX_CLOCKS, ...(n !== undefined && { n }) },
      (progress) => this.#notify("progress", progress));
    if (turn !== this.#turn) return;
    await this.updateView();
    this.#notify("moved", reply);
  }

  /** Sends a command to the debugger. */
  async command(line) {
    const reply = await this.machine.request({ do: "say", line, ms: COMMAND_TIMEOUT });
    await this.updateView();
    if (reply.ok) this.#notify("moved", reply);
    return reply;
  }

  /** Goes to a step while the slider is dragged. If several steps are pending, only the last
   * counts. */
  async slide(step) {
    const moving = this.#target !== null;
    this.#target = step;
    if (moving) return;
    while (this.#target !== null) {
      const target = this.#target;
      await this.go("step-to", target);
      if (this.#target === target) this.#target = null;
    }
  }
}
