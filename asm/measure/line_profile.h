/* line_profile.h - the clocks of a program by source line. The instructions of a macro
 * are summed at the lines at which they are shown (asm/text/shown_line.h), separately
 * for each region and form.
 *
 * A listener adds the pieces of the clock's records. As in the accounts, a piece
 * belongs to the instruction that causes it. If instructions wait for a vector
 * instruction, the vector instruction is charged. Code without a known line has a row.
 * An instruction within which the run stopped has a row, too. The sum of all rows
 * equals the accounts for each cause, and also within each region.
 */
#ifndef ASM_LINE_PROFILE_H
#define ASM_LINE_PROFILE_H

#include "asm/object/object.h"
#include "base/command_output.h"

struct line_profile;

/* Returns a profile, or NULL if memory is exhausted. The object must have source lines
 * and outlive the profile. */
struct line_profile *line_profile_new(const struct object *object);
void line_profile_free(struct line_profile *profile);
/* Adds each instruction of a run to a profile. The context is the struct line_profile.
 * The listener must be added before the run starts. */
c205_listener line_profile_listen;

/* Adds the counts of another profile of the same object. */
void line_profile_add(struct line_profile *profile, const struct line_profile *more);

struct profile_row {
    const char *region; /* "": none */
    const char *file;   /* NULL: code without lines, or the end of the run */
    size_t number;
    const char *source;
    enum asm_form form;
    uint64_t executions, elements, clocks[C205_CAUSES];
};

size_t line_profile_count(const struct line_profile *profile);
/* Returns a row. Rows are sorted by address. The last two rows are code without lines
 * and the incomplete instruction. */
const struct profile_row *line_profile_row(const struct line_profile *profile,
                                           size_t i);

/* Returns the clocks of all causes of a row. */
uint64_t line_profile_clocks(const struct profile_row *row);

/* The order of the rows that are shown: by clocks, or by address. Rows without clocks
 * are omitted. */
enum profile_order { PROFILE_HOTTEST, PROFILE_AS_WRITTEN };
struct profile_view {
    enum profile_order order;
    bool regions; /* show a column of regions, with the largest region first */
};
/* Returns a table of the profile. in_words: one column names the causes; otherwise each
 * cause has a column. Returns NULL if memory is exhausted. */
struct table *line_profile_table(const struct line_profile *profile,
                                 struct profile_view view, bool in_words);
/* Prints the table in the format of the results. In JSON it is the member "lines".
 * Returns the exit code. */
int line_profile_show(const struct line_profile *profile, struct profile_view view,
                      const struct command_output *results);

#endif
