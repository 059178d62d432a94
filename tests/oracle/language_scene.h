/* language_scene.h - generates random scenes as texts in the scene language.
 *
 * The texts have declarations of every kind, expressions with every operator and
 * function, conditions, loops, macros and arrays; all shapes that POV-Ray also has,
 * solids, clipped and bounded objects, transforms, textures, lights, fogs, skies and
 * cameras.  They use everything that means the same in both programs by docs/scenes.md.
 * The differences listed in docs/povray.md are avoided; comments mark the places.
 */
#ifndef LANGUAGE_SCENE_H
#define LANGUAGE_SCENE_H

#include <stdint.h>

/* Size of the pictures for which they are made. */
enum { LANGUAGE_WIDTH = 40, LANGUAGE_HEIGHT = 30 };

/* The image of their image_map is a file of this name in the same folder. */
#define LANGUAGE_IMAGE "language_image.ppm"
extern const char language_image[];

/* Returns the text of a scene; the caller frees it. */
char *language_scene_text(uint64_t seed);

#endif
