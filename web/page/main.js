// main.js - creates the panels of the page and connects them with the bar and the keys.

import { makeBar, setStatus } from "./bar.js";
import { makeCauses } from "./causes.js";
import { makeCompare } from "./compare.js";
import { makeConsole } from "./console.js";
import { $, choices, count, el, fill, storage, some } from "./dom.js";
import { makeEditor } from "./editor.js";
import { faultItem } from "./faults.js";
import { makeInstruction } from "./instruction.js";
import { makeKeys } from "./keys.js";
import { makeLaboratory } from "./laboratory.js";
import { enlarge, hideVerdict, noteVerdict, showLesson, showVerdict } from "./lesson.js";
import { Machine } from "./machine.js";
import { course, engineBytes, notice, scenes, tracerBytes, tracerSource, workerSource } from "./parts.js";
import { OWN, Programs } from "./programs.js";
import { makeReference } from "./reference.js";
import { makeRegisters } from "./registers.js";
import { makeResults } from "./results.js";
import { Session } from "./session.js";
import { MAX_PROGRAM, fromHash, toHash } from "./share.js";
import { makeSide } from "./side.js";
import { makeSplit } from "./split.js";
import { makeTabs } from "./tabs.js";
import { switchTheme } from "./theme.js";
import { makeTimeline } from "./timeline.js";
import { tracerPanel } from "./tracer.js";
import { makeVectors } from "./vectors.js";

const PAUSE = 300; // milliseconds without typing before the text is assembled

const session = new Session(new Machine(workerSource(), engineBytes()));
const [about, courseData] = await Promise.all([session.machine.request({ do: "about" }), course()])
  .catch((fault) => {
    setStatus(`The engine cannot start in this browser: ${fault.message}`, "bad");
    throw fault;
  });
const programs = new Programs(about, courseData);

// --- Panels --------------------------------------------------------------------

let typing = 0;
const editor = makeEditor($("source"), about, {
  changed(text) {
    session.change(text);
    programs.write(text);
    hideVerdict();
    forgetLink();
    clearTimeout(typing);
    typing = setTimeout(() => { typing = 0; session.load(); }, PAUSE);
  },
  breaks: (lines) => session.setBreaks(lines),
  help(name) {
    if (!name) return $("keys").click();
    showTab("reference");
    showInstructions(name);
  },
  tooLong: (length) => setStatus(`The text was rejected: the program would have ${some(length, "character")}, `
    + `and the limit is ${count(MAX_PROGRAM)}.`, "bad"),
  at: (explanation) => fill($("source-note"), explanation && [el("code", {}, explanation.name), ` ${explanation.effect}`]),
});
makeBar(session);
makeResults(session, () => programs.exercise ? programs.lesson.results ?? [] : [], (line) => editor.toLine(line));
makeSplit();
const side = makeSide(() => { if (!(session.view?.step > 0)) editor.toExercise(); });
makeTimeline($("timeline"), session);
makeInstruction($("instruction"), session);
makeCauses($("causes"), session);
makeRegisters($("registers"), session);
makeVectors($("vectors"), session);
makeConsole($("console"), session);
const showInstructions = makeReference($("reference"), about);
const laboratory = makeLaboratory($("laboratory"), session, comparablePrograms);
const comparison = makeCompare($("compare"), session, comparablePrograms);
const showTab = makeTabs(document.querySelector("[role=tablist]"), (name) => {
  if (name === "laboratory") laboratory.updateLists();
  if (name === "compare") comparison.updateLists();
  if (name === "tracer") openTracer();
});

// Creates the panel of the ray tracer when it is first opened.
async function openTracer() {
  if ($("tracer").hasChildNodes()) return;
  tracerPanel($("tracer"), { source: tracerSource(), wasm: tracerBytes, scenes: await scenes(),
    models: about.models });
}

/** Returns the program in the editor and all programs for a comparison with it. */
function comparablePrograms() {
  return [{ value: "mine", title: "my program", text: editor.text },
    ...(session.savedText ? [{ value: "saved", title: "saved", text: session.savedText }] : []),
    ...programs.comparable];
}

