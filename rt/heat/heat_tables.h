/* heat_tables.h - what is found of a scene's heat, as tables.  NULL: no memory. */
#ifndef RT_HEAT_TABLES_H
#define RT_HEAT_TABLES_H

#include "base/table.h"
#include "rt/heat/heat.h"

/* Of a part or a material the kind and the line are those of its first primitive.  Surfaces
 * of which nothing is seen are left out unless all are wanted. */
struct table *heat_table_of_areas(const struct heat *heat, bool all);
/* How many of them were tried and have no area that is seen. */
size_t heat_unseen(const struct heat *heat);
struct table *heat_table_of_factors(const struct heat *heat);
/* .. beside those that are smoothed, and by how many standard errors these are off. */
struct table *heat_table_of_smoothed(const struct heat *heat);
/* Then that of the environment, and of all together. */
struct table *heat_table_of_flows(const struct heat *heat);

#endif
