/* plain_image.c - image maps by POV-Ray's rules (plain_light.h). */
#include "tests/oracle/plain_light.h"

#include <math.h>

/* POV-Ray shifts images by this distance. */
#define EARLIER 1e-10

/* Returns the angle from a to b as a fraction of a turn. */
static double turn(double a, double b)
{
    double share = atan2(b, a) / (2 * acos(-1));
    return share < 0 ? share + 1 : share;
}

/* Computes the image coordinates: u from 0 to 1 over its width, and v upwards. */
static void place_of(const struct image_map *map, const double point[3], double *u,
                     double *v)
{
    double x = point[0], y = point[1], z = point[2];
    *u = map->mapping == IMAGE_PLANAR ? x : turn(x, z);
    switch (map->mapping) {
    case IMAGE_SPHERICAL:
        *v = .5 + asin(y / sqrt(x * x + y * y + z * z)) / acos(-1);
        break;
    case IMAGE_TORUS: *v = turn(1 - hypot(x, z), -y); break;
    default: *v = y; break;
    }
}

static bool is_beyond(double share)
{
    return share + EARLIER < 0 || share + EARLIER >= 1;
}

bool plain_image_misses(const struct image_map *map, const double point[3])
{
    double u, v;
    if (!map->once)
        return false;
    place_of(map, point, &u, &v);
    return (map->mapping == IMAGE_PLANAR && (is_beyond(u) || is_beyond(v)))
           || (map->mapping == IMAGE_CYLINDRICAL && is_beyond(v));
}

/* Wraps an index to `count` columns or rows. If `once` is true, clamps it instead. */
static size_t within(double place, size_t count, bool once)
{
    double last = (double)count - 1;
    if (once)
        return (size_t)fmin(fmax(place, 0), last);
    return (size_t)fmin(place - floor(place / (double)count) * (double)count, last);
}

/* Returns the colour of a pixel by column and row, which may be out of range. */
static void pixel_at(const struct image_map *map, double column, double row,
                     double color[3])
{
    const struct image_table *table = map->table;
    size_t x = within(column, table->width, map->once);
    size_t y = within(row, table->height, map->once);
    for (size_t i = 0; i < 3; i++)
        color[i] = table->light[table->samples[3 * (y * table->width + x) + i]];
}

/* Returns the weight of a pixel whose centre is at this offset, in pixels. */
static double weight_of(enum image_sampling sampling, double along, double across)
{
    if (sampling == IMAGE_BY_DISTANCE)
        return 1 / fmax(along * along + across * across, 1e-12);
    return (1 - fabs(along)) * (1 - fabs(across));
}

/* Interpolates between the pixels whose centres surround the position. */
static void between_pixels(const struct image_map *map, double column, double row,
                           double color[3])
{
    double left = floor(column - .5), top = floor(row - .5), sum = 0;
    for (int i = 0; i < 3; i++)
        color[i] = 0;
    for (double x = left; x <= left + 1; x++)
        for (double y = top; y <= top + 1; y++) {
            double weight = weight_of(map->sampling, column - .5 - x, row - .5 - y);
            double pixel[3];
            pixel_at(map, x, y, pixel);
            for (int i = 0; i < 3; i++)
                color[i] += weight * pixel[i];
            sum += weight;
        }
    for (int i = 0; i < 3; i++)
        color[i] /= sum;
}

void plain_image(const struct image_map *map, const double point[3], double color[3])
{
    double u, v;
    place_of(map, point, &u, &v);
    u += EARLIER;
    v += EARLIER;
    double column = (u - floor(u)) * (double)map->table->width;
    double row = (ceil(v) - v) * (double)map->table->height;
    if (map->sampling == IMAGE_NEAREST)
        pixel_at(map, floor(column), floor(row), color);
    else
        between_pixels(map, column, row, color);
}
