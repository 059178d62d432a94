// session.js - the program at hand: what is loaded and where it stands.  Panels hear
// of it: "loaded" (the engine's reply), "view" (what all panels show), "profile" (clocks
// by lines), "moved" (how a movement ended), "busy", "progress", "breaks".

const PATIENCE = 2000; // milliseconds that a line of the debugger may take
const ELEMENTS = 64, MAX_ELEMENTS = 4096; // of each vector that are looked at

export class Session {
  #listeners = {};
  #turn = 0;
  #target = null;
  #stale = true;

  name = "program.s";
  text = "";
  model = "";
  warm = ""; // "": as the program says; "warm", "cold"
  breaks = [];
  loaded = null;
  view = null;
  busy = false;
  elements = ELEMENTS;
  kept = ""; // a program put aside to compare with

  constructor(machine) {
    this.machine = machine;
  }

  on(kind, listener) {
    (this.#listeners[kind] ??= []).push(listener);
  }

  #tell(kind, what) {
    for (const listener of this.#listeners[kind] ?? []) listener(what);
  }

  /** A setting of a request, left out when the program itself says it. */
  get setting() {
    return { model: this.model, ...(this.warm && { warm: this.warm === "warm" }) };
  }

  /** Asks for something that may take long: busy until it is there. */
  async longer(request, progress) {
    this.#occupy(true);
    const reply = await this.machine.ask(request, progress);
    this.#occupy(false);
    return reply;
  }

  #occupy(busy) {
    this.busy = busy;
    this.#tell("busy", busy);
  }

  keep() {
    this.kept = this.text;
  }

  stop() {
    this.machine.stop();
  }

  /** The text has changed: what is loaded is another program's. */
  change(text) {
    this.text = text;
    this.#stale = true;
  }

  /** Assembles the text and goes to its beginning. */
  async load() {
    const turn = ++this.#turn;
    if (this.busy) this.stop();
    this.#stale = this.machine.lost = false;
    const reply = await this.machine.ask(
      { do: "load", name: this.name, text: this.text, ...this.setting });
    if (turn !== this.#turn) return;
    this.loaded = reply;
    this.view = null;
    this.elements = ELEMENTS;
    this.#tell("loaded", reply);
    if (!reply.ok) return;
    await this.setBreaks(this.breaks);
    await this.look();
  }

  /** Breakpoints at lines of the program's text; the engine says where they stand. */
  async setBreaks(lines) {
    this.breaks = lines;
    if (!this.loaded?.ok) return;
    const reply = await this.machine.ask({ do: "breaks", lines });
    if (reply.ok) this.breaks = reply.lines.filter(({ line }) => line).map(({ line }) => line);
    this.#tell("breaks", this.breaks);
  }

  async look() {
    const turn = this.#turn;
    const view = await this.machine.ask({ do: "view", elements: this.elements });
    if (turn !== this.#turn || !view.ok) return;
    this.view = view;
    this.#tell("view", view);
    this.#lookAtLines(view);
  }

  // Clocks by lines of the text itself, "program.s:12" being line 12.
  async #lookAtLines(view) {
    const profile = await this.machine.ask({ do: "profile", idle: true });
    if (view !== this.view || !profile.ok || profile.stopped) return;
    const start = `${this.name}:`;
    this.#tell("profile", profile.lines.filter(({ line }) => line.startsWith(start))
      .map((row) => ({ ...row, line: Number(row.line.slice(start.length)) })));
  }

  /** More elements of vectors, up to a most. */
  lookFurther() {
    this.elements = Math.min(4 * this.elements, MAX_ELEMENTS);
    return this.look();
  }

  /** Moves, as the debugger's verbs do: "end", "step", "back" .., "step-to" N. */
  async go(how, n) {
    if (this.busy) return;
    if (this.#stale || this.machine.lost) await this.load();
    if (!this.loaded?.ok) return;
    const turn = this.#turn;
    const reply = await this.longer({ do: "go", how, ...(n !== undefined && { n }) },
      (progress) => this.#tell("progress", progress));
    if (turn !== this.#turn) return;
    await this.look();
    this.#tell("moved", reply);
  }

  /** A line of the debugger's own verbs. */
  async say(line) {
    const reply = await this.machine.ask({ do: "say", line, ms: PATIENCE });
    await this.look();
    if (reply.ok) this.#tell("moved", reply);
    return reply;
  }

  /** To a step, as the slider is drawn: of many targets the last one counts. */
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
