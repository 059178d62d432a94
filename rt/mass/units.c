/* units.c - parses, converts and formats the units of lengths and masses. */
#include "rt/mass/units.h"

#include <stdio.h>
#include <string.h>

struct named_unit {
    const char *name;
    double size;
};
static const struct named_unit lengths[] = {
    { "mm", .1 }, { "cm", 1 },    { "dm", 10 },
    { "m", 100 }, { "in", 2.54 }, { "ft", 30.48 },
};
static const struct named_unit masses[] = {
    { "mg", .001 },         { "g", 1 },          { "kg", 1e3 }, { "t", 1e6 },
    { "oz", 28.349523125 }, { "lb", 453.59237 },
};
enum {
    LENGTHS = sizeof lengths / sizeof *lengths,
    MASSES = sizeof masses / sizeof *masses
};

const char *mass_unit_name(size_t i)
{
    return i < LENGTHS            ? lengths[i].name
           : i < LENGTHS + MASSES ? masses[i - LENGTHS].name
                                  : NULL;
}

static const struct named_unit *find_unit(const struct named_unit *list, size_t count,
                                          const char *name, size_t length)
{
    for (size_t i = 0; i < count; i++)
        if (strlen(list[i].name) == length && strncmp(list[i].name, name, length) == 0)
            return &list[i];
    return NULL;
}

bool mass_units_take(const char *text, struct mass_units *units)
{
    const char *comma = strchr(text, ',');
    const struct named_unit *length, *mass;
    if (!comma)
        return false;
    length = find_unit(lengths, LENGTHS, text, (size_t)(comma - text));
    mass = find_unit(masses, MASSES, comma + 1, strlen(comma + 1));
    if (!length || !mass)
        return false;
    *units = (struct mass_units){ length->name, mass->name, length->size, mass->size };
    return true;
}

double mass_units_density(const struct mass_units *units, double density)
{
    double side = units->centimetres;
    return units->length ? density * side * side * side / units->grams : density;
}

void mass_units_text(const struct mass_units *units, int mass, int length,
                     char text[MASS_UNIT])
{
    char sides[MASS_UNIT / 2] = "";
    text[0] = '\0';
    if (!units->length)
        return;
    if (length > 1)
        snprintf(sides, sizeof sides, "%s^%d", units->length, length);
    else if (length == 1)
        snprintf(sides, sizeof sides, "%s", units->length);
    snprintf(text, MASS_UNIT, "%s%s%s", mass ? units->mass : "",
             mass && length ? " " : "", sides);
}
