/* timeline.h - records when each instruction of a run arrived, issued, executed and
 * completed, and the cause to which each clock was charged.
 *
 * A listener stores the clock's own records for an interval of clocks; nothing is
 * computed here. Three formats can be written: a picture (SVG), text for the
 * viewer Konata with a line for each instruction (Kanata 0004), and trace events
 * for viewers such as Perfetto (JSON). The sum of the charged clocks is the number
 * of clocks that passed.
 */
#ifndef ASM_TIMELINE_H
#define ASM_TIMELINE_H

#include "base/arena.h"
#include "base/sink.h"
#include "vm/c205.h"

enum { MAX_TIMELINE = 50000 }; /* instructions */

/* A piece of charged time, or a phase of a vector instruction. */
struct timed_piece {
    uint64_t begin, end;
    c205_cause cause;
    c205_wait wait;
    unsigned number;
};

struct timed_insn {
    uint64_t pc, arrived, issued, ready;
    uint64_t done; /* clock when its results are available and the next arrives */
    const c205_insn *insn; /* NULL: the results in flight at the end of the run */
    const char *text;
    size_t elements;
    size_t first_piece, piece_count, first_phase, phase_count;
};

struct timeline {
    uint64_t from, to; /* clocks; instructions that overlap this interval are stored */
    size_t insn_count, piece_count, phase_count;
    struct timed_insn *insns;
    struct timed_piece *pieces, *phases;
    size_t insn_capacity, piece_capacity, phase_capacity;
    struct arena kept;
    size_t most; /* most instructions stored; 0: MAX_TIMELINE */
    bool full;   /* more instructions were not stored */
};

/* Set from and to, and all other fields to zero, before listening. */
c205_listener timeline_listen; /* its context is the timeline */
/* Returns false if memory was exhausted. */
bool timeline_is_good(const struct timeline *timeline);
void timeline_free(struct timeline *timeline);

/* title: of the picture */
bool timeline_svg(const struct timeline *timeline, const char *title,
                  const struct sink *sink);
bool timeline_kanata(const struct timeline *timeline, const struct sink *sink);
bool timeline_trace_events(const struct timeline *timeline, const struct sink *sink);

/* Writes "saxpy.s, clocks 0 to 1242 on cyber205-2pipe". */
enum { TIMELINE_TITLE = 400 };
void timeline_title(const struct timeline *timeline, const char *program,
                    const char *model, char title[TIMELINE_TITLE]);

/* Returns the number of instructions, without the results in flight at the end. */
size_t timeline_instructions(const struct timeline *timeline);
/* Moves `to` to the clock at which the last instruction
 * completed, if that is earlier. */
void timeline_finish(struct timeline *timeline);
/* Returns the format for the name of a file, .svg, .kanata or .json; NULL or
 * false for any other name. */
struct timeline_form;
const struct timeline_form *timeline_form_of(const char *path);
bool timeline_is_named(const char *path);
bool timeline_write(const struct timeline *timeline, const struct timeline_form *form,
                    const char *title, const struct sink *sink);
/* Saves a file in the format of its name. Writes the whole file or leaves
 * the old one unchanged. */
bool timeline_save(const struct timeline *timeline, const char *path, const char *title,
                   c205_error *error);

#endif
