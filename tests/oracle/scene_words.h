/* scene_words.h - parts of random scenes in the scene language: lights with a
 * direction, normals, closed meshes and height fields. */
#ifndef SCENE_WORDS_H
#define SCENE_WORDS_H

#include "tests/oracle/solid_text.h"

#include <stdint.h>

/* For every other light, prints keywords of its beam, parallel rays and attenuation,
 * otherwise none.  The text starts with a space.  The rest of the scene does not depend
 * on it: the state is a copy of that with which the scene continues. */
void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS]);

/* Adds a normal to one look in `in`.  The rest of the scene does not depend on it: the
 * state is a copy of that with which the scene continues. */
void bump_words(uint64_t state, size_t in, char look[SOLID_WORDS]);

/* Prints a box; each side is split by one of its diagonals. */
void mesh_box_words(uint64_t state, double corner[2][3], char words[SOLID_WORDS]);
/* Prints a star at the origin, within the radius 1: points all round, near and far, an
 * apex above and one below, so that a line may cross it many times. */
void mesh_star_words(uint64_t state, char words[SOLID_WORDS]);
/* Prints a height field of the same width, possibly with water. */
void mesh_field_words(uint64_t state, char words[SOLID_WORDS]);

#endif
