/* named_values.h - numbers that are given to a scene's parts and materials by name: densities,
 * emissivities, temperatures.
 *
 * A part has the value that is given to its own name, else that of its material, else the
 * one for all others; where several say one it is the first.  They come from options,
 * NAME=VALUE, from a file, and from floats of the scene whose names end in what such a
 * value is called.
 */
#ifndef RT_GIVEN_VALUES_H
#define RT_GIVEN_VALUES_H

#include "base/diagnostic.h"
#include "rt/scene/scene_internal.h"

/* What is given. */
struct value_kind {
    const char *name;   /* "density" */
    const char *ending; /* of floats of the scene: "_Density" */
    const char *range;  /* "above 0" */
    bool (*allows)(double value);
    const char *word; /* that stands for a value, too; NULL: none */
    double word_value;
};

struct named_value {
    const char *name;
    double value;
};

struct named_values {
    const struct value_kind *kind;
    size_t count;
    struct named_value *list; /* the first of a name counts */
    double others;            /* of what has no other; NaN: none */
    struct arena kept;
};

void named_begin(struct named_values *given, const struct value_kind *kind);
/* NAME=VALUE, where the name `default` is all others.  False: it is no such text,
 * or a value out of range; or no memory; the error says which. */
bool named_add(struct named_values *given, const char *text, c205_error *error);
/* A file of lines: a number, which means nothing, a value, a name; what is behind # is
 * passed over.  False: the reports say what is wrong with it. */
bool named_read(struct named_values *given, const char *path,
                struct diagnostics *reports);
/* Those of the scene's floats. */
bool named_add_scene(struct named_values *given, const struct scene *scene,
                     c205_error *error);
void named_free(struct named_values *given);

/* False: one of the names so far is not that of a part or a material, nor this one (NULL: there
 * is no other); the error lists those that there are. */
bool named_check(const struct named_values *given, const struct named_parts *parts,
                 const char *besides, c205_error *error);
/* NaN: the part has none. */
double named_of_part(const struct named_values *given, const struct named_part *part);
/* .. nobody has that name. */
double named_of_name(const struct named_values *given, const char *name);

#endif
