// console.js - accepts commands of the debugger, as in a terminal.

import { el, fill, heading } from "./dom.js";

const MAX_COMMANDS = 400; // maximum number of commands in the transcript

export function makeConsole(panel, session) {
  const commands = [];
  let at = 0;
  const transcript = el("div", { class: "transcript", role: "log", tabindex: 0,
    "aria-label": "Output of the debugger" });
  const line = el("input", { id: "console-line", type: "text", spellcheck: "false",
    autocomplete: "off", autocapitalize: "off", keydown: recall });
  const form = el("form", { class: "prompt", submit: submit },
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
    if (!by || commands.length === 0) return;
    event.preventDefault();
    at = Math.min(Math.max(at + by, 0), commands.length);
    line.value = commands[at] ?? "";
  }

  function submit(event) {
    event.preventDefault();
    const words = line.value.trim();
    line.value = "";
    if (words) send(words);
  }

  async function send(words) {
    if (commands.at(-1) !== words) commands.push(words);
    at = commands.length;
    const reply = await session.command(words);
    transcript.append(
      el("p", { class: "command" }, `(c205) ${words}`),
      el("pre", { class: reply.ok ? null : "fault" },
        reply.ok ? reply.text : reply.error));
    while (transcript.childElementCount > 2 * MAX_COMMANDS) transcript.firstChild.remove();
    transcript.scrollTop = transcript.scrollHeight;
  }
}
