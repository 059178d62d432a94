/* language_scene.h - generates random scenes as texts in the scene language.
 *
 * The texts contain declarations of every kind, expressions with every operator and
 * function, conditions, loops, macros and arrays. They also contain all shapes that
 * POV-Ray has, solids, clipped and bounded objects, transforms, textures, lights, fogs,
 * skies and cameras. They use everything that has the same meaning in both programs,
 * according to docs/scenes.md. Differences that docs/povray.md lists are avoided;
 * comments mark these places.
 */
#ifndef LANGUAGE_SCENE_H
#define LANGUAGE_SCENE_H

#include <stdint.h>

/* The size of the pictures for which the scenes are made. */
enum { LANGUAGE_WIDTH = 40, LANGUAGE_HEIGHT = 30 };

/* The image file of the image_map of the scenes, which is in the folder of the
 * scene. */
#define LANGUAGE_IMAGE "language_image.ppm"
extern const char language_image[];

/* Returns the text of a scene. The caller frees it. */
char *language_scene_text(uint64_t seed);

#endif
