// lesson.js - the text of a lesson, its goals, the verdict, and the progress of the learner. The
// browser stores the progress.

import { $, count, el, fill, storage, some } from "./dom.js";

const MEDALS = ["", "bronze", "silver", "gold"];

/** Returns the stored progress of a lesson, {text, medal, passed}. Values of a wrong type are
 * dropped. */
export function progress(name) {
  const { text, medal, passed } = storage.get(`lesson.${name}`) ?? {};
  return { ...(typeof text === "string" && { text }),
    ...(passed === true && { passed, medal: MEDALS.includes(medal) ? medal : "" }) };
}
export const note = (name, more) => storage.set(`lesson.${name}`, { ...progress(name), ...more });

/** Returns number and title of a lesson, as in "3 First vector", with a mark for the best result. */
export function title({ number, title: words, name }) {
  const { passed, medal } = progress(name);
  return `${number} ${words}${passed ? ` ✓${medal ? ` ${medal}` : ""}` : ""}`;
}

// Returns the clock limits of a test for each medal, as in "gold at most 95 clocks, silver 110".
const clockLimits = ({ goals }) => Object.entries(goals)
  .map(([medal, clocks], i) => `${medal} ${i === 0 ? `at most ${some(clocks, "clock")}` : count(clocks)}`).join(", ");

let shown = null;

/** Shows a lesson. EXERCISE: the editor contains the learner's answer, not an example. */
export function showLesson(lesson, exercise) {
  hideVerdict();
  $("check").disabled = !exercise;
  $("exercise").hidden = exercise;
  $("goals").hidden = !exercise;
  if (lesson === shown) return;
  shown = lesson;
  $("lesson-panel").hidden = !lesson;
  document.body.classList.toggle("has-lesson", Boolean(lesson));
  if (!lesson) return;
  $("lesson-heading").textContent = `${lesson.number} ${lesson.title}`;
  $("lesson-text").innerHTML = lesson.html ?? "";
  $("lesson-text").scrollTop = 0;
  $("goals").textContent = lesson.tests.filter((test) => test.goals).map(clockLimits).join("; ");
}

export function hideVerdict() {
  $("verdict").hidden = true;
}

/** Shows a figure of the lesson in a dialogue, as wide as the page. */
export function enlarge(figure) {
  $("figure-dialog").firstElementChild.replaceChildren(figure.querySelector("svg").cloneNode(true));
  $("figure-dialog").showModal();
}

/** Stores a verdict if it is the best of its lesson. */
export function noteVerdict(reply) {
  const best = progress(reply.lesson);
  const better = MEDALS.indexOf(reply.medal) > MEDALS.indexOf(best.medal ?? "");
  if (reply.passed && (!best.passed || better)) note(reply.lesson, { passed: true, medal: reply.medal });
}

/** Shows the verdict of the engine. STEPS are buttons, {title, act}, for what the learner may do
 * next. */
export function showVerdict(reply, steps) {
  const verdict = $("verdict");
  verdict.hidden = false;
  verdict.className = `panel verdict ${reply.passed ? `passed ${reply.medal || "plain"}` : "failed"}`;
  fill(verdict,
    el("h3", {}, reply.passed ? "Passed" : "Not passed",
      reply.medal && el("span", { class: `medal ${reply.medal}` }, reply.medal),
      el("button", { type: "button", class: "quiet close", click: hideVerdict }, "Close")),
    steps.length > 0 && el("div", { class: "steps" }, steps.map(({ title, act }) =>
      el("button", { type: "button", click: act }, title))),
    ...sentences(reply.report),
    ...reply.tests.filter(({ clocks, report }) => clocks > 0 || report.length > 0).map(tested));
  verdict.scrollTop = 0;
  verdict.scrollIntoView({ block: "nearest" });
}

const tested = (test) => el("section", {},
  el("h4", {}, `${test.passed ? "✓" : "✗"} ${test.name}`,
    el("small", {}, test.clocks > 0 && some(test.clocks, "clock"), test.medal && ` · ${test.medal}`)),
  el("p", { class: "tries" }, test.tries),
  ...sentences(test.report));

// Formats a report. The further lines of a sentence are lines of the program.
const sentences = (report) => report.map((sentence) =>
  el("p", { class: sentence.includes("\n") ? "lines" : null }, sentence));
