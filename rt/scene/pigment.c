/* pigment.c - properties of pigments, and the colours of their lists. */
#include "rt/scene/scene.h"

#include <math.h>

#include "rt/scene/elementary.h"
#include "rt/scene/vector3.h"

#define ROUND 1.00001 /* the frequency has this period in POV-Ray, not exactly 1 */

const struct pattern_rule pattern_rules[PATTERN_FUNCTIONS] = {
#define PATTERN(KIND, name, pigment, value, ...) \
    { .routine = "pattern_" #name, __VA_ARGS__ },
#include "rt/scene/patterns.def"
};

bool pigment_has_map(const struct pigment *pigment)
{
    return pigment->kind == PIGMENT_GRADIENT || pigment->kind == PIGMENT_PATTERN;
}

/* Only planar and cylindrical maps leave points outside, because spherical and toroidal
 * maps cover the whole image. */
bool image_is_bounded(const struct image_map *map)
{
    return map->once
           && (map->mapping == IMAGE_PLANAR || map->mapping == IMAGE_CYLINDRICAL);
}

int pigment_cells(const struct pigment *pigment)
{
    return pigment->kind == PIGMENT_CHECKER
                   || (pigment->kind == PIGMENT_IMAGE
                       && image_is_bounded(&pigment->image))
               ? 2
               : 1;
}

bool pigment_makes_sky(const struct pigment *pigment)
{
    return pigment_has_map(pigment) || pigment->kind == PIGMENT_IMAGE;
}

bool pigment_is_clear(const struct pigment *pigment)
{
    for (int i = 0; i < pigment_cells(pigment); i++)
        if (pigment->filter[i] != 0 || pigment->transmit[i] != 0)
            return true;
    return false;
}

size_t pigment_list_count(const struct pigment *pigment)
{
    if (pigment->kind == PIGMENT_CHECKER)
        return pattern_rules[PATTERN_CHECKER].listed;
    if (pigment->kind != PIGMENT_PATTERN)
        return 0;
    return pattern_rules[pigment->pattern.function].listed;
}

/* Applies the wave function. rt/kernels/light/pattern.s has the same formulas. */
static double in_wave(const struct pattern *pattern, double value)
{
    if (pattern->frequency != 0)
        value = fmod(pattern->frequency * value + pattern->phase, ROUND);
    if (value < 0)
        value -= floor(value);
    switch (pattern->wave) {
    case WAVE_TRIANGLE: return value > .5 ? 2 - 2 * value : 2 * value;
    case WAVE_SINE: return (1 + elementary_sin(2 * PI * value)) / 2;
    case WAVE_SCALLOP: return fabs(elementary_sin(PI * value));
    case WAVE_CUBIC: return value * value * (3 - 2 * value);
    case WAVE_POLY: return elementary_pow(value, pattern->exponent);
    default: return value;
    }
}

static double between(double a, double b, double share)
{
    return (1 - share) * a + share * b;
}

static struct color_stop map_at(const struct color_map *map, double value)
{
    const struct color_stop *above = map->stops, *below;
    const struct color_stop *end = map->stops + map->count;
    struct color_stop stop = { .at = value };
    double share;
    while (above < end && above->at <= value)
        above++;
    below = above > map->stops ? above - 1 : above;
    if (above == end)
        above = below;
    share = above > below ? (value - below->at) / (above->at - below->at) : 0;
    for (int i = 0; i < 3; i++)
        stop.color[i] = between(below->color[i], above->color[i], share);
    stop.filter = between(below->filter, above->filter, share);
    stop.transmit = between(below->transmit, above->transmit, share);
    return stop;
}

double pigment_list_value(const struct pigment *pigment, size_t i)
{
    return in_wave(&pigment->pattern, (double)i);
}

struct color_stop pigment_listed(const struct pigment *pigment, size_t i)
{
    return map_at(&pigment->map, pigment_list_value(pigment, i));
}
