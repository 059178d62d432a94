/* iterations_table.h - the refinement steps of the root solver as rows of tables. All
 * reports use the same rows.
 *
 * A report adds its own columns before these columns, and its own cells before the
 * cells that the functions add.
 */
#ifndef RT_ITERATIONS_TABLE_H
#define RT_ITERATIONS_TABLE_H

#include "base/table.h"
#include "rt/roots/iterations.h"

/* clang-format off */
#define ITERATIONS_COLUMNS \
    { "roots_of", "roots of", TABLE_TEXT, 0 }, \
    { "brackets", "brackets", TABLE_COUNT, 0 }, \
    { "halvings_per_bracket", "halvings/bracket", TABLE_NUMBER, 2 }, \
    { "steps", "steps", TABLE_COUNT, 0 }, \
    { "steps_per_bracket", "steps/bracket", TABLE_NUMBER, 2 }, \
    { "passes", "passes", TABLE_COUNT, 0 }, \
    { "lanes_per_pass", "lanes/pass", TABLE_NUMBER, 1 }, \
    { "active_percent", "% active", TABLE_NUMBER, 1 }
/* clang-format on */

/* clang-format off */
#define ITERATIONS_PASS_COLUMNS \
    { "roots_of", "roots of", TABLE_TEXT, 0 }, \
    { "pass", "pass", TABLE_COUNT, 0 }, \
    { "active", "active", TABLE_COUNT, 0 }, \
    { "brackets_percent", "% of brackets", TABLE_NUMBER, 1 }, \
    { "lanes", "lanes", TABLE_COUNT, 0 }, \
    { "active_percent", "% active", TABLE_NUMBER, 1 }
/* clang-format on */

/* Adds the cells of a row of ITERATIONS_COLUMNS: the counts of a stage. */
void iterations_add(struct table *table, const struct iterations *iterations,
                    enum stage stage);

/* Returns the number of passes of a stage's longest refinement. */
size_t iterations_passes(const struct iterations *iterations, enum stage stage);
/* Adds the cells of a row of ITERATIONS_PASS_COLUMNS: the counts of a pass. The first
 * pass is 0. */
void iterations_add_pass(struct table *table, const struct iterations *iterations,
                         enum stage stage, size_t pass);

#endif
