// main.js - the page: puts the panels together and ties the bar and the keys to them.

import { course, engineBytes, notice, scenes, tracerBytes, tracerSource, workerSource } from "./parts.js";
import { $, choices, count, el, fill, kept, some } from "./dom.js";
import { makeCauses } from "./causes.js";
import { makeCompare } from "./compare.js";
import { makeConsole } from "./console.js";
import { makeEditor } from "./editor.js";
import { makeInstruction } from "./instruction.js";
import { makeLaboratory } from "./laboratory.js";
import { hideVerdict, note, progress, setFolded, showLesson, showVerdict, title } from "./lesson.js";
import { Machine } from "./machine.js";
import { makeRegisters } from "./registers.js";
import { Session } from "./session.js";
import { fromHash, toHash } from "./share.js";
import { makeTabs } from "./tabs.js";
import { makeTimeline } from "./timeline.js";
import { tracerPanel } from "./tracer.js";
import { makeVectors } from "./vectors.js";

const PAUSE = 300; // milliseconds of no typing before the text is assembled
const OWN = "own"; // the learner's own program, of no lesson

const session = new Session(new Machine(workerSource(), engineBytes()));
const [about, { lessons: texts, examples }] = await Promise.all([
  session.machine.ask({ do: "about" }), course()]);
const lessons = new Map(about.lessons.map((lesson) => [`lesson:${lesson.name}`, lesson]));
const programs = new Map(examples.map((example) => [`example:${example.name}`, example]));
let at = OWN; // what is chosen in the list of programs

// --- panels -------------------------------------------------------------------

let typing = 0;
const editor = makeEditor($("source"), about, {
  changed(text) {
    session.change(text);
    hideVerdict();
    remember(text);
    clearTimeout(typing);
    typing = setTimeout(() => { typing = 0; session.load(); }, PAUSE);
  },
  breaks: (lines) => session.setBreaks(lines),
  at(told) {
    fill($("source-note"), told && [el("code", {}, told.name), ` ${told.effect}`]);
  },
});
makeTimeline($("timeline"), session);
makeInstruction($("instruction"), session);
makeCauses($("causes"), session);
makeRegisters($("registers"), session);
makeVectors($("vectors"), session);
makeConsole($("console"), session);
const laboratory = makeLaboratory($("laboratory"), session, others);
const comparison = makeCompare($("compare"), session, others);
const showTab = makeTabs(document.querySelector("[role=tablist]"), (name) => {
  if (name === "laboratory") laboratory.offer();
  if (name === "compare") comparison.offer();
  if (name === "tracer") openTracer();
});

// When it is first looked at.
async function openTracer() {
  if ($("tracer").hasChildNodes()) return;
  tracerPanel($("tracer"), { source: tracerSource(), wasm: tracerBytes, scenes: await scenes(),
    models: about.models });
}

/** All programs that another can be held beside. */
function others() {
  const lesson = lessons.get(at);
  return [
    { value: "mine", title: "my program", text: editor.text },
    session.kept && { value: "kept", title: "kept", text: session.kept },
    lesson && { value: "start", title: "the text to complete", text: lesson.start },
    ...[...(texts[lesson?.name]?.examples ?? []), ...examples]
      .map(({ name, text }) => ({ value: name, title: name, text })),
  ].filter(Boolean);
}

// --- what is told ---------------------------------------------------------------

function say(words, kind = "") {
  $("status").textContent = words;
  $("status").className = `status ${kind}`;
}

session.on("loaded", (reply) => {
  const told = reply.diagnostics ?? [];
  editor.tell(told.filter(({ file }) => !file || file === session.name));
  editor.stand(0);
  $("faults").hidden = told.length === 0;
  fill($("faults"), told.map((one) => el("li", { class: one.severity },
    el("button", { type: "button", click: () => editor.toLine(one.line, one.column) },
      `line ${one.line}`), " ", one.message)));
  const errors = told.filter(({ severity }) => severity !== "warning").length;
  if (!reply.ok) say(errors > 0 ? `${some(errors, "error")}: the program cannot run yet` : reply.error, "bad");
  else say("Assembled. It stands at its beginning.");
  if (!reply.ok) settle(null);
  $("machine").classList.toggle("lost", !reply.ok);
});

// What the debugger said, as a sentence.
const sentence = (words) => words && words[0].toUpperCase() + words.slice(1).replace(/[.\n]*$/, ".");

const WHY = { end: "The program has ended.", breakpoint: "Stopped at a breakpoint.",
  limit: "It has run for very long; Run goes on.", start: "At the beginning." };

