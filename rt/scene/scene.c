#include "rt/scene/scene.h"

#include <stdlib.h>

bool pigment_has_map(const struct pigment *pigment)
{
    return pigment->kind == PIGMENT_GRADIENT
           || pigment->kind == PIGMENT_PATTERN;
}

bool pigment_is_clear(const struct pigment *pigment)
{
    int colors = pigment->kind == PIGMENT_CHECKER ? 2 : 1;

    for (int i = 0; i < colors; i++)
        if (pigment->filter[i] != 0 || pigment->transmit[i] != 0)
            return true;
    return false;
}

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
