/* plain_camera.c - camera rays, and points on the lens (plain_light.h). */
#include "tests/oracle/plain_light.h"

#include "rt/scene/vector3.h"

size_t plain_samples(const struct camera *camera)
{
    if (camera->lens_radius == 0 || camera->lens_points < 2)
        return 1;
    return (size_t)ceil(sqrt(camera->lens_points));
}

/* Divides the interval from -1 to 1 into `cells` cells. Returns a cell's centre. */
static double in_cell(size_t number, size_t cells)
{
    return ((double)(number % cells) + .5) * 2 / (double)cells - 1;
}

/* Maps the square from -1 to 1 to the unit disk. Concentric squares become circles, and
 * each side of a square becomes a quarter of its circle. */
static void to_disk(double a, double b, double *x, double *y)
{
    double radius = fmax(fabs(a), fabs(b)), angle = 0;
    if (fabs(a) > fabs(b))
        angle = PI / 4 * b / a + (a < 0 ? PI : 0);
    else if (b != 0)
        angle = PI / 2 - PI / 4 * a / b + (b < 0 ? PI : 0);
    *x = radius * cos(angle);
    *y = radius * sin(angle);
}

/* Moves the origin of a ray to a point of the lens, and directs it to the focal point
 * of the ray through the centre of the lens. rt/layout/lens.c defines the points. */
static void leave_lens(const struct camera *camera, size_t row, size_t column,
                       struct ray *ray)
{
    size_t cells = plain_samples(camera);
    double focus = camera->focal_distance, length = length3(camera->direction);
    double across[3], upward[3], x, y;
    cross3(camera->direction, camera->right, upward);
    cross3(upward, camera->direction, across);
    to_disk(in_cell(row + column, cells), in_cell(row + 2 * column, cells), &x, &y);
    x *= camera->lens_radius / length3(across);
    y *= camera->lens_radius / length3(upward);
    for (int i = 0; i < 3; i++) {
        double sharp = ray->origin[i] + focus / length * ray->direction[i];
        ray->origin[i] += x * across[i] + y * upward[i];
        ray->direction[i] = sharp - ray->origin[i];
    }
}

struct ray plain_camera_ray(const struct camera *camera, size_t width, size_t height,
                            size_t x, size_t y)
{
    double u = ((double)x + .5) / (double)width - .5;
    double v = .5 - ((double)y + .5) / (double)height;
    struct ray ray;
    for (int i = 0; i < 3; i++) {
        double across = u * camera->right[i] + v * camera->up[i];
        ray.origin[i] = camera->location[i] + (camera->orthographic ? across : 0);
        ray.direction[i] = camera->direction[i] + (camera->orthographic ? 0 : across);
    }
    if (plain_samples(camera) > 1)
        leave_lens(camera, y, x, &ray);
    scale3(1 / length3(ray.direction), ray.direction);
    return ray;
}
