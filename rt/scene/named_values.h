/* named_values.h - numbers that are assigned to parts and materials by name: densities,
 * emissivities, temperatures.
 *
 * A part has the value of its name. If there is none, it has the value of its material,
 * or else the default value. If a name has several values, the first is used. The
 * values come from options of the form NAME=VALUE, from a file, and from floats of the
 * scene whose names have a fixed ending.
 */
#ifndef RT_NAMED_VALUES_H
#define RT_NAMED_VALUES_H

#include "base/diagnostic.h"
#include "rt/scene/named_parts.h"

/* A quantity, such as the density. */
struct value_kind {
    const char *name;   /* such as "density" */
    const char *ending; /* suffix of floats in the scene, such as "_Density" */
    const char *range;  /* valid values, such as "above 0" */
    bool (*allows)(double value);
    const char *word; /* a word that is accepted as a value; NULL: none */
    double word_value;
};

struct named_value {
    const char *name;
    double value;
};

struct named_values {
    const struct value_kind *kind;
    size_t count;
    struct named_value *list; /* in order; the first entry of a name is used */
    double others;            /* default value; NaN: none */
    struct arena kept;
};

void named_begin(struct named_values *given, const struct value_kind *kind);
/* Adds NAME=VALUE. The name `default` sets the default. If the text has another form,
 * if the value is out of range, or if out of memory, sets the error and returns
 * false. */
bool named_add(struct named_values *given, const char *text, c205_error *error);
/* Reads a file. Each line has a number, which is ignored, a value and a name. A comment
 * extends from # to the end of the line. Returns false if lines are wrong; the reports
 * list all of them. */
bool named_read(struct named_values *given, const char *path,
                struct diagnostics *reports);
/* Adds the floats of the scene whose names end in kind->ending. Returns false if a
 * value is out of range, or if out of memory. */
bool named_add_scene(struct named_values *given, const struct scene *scene,
                     c205_error *error);
void named_free(struct named_values *given);

/* Checks that each name is the name of a part or a material, or `besides` (NULL: none).
 * Otherwise sets an error that lists the existing names, and returns false. */
bool named_check(const struct named_values *given, const struct named_parts *parts,
                 const char *besides, c205_error *error);
/* Returns the value of a part, or NaN if it has none. */
double named_of_part(const struct named_values *given, const struct named_part *part);
/* Returns the value of a name, or NaN if it has none. */
double named_of_name(const struct named_values *given, const char *name);

#endif