session.on("moved", (reply) => {
  if (!reply.ok) return say(reply.error, "bad");
  say(reply.stopped ? "Stopped by you." : sentence(reply.message) || WHY[reply.why]
    || `Step ${count(reply.step)}, clock ${count(reply.clock)}.`,
    reply.why === "trap" || reply.why === "limit" ? "bad" : reply.why === "end" ? "good" : "");
});

session.on("progress", (part) => say(
  part.step === undefined ? "Working .." : `Running: step ${count(part.step)}, clock ${count(part.clock)} ..`));

session.on("busy", (busy) => {
  document.body.classList.toggle("busy", busy);
  $("run").hidden = busy;
  $("stop").hidden = !busy;
  if (busy && document.activeElement === $("run")) $("stop").focus();
});

session.on("view", (view) => {
  settle(view);
  editor.stand(view.ended ? 0 : view.line ?? 0);
});

session.on("profile", (rows) => editor.charge(rows));
session.on("breaks", (lines) => editor.setBreaks(lines));

// The bar and the output, of a view or of no program.
function settle(view) {
  const { step = 0, steps = 0, ended = false, clock = 0, printed = "" } = view ?? {};
  const slider = $("slider");
  slider.max = Math.max(steps, step);
  slider.value = step;
  slider.disabled = !view || Number(slider.max) === 0;
  slider.setAttribute("aria-valuetext", `step ${step} of ${slider.max}`);
  $("where").textContent = `${count(step)} of ${count(Number(slider.max))}`;
  $("back").disabled = $("before").disabled = $("reset").disabled = !view || step === 0;
  $("step").disabled = $("on").disabled = !view || ended;
  $("run").disabled = !view;
  $("output").textContent = printed;
  $("output").classList.toggle("nothing", printed === "");
  $("ending").textContent = ended ? `ended at clock ${count(clock)}` : "";
}

// --- programs --------------------------------------------------------------------

function offer() {
  choices($("lesson"), [
    { group: "Course", choices: [...lessons].map(([value, lesson]) => ({ value, title: title(lesson) })) },
    { group: "Examples", choices: examples.map(({ name }) => ({ value: `example:${name}`, title: name })) },
    { group: "My own", choices: [{ value: OWN, title: "my program" }] },
  ]);
  $("lesson").value = at;
}

function remember(text) {
  const lesson = lessons.get(at);
  if (lesson) note(lesson.name, { text });
  else if (at === OWN) kept.set("own", text);
}

const EMPTY = '        .include "print.s"\n\n        EXIT\n';

function original(which) {
  return lessons.get(which)?.start ?? programs.get(which)?.text ?? EMPTY;
}

function open(which, text) {
  at = lessons.has(which) || programs.has(which) ? which : OWN;
  const lesson = lessons.get(at);
  offer();
  showLesson(lesson, lesson && texts[lesson.name]?.html);
  session.name = lesson ? `${lesson.name}.s` : programs.get(at)?.name ?? "program.s";
  const mine = lesson ? progress(lesson.name).text : at === OWN ? kept.get("own") : null;
  editor.set(text ?? mine ?? original(at));
  session.breaks = [];
  session.change(editor.text);
  if (text !== undefined) remember(text);
  kept.set("at", at);
  return session.load();
}

async function check() {
  const lesson = lessons.get(at);
  if (!lesson || session.busy) return;
  say("Trying the answer ..");
  const reply = await session.longer({ do: "grade", lesson: lesson.name, text: editor.text },
    () => say("Trying the answer .."));
  if (!reply.ok || reply.stopped) return say(reply.error ?? "Stopped by you.", "bad");
  showVerdict(reply);
  offer();
  say(reply.passed ? `Passed${reply.medal ? `: ${reply.medal}` : ""}.` : "Not passed yet: the verdict says why.",
    reply.passed ? "good" : "bad");
}

async function share() {
  const hash = await toHash({ text: editor.text, model: session.model, warm: session.warm,
    lesson: lessons.get(at)?.name });
  history.replaceState(null, "", hash);
  try {
    await navigator.clipboard.writeText(location.href);
    say("The link is in the clipboard; it holds the whole program.");
  } catch {
    say("The link is in the address bar; it holds the whole program.");
  }
}

async function openHash() {
  const shared = await fromHash(location.hash);
  if (!shared) return false;
  if (about.models.some(({ name }) => name === shared.model)) session.model = $("model").value = shared.model;
  session.warm = $("warm").value = ["warm", "cold"].includes(shared.warm) ? shared.warm : "";
  await open(shared.lesson ? `lesson:${shared.lesson}` : OWN, shared.text);
  return true;
}

