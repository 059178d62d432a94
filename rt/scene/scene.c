/* scene.c - frees a scene. */
#include "rt/scene/scene.h"

#include <stdlib.h>

void scene_free(struct scene *scene)
{
    if (!scene)
        return;
    free(scene->lights);
    free(scene->primitives);
    free(scene->nodes);
    free(scene->regions);
    arena_free(&scene->kept);
    free(scene);
}
