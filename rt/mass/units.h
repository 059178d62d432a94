/* units.h - in which units lengths and masses are told.
 *
 * Without units a scene's lengths are what they are, and a density is a mass of a cube
 * whose sides have the length one.  With units densities are those of tables, grams in a
 * cubic centimetre.
 */
#ifndef RT_MASS_UNITS_H
#define RT_MASS_UNITS_H

#include <stdbool.h>
#include <stddef.h>

struct mass_units {
    const char *length, *mass; /* NULL: none were given */
    double centimetres;        /* of the length unit */
    double grams;              /* .. of the mass unit */
};

/* "mm,g".  False: it is no pair of units that are known. */
bool mass_units_take(const char *text, struct mass_units *units);
/* The i-th unit, lengths before masses; NULL: there are no more. */
const char *mass_unit_name(size_t i);

/* What a density becomes, as a mass of a cube with sides of length one. */
double mass_units_density(const struct mass_units *units, double density);
/* "mm^3", "g mm^2": a mass to the power of 0 or 1, a length to another one. */
enum { MASS_UNIT = 32 };
void mass_units_text(const struct mass_units *units, int mass, int length,
                     char text[MASS_UNIT]);

#endif
