/* language_scene.h - random scenes, as texts in the scene language.
 *
 * Declarations of every kind, expressions of every operator and function,
 * conditions, loops, macros and arrays; all shapes that POV-Ray has, too, solids,
 * clipped and bounded ones, motions, looks, lights, fogs, skies and cameras: of
 * what docs/scenes.md says that it means the same in both programs.  What
 * docs/povray.md lists as a difference is not drawn; the places say so.
 */
#ifndef LANGUAGE_SCENE_H
#define LANGUAGE_SCENE_H

#include <stdint.h>

/* Pictures that they are made for. */
enum { LANGUAGE_WIDTH = 40, LANGUAGE_HEIGHT = 30 };

/* What they show by image_map is in a file of this name, beside them. */
#define LANGUAGE_IMAGE "language_image.ppm"
extern const char language_image[];

/* The caller frees it. */
char *language_scene_text(uint64_t seed);

#endif
