/* quartic_costs.h - what rt205 quartic tells after the roots: which clocks
 * they took, how falsi went, how many brackets were active pass by pass.
 *
 * It is printed on lines that begin with #, so that the roots are what is
 * left without them.
 */
#ifndef RT_QUARTIC_COSTS_H
#define RT_QUARTIC_COSTS_H

#include "base/json.h"
#include "base/table.h"
#include "rt/roots/roots.h"

struct quartic_costs {
    const char *file;
    const struct roots_options *options;
    const struct root_search *search; /* done, and watched */
    const struct iterations *iterations;
    size_t polynomials, roots;
};

/* Print, and add to the JSON file if there is one.  False: memory ran out. */
bool quartic_costs_tell(const struct quartic_costs *costs, struct json *json);

/* A heading and the table, each line behind a #.  False: likewise. */
bool print_remarks(const struct table *table, const char *heading);

#endif
