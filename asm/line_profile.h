/* line_profile.h - where the clocks of a program went, line by line of its source; macros
 * are summed at the line that calls them, in each region apart.
 *
 * A listener adds up the pieces of the clock's own records.  As in the accounts each belongs to
 * the instruction whose work it is: clocks that others wait for a vector instruction are
 * that one's.  Code whose line is not known has a row of its own, and so have clocks of an
 * instruction within which a run was stopped.  The sum of all rows is that of the accounts,
 * cause by cause, and so is that of a region.
 */
#ifndef ASM_LINE_PROFILE_H
#define ASM_LINE_PROFILE_H

#include "asm/assemble.h"
#include "base/command_output.h"

struct line_profile;

/* The object knows its lines and outlives it.  NULL: no memory. */
struct line_profile *line_profile_new(const struct object *object);
void line_profile_free(struct line_profile *profile);
/* The listener; its context is the profile, of one run from its beginning. */
c205_listener line_profile_listen;

/* Add what another one of the same object has. */
void line_profile_add(struct line_profile *profile, const struct line_profile *more);

struct profile_row {
    const char *region; /* "": none */
    const char *file;   /* NULL: code without lines, or the end of the run */
    size_t number;
    const char *source;
    uint64_t executions, elements, clocks[C205_CAUSES];
};

size_t line_profile_count(const struct line_profile *profile);
/* In the order of addresses; the last two are code without lines, and an instruction that was
 * not done. */
const struct profile_row *line_profile_row(const struct line_profile *profile,
                                           size_t i);

/* Rows that took time: the hottest first, or as they are. */
enum profile_order { PROFILE_HOTTEST, PROFILE_AS_WRITTEN };
struct profile_view {
    enum profile_order order;
    bool regions; /* have a column; the hottest one comes first, then */
};
/* For the eye: with the causes in words; or with a column for each cause.  NULL: no memory. */
struct table *line_profile_table(const struct line_profile *profile,
                                 struct profile_view view, bool in_words);
/* What suits the format of the results; in JSON "lines".  The exit code. */
int line_profile_show(const struct line_profile *profile, struct profile_view view,
                      const struct command_output *results);

#endif
