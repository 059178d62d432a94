/* quartic_costs.h - reports the costs of rt205 quartic after the roots: the clocks, the
 * steps of falsi, and the active brackets in each pass.
 *
 * In text output these lines begin with #, so that a reader of the roots can skip them.
 */
#ifndef RT_QUARTIC_COSTS_H
#define RT_QUARTIC_COSTS_H

#include "base/command_output.h"
#include "rt/roots/roots.h"

struct quartic_costs {
    const char *file;
    const struct roots_options *options;
    const struct root_search *search; /* a search that has been run with an observer */
    const struct iterations *iterations;
    size_t polynomials, roots;
};

/* Prints all costs. Returns false if out of memory. */
bool quartic_costs_print(const struct quartic_costs *costs,
                         const struct command_output *results);

/* Prints a table, and adds it to the JSON under the key. Text output has # before each
 * line. Returns false if out of memory. */
bool quartic_costs_part(const struct command_output *results, const struct table *table,
                        const char *key, const char *heading);

/* Prints the reliability of the model. Text output has # before each line. */
void quartic_costs_model(const struct command_output *results, const c205_model *model);

#endif
