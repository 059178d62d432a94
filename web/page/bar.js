// bar.js - runs the program: the buttons, the slider over all steps, the status line, and the
// output of the program.

import { $, count, fixed, some } from "./dom.js";
import { faultSentence } from "./faults.js";

const PROGRESS_INTERVAL = 500; // milliseconds between two reports of progress
// Maps the id of each button to the value of "how" in the request "go".
const RUN_COMMANDS = { run: "end", reset: "start", step: "step", back: "back", continue: "continue",
  "reverse-continue": "reverse-continue" };
const STOP_REASONS = { breakpoint: "Stopped at a breakpoint.",
  limit: "Stopped after 100,000,000 clocks: probably an endless loop. Run continues it.", start: "At the beginning." };
const STATUS_CLASS = { limit: "bad", end: "good" };

export function setStatus(words, kind = "") {
  $("status").textContent = words;
  $("status").className = `status ${kind}`;
}

// Formats a message of the debugger as a sentence.
const sentence = (words) => words && words[0].toUpperCase() + words.slice(1).replace(/[.\n]*$/, ".");

// Returns the sum of a run, as in "Finished in 83 clocks: 71 % operand wait."
function finished({ clocks, causes }) {
  const { cause, percent } = causes.reduce((most, one) => one.clocks > most.clocks ? one : most);
  return `Finished in ${some(clocks, "clock")}: ${fixed(percent, 0)} % ${cause}.`;
}

// Reports the end of a run or a step.
function reportRun(reply, { name, view }) {
  if (!reply.ok) return setStatus(reply.error, "bad");
  if (reply.stopped) return setStatus("Stopped by you.");
  if (reply.why === "trap") return setStatus(faultSentence(view.diagnostics.at(-1), name), "bad");
  if (reply.why === "end" && view.status === 0) return setStatus(finished(view.accounts), "good");
  setStatus(sentence(reply.message) || STOP_REASONS[reply.why] || `Step ${count(reply.step)}, clock ${count(reply.clock)}.`,
    STATUS_CLASS[reply.why]);
}

// Updates buttons, slider and output from a view. null: no program is loaded.
function update(view) {
  const { step = 0, steps = 0, ended = false, clock = 0, printed = "", printed_cut: cut = false } = view ?? {};
  const slider = $("slider");
  slider.max = Math.max(steps, step);
  slider.value = step;
  slider.disabled = slider.max === "0";
  slider.setAttribute("aria-valuetext", `step ${step} of ${slider.max}`);
  place();
  $("back").disabled = $("reverse-continue").disabled = $("reset").disabled = step === 0;
  $("step").disabled = $("continue").disabled = !view || ended;
  $("run").disabled = !view;
  $("output").textContent = printed;
  $("output").classList.toggle("nothing", printed === "");
  $("ending").textContent = [ended && `ended at clock ${count(clock)}`,
    cut && "only a part of the output is stored"].filter(Boolean).join("; ");
}

function place() {
  const { value, max } = $("slider");
  $("where").textContent = `${count(Number(value))} of ${count(Number(max))}`;
}

function showBusy(isBusy) {
  document.body.classList.toggle("busy", isBusy);
  $("run").hidden = isBusy;
  $("stop").hidden = !isBusy;
  if (isBusy && document.activeElement === $("run")) $("stop").focus();
  if (!isBusy && document.activeElement === $("stop")) $("run").focus();
}

export function makeBar(session) {
  let last = 0;
  for (const [id, how] of Object.entries(RUN_COMMANDS)) $(id).addEventListener("click", () => session.go(how));
  $("stop").addEventListener("click", () => session.stop());
  $("slider").addEventListener("input", () => { place(); session.slide(Number($("slider").value)); });
  session.on("loaded", (reply) => { if (!reply.ok) update(null); });
  session.on("view", update);
  session.on("busy", showBusy);
  session.on("moved", (reply) => reportRun(reply, session));
  session.on("progress", ({ step, clock }) => {
    if (performance.now() - last < PROGRESS_INTERVAL) return;
    last = performance.now();
    setStatus(`Running: step ${count(step)}, clock ${count(clock)} ..`);
  });
}
