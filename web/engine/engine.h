/* engine.h - a program under the control of a page: one call, JSON in, JSON out.
 *
 * An engine has one program at a time, under a debugger's control with its whole past. A
 * request is an object whose member "do" says what is wanted; the reply is one in one line.
 *
 *   { "do": "load", "name": "saxpy.s", "text": "..." }
 *   { "do": "go", "how": "end", "ms": 50 }      and, while it answers "done": false,
 *   { "do": "more", "ms": 50 }
 *   { "do": "view" }
 *
 * All that it tells is told by the machine's own accounts, records and memory, in the forms
 * that the commands of c205 have in their JSON wherever they have one. Units: clocks of the
 * machine, unless the name says another; addresses are of bits; lines and columns are
 * counted from 1, line 0 is no line of the program's own text (a macro's lines are those of
 * its call). Numbers of the machine are texts, as c205_to_text has them; what is too much
 * for a number of JSON is null.
 *
 * ---- Every reply
 *
 *   ok            true; or false, and nothing has changed but that work which was not done
 *                 is given up:
 *   error         one sentence
 *   diagnostics   of a text that cannot be assembled, and of one that can: severity ("error",
 *                 "warning", "report", "said"), file, line, column, length, message
 *
 * ---- Long work: go, profile, timeline, sweep, compare
 *
 * The request says how long a slice of it is: "ms" of the host's clock, or "clocks" of the machine
 * (of a sweep: runs), or as long as it takes. The reply has
 *
 *   done          false: there is more, which { "do": "more", "ms": .. } continues with; the
 *                 other members are those below once it is true
 *
 * Of the other requests about, grade, view and accounts leave work alone (a profile or a
 * timeline is given up by the last two), all the others give it up: then the program
 * is where a movement has come to, and where it stood before a profile or a timeline.
 *
 * ---- about: what there is
 *
 *   version, model (the usual one)
 *   models        of machines: name, title
 *   instructions  mnemonic, operands (as they are written), half_operands (with ,H; missing: it
 *                 has no such form), effect, unit, vector, source (P S D R)
 *   directives    their names
 *   lessons       number, name, title, start (the program to complete), tests:
 *                 name, tries, warm (its pages are in memory), goals (clocks: gold, silver,
 *                 bronze; missing: none)
 *
 * ---- load: a program in place of the one before
 *
 *   text          the program
 *   name          of its file ("program.s")
 *   model         one of those built in (that which the program expects, or the usual one)
 *   warm          true, false: whether its pages are in memory (as the program says)
 *   defines       { "n": 100 }: integers, as --define gives them; the text uses each name
 *   files         { "data.inc": "..." }: texts for .include and .incfile
 *
 *   name, model, warm, diagnostics
 *   symbols       name, label (or a constant), value (or hex: the bits of a word), contents
 *                 ("", "code", "words", "half words", "bits", "bytes"), count
 *   lines         those of the text that have code
 *
 * ---- breaks: where it stops, in place of those of the last such request
 *
 *   lines         [ 10, 12 ]
 *
 *   lines         for each: wanted, and line, where it really stands; or message, why nowhere
 *
 * ---- go: a movement
 *
 *   how           end (past breakpoints), continue, step, next (a call being one), back,
 *                 reverse-continue, step-to, clock-to (the first step that has it or more behind it),
 *                 start
 *   n             so many steps (1), of step, next and back; where to, of step-to and clock-to
 *   limit         clocks that it takes at most (1000000000)
 *
 *   why           moved, breakpoint, trap, end, start (there is no way farther back), limit; or
 *                 running, while done is false
 *   step, steps   where it stands, and the most that is known of the run
 *   clock
 *   message       what stopped it, in the debugger's words, lines of text
 *
 * ---- view: what there is to be seen where the program stands
 *
 *   elements      of a vector that are shown (64, at most 65536)
 *   first         { "x": 100 }: of this vector from that one on (0)
 *   all-registers true: those without name and contents as well
 *
 *   step, steps, clock, microseconds, pc, line, region
 *   ended         and then trap ("none": by itself), status
 *   next          the next instruction as text; null: none
 *   operands      of it, or of the two that a LINKV links: mnemonic, field (letter of the
 *                 format), number (of the register), half, name, text, and of a vector
 *                 vector: address, count, kind, control (address of its bits)
 *   last          the last instruction, null: none: text, line, mnemonic, effect, unit, elements;
 *                 clocks (by how much it moved the clock), arrived, issued, waited (issued - arrived),
 *                 ready, unit_free; formula (these sums in words); constants of the model: name, value,
 *                 unit, source (P S D R F); pieces of its clocks: clocks, cause, wait (in words),
 *                 line (whose work it is); phases of the vector unit: begin, end, cause; in_flight:
 *                 pieces until all was done, behind the end
 *   registers     number, name, hex, text, integer (low 48 bits), changed (by the last instruction),
 *                 descriptor (if there is memory for its elements): address, count, kind, label;
 *                 left, right (named half registers): number, name, text
 *   accounts      clocks, instructions, vector (of these), elements, mflops, mean_length, causes:
 *                 cause, clocks, percent (of all); regions: region, and the same of each
 *   vectors       data at labels, 256 of them: label, kind ("words", "half words", "bits"), address,
 *                 count, first, values (texts; of bits one text of 0 and 1), changed, stored (by the
 *                 last instruction: first, count)
 *   printed       by the program up to here; printed_cut: not all of it, it was too much
 *
 * ---- accounts: "clocks", "causes" and "regions" of c205 run --json, up to here
 *
 * ---- profile: "lines" of c205 run --profile --json, up to here
 *
 *   in-order      true: as the lines stand; else the hottest first
 *
 * ---- timeline: of all that is known of the run
 *
 *   from, to      clocks
 *   most          instructions (2000, at most 50000)
 *   file          "x.svg", "x.kanata", "x.json": as c205 timeline writes a file of such a name
 *
 *   from, to      to where there is something
 *   full          there were more instructions
 *   file          its text; or
 *   lanes         name, rows (of spans that do not overlap)
 *   insns         pc, line, text, unit, elements, arrived, issued, ready, done, phases and pieces:
 *                 begin, end, cause
 *   spans         lane, row, begin, end, insn (number in insns), cause (missing: its own work)
 *   charged       begin, end, cause: without gaps
 *
 * ---- sweep: a program, or two, against a constant
 *
 *   text, other   programs; the second may be missing
 *   name, other-name  of their files ("first", "second")
 *   constant      its name
 *   from, to      its values; step, or factor: only those; points: so many (8 an octave, at the
 *                 most 25)
 *   model, warm, defines, files as of load; limit: clocks of a run at most (100000000)
 *
 *   part          while done is false: so much is done, 0 .. 1
 *   constant, model, and points, lines, causes, crossings of c205 sweep --json; svg, its picture
 *
 * ---- compare: two programs
 *
 *   texts         two: name, text, model (of this one)
 *   model, warm, defines, files as of load; limit
 *
 *   programs      name, model
 *   sentence, and causes, regions, figures of c205 compare --json
 *
 * ---- grade: an answer to an exercise
 *
 *   lesson        its name or number
 *   name, text    of the answer
 *
 *   what c205 check --format json has of it; words: the same as text
 *
 * ---- say: a line for the debugger
 *
 *   line          "why", "break 10", "continue", ..: docs/debugging.md; movements end with the
 *                 slice, or with limit
 *
 *   text          what it says to that
 *   step, steps, clock
 */
#ifndef WEB_ENGINE_H
#define WEB_ENGINE_H

#include <stddef.h>
#include <stdint.h>

struct engine;

/* Clocks that one movement takes unless the request says another number .. */
#define ENGINE_LIMIT UINT64_C(1000000000)
/* .. and each run of a sweep. */
#define ENGINE_SWEEP_LIMIT UINT64_C(100000000)

/* NULL: no memory. */
struct engine *engine_new(void);
void engine_free(struct engine *engine);

/* Whatever requests say, no movement and no run of a sweep takes more clocks from now on. */
void engine_bound(struct engine *engine, uint64_t clocks);

/* The reply to a request of so many bytes, whatever they are: a text to be freed.  NULL:
 * there is no memory even for that. */
char *engine_answer(struct engine *engine, const char *request, size_t length);

#endif
