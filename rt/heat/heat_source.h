/* heat_source.h - generates points on a primitive of a scene, and directions in which
 * it radiates. They come from the primitive's emission or, if it has none, from lines
 * through it.
 *
 * The lines go through a sphere around the primitive, or around its region if that is
 * smaller. Only their crossings with this primitive count. Each crossing is a point,
 * and its ray continues along the line. Every bounded surface can therefore radiate. A
 * surface without an inside and without an emission radiates from both sides equally
 * often.
 */
#ifndef RT_HEAT_SOURCE_H
#define RT_HEAT_SOURCE_H

#include "rt/heat/emission.h"
#include "rt/scene/scene.h"

/* Returns for each primitive the reason why it cannot radiate, as a sentence, or NULL
 * if it can. The caller frees the list. Returns NULL if out of memory. */
const char **source_refusals(const struct scene *scene);

struct heat_source;

/* Returns a source. All three modes are permitted in options->mode. options->points is
 * the number of points that an emission generates, or else the number of lines. If the
 * primitive cannot radiate, for invalid options, or if out of memory, sets the error
 * and returns NULL. The scene must outlive the source. */
struct heat_source *source_new(const struct scene *scene, size_t primitive,
                               const struct emission_options *options,
                               c205_error *error);
void source_free(struct heat_source *source);

/* The points that source_run generates: EMITTED_PLANES planes with a word for each
 * point. The caller frees the planes. The area of the primitive is the sum of the
 * weights of the points, divided by options->points. */
struct sourced {
    size_t count;
    c205_word *planes;
};

/* Runs a source on new machines and adds their accounts. Threads may run the same
 * source concurrently. Returns false after a trap, if out of memory, or if there are
 * more crossings than a vector can have. */
bool source_run(const struct heat_source *source, const struct emission_choice *choice,
                struct sourced *made, struct accounts *accounts, c205_error *error);

#endif
