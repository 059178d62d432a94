// registers.js - shows the registers, and marks those that the last instruction changed.

import { count, el, fill, heading, table } from "./dom.js";

const MAX = 64; // maximum number of rows; few programs use more registers

export function makeRegisters(panel, session) {
  session.on("view", ({ registers }) => {
    const shown = registers.slice(0, MAX);
    fill(panel,
      heading("registers", "Registers"),
      shown.length === 0
        ? el("p", { class: "empty" }, "The program names no registers.")
        : el("div", { class: "scroll", tabindex: 0, role: "group",
          "aria-label": "Registers and their contents" },
          table("Registers", [["register"], ["hexadecimal", "hex"], ["value", "number"]],
            shown.map((one) => ({
              class: one.changed ? "changed" : "",
              cells: [title(one), el("code", {}, one.hex), meaning(one)],
            })))));
  });
}

const title = ({ number, name, changed }) => [
  el("code", {}, `r${number}`), name && el("b", {}, ` ${name}`),
  changed && el("span", { class: "visually-hidden" }, " changed")];

// Formats a word: as a descriptor, as named half registers, or otherwise as a number.
function meaning({ text, descriptor, left, right }) {
  if (descriptor) return `${count(descriptor.count)} ${descriptor.kind} ${descriptor.label
    ? `of ${descriptor.label}` : `from ${descriptor.address.toString(16).toUpperCase()}`}`;
  const halves = [left, right].filter(Boolean);
  if (halves.length > 0) return halves.map((half) => `${half.name} ${half.text}`).join(", ");
  return text;
}
