/* surface.c - computes the fractions of light that a surface transmits and reflects. */
#include "rt/layout/surface.h"

#include <math.h>

#include "rt/shapes/primitive.h"

double greatest_of(const double color[3])
{
    return fmax(fabs(color[0]), fmax(fabs(color[1]), fabs(color[2])));
}

static bool is_black(const double color[3])
{
    return color[0] == 0 && color[1] == 0 && color[2] == 0;
}

bool surface_is_mirror(const struct finish *finish)
{
    return !is_black(finish->reflection) || !is_black(finish->reflection_most);
}

enum mirror_kind surface_mirror_kind(const struct finish *finish)
{
    bool varies = finish->reflection_metallic != 0;
    if (!surface_is_mirror(finish))
        return MIRROR_CONSTANT;
    if (finish->fresnel)
        return MIRROR_FRESNEL;
    for (int i = 0; i < 3; i++)
        varies = varies || finish->reflection[i] != finish->reflection_most[i];
    return varies ? MIRROR_POWER : MIRROR_CONSTANT;
}

static bool is_glossy(const struct finish *finish)
{
    bool gleams = finish->phong != 0 || finish->specular != 0;
    return (finish->brilliance != 1 && finish->diffuse != 0)
           || (finish->metallic != 0 && gleams)
           || surface_mirror_kind(finish) != MIRROR_CONSTANT;
}

bool scene_is_glossy(const struct scene *scene)
{
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (is_glossy(&scene->primitives[i].finish))
            return true;
    return false;
}

void surface_passing(const struct pigment *pigment, int which, double passing[3])
{
    for (int i = 0; i < 3; i++)
        passing[i] = pigment->filter[which] * pigment->color[which][i]
                     + pigment->transmit[which];
}

/* Returns the largest channel of the transmitted light, or -1 if its brightness is not
 * above `least`. As in POV-Ray, a ray with less brightness is not traced, even if its
 * largest channel exceeds `least`. */
double surface_passing_weight(const double passing[3], double least)
{
    double brightness = .297 * passing[0] + .589 * passing[1] + .114 * passing[2];
    return brightness > least ? greatest_of(passing) : -1;
}

double surface_opacity(const struct pigment *pigment, int which)
{
    return 1 - pigment->filter[which] - pigment->transmit[which];
}

bool surface_is_metal(const struct pigment *pigment, const struct finish *finish)
{
    bool one = pigment_cells(pigment) == 1
               || surface_opacity(pigment, 0) == surface_opacity(pigment, 1);
    return one && (finish->metallic != 0 || finish->reflection_metallic != 0);
}

void surface_color(const struct pigment *pigment, int which, double color[3])
{
    double share = surface_opacity(pigment, which);
    for (int i = 0; i < 3; i++)
        color[i] = share * pigment->color[which][i];
}
