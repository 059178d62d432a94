/* mesh_text.h - closed meshes and fields of heights by chance in the scene language, up to their
 * modifiers. */
#ifndef MESH_TEXT_H
#define MESH_TEXT_H

#include "tests/oracle/solid_text.h"

#include <stdint.h>

/* A box; each side is cut by either diagonal. */
void mesh_box_words(uint64_t state, double corner[2][3], char words[SOLID_WORDS]);
/* About the origin, within the distance 1: points all round, near and far, an apex
 * above and one below, so that a line may cross it many times. */
void mesh_star_words(uint64_t state, char words[SOLID_WORDS]);
/* A field of heights as wide, perhaps with water. */
void mesh_field_words(uint64_t state, char words[SOLID_WORDS]);

#endif
