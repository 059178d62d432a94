// lesson.js - the text of a lesson, its goals, the verdict; and what has been reached
// so far, kept between visits where the browser lets us.

import { $, count, el, fill, kept, some } from "./dom.js";

const MEDALS = ["", "bronze", "silver", "gold"];

/** What is kept of a lesson: {text, medal, passed}, without what has another type. */
export function progress(name) {
  const { text, medal, passed } = kept.get(`lesson.${name}`) ?? {};
  return { ...(typeof text === "string" && { text }),
    ...(passed === true && { passed, medal: MEDALS.includes(medal) ? medal : "" }) };
}
export const note = (name, more) => kept.set(`lesson.${name}`, { ...progress(name), ...more });

/** "3 First vector", with a sign of what was reached. */
export function title({ number, title: words, name }) {
  const { passed, medal } = progress(name);
  return `${number} ${words}${passed ? ` ✓${medal ? ` ${medal}` : ""}` : ""}`;
}

// "gold 95, silver 110": clocks of a test.
const wanted = ({ goals }) => Object.entries(goals)
  .map(([medal, clocks]) => `${medal} ${count(clocks)}`).join(", ");

let shown = null;

/** EXERCISE: what is written is an answer to it. */
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
  $("goals").textContent = lesson.tests.filter((test) => test.goals).map(wanted).join("; ");
}

export function setFolded(folded) {
  $("lesson-panel").classList.toggle("folded", folded);
  $("fold").textContent = folded ? "Show" : "Hide";
  $("fold").setAttribute("aria-expanded", String(!folded));
}

// A verdict is where the text was.
function judged(so) {
  $("verdict").hidden = !so;
  $("lesson-panel").classList.toggle("judged", so);
}

export const hideVerdict = () => judged(false);

/** The engine's verdict in its own words. */
export function showVerdict(reply) {
  const best = progress(reply.lesson);
  const better = MEDALS.indexOf(reply.medal) > MEDALS.indexOf(best.medal ?? "");
  if (reply.passed && (!best.passed || better)) note(reply.lesson, { passed: true, medal: reply.medal });
  const verdict = $("verdict");
  setFolded(false);
  judged(true);
  verdict.className = `verdict ${reply.passed ? `passed ${reply.medal || "plain"}` : "failed"}`;
  fill(verdict,
    el("h3", {}, reply.passed ? "Passed" : "Not passed",
      reply.medal && el("span", { class: `medal ${reply.medal}` }, reply.medal),
      el("button", { type: "button", class: "quiet close", click: hideVerdict }, "Back to the lesson")),
    ...sentences(reply.report),
    ...reply.tests.filter(({ clocks, report }) => clocks > 0 || report.length > 0).map(tested));
  verdict.scrollTop = 0;
  $("lesson-panel").scrollIntoView({ block: "start" });
}

const tested = (test) => el("section", {},
  el("h4", {}, `${test.passed ? "✓" : "✗"} ${test.name}`,
    el("small", {}, test.clocks > 0 && some(test.clocks, "clock"), test.medal && ` · ${test.medal}`)),
  el("p", { class: "tries" }, test.tries),
  ...sentences(test.report));

// What is of several lines shows lines of the program.
const sentences = (report) => report.map((sentence) =>
  el("p", { class: sentence.includes("\n") ? "lines" : null }, sentence));
