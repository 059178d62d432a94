/* heat_tables.h - the results of a heat computation as tables. Functions return
 * NULL if out of memory. */
#ifndef RT_HEAT_TABLES_H
#define RT_HEAT_TABLES_H

#include "base/table.h"
#include "rt/heat/heat.h"

/* Returns the areas. The kind and line of a part or material are those of its
 * first primitive. Surfaces without a visible part are left out unless `all` is
 * set. */
struct table *heat_table_of_areas(const struct heat *heat, bool all);
/* Returns the number of surfaces that were sampled and have no visible area. */
size_t heat_invisible(const struct heat *heat);
struct table *heat_table_of_factors(const struct heat *heat);
/* Returns the factors with their smoothed values, and the change in standard
 * errors. */
struct table *heat_table_of_smoothed(const struct heat *heat);
/* Returns the flows of the surfaces, of the environment, and their sum. */
struct table *heat_table_of_flows(const struct heat *heat);

#endif
