/* find_viewpoints.c - finds the points of a scene through which many rays pass. */
#include "rt/layout/find_viewpoints.h"

#include <string.h>

#include "rt/layout/lights.h"
#include "rt/scene/vector3.h"

static bool is_there(const struct viewpoints *viewpoints, const double place[3])
{
    for (size_t i = 0; i < viewpoints->count; i++)
        if (memcmp(viewpoints->places[i], place, sizeof viewpoints->places[i]) == 0)
            return true;
    return false;
}

static void add_viewpoint(struct viewpoints *viewpoints, const double place[3])
{
    if (viewpoints->count < MAX_VIEWPOINTS && !is_there(viewpoints, place))
        copy3(place, viewpoints->places[viewpoints->count++]);
}

void viewpoints_find(const struct scene *scene, struct viewpoints *viewpoints)
{
    viewpoints->count = 0;
    if (!scene->camera.orthographic && scene->camera.lens_radius == 0)
        add_viewpoint(viewpoints, scene->camera.location);
    for (size_t i = 0; i < scene->light_count; i++)
        if (light_shadows_from_point(&scene->lights[i]))
            add_viewpoint(viewpoints, scene->lights[i].position);
}
