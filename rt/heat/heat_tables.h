/* heat_tables.h - converts the areas, factors and flows of a heat computation to
 * tables. All functions that return a table return NULL if out of memory. */
#ifndef RT_HEAT_TABLES_H
#define RT_HEAT_TABLES_H

#include "base/table.h"
#include "rt/heat/heat.h"

/* Returns a table of the areas of the surfaces. A part or material has the kind and
 * line of its first primitive. Surfaces without a visible part are omitted unless `all`
 * is true. */
struct table *heat_table_of_areas(const struct heat *heat, bool all);
/* Returns the number of surfaces that were sampled but have no visible area. */
size_t heat_invisible(const struct heat *heat);
struct table *heat_table_of_factors(const struct heat *heat);
/* Returns a table of the factors, their smoothed values, and the changes in standard
 * errors. */
struct table *heat_table_of_smoothed(const struct heat *heat);
/* Returns a table of the flows of the surfaces and of the environment, and of their
 * sum. */
struct table *heat_table_of_flows(const struct heat *heat);

#endif
