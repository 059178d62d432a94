/* lens.c - distributes points over a camera's lens, one for each ray of a pixel.
 *
 * A square of samples x samples cells covers the lens. The centre of cell i, j is
 *
 *     a = (2 i + 1)/samples - 1,   b = (2 j + 1)/samples - 1
 *
 * It is mapped to a point of the unit disk. The point has the radius a and the angle
 * pi/4 b/a if |a| > |b|, else the radius b and the angle pi/2 - pi/4 a/b. This map
 * preserves areas (Shirley and Chiu, "A Low Distortion Map Between Disk and Square",
 * 1997).
 *
 * Neighbours in a pixel should be far apart on the lens, and each row and column of the
 * pixel should cover all of it. The ray in row r and column c has the cell
 *
 *     i = r + c,   j = r + 2 c    (modulo samples),
 *
 * which is Arnold's cat map. It uses every cell once. All pixels have the same points.
 * This avoids noise, but a lens with few points looks like several superimposed
 * pictures.
 */
#include "rt/layout/lens.h"

#include "rt/scene/elementary.h"
#include "rt/scene/vector3.h"

/* Maps the point (a, b) of the square [-1, 1] x [-1, 1] to the unit disk. */
static void disk_point(double a, double b, double point[2])
{
    bool by_a = fabs(a) > fabs(b);
    double radius = by_a ? a : b;
    double angle = by_a ? PI / 4 * (b / a) : b != 0 ? PI / 2 - PI / 4 * (a / b) : 0;
    point[0] = radius * elementary_cos(angle);
    point[1] = radius * elementary_sin(angle);
}

/* Computes two vectors with the length of the lens radius, perpendicular to the
 * direction and to each other. */
static void lens_axes(const struct camera *camera, double x[3], double y[3])
{
    double ahead[3];
    copy3(camera->direction, ahead);
    scale3(1 / length3(ahead), ahead);
    cross3(ahead, camera->right, y);
    scale3(1 / length3(y), y);
    cross3(y, ahead, x);
    scale3(camera->lens_radius, x);
    scale3(camera->lens_radius, y);
}

static double middle(size_t cell, size_t samples)
{
    return (double)(2 * (cell % samples) + 1) / (double)samples - 1;
}

void layout_lens(struct record_layout *layout, const struct camera *camera,
                 size_t samples)
{
    size_t count = samples * samples;
    uint64_t address = layout_reserve(layout, 3 * count);
    double x[3], y[3], point[2];
    lens_axes(camera, x, y);
    for (size_t i = 0; i < count; i++) {
        size_t row = i / samples, column = i % samples;
        disk_point(middle(row + column, samples), middle(row + 2 * column, samples),
                   point);
        for (size_t axis = 0; axis < 3; axis++) {
            c205_word word = c205_from_double(x[axis] * point[0] + y[axis] * point[1]);
            layout_words(layout, address + 64 * (axis * count + i), &word, 1);
        }
    }
    layout_word(layout, "scene_lens", address);
    layout_word(layout, "scene_focus", c205_from_double(camera->focal_distance));
}
