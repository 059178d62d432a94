/* engine.h - a program under the control of a page: one function, with JSON in and out.
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
 * All values are from the machine's accounts, records and memory. If a command of c205
 * has the same values in its JSON, they have the same form here. Units are clocks of
 * the machine unless the name has another unit. Addresses are bit addresses. Lines and
 * columns are counted from 1; line 0 means no line of the program's own text. The line
 * of an instruction from a macro is that of the call. Numbers of the machine are texts,
 * as by c205_to_text. A value that is too large for a number of JSON is null.
 *
 * Below, the members of a request are listed first, with their default values in
 * parentheses, and after an empty line those of its reply.
 *
 * ---- Every reply
 *
 *   ok            true; or false: then nothing has changed, except that unfinished work
 *                 may have been given up:
 *   error         one sentence
 *   diagnostics   of the assembler, for a text with or without errors: severity
 *                 ("error", "warning", "report", "said"), file, line, column, length,
 *                 message
 *
 * ---- Long work: go, profile, timeline, sweep, compare
 *
 * The request has the length of a slice: "ms" of the host's clock, or "clocks" of the
 * machine (for a sweep: runs). Without them the work is done in one slice. The reply
 * has
 *
 *   done          false: { "do": "more", "ms": .. } continues the work; the other
 *                 members below are in the reply that has done true
 *
 * The other requests have these effects on unfinished work. about and grade keep it.
 * view and accounts keep it, except a profile or a timeline. All others abandon it. An
 * abandoned execution leaves the program where it is; an abandoned profile or timeline
 * leaves it where it was before.
 *
 * ---- about: lists the features of the engine
 *
 *   version, model (the default one)
 *   models        of machines: name, title
 *   instructions  mnemonic, operands (as text), half_operands (with ,H; missing: no
 *                 such form), effect, unit, vector, source (P S D R)
 *   directives    their names
 *   lessons       number, name, title, start (the program to complete), tests: name,
 *                 tries, warm (its pages are in memory), goals (clocks: gold, silver,
 *                 bronze; missing: none)
 *
 * ---- load: replaces the program
 *
 *   text          the program
 *   name          of its file ("program.s")
 *   model         a built-in one (that of the program's expect-model, or the default
 *                 one)
 *   warm          true, false: whether its pages are in memory (as the program
 *                 requests)
 *   defines       { "n": 100 }: integers, as by --define; the text must use each name
 *   files         { "data.inc": "..." }: texts for .include and .incfile
 *
 *   name, model, warm, diagnostics
 *   symbols       name, label (false: a constant), value (or hex: the bits of a word),
 *                 contents ("", "code", "words", "half words", "bits", "bytes"), count
 *   lines         the lines of the text that have code
 *
 * ---- breaks: replaces the breakpoints at lines
 *
 *   lines         [ 10, 12 ]
 *
 *   lines         for each: wanted, and line, its actual line; or message, the reason
 *                 why it cannot be set
 *
 * ---- go: moves the program
 *
 *   how           end (ignores breakpoints), continue, step, next (a call counts as one
 *                 step), back, reverse-continue, step-to, clock-to (the first step at
 *                 or after that clock), start
 *   n             number of steps (1), for step, next and back; the target of step-to
 *                 and clock-to
 *   limit         clocks at most (1000000000)
 *
 *   why           moved, breakpoint, trap, end, start (there is no earlier step),
 *                 limit; or running, while done is false
 *   step, steps   the current step, and the largest one so far
 *   clock
 *   message       the debugger's report of the stop, lines of text
 *
 * ---- view: the state of the program
 *
 *   elements      number of elements of a vector (64, at most 65536)
 *   first         { "x": 100 }: first element of this vector (0)
 *   all-registers true: also registers without name and contents
 *
 *   step, steps, clock, microseconds, pc, line, region
 *   ended         if true, also trap ("none": it ended regularly) and status
 *   next          the next instruction as text; null: none
 *   operands      of it, or of the two that a LINKV links: mnemonic, field (letter of
 *                 the format), number (of the register), half, name, text, and for a
 *                 vector vector: address, count, kind, control (address of its bits)
 *   last          the last instruction, null: none: text, line, mnemonic, effect, unit,
 *                 elements; clocks (by which it advanced the clock), arrived, issued,
 *                 waited (issued - arrived), ready, unit_free; formula (these sums as
 *                 text); constants of the model: name, value, unit, source (P S D R F);
 *                 pieces of its clocks: clocks, cause, wait (as text), line (of the
 *                 instruction that is charged); phases of the vector unit: begin, end,
 *                 cause; in_flight: pieces after the end, until all results are
 *                 complete
 *   registers     number, name, hex, text, integer (low 48 bits), changed (by the last
 *                 instruction), descriptor (if its elements are mapped): address,
 *                 count, kind, label; left, right (named half registers): number, name,
 *                 text
 *   accounts      clocks, instructions, vector (of these), elements, mflops,
 *                 mean_length, causes: cause, clocks, percent (of all); regions:
 *                 region, and the same members for each
 *   vectors       data at labels, at most 256: label, kind ("words", "half words",
 *                 "bits"), address, count, first, values (texts; for bits one text of 0
 *                 and 1), changed, stored (by the last instruction: first, count)
 *   printed       output up to this step; printed_cut: it was too long and is
 *                 incomplete
 *
 * ---- accounts: "clocks", "causes" and "regions" of c205 run --json, up to this step
 *
 * ---- profile: "lines" of c205 run --profile --json, up to this step
 *
 *   in-order      true: in the order of the lines; otherwise the most clocks first
 *
 * ---- timeline: of all steps so far, also those after the current one
 *
 *   from, to      clocks
 *   most          instructions (2000, at most 50000)
 *   file          "x.svg", "x.kanata", "x.json": in the format in which c205 timeline
 *                 writes a file of that name
 *
 *   from, to      reduced to the clocks that have instructions
 *   full          more instructions were omitted
 *   file          its text; or, without file:
 *   lanes         name, rows (of spans that do not overlap)
 *   insns         pc, line, text, unit, elements, arrived, issued, ready, done, phases
 *                 and pieces: begin, end, cause
 *   spans         lane, row, begin, end, insn (index in insns), cause (missing: its
 *                 execution)
 *   charged       begin, end, cause: without gaps
 *
 * ---- sweep: one or two programs against a constant
 *
 *   text, other   programs; the second may be missing
 *   name, other-name  of their files ("first", "second")
 *   constant      its name
 *   from, to      its range; step, or factor: only those values; points: number of
 *                 values (8 per octave, at most 25)
 *   model, warm, defines, files as in load; limit: clocks of a run at most (100000000)
 *
 *   part          while done is false: the part that is done, 0 .. 1
 *   constant, model, and points, lines, causes, crossings of c205 sweep --json
 *   svg           the picture
 *
 * ---- compare: two programs
 *
 *   texts         two: name, text, model (of this one)
 *   model, warm, defines, files as in load; limit
 *
 *   programs      name, model
 *   sentence, and causes, regions, figures of c205 compare --json
 *
 * ---- grade: an answer to an exercise
 *
 *   lesson        its name or number
 *   name, text    of the answer
 *
 *   the members of c205 check --format json; words: the same as text
 *
 * ---- say: executes a line of the debugger
 *
 *   line          "why", "break 10", "continue", ..: docs/debugging.md; execution ends
 *                 at the end of the slice, or at limit
 *
 *   text          the debugger's reply
 *   step, steps, clock
 */
#ifndef WEB_ENGINE_H
#define WEB_ENGINE_H

#include <stddef.h>
#include <stdint.h>

struct engine;

/* Default limit of clocks for an execution. */
#define ENGINE_LIMIT UINT64_C(1000000000)
/* Default limit of clocks for a run of a sweep. */
#define ENGINE_SWEEP_LIMIT UINT64_C(100000000)

/* Returns NULL if memory is exhausted. */
struct engine *engine_new(void);
void engine_free(struct engine *engine);

/* Sets an upper limit of clocks for all executions and runs, which
 * requests cannot exceed. */
void engine_bound(struct engine *engine, uint64_t clocks);

/* Returns the reply to a request of `length` arbitrary bytes, a text that the caller
 * frees. Returns NULL if there is no memory even for a reply. */
char *engine_answer(struct engine *engine, const char *request, size_t length);

#endif
