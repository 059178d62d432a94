/* timeline.h - when each instruction of a run arrived, issued, worked and was done; and what
 * each clock was charged to.
 *
 * A listener keeps the clock's own records of a stretch of clocks; nothing is worked out
 * here.  Three forms are written of it: a picture (SVG); text that the viewer Konata shows, a
 * line for each instruction (Kanata 0004); and trace events for Perfetto and its like
 * (JSON).  The sum of what was charged is by how much the clock moved there.
 */
#ifndef ASM_TIMELINE_H
#define ASM_TIMELINE_H

#include "base/arena.h"
#include "base/sink.h"
#include "vm/c205.h"

enum { MAX_TIMELINE = 50000 }; /* instructions */

/* One piece of time that was charged, or one phase of a vector instruction. */
struct timed_piece {
    uint64_t begin, end;
    c205_cause cause;
    c205_wait wait;
    unsigned number;
};

struct timed_insn {
    uint64_t pc, arrived, issued, ready;
    uint64_t done;         /* its results are there, and the clock has moved on */
    const c205_insn *insn; /* NULL: what was in flight at the end of the run */
    const char *text;
    size_t elements;
    size_t first_piece, piece_count, first_phase, phase_count;
};

struct timeline {
    uint64_t from, to; /* clocks; what reaches in between is kept */
    size_t insn_count, piece_count, phase_count;
    struct timed_insn *insns;
    struct timed_piece *pieces, *phases;
    size_t insn_capacity, piece_capacity, phase_capacity;
    struct arena kept;
    size_t most; /* instructions that are kept; 0: MAX_TIMELINE */
    bool full;   /* there were more, which are left out */
};

/* Begin with from and to, the rest zero. */
c205_listener timeline_listen; /* its context is the timeline */
/* False: memory ran out. */
bool timeline_is_good(const struct timeline *timeline);
void timeline_free(struct timeline *timeline);

/* The title is that of the picture. */
bool timeline_svg(const struct timeline *timeline, const char *title,
                  const struct sink *sink);
bool timeline_kanata(const struct timeline *timeline, const struct sink *sink);
bool timeline_trace_events(const struct timeline *timeline, const struct sink *sink);

/* "saxpy.s, clocks 0 to 1242 on cyber205-2pipe" */
enum { TIMELINE_TITLE = 400 };
void timeline_title(const struct timeline *timeline, const char *program,
                    const char *model, char title[TIMELINE_TITLE]);

/* Instructions, without what was in flight at the end. */
size_t timeline_instructions(const struct timeline *timeline);
/* It ends where the last of it was done, if that is before. */
void timeline_finish(struct timeline *timeline);
/* A file's name says which form it has: .svg, .kanata, .json; NULL, false: none of these. */
struct timeline_form;
const struct timeline_form *timeline_form_of(const char *path);
bool timeline_is_named(const char *path);
bool timeline_write(const struct timeline *timeline, const struct timeline_form *form,
                    const char *title, const struct sink *sink);
/* As a file of such a name; whole, or not at all. */
bool timeline_save(const struct timeline *timeline, const char *path, const char *title,
                   c205_error *error);

#endif
