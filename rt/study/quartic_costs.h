/* quartic_costs.h - what rt205 quartic tells after the roots: which clocks
 * they took, how falsi went, how many brackets were active pass by pass.
 *
 * As text it is on lines that begin with #, so that the roots are what is
 * left without them.
 */
#ifndef RT_QUARTIC_COSTS_H
#define RT_QUARTIC_COSTS_H

#include "base/command_output.h"
#include "rt/roots/roots.h"

struct quartic_costs {
    const char *file;
    const struct roots_options *options;
    const struct root_search *search; /* done, and watched */
    const struct iterations *iterations;
    size_t polynomials, roots;
};

/* False: memory ran out. */
bool quartic_costs_print(const struct quartic_costs *costs,
                         const struct command_output *results);

/* Such a table.  False: likewise. */
bool quartic_costs_part(const struct command_output *results, const struct table *table,
                        const char *key, const char *heading);

/* How far the model can be trusted, likewise. */
void quartic_costs_model(const struct command_output *results, const c205_model *model);

#endif
