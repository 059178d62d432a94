// split.js - the bar between the lesson and the program below it. The pointer or keys move it, and
// its position is stored.

import { $, storage } from "./dom.js";

const MIN = 15, MAX = 85, STEP = 5; // height of the lesson in percent
const DEFAULT = 50;

export function makeSplit() {
  const bar = $("split");
  const main = document.querySelector("main");

  function set(percent) {
    const share = Math.round(Math.min(Math.max(percent, MIN), MAX));
    main.style.setProperty("--lesson", `${share}%`);
    bar.setAttribute("aria-valuenow", String(share));
    return share;
  }
  const setAndStore = (percent) => storage.set("split", set(percent));

  bar.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    bar.setPointerCapture(event.pointerId);
  });
  bar.addEventListener("pointermove", (event) => {
    if (!bar.hasPointerCapture(event.pointerId)) return;
    const { top } = $("lesson-panel").getBoundingClientRect();
    setAndStore(100 * (event.clientY - top) / main.clientHeight);
  });
  bar.addEventListener("dblclick", () => setAndStore(DEFAULT));
  bar.addEventListener("keydown", (event) => {
    const now = Number(bar.getAttribute("aria-valuenow"));
    const to = { ArrowUp: now - STEP, ArrowDown: now + STEP, Home: MIN, End: MAX }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    setAndStore(to);
  });
  bar.setAttribute("aria-valuemin", String(MIN));
  bar.setAttribute("aria-valuemax", String(MAX));
  set(Number(storage.get("split")) || DEFAULT);
}
