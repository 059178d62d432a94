/* source.h - points of a scene's primitive, and the ways in which it radiates from there:
 * made by its emission, or by lines through it if it has none.
 *
 * Lines go through a sphere about the primitive or about the region that it is a part of, the
 * smaller one, and cross the primitive alone: each crossing is a point, in whose direction
 * the line continues.  So every surface radiates of which an end is known; one without inside,
 * which has no emission, radiates from both of its sides, as often from one as from the other.
 */
#ifndef RT_SOURCE_H
#define RT_SOURCE_H

#include "rt/heat/emission.h"
#include "rt/scene/scene.h"

/* Why each of the scene's primitives radiates nothing, a sentence, or NULL: it does.  The
 * caller frees the list.  NULL: no memory. */
const char **source_refusals(const struct scene *scene);

struct heat_source;

/* The options' mode is any of the three; their points are those of an emission, or lines.
 * NULL: the primitive radiates nothing, options that cannot be, no memory; the error says
 * which.  The scene must outlive the source. */
struct heat_source *source_new(const struct scene *scene, size_t primitive,
                               const struct emission_options *options,
                               c205_error *error);
void source_free(struct heat_source *source);

/* What is made: EMITTED_PLANES planes of so many words, which the caller frees.  The sum of the
 * weights over the options' points is the area. */
struct sourced {
    size_t count;
    c205_word *planes;
};

/* In machines of its own, whose accounts are added; any number of threads may run a source at
 * a time.  False: a trap, no memory, more crossings than a vector is long. */
bool source_run(const struct heat_source *source, const struct emission_choice *choice,
                struct sourced *made, struct accounts *accounts, c205_error *error);

#endif
