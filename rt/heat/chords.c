/* chords.c - generates random lines through a sphere. Each line contains a ray that a
 * point of the sphere emits. */
#include "rt/heat/chords.h"

#include <math.h>

#include "rt/scene/elementary.h"
#include "rt/shapes/primitive.h"

bool chords_begin(struct chords *chords, const struct emission_options *emits,
                  c205_error *error)
{
    struct primitive sphere = { .kind = PRIMITIVE_SPHERE };
    for (int i = 0; i < 3; i++) {
        sphere.shape.sphere.center[i] = chords->center[i];
        sphere.to_world.rows[i][i] = sphere.to_local.rows[i][i] = 1;
    }
    sphere.shape.sphere.radius = chords->radius;
    chords->count = emits->points;
    chords->sphere = emission_new(&sphere, emits, error);
    return chords->sphere;
}

void chords_end(struct chords *chords)
{
    emission_free(chords->sphere);
    chords->sphere = NULL;
}

double chords_weight(const struct chords *chords)
{
    return 2 * elementary_acos(-1) * chords->radius * chords->radius;
}

bool chords_run(const struct chords *chords, const struct emission_choice *choice,
                c205_word *planes, struct scene_ray *lines, struct accounts *accounts,
                c205_error *error)
{
    size_t count = chords->count;
    if (!emission_run(chords->sphere, choice, planes, accounts, error))
        return false;
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < 3; k++) {
            lines[i].origin[k] = c205_to_double(
                planes[(EMITTED_POINT + k) * count + i]);
            lines[i].direction[k] = c205_to_double(
                planes[(EMITTED_RAY + k) * count + i]);
        }
    return true;
}