// --- the bar and the keys -----------------------------------------------------------

const acts = {
  run: () => session.go("end"),
  stop: () => session.stop(),
  reset: () => session.go("start"),
  step: () => session.go("step"),
  back: () => session.go("back"),
  on: () => session.go("continue"),
  before: () => session.go("reverse-continue"),
  check, share,
  "to-compare": () => { showTab("compare"); return comparison.run(); },
  keys: () => $("keys-dialog").showModal(),
  theme: () => setTheme(dark() ? "light" : "dark"),
  again: () => { editor.set(original(at)); remember(editor.text); session.change(editor.text); return session.load(); },
  fold,
};
for (const [id, act] of Object.entries(acts)) $(id).addEventListener("click", act);

const KEYS = [
  ["F8", "run", "run to the end"], ["Shift F8", "reset", "back to the beginning"],
  ["F4", "step", "one instruction on"], ["Shift F4", "back", "one instruction back"],
  ["F2", "on", "on to the next breakpoint"], ["Shift F2", "before", "back to the breakpoint before"],
  ["F9", null, "a breakpoint at the line of the cursor, or none"],
  ["Escape", "stop", "stop what takes long"],
  ["Alt Enter", "check", "check my answer"], ["F1", "keys", "these keys"],
];
const ALSO = [
  ["Escape Tab", "one after the other: leave the text of the program"],
  ["← → + − Home", "in the time line: earlier, later, shorter, longer, all of it"],
  ["← →", "in the tabs: another view; in the slider: a step"],
  ["↑ ↓", "in the console: what was said before"],
];
$("keys-table").tBodies[0].append(...[...KEYS.map(([key, , what]) => [key, what]), ...ALSO]
  .map(([key, what]) => el("tr", {}, el("th", { scope: "row" },
    key.split(" ").map((one) => [el("kbd", {}, one), " "])), el("td", {}, what))));
$("licences").addEventListener("toggle", async () => {
  $("licences").lastElementChild.textContent = await notice();
});
for (const [key, id, what] of KEYS)
  if (id) {
    $(id).title = `${what} (${key})`;
    $(id).setAttribute("aria-keyshortcuts", key.replace(" ", "+"));
  }

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey) return;
  const key = `${event.shiftKey ? "Shift " : ""}${event.altKey ? "Alt " : ""}${event.key}`;
  const found = KEYS.find(([name]) => name === key);
  if (!found?.[1] || $("keys-dialog").open || (key === "Escape" && !session.busy)) return;
  event.preventDefault();
  if (!$(found[1]).disabled) acts[found[1]]();
}, true);

$("slider").addEventListener("input", () => {
  $("where").textContent = `${count(Number($("slider").value))} of ${count(Number($("slider").max))}`;
  session.slide(Number($("slider").value));
});
$("lesson").addEventListener("change", () => open($("lesson").value));
$("model").addEventListener("change", () => { session.model = $("model").value; session.load(); });
$("warm").addEventListener("change", () => { session.warm = $("warm").value; session.load(); });
addEventListener("hashchange", openHash);
// A lesson's link to another lesson.
$("lesson-text").addEventListener("click", (event) => {
  const name = event.target.closest("a[data-lesson]")?.dataset.lesson;
  if (name) { event.preventDefault(); open(`lesson:${name}`); }
});

function fold() {
  setFolded(!$("lesson-panel").classList.contains("folded"));
}

// --- light and dark ---------------------------------------------------------------------

const wanted = matchMedia("(prefers-color-scheme: dark)");
const dark = () => (document.documentElement.dataset.theme ?? (wanted.matches ? "dark" : "light")) === "dark";

function setTheme(theme) {
  if (theme) document.documentElement.dataset.theme = theme;
  if (theme) kept.set("theme", theme);
  $("theme").lastElementChild.textContent = dark() ? "Light" : "Dark";
}
wanted.addEventListener("change", () => setTheme());
setTheme(kept.get("theme"));

// --- the beginning -------------------------------------------------------------------------

choices($("model"), about.models.map(({ name, title: words }) => ({ value: name, title: words ?? name })));
session.model = $("model").value = about.model;
if (!await openHash()) await open(kept.get("at") ?? lessons.keys().next().value ?? `example:${examples[0].name}`);
document.body.classList.add("ready");

// For those who look behind the page: its tests, and a curious console.
window.c205 = { session, editor, about, ask: (request) => session.machine.ask(request),
  example: (name) => examples.find((one) => one.name === name)?.text,
  quiet: () => typing === 0 && !session.busy && session.machine.idle };
