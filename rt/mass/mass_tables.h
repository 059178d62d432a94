/* mass_tables.h - what is found of a scene's mass properties, as tables.  NULL: no
 * memory. */
#ifndef RT_MASS_TABLES_H
#define RT_MASS_TABLES_H

#include "base/table.h"
#include "rt/mass/mass.h"

struct table *mass_table_of_figures(const struct mass *mass);
/* Of pairs that claim something both. */
struct table *mass_table_of_overlaps(const struct mass *mass);
struct table *mass_table_of_axes(const struct mass *mass);
/* Step by step. */
struct table *mass_table_of_clocks(const struct mass *mass);

#endif
