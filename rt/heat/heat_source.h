/* heat_source.h - generates points of a scene's primitive and directions in which it
 * radiates, by its emission, or by lines through it if it has none.
 *
 * The lines go through a sphere around the primitive, or around its region if that
 * is smaller, and cross the primitive alone. Each crossing is a point, and its ray
 * continues along the line. Every bounded surface can therefore radiate. A surface
 * that has no inside and no emission radiates from both of its sides equally
 * often.
 */
#ifndef RT_SOURCE_H
#define RT_SOURCE_H

#include "rt/heat/emission.h"
#include "rt/scene/scene.h"

/* Returns, for each of the scene's primitives, the reason why it cannot radiate,
 * as a sentence, or NULL if it can. The caller frees the list. Returns NULL if out
 * of memory. */
const char **source_refusals(const struct scene *scene);

struct heat_source;

/* Returns a source. The mode is any of the three; points is the number of points of an
 * emission, or of lines. Returns NULL with the reason in the error if the primitive
 * cannot radiate, for invalid options, or if memory is exhausted. The scene must
 * outlive the source. */
struct heat_source *source_new(const struct scene *scene, size_t primitive,
                               const struct emission_options *options,
                               c205_error *error);
void source_free(struct heat_source *source);

/* The output: EMITTED_PLANES planes of count words, which the caller frees. The
 * sum of the weights divided by the options' points is the area. */
struct sourced {
    size_t count;
    c205_word *planes;
};

/* Runs a source on machines of its own and adds their accounts. Threads may run
 * one source concurrently. Returns false after a trap, if out of memory, or if
 * there are more crossings than a vector holds. */
bool source_run(const struct heat_source *source, const struct emission_choice *choice,
                struct sourced *made, struct accounts *accounts, c205_error *error);

#endif
