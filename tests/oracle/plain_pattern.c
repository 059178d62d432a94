/* plain_pattern.c - the values of POV-Ray's patterns at points (plain_light.h). */
#include "tests/oracle/plain_light.h"

#include <math.h>
#include <stdbool.h>

/* The period of the frequency in POV-Ray, which is not 1. */
#define ROUND 1.00001
/* Bricks and cubes are shifted by this distance. */
#define EARLIER 1e-10

static double half_turn(void)
{
    return acos(-1);
}

static double within(double distance)
{
    return fmax(0, 1 - distance);
}

static double gradient(const struct pigment *pigment, const double point[3])
{
    double along = 0;
    for (int i = 0; i < 3; i++)
        along += point[i] * pigment->axis[i];
    return along > 1 ? fmod(along, 1) : along;
}

/* Returns true if a point is in a joint between bricks of this length. */
static bool in_joint(double at, double length, double mortar)
{
    double part = at / length;
    return part - floor(part) <= mortar / length;
}

/* Courses are layered along y. In every second course the joints along x are above the
 * middles of bricks; in the other courses the joints along z are. */
static double brick(const struct pattern *pattern, const double point[3])
{
    const double *size = pattern->own.brick_size;
    double m = pattern->own.mortar, more = m + EARLIER;
    double course = (point[1] + more) / (2 * size[1]);
    bool first = course - floor(course) <= .5;
    return !in_joint(point[1] + more, size[1], m)
           && !in_joint(point[0] + more + (first ? 0 : size[0] / 2), size[0], m)
           && !in_joint(point[2] + more + (first ? size[2] / 2 : 0), size[2], m);
}

/* Returns the number of the nearest centre of a hexagon. */
static double hexagon(const double point[3])
{
    double column = floor(point[0] / 1.5), best = INFINITY, number = 0;
    for (double k = column - 1; k <= column + 2; k++) {
        double row = floor(point[2] / sqrt(3) - k / 2);
        for (double a = row - 1; a <= row + 2; a++) {
            double away = hypot(point[0] - 1.5 * k, point[2] - sqrt(3) * (a + k / 2));
            if (away < best) {
                best = away;
                number = a - k;
            }
        }
    }
    return number - 3 * floor(number / 3);
}

static double value_at(const struct pigment *pigment, const double point[3])
{
    double x = point[0], y = point[1], z = point[2];
    double far = sqrt(x * x + y * y + z * z), turn = 2 * half_turn();
#define PATTERN(KIND, name, words, value, ...) \
    if (pigment->pattern.function == PATTERN_##KIND) \
        return value;
#include "rt/scene/patterns.def"
    return NAN;
}

static double in_wave(const struct pattern *pattern, double at)
{
    switch (pattern->wave) {
    case WAVE_TRIANGLE: return at > .5 ? 2 - 2 * at : 2 * at;
    case WAVE_SINE: return (1 + sin(2 * half_turn() * at)) / 2;
    case WAVE_SCALLOP: return fabs(sin(half_turn() * at));
    case WAVE_CUBIC: return at * at * (3 - 2 * at);
    case WAVE_POLY: return pow(at, pattern->exponent);
    default: return at;
    }
}

double plain_pattern(const struct pigment *pigment, const double point[3])
{
    const struct pattern *pattern = &pigment->pattern;
    double value = value_at(pigment, point);
    if (pattern->frequency != 0)
        value = fmod(pattern->frequency * value + pattern->phase, ROUND);
    if (value < 0)
        value -= floor(value);
    return in_wave(pattern, value);
}