// --- Text: errors, the current line, clocks of lines ---------------------------------

session.on("loaded", (reply) => {
  const errors = (reply.diagnostics ?? []).filter(({ severity }) => severity === "error").length;
  listFaults(reply.diagnostics ?? []);
  editor.markLine(0);
  $("machine").classList.toggle("lost", !reply.ok);
  if (reply.ok) setStatus("Ready. Run it, or go step by step.");
  else setStatus(errors > 0 ? `${some(errors, "error")}: the program cannot run yet.` : reply.error, "bad");
});

// Lists errors and warnings below the program, and marks their lines.
let listed = "";
function listFaults(faults) {
  const all = JSON.stringify([session.name, faults]);
  if (all === listed) return;
  listed = all;
  editor.showDiagnostics(faults.filter(({ file }) => file === session.name));
  $("faults").hidden = faults.length === 0;
  fill($("faults"), faults.map((fault) => faultItem(fault, session.name, (...place) => editor.toLine(...place))));
}

session.on("moved", hideVerdict);
let fresh = false; // the program has been assembled and not yet run
session.on("loaded", () => { fresh = true; });
session.on("view", ({ ended, line, diagnostics }) => {
  listFaults([...session.loaded.diagnostics, ...diagnostics]);
  editor.markLine(ended ? 0 : line, !fresh);
  fresh = false;
});
session.on("profile", (rows) => editor.charge(rows));
session.on("breaks", (lines) => editor.setBreaks(lines));

// The buttons that go to breakpoints are shown if there is a breakpoint.
session.on("breaks", (lines) => {
  for (const id of ["continue", "reverse-continue"]) $(id).hidden = lines.length === 0;
});

// Hides the controls that the lesson does not need, unless their values are not the usual ones.
function showControls() {
  const needed = (id) => !programs.lesson || programs.lesson.controls.includes(id);
  $("to-compare").hidden = !needed("to-compare");
  $("model").parentNode.hidden = !needed("model") && session.model === about.model;
  $("warm").parentNode.hidden = !needed("warm") && session.warm === programs.warm;
}

// --- Programs -------------------------------------------------------------------------

/**
 * Opens a program. TEXT is shown instead of the text that the learner stored for it, which remains
 * stored until an edit. WARM: whether pages are in memory. If it is missing, it is as in the tests
 * of the lesson.
 */
function open(key, text, warm) {
  programs.choose(key);
  programs.updateLists();
  comparison.reset();
  showLesson(programs.lesson, programs.exercise);
  session.warm = $("warm").value = warm ?? programs.warm;
  session.name = programs.name;
  session.breaks = [];
  showControls();
  editor.set(text ?? programs.written ?? programs.text);
  side.reset();
  if (!programs.exercise) side.showProgram();
  editor.toExercise();
  session.change(editor.text);
  return session.load();
}

async function check() {
  if (!programs.exercise || session.busy) return;
  side.showProgram();
  setStatus("Checking the answer ..");
  const reply = await session.runRequest({ do: "grade", lesson: programs.lesson.name,
    name: programs.name, text: editor.text });
  if (session.machine.lost) await session.load();
  if (!reply.ok || reply.stopped) return setStatus(reply.stopped ? "Stopped by you." : reply.error, "bad");
  noteVerdict(reply);
  programs.updateLists();
  showVerdict(reply, reply.passed ? nextSteps() : []);
  if (reply.passed) setStatus(`Passed${reply.medal ? `: ${reply.medal}` : ""}.`, "good");
  else setStatus("Not passed. The verdict gives the reason.", "bad");
}

// Returns what a learner may do after a passed exercise.
function nextSteps() {
  const { nextLesson, solution: [solution] } = programs;
  return [
    nextLesson && { title: `Next lesson: ${nextLesson.title}`, act: () => open(`lesson:${nextLesson.name}`) },
    solution && { title: "Show the solution", act: () => open(solution.value) },
    solution && { title: "Compare with the solution",
      act: () => { showTab("compare"); comparison.compareWith(solution.value); } },
  ].filter(Boolean);
}

