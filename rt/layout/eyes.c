#include "rt/layout/eyes.h"

#include "rt/layout/lights.h"
#include "rt/scene/vector.h"

static void add(struct eyes *eyes, const double place[3])
{
    if (eyes->count < EYES_MOST)
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
