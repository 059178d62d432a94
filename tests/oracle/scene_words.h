/* scene_words.h - parts of random scenes in the scene language: lights that shine to one
 * side, normals, closed meshes and fields of heights. */
#ifndef SCENE_WORDS_H
#define SCENE_WORDS_H

#include "tests/oracle/solid_text.h"

#include <stdint.h>

/* Of every other light words of its beam, of its parallel rays, of how it fades, else
 * none.  They begin with an empty place.  What else a scene draws does not depend on
 * them: the state is a copy of that with which it continues. */
void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS]);

/* To one in so many looks a normal is added.  What else a scene draws does not depend
 * on it: the state is a copy of that with which it continues. */
void bump_words(uint64_t state, size_t in, char look[SOLID_WORDS]);

/* A box; each side is cut by either diagonal. */
void mesh_box_words(uint64_t state, double corner[2][3], char words[SOLID_WORDS]);
/* About the origin, within the distance 1: points all round, near and far, an apex
 * above and one below, so that a line may cross it many times. */
void mesh_star_words(uint64_t state, char words[SOLID_WORDS]);
/* A field of heights as wide, perhaps with water. */
void mesh_field_words(uint64_t state, char words[SOLID_WORDS]);

#endif
