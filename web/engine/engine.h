/* engine.h - controls a program for a page. One function takes and returns JSON.
 *
 * An engine has one program at a time. A debugger controls it and can go back to any
 * step. A request is an object whose member "do" is its name; the reply is an object in
 * one line.
 *
 *   { "do": "load", "name": "saxpy.s", "text": "..." }
 *   { "do": "go", "how": "end", "ms": 50 }      and, while the reply has "done": false,
 *   { "do": "more", "ms": 50 }
 *   { "do": "view" }
 *
 * All values come from the accounts, records and memory of the machine. They have the
 * same form as in the JSON of a c205 command, if a command has them. Units are clocks
 * of the machine unless the name states another unit. Addresses are bit addresses.
 * Lines and columns count from 1; line 0 means that the program's text has no such
 * line. An instruction of a macro has the line of the call. Numbers of the machine are
 * texts in the form of c205_to_text. A value that is too large for a number of JSON is
 * null.
 *
 * Each section lists the members of a request, with default values in parentheses.
 * After an empty line it lists the members of the reply.
 *
 * ---- Every reply
 *
 *   ok            false: the request failed and changed nothing, but unfinished work
 *                 may have been abandoned
 *   error         a sentence, if ok is false
 *   diagnostics   messages of the assembler about a text: severity ("error", "warning",
 *                 "report", "said"), file, line, column, length, message
 *
 * ---- Long work: go, profile, timeline, sweep, compare
 *
 * The request contains the length of a slice: "ms" of the host's time, or "clocks" of
 * the machine (runs of a sweep). Without them the work is done in one slice. The reply
 * contains
 *
 *   done          false: { "do": "more", "ms": .. } continues the work; true: the reply
 *                 has the other members below
 *
 * Other requests may abandon unfinished work. about and grade do not. view, results and
 * accounts abandon only a profile or a timeline. All others abandon any work. The program
 * remains at its current step after an abandoned execution. It returns to its previous
 * step after an abandoned profile or timeline.
 *
 * ---- about: lists the features of the engine
 *
 *   version, model (the default model)
 *   models        name, title
 *   instructions  mnemonic, operands (as text), half_operands (with ,H; missing if
 *                 there are none), effect, unit, vector, source (P S D R)
 *   directives    names
 *   lessons       number, name, title, start (the program to complete), tests: name,
 *                 tries, warm (its pages are in memory), goals (gold, silver and
 *                 bronze in clocks; missing if there are none)
 *
 * ---- load: replaces the program
 *
 *   text          the program
 *   name          name of its file ("program.s")
 *   model         name of a built-in model (the model of expect-model in the program,
 *                 or the default model)
 *   warm          true if its pages are in memory (as the program requests)
 *   defines       { "n": 100 }: integers, as with --define; the text must use each name
 *   files         { "data.inc": "..." }: texts for .include and .incfile
 *
 *   name, model, warm, diagnostics
 *   symbols       name, label (false for a constant), value (or hex, the bits of a
 *                 word), contents ("", "code", "words", "half words", "bits", "bytes"),
 *                 count
 *   lines         the lines of the text that have code
 *
 * ---- breaks: replaces the breakpoints at lines
 *
 *   lines         [ 10, 12 ]
 *
 *   lines         wanted, line (the actual line); or message (the reason of a failure)
 *
 * ---- go: executes the program
 *
 *   how           end (ignores breakpoints), continue, step, next (a call counts as one
 *                 step), back, reverse-continue, step-to, clock-to (the first step at
 *                 or after the clock), start
 *   n             number of steps (1), for step, next and back; the target of step-to
 *                 and clock-to
 *   limit         maximum clocks (1000000000)
 *
 *   why           moved, breakpoint, trap, end, start (there is no earlier step),
 *                 limit; or running if done is false
 *   step, steps   the current step and the largest step so far
 *   clock
 *   message       the debugger's report of the stop, as lines of text
 *
 * ---- view: the state of the program
 *
 *   elements      maximum number of elements of a vector (64, at most 65536)
 *   first         { "x": 100 }: first element of this vector (0)
 *   all-registers true: include registers without name and contents
 *
 *   step, steps, clock, microseconds, pc, line, region
 *   ended         if true, the reply also has trap ("none" after EXIT) and status
 *   next          the next instruction as text; null: none
 *   operands      of the next instruction or linked pair: mnemonic, field (letter of
 *                 the format), number (of the register), half, name, text, and vector
 *                 if it is a vector: address, count, kind, control (bit address)
 *   last          the last instruction, or null: text, line, mnemonic, effect, unit,
 *                 elements; clocks (increase of the clock), arrived, issued,
 *                 waited (issued - arrived), ready, unit_free; formula (these sums as
 *                 text); constants of the model: name, value, unit, source (P S D R F);
 *                 pieces of its clocks: clocks, cause, wait (as text), line (of the
 *                 charged instruction); phases of the vector unit: begin, end, cause;
 *                 in_flight: pieces from the end of the program until all results are
 *                 complete
 *   registers     number, name, hex, text, integer (low 48 bits), changed (by the last
 *                 instruction), descriptor (if its elements are mapped):
 *                 address, count, kind, label; left, right (named half registers):
 *                 number, name, text
 *   accounts      clocks, instructions, vector (vector instructions), elements, mflops,
 *                 mean_length, causes: cause, clocks, percent (of all clocks); regions:
 *                 region, and the same members for each
 *   vectors       data at labels, at most 256: label, kind ("words", "half words",
 *                 "bits"), address, count, first, values (texts; bits are one text of 0
 *                 and 1), changed, stored (by the last instruction: first, count)
 *   printed       output up to this step; printed_cut: the output is too long and
 *                 incomplete
 *
 * ---- results: the labels whose data differ from the program's text
 *
 *   elements      maximum number of elements of a label (16)
 *
 *   results       label, kind, count (of elements), differs (number of elements that
 *                 differ), first (of the listed elements), values (texts), changed
 *                 (true if the element differs)
 *
 * ---- accounts: "clocks", "causes" and "regions" of c205 run --json, up to this step
 *
 * ---- profile: "lines" of c205 run --profile --json, up to this step
 *
 *   in-order      true: by line; false: the largest number of clocks first
 *
 * ---- timeline: all known steps, including steps after the current step
 *
 *   from, to      clocks
 *   most          maximum number of instructions (2000, at most 50000)
 *   columns       number of columns for the shares (0, at most 4096 and at most the
 *                 clocks of the range); the shares replace lanes, insns, spans and
 *                 charged if more instructions than "most" are in the range
 *   file          "x.svg", "x.kanata" or "x.json": selects a format of c205 timeline
 *
 *   from, to      limited to the clocks that have instructions
 *   full          more instructions were omitted
 *   shares        with "columns", if full: cause, clocks (of each column)
 *   file          text of the file; without file in the request:
 *   lanes         name, rows (the spans of a row do not overlap)
 *   insns         pc, line, text, source (line and form of an instruction of a macro,
 *                 or ""), unit, elements, arrived, issued, ready, done, phases and
 *                 pieces: begin, end, cause
 *   spans         lane, row, begin, end, insn (index in insns), cause (missing for
 *                 execution)
 *   charged       begin, end, cause; without gaps
 *
 * ---- sweep: runs one or two programs for many values of a constant
 *
 *   text, other   programs; the second may be missing
 *   name, other-name  names of their files ("first", "second")
 *   constant      name of the constant
 *   from, to      range; step or factor: only these values; points: number of values (8
 *                 per octave, at most 25)
 *   model, warm, defines, files as in load; limit: maximum clocks of a run (100000000)
 *
 *   part          the part of the work that is done, 0 .. 1; only if done is false
 *   constant, model, and points, lines, causes, crossings of c205 sweep --json
 *   svg           picture
 *
 * ---- compare: compares two programs
 *
 *   texts         two programs: name, text, model (of this program)
 *   model, warm, defines, files as in load; limit
 *
 *   programs      name, model
 *   sentence, and causes, regions, figures of c205 compare --json
 *
 * ---- grade: grades an answer to an exercise
 *
 *   lesson        name or number of the lesson
 *   name, text    answer
 *
 *   the members of c205 check --format json; words: the verdict as text
 *
 * ---- say: executes a line of the debugger
 *
 *   line          "why", "break 10", "continue" and others (docs/debugging.md);
 *                 execution ends at the end of the slice or at limit
 *
 *   text          reply of the debugger
 *   step, steps, clock
 */
#ifndef WEB_ENGINE_H
#define WEB_ENGINE_H

#include <stddef.h>
#include <stdint.h>

struct engine;

/* Default limit of an execution in clocks. */
#define ENGINE_LIMIT UINT64_C(1000000000)
/* Default limit of a run of a sweep in clocks. */
#define ENGINE_SWEEP_LIMIT UINT64_C(100000000)

/* Returns an engine, or NULL if memory is exhausted. */
struct engine *engine_new(void);
void engine_free(struct engine *engine);

/* Sets the highest limit, in clocks, of an execution or of a run of a sweep. A larger
 * limit in a request is reduced to this value. */
void engine_bound(struct engine *engine, uint64_t clocks);

/* Returns the reply to a request of `length` arbitrary bytes. The caller frees it.
 * Returns NULL if there is no memory for a reply. */
char *engine_answer(struct engine *engine, const char *request, size_t length);

#endif
