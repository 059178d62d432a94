// keys.js - a key for each button of the bar, and the dialogue that lists the keys. No key uses
// Ctrl, because browsers use combinations with Ctrl.

import { $, el } from "./dom.js";

// A row has the key, the id of its button, and the description.
const KEYS = [
  ["F8", "run", "run to the end"],
  ["Shift F8", "reset", "go back to the beginning"],
  ["F4", "step", "execute one instruction"],
  ["Shift F4", "back", "go back one instruction"],
  ["F2", "continue", "run to the next breakpoint"],
  ["Shift F2", "reverse-continue", "go back to the previous breakpoint"],
  ["Escape", "stop", "stop a long operation"],
  ["Alt Enter", "check", "check my answer"],
  ["F1", "keys", "show the keys"],
];
const ELSEWHERE = [
  ["F1", "on an instruction of the program: its row in the reference"],
  ["F6", "go to the next panel; with Shift to the previous panel"],
  ["F9", "set or remove a breakpoint at the line of the cursor"],
  ["Escape Tab", "one after the other: leave the program text"],
  ["← → + − Home", "in the time line: earlier, later, shorter, longer, all of it"],
  ["← →", "in the tabs: another view; in the slider: one step"],
  ["↑ ↓", "at the bar below a lesson: show less or more of it"],
  ["↑ ↓", "in the console: earlier commands"],
];

function showKeys() {
  const rows = [...KEYS.map(([key, , what]) => [key, what]), ...ELSEWHERE];
  $("keys-table").tBodies[0].append(...rows.map(([key, what]) => el("tr", {},
    el("th", { scope: "row" }, key.split(" ").map((one) => [el("kbd", {}, one), " "])),
    el("td", {}, what))));
  for (const [key, id, what] of KEYS) {
    $(id).title = `${what} (${key})`;
    $(id).setAttribute("aria-keyshortcuts", key.replace(" ", "+"));
  }
}

// The parts between which F6 moves. A part that is not visible is skipped.
const PARTS = ["#run", "#lesson-text", ".cm-content", "#verdict", "#outcome", "[role=tabpanel]:not([hidden])"];

function nextPart(by) {
  const parts = PARTS.map((one) => document.querySelector(one)).filter((part) => part.checkVisibility());
  const at = parts.findIndex((part) => part.contains(document.activeElement));
  parts[(Math.max(at, 0) + by + parts.length) % parts.length].focus();
}

/** Makes each key click its button if the button is enabled. */
export function makeKeys() {
  showKeys();
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || $("keys-dialog").open) return;
    if (event.key === "F6") {
      event.preventDefault();
      return nextPart(event.shiftKey ? -1 : 1);
    }
    const pressed = `${event.shiftKey ? "Shift " : ""}${event.altKey ? "Alt " : ""}${event.key}`;
    const found = KEYS.find(([key]) => key === pressed);
    if (pressed === "F1" && event.target.closest(".cm-content")) return; // the editor handles F1
    if (!found || (found[1] === "stop" && $("stop").hidden)) return;
    event.preventDefault();
    $(found[1]).click();
  }, true);
}
