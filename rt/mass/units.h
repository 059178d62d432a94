/* units.h - the units in which lengths and masses are reported.
 *
 * Without units, a scene's lengths are reported as they are, and a density is a
 * mass per cube of the unit length. With units, densities are in grams per cubic
 * centimetre, as in tables of materials.
 */
#ifndef RT_MASS_UNITS_H
#define RT_MASS_UNITS_H

#include <stdbool.h>
#include <stddef.h>

struct mass_units {
    const char *length, *mass; /* NULL: none were given */
    double centimetres;        /* of the length unit */
    double grams;              /* of the mass unit */
};

/* Parses a pair of units such as "mm,g". Returns false if a unit is unknown. */
bool mass_units_take(const char *text, struct mass_units *units);
/* Returns the i-th unit, lengths before masses, or NULL after the last. */
const char *mass_unit_name(size_t i);

/* Converts a density to mass units per cube of the length unit. */
double mass_units_density(const struct mass_units *units, double density);
/* Formats a unit such as "mm^3" or "g mm^2". The power of the mass is 0 or 1; that
 * of the length is any. */
enum { MASS_UNIT = 32 };
void mass_units_text(const struct mass_units *units, int mass, int length,
                     char text[MASS_UNIT]);

#endif
