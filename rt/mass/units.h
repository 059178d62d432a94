/* units.h - parses, converts and formats the units of reported lengths and masses.
 *
 * Without units, lengths are in the unit of the scene, and a density is a mass per cube
 * of this unit. With units, densities are in grams per cubic centimetre, as in tables
 * of materials.
 */
#ifndef RT_MASS_UNITS_H
#define RT_MASS_UNITS_H

#include <stdbool.h>
#include <stddef.h>

struct mass_units {
    const char *length, *mass; /* NULL: no units */
    double centimetres;        /* length unit in centimetres */
    double grams;              /* mass unit in grams */
};

/* Parses a pair of units such as "mm,g". Returns false if a unit is unknown. */
bool mass_units_take(const char *text, struct mass_units *units);
/* Returns the name of unit i. Lengths come before masses. Returns NULL after the last
 * unit. */
const char *mass_unit_name(size_t i);

/* Converts a density to mass units per cube of the length unit. */
double mass_units_density(const struct mass_units *units, double density);
/* MASS_UNIT is the size of a text such as "mm^3" or "g mm^2", which mass_units_text
 * formats. `mass` and `length` are the exponents of the units; `mass` is 0 or 1. */
enum { MASS_UNIT = 32 };
void mass_units_text(const struct mass_units *units, int mass, int length,
                     char text[MASS_UNIT]);

#endif
