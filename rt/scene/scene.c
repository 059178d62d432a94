/* scene.c - frees a scene, and decides whether bumps change any normal. */
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

bool bumps_show(const struct bumps *bumps)
{
    const struct bump_list *list = bumps->list;
    return list && (list->bump.pattern.kind != PIGMENT_COLOR || list->average);
}
