#include "rt/layout/eyes.h"

#include <string.h>

#include "rt/layout/lights.h"
#include "rt/scene/vector.h"

static bool is_there(const struct eyes *eyes, const double place[3])
{
    for (size_t i = 0; i < eyes->count; i++)
        if (memcmp(eyes->places[i], place, sizeof eyes->places[i]) == 0)
            return true;
    return false;
}

static void add(struct eyes *eyes, const double place[3])
{
    if (eyes->count < MAX_EYES && !is_there(eyes, place))
        copy3(place, eyes->places[eyes->count++]);
}

void eyes_find(const struct scene *scene, struct eyes *eyes)
{
    eyes->count = 0;
    if (!scene->camera.orthographic && scene->camera.lens_radius == 0)
        add(eyes, scene->camera.location);
    for (size_t i = 0; i < scene->light_count; i++)
        if (light_shadows_from_point(&scene->lights[i]))
            add(eyes, scene->lights[i].position);
}
