// programs.js - the list of programs: lessons with their exercises and examples, other examples,
// and the learner's program.

import { $, choices, storage } from "./dom.js";
import { note, progress, title } from "./lesson.js";

export const OWN = "own";
const FIRST = "example:first.s"; // the program of the first visit
const EMPTY = '        .include "print.s"\n\n        EXIT\n';

/** ABOUT is the reply to the request about. COURSE contains the lessons and examples of the page. */
export class Programs {
  #list = new Map(); // {name, text, lesson} by key; the key of a lesson is lesson:NAME

  constructor(about, course) {
    this.lessons = about.lessons.map((lesson) => ({ ...lesson, ...course.lessons[lesson.name] }));
    for (const lesson of this.lessons) {
      this.#list.set(`lesson:${lesson.name}`,
        { name: `${lesson.name}.s`, text: lesson.start, lesson, exercise: true });
      for (const { name, text } of lesson.examples ?? [])
        this.#list.set(`part:${lesson.name}:${name}`, { name, text, lesson });
      if (lesson.solution)
        this.#list.set(`solution:${lesson.name}`, { name: "solution.s", text: lesson.solution, lesson });
    }
    for (const { name, text } of course.examples) this.#list.set(`example:${name}`, { name, text });
    this.#list.set(OWN, { name: "program.s", text: EMPTY });
  }

  has(key) {
    return this.#list.has(key);
  }

  /** Selects the program with a key, or the program of the first visit if there is none. */
  choose(key) {
    this.key = this.#list.has(key) ? key : FIRST;
    Object.assign(this, { lesson: undefined, exercise: false }, this.#list.get(this.key));
    storage.set("at", this.key);
  }

  /** "warm" if the pages are in memory in all tests of the lesson. "": the program determines it. */
  get warm() {
    return this.lesson?.tests.every(({ warm }) => warm) ? "warm" : "";
  }

  #of(kind, titleOf = ({ name }) => name) {
    return [...this.#list].filter(([key]) => key.startsWith(kind))
      .map(([value, program]) => ({ value, title: titleOf(program), text: program.text }));
  }

  /** A list with the solution of the current lesson, which is empty until the learner has passed. */
  get solution() {
    return this.lesson && progress(this.lesson.name).passed
      ? this.#of(`solution:${this.lesson.name}`, () => "the solution") : [];
  }

  /** The lesson after the current lesson, or undefined. */
  get nextLesson() {
    return this.lessons[this.lessons.indexOf(this.lesson) + 1];
  }

  get #parts() {
    return this.lesson ? [...this.#of(`part:${this.lesson.name}:`), ...this.solution] : [];
  }

  /** Fills the list of programs. It contains the examples of a lesson while the lesson is open. */
  updateLists() {
    const groups = [
      { group: "Course", choices: this.#of("lesson:", ({ lesson }) => title(lesson)) },
      { group: "Examples of this lesson", choices: this.#parts },
      { group: "Examples", choices: this.#of("example:") },
      { group: "My own", choices: [{ value: OWN, title: "my program" }] },
    ];
    choices($("lesson"), groups.filter((one) => one.choices.length > 0));
    $("lesson").value = this.key;
  }

  /** The learner's text of this program, or null. */
  get written() {
    if (this.exercise) return progress(this.lesson.name).text ?? null;
    return this.key === OWN ? storage.text("own") : null;
  }

  write(text) {
    if (this.exercise) note(this.lesson.name, { text });
    else if (this.key === OWN) storage.set("own", text);
  }

  /** The programs for a comparison with the current program. */
  get comparable() {
    const start = { value: "start", title: "the starting text", text: this.text };
    return [...(this.exercise ? [start] : []), ...this.#parts, ...this.#of("example:")];
  }
}
