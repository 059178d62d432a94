// side.js - selects what is next to the machine: the lesson, the program, or both. The choice is
// stored.

import { storage } from "./dom.js";

const SIDES = ["lesson", "program", "both"];

const radios = () => [...document.querySelectorAll("[name=side]")];
const chosen = () => SIDES.find((side) => side === storage.get("side")) ?? "lesson";

/** SHOWN is called when the program appears. */
export function makeSide(shown) {
  function show(side) {
    const before = document.body.dataset.side;
    document.body.dataset.side = side;
    for (const radio of radios()) radio.checked = radio.value === side;
    if (before === "lesson" && side !== "lesson") shown();
  }
  for (const radio of radios())
    radio.addEventListener("click", () => { storage.set("side", radio.value); show(radio.value); });
  show(chosen());
  return {
    /** Shows what the learner has chosen. */
    reset: () => show(chosen()),
    /** Shows the program until another lesson is opened. */
    showProgram() { if (document.body.dataset.side === "lesson") show("program"); },
  };
}
