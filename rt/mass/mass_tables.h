/* mass_tables.h - converts the mass properties of a scene to tables. All functions
 * return NULL if out of memory. */
#ifndef RT_MASS_TABLES_H
#define RT_MASS_TABLES_H

#include "base/table.h"
#include "rt/mass/mass.h"

struct table *mass_table_of_figures(const struct mass *mass);
/* Returns a table of the pairs of parts that overlap. */
struct table *mass_table_of_overlaps(const struct mass *mass);
struct table *mass_table_of_axes(const struct mass *mass);
/* Returns a table of the clocks of each stage. */
struct table *mass_table_of_clocks(const struct mass *mass);

#endif