async function share() {
  const lesson = programs.exercise && programs.lesson.name;
  const { model, warm } = session;
  try {
    history.replaceState(null, "", await toHash({ text: editor.text, model, warm, lesson }));
  } catch (fault) {
    forgetLink();
    return setStatus(fault instanceof RangeError ? `The program ${fault.message}`
      : `This browser cannot make a link: ${fault.message}`, "bad");
  }
  try {
    await navigator.clipboard.writeText(location.href);
    setStatus("The link is in the clipboard; it contains the whole program.");
  } catch {
    setStatus("The link is in the address bar; it contains the whole program.");
  }
}

// Removes the link from the address bar, because the editor contains another program now.
function forgetLink() {
  if (location.hash) history.replaceState(null, "", location.pathname + location.search);
}

// Opens the program of a link. Opens OTHERWISE if there is no link or it is damaged.
async function openLink(otherwise) {
  let shared = null, fault = "";
  try {
    shared = await fromHash(location.hash);
  } catch (reason) {
    fault = reason instanceof RangeError ? `The link cannot be opened: its program ${reason.message}`
      : "The link is damaged: it contains no program.";
  }
  if (shared) {
    const key = shared.lesson ? `lesson:${shared.lesson}` : OWN;
    const known = programs.has(key);
    if (!known) fault = "The link names an unknown lesson.";
    if (about.models.some(({ name }) => name === shared.model)) session.model = $("model").value = shared.model;
    const warm = ["warm", "cold"].includes(shared.warm) ? shared.warm : "";
    if (shared.text === undefined) await open(known ? key : otherwise ?? programs.key);
    else {
      await open(known ? key : OWN, shared.text, warm);
      session.savedText = programs.written ?? "";
    }
  } else if (otherwise !== undefined) await open(otherwise);
  if (fault) setStatus(fault, "bad");
}

// --- Buttons and lists ------------------------------------------------------------------

const acts = {
  check, share, theme: switchTheme,
  "to-compare": () => { showTab("compare"); comparison.run(); },
  keys: () => $("keys-dialog").showModal(),
  exercise: () => open(`lesson:${programs.lesson.name}`),
  restore: () => editor.type(programs.text),
};
for (const [id, act] of Object.entries(acts)) $(id).addEventListener("click", act);
for (const place of [document.querySelector(".transport"), document.querySelector(".skip")])
  place.addEventListener("click", side.showProgram);
makeKeys();

$("lesson").addEventListener("change", () => { forgetLink(); open($("lesson").value); });
$("model").addEventListener("change", () => { session.model = $("model").value; session.load(); });
$("warm").addEventListener("change", () => { session.warm = $("warm").value; session.load(); });
$("licences").addEventListener("toggle", async () => {
  $("licences").lastElementChild.textContent = await notice();
});
// Opens another lesson or an example if the learner clicks a link in the text of the lesson.
$("lesson-text").addEventListener("click", (event) => {
  const figure = event.target.closest("figure");
  if (figure) return enlarge(figure);
  const { lesson, example } = event.target.closest("[data-lesson], [data-example]")?.dataset ?? {};
  if (!lesson && !example) return;
  event.preventDefault();
  open(lesson ? `lesson:${lesson}` : `part:${programs.lesson.name}:${example}`);
  if (example) document.querySelector(".source").scrollIntoView({ block: "nearest" });
});
addEventListener("hashchange", () => openLink());

// --- Start --------------------------------------------------------------------------------

choices($("model"), about.models.map(({ name, title }) => ({ value: name, title })));
session.model = $("model").value = about.model;
await openLink(storage.get("at"));
document.body.classList.add("ready");

// The objects of the page, for tests and for users of the browser's console.
window.c205 = { session, editor, about, request: (request) => session.machine.request(request),
  example: (name) => courseData.examples.find((one) => one.name === name)?.text,
  quiet: () => typing === 0 && !session.busy && session.machine.idle };
