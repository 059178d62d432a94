/* chords.h - lines through a sphere, isotropic and uniform: those along which it would
 * radiate inward, made by a machine.
 *
 * What a sphere radiates goes out; followed back from where it does, it came in.  Of a
 * surface within the sphere, of radius R, an element dA is crossed by each line with the
 * chance dA / (2 pi R^2), in directions that have the cosine law on either side.
 */
#ifndef RT_CHORDS_H
#define RT_CHORDS_H

#include "rt/heat/emission.h"
#include "rt/trace/ray_query.h"

/* Lines end on the sphere and begin outside of it, so many radii before. */
#define CHORDS_BEHIND 2.01

struct chords {
    double center[3], radius;
    size_t count; /* of a run: the points of the emission */
    struct emission *sphere;
};

/* False: what emission_new refuses.  End it in either case. */
bool chords_begin(struct chords *chords, const struct emission_options *emits,
                  c205_error *error);
void chords_end(struct chords *chords);

/* What an element of area counts for that a line has crossed: 2 pi R^2. */
double chords_weight(const struct chords *chords);

/* As many lines, and the planes of the points where they end (enum emitted).  Any number of
 * threads may run them at a time.  False: a trap, no memory. */
bool chords_run(const struct chords *chords, const struct emission_choice *choice,
                c205_word *planes, struct scene_ray *lines, struct accounts *accounts,
                c205_error *error);

#endif
