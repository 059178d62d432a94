/* timeline.h - records when each instruction of a run arrived, issued, executed and
 * completed, and the cause to which each clock was charged.
 *
 * timeline_listen stores the instructions that overlap a given interval of clocks. A
 * timeline is written as a picture (SVG), as text for the viewer Konata (Kanata 0004),
 * or as trace events for viewers such as Perfetto (JSON). The charged clocks sum to the
 * clocks that passed.
 */
#ifndef ASM_TIMELINE_H
#define ASM_TIMELINE_H

#include "asm/object/object.h"
#include "base/arena.h"

enum { MAX_TIMELINE = 50000 }; /* default number of instructions */

/* A piece of charged time or a phase of a vector instruction. */
struct timed_piece {
    uint64_t begin, end;
    c205_cause cause;
    c205_wait wait;
    unsigned number;
};

struct timed_insn {
    uint64_t pc, arrived, issued, ready;
    uint64_t done; /* the clock when its results are available and the next instruction
                    * arrives */
    const c205_insn *insn; /* NULL: the wait for results in flight at the end */
    const char *text;
    const char *line; /* its source line and form, if it belongs to a macro, or "" */
    size_t elements;
    size_t first_piece, piece_count, first_phase, phase_count;
};

struct timeline {
    const struct object *object; /* the program, for the lines of macros, or NULL */
    uint64_t from, to; /* an interval in clocks; instructions that overlap it are
                          stored */
    size_t insn_count, piece_count, phase_count;
    struct timed_insn *insns;
    struct timed_piece *pieces, *phases;
    size_t insn_capacity, piece_capacity, phase_capacity;
    struct arena kept;
    size_t most; /* maximum number of instructions; 0: MAX_TIMELINE */
    bool full;   /* further instructions were not stored */
};

/* Before listening, set object, from and to, and all other fields to zero. */
c205_listener timeline_listen; /* its context is the timeline */
/* Returns false if memory is exhausted. */
bool timeline_is_good(const struct timeline *timeline);
void timeline_free(struct timeline *timeline);

/* Write the timeline as a picture (SVG), for Konata, and as trace events. title is the
 * title of the picture. They return false if memory is exhausted. */
bool timeline_svg(const struct timeline *timeline, const char *title,
                  const struct sink *sink);
bool timeline_kanata(const struct timeline *timeline, const struct sink *sink);
bool timeline_trace_events(const struct timeline *timeline, const struct sink *sink);

/* Writes a title such as "saxpy.s, clocks 0 to 1242 on cyber205-2pipe". */
enum { TIMELINE_TITLE = 400 };
void timeline_title(const struct timeline *timeline, const char *program,
                    const char *model, char title[TIMELINE_TITLE]);

/* Returns the number of instructions. The entry for the final wait for results in
 * flight does not count. */
size_t timeline_instructions(const struct timeline *timeline);
/* Moves `to` back to the clock at which the last instruction completed, if `to` is
 * after this clock. */
void timeline_finish(struct timeline *timeline);
/* A format is selected by the ending of a file name: .svg, .kanata or .json.
 * timeline_form_of returns NULL and timeline_is_named false for any other ending. */
struct timeline_form;
const struct timeline_form *timeline_form_of(const char *path);
bool timeline_is_named(const char *path);
bool timeline_write(const struct timeline *timeline, const struct timeline_form *form,
                    const char *title, const struct sink *sink);
/* Saves a timeline in the format that the ending of the path selects. Writes the whole
 * file or leaves the old file unchanged. */
bool timeline_save(const struct timeline *timeline, const char *path, const char *title,
                   c205_error *error);

#endif
