/* named_values.h - numbers that are assigned to parts and materials by name: densities,
 * emissivities, temperatures.
 *
 * A part has the value of its own name, else that of its material, else the default. If
 * a name has several values, the first counts. The values come from options of the form
 * NAME=VALUE, from a file, and from floats of the scene whose names have a fixed
 * ending.
 */
#ifndef RT_GIVEN_VALUES_H
#define RT_GIVEN_VALUES_H

#include "base/diagnostic.h"
#include "rt/scene/scene_internal.h"

/* The quantity of the values, such as the density. */
struct value_kind {
    const char *name;   /* "density" */
    const char *ending; /* suffix of floats of the scene: "_Density" */
    const char *range;  /* "above 0" */
    bool (*allows)(double value);
    const char *word; /* word that is also accepted as a value; NULL: none */
    double word_value;
};

struct named_value {
    const char *name;
    double value;
};

struct named_values {
    const struct value_kind *kind;
    size_t count;
    struct named_value *list; /* in order; the first of a name counts */
    double others;            /* the default; NaN: none */
    struct arena kept;
};

void named_begin(struct named_values *given, const struct value_kind *kind);
/* Adds NAME=VALUE; the name `default` sets the default. Fails if the text has another
 * form, if the value is out of range, or without memory; the error has the reason. */
bool named_add(struct named_values *given, const char *text, c205_error *error);
/* Reads a file of lines: a number, which is ignored, a value and a name. Text from a #
 * to the end of its line is ignored. Fails if a line is wrong; the reports list all
 * wrong lines. */
bool named_read(struct named_values *given, const char *path,
                struct diagnostics *reports);
/* Adds the floats of the scene whose names end in kind->ending. Fails if a value is out
 * of range, or without memory. */
bool named_add_scene(struct named_values *given, const struct scene *scene,
                     c205_error *error);
void named_free(struct named_values *given);

/* Fails if one of the names so far is not that of a part or a material; the error lists
 * those that exist. The name `besides` is also accepted; NULL: none. */
bool named_check(const struct named_values *given, const struct named_parts *parts,
                 const char *besides, c205_error *error);
/* Returns the value of a part; NaN: it has none. */
double named_of_part(const struct named_values *given, const struct named_part *part);
/* Returns the value of a name; NaN: it has none. */
double named_of_name(const struct named_values *given, const char *name);

#endif
