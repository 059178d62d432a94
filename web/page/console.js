// console.js - accepts the commands of the debugger, like the terminal.

import { el, fill, heading } from "./dom.js";

const KEEP = 400; // commands that the transcript shows

export function makeConsole(panel, session) {
  const said = [];
  let at = 0;
  const transcript = el("div", { class: "transcript", role: "log", tabindex: 0,
    "aria-label": "Output of the debugger" });
  const line = el("input", { id: "console-line", type: "text", spellcheck: "false",
    autocomplete: "off", autocapitalize: "off", keydown: recall });
  const form = el("form", { class: "prompt", submit: say },
    el("label", { for: "console-line" }, "(c205)"), line,
    el("button", { type: "submit" }, "Send"));

  fill(panel, el("section", { class: "panel", "aria-labelledby": "console-heading" },
    heading("console", "Commands of the debugger"),
    el("p", { class: "verbs" },
      ["help", "why", "account", "info registers", "where"].map((verb) =>
        el("button", { type: "button", class: "quiet", click: () => send(verb) }, verb))),
    transcript, form));

  function recall(event) {
    const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (!by || said.length === 0) return;
    event.preventDefault();
    at = Math.min(Math.max(at + by, 0), said.length);
    line.value = said[at] ?? "";
  }

  function say(event) {
    event.preventDefault();
    const words = line.value.trim();
    line.value = "";
    if (words) send(words);
  }

  async function send(words) {
    if (said.at(-1) !== words) said.push(words);
    at = said.length;
    const reply = await session.say(words);
    transcript.append(
      el("p", { class: "said" }, `(c205) ${words}`),
      el("pre", { class: reply.ok ? null : "fault" },
        reply.ok ? reply.text : reply.error));
    while (transcript.childElementCount > 2 * KEEP) transcript.firstChild.remove();
    transcript.scrollTop = transcript.scrollHeight;
  }
}
