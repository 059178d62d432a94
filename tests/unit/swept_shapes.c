/* swept_shapes.c - writes random prisms and lathes. */
#include "swept_shapes.h"

/* ---- Prisms -------------------------------------------------------------- */

/* Adds a loop around a point with increasing angles, so that it is simple. */
static size_t add_prism_loop(char *text, size_t size, double x, double z, double reach)
{
    size_t corners = 3 + below(8);
    for (size_t i = 0; i <= corners; i++) {
        static double first[2];
        double angle = 2 * acos(-1) * ((double)i + between(-.3, .3)) / (double)corners;
        double radius = reach * between(.3, 1);
        double point[2] = { x + radius * cos(angle), z + radius * sin(angle) };
        if (i == 0)
            memcpy(first, point, sizeof first);
        if (i == corners)
            memcpy(point, first, sizeof first);
        add_text(text, size, ", <%.6f, %.6f>", point[0], point[1]);
    }
    return corners + 1;
}

/* Adds at least `least` corners at random positions, from x = low to 1. */
static size_t add_tangle(char *text, size_t size, size_t least, double low)
{
    size_t corners = least + below(9);
    for (size_t i = 0; i < corners; i++)
        add_text(text, size, ", <%.6f, %.6f>", between(low, 1), between(-1, 1));
    return corners;
}

/* Adds a comb, in which a ray can have more than three segments. */
static size_t add_prism_comb(char *text, size_t size)
{
    size_t teeth = 2 + below(10);
    double step = 2. / (double)teeth, depth = between(-.4, .6);
    add_text(text, size, ", <-1, -.7>");
    for (size_t i = 0; i < teeth; i++) {
        double x = -1 + step * (double)i;
        add_text(text, size, ", <%.6f, .7>, <%.6f, .7>, <%.6f, %.6f>, <%.6f, %.6f>", x,
                 x + .5 * step, x + .6 * step, -depth, x + step, -depth);
    }
    add_text(text, size, ", <1, -.7>");
    return 4 * teeth + 2;
}

void add_prism(char *text, size_t size, bool tangles)
{
    char path[4000] = "";
    size_t count = 0, sort = below(3 + tangles);
    if (sort == 3)
        count = add_tangle(path, sizeof path, 3, -1);
    else if (sort == 2)
        count = add_prism_comb(path, sizeof path);
    else
        for (size_t loops = 1 + below(3); loops > 0; loops--)
            count += add_prism_loop(path, sizeof path, between(-.4, .4),
                                    between(-.4, .4), between(.3, 1));
    add_text(text, size, "prism { %s%.4f, %.4f, %zu%s %s ",
             below(2) ? "linear_sweep " : "", between(-.8, -.1), between(.1, .8), count,
             path, below(4) ? "" : "open");
}

/* ---- Prisms of quadratic splines ----------------------------------------- */

enum { MAX_CORNERS = 9 };

/* Writes the corners, the last one also first, as a smooth closed spline needs. */
static size_t add_spline_corners(char *text, size_t size,
                                 double corners[MAX_CORNERS][2], size_t count)
{
    add_text(text, size, ", <%.6f, %.6f>", corners[count - 1][0],
             corners[count - 1][1]);
    for (size_t i = 0; i <= count; i++)
        add_text(text, size, ", <%.6f, %.6f>", corners[i % count][0],
                 corners[i % count][1]);
    return count + 2;
}

/* Adds a spline loop around a point. In some loops the last corner is repeated, or is
 * on the line to the first corner. */
static size_t add_spline_loop(char *text, size_t size, double x, double z, double reach)
{
    double corners[MAX_CORNERS][2];
    size_t count = 3 + below(5);
    for (size_t i = 0; i < count; i++) {
        double angle = 2 * acos(-1) * ((double)i + between(-.3, .3)) / (double)count;
        double radius = reach * between(.4, 1);
        corners[i][0] = x + radius * cos(angle);
        corners[i][1] = z + radius * sin(angle);
    }
    if (below(4) == 0) {
        memcpy(corners[count], corners[count - 1], sizeof *corners);
        count++;
    }
    if (below(4) == 0) {
        for (int k = 0; k < 2; k++)
            corners[count][k] = .3 * corners[count - 1][k] + .7 * corners[0][k];
        count++;
    }
    return add_spline_corners(text, size, corners, count);
}

/* Adds a spline with corners at random positions. */
static size_t add_spline_tangle(char *text, size_t size)
{
    double corners[MAX_CORNERS][2];
    size_t count = 3 + below(MAX_CORNERS - 2);
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            corners[i][k] = between(-1, 1);
    return add_spline_corners(text, size, corners, count);
}

void add_quadratic_prism(char *text, size_t size, bool tangles)
{
    char path[4000] = "";
    size_t count = 0;
    if (tangles && below(4) == 0)
        for (size_t loops = 1 + below(2); loops > 0; loops--)
            count += add_spline_tangle(path, sizeof path);
    else
        for (size_t loops = 1 + below(3); loops > 0; loops--)
            count += add_spline_loop(path, sizeof path, between(-.4, .4),
                                     between(-.4, .4), between(.3, 1));
    add_text(text, size, "prism { quadratic_spline %s%.4f, %.4f, %zu%s %s ",
             below(2) ? "linear_sweep " : "", between(-.8, -.1), between(.1, .8), count,
             path, below(4) ? "" : "open");
}

/* ---- Lathes -------------------------------------------------------------- */

/* Adds a profile that rises or is level. Each end is on the axis or open. */
static size_t add_lathe_profile(char *text, size_t size)
{
    size_t corners = 2 + below(9), count = corners;
    double height = -1, radius = between(.1, 1);
    bool level = below(3) > 0;
    if (level) {
        add_text(text, size, ", <0, %.4f>", height);
        count++;
    }
    for (size_t i = 0; i < corners; i++) {
        add_text(text, size, ", <%.4f, %.4f>", radius, height);
        level = !level && below(4) == 0;
        height += level ? 0 : between(.05, 2. / (double)corners);
        radius = level || below(4) ? between(.05, 1) : radius;
    }
    if (below(3)) {
        add_text(text, size, ", <0, %.4f>", height - between(0, .3));
        count++;
    }
    return count;
}

/* Adds a loop that may touch the axis and may be closed. */
static size_t add_lathe_loop(char *text, size_t size)
{
    size_t corners = 3 + below(6);
    double first[2] = { 0, 0 };
    bool closed = below(4) > 0;
    for (size_t i = 0; i < corners; i++) {
        double turn = 2 * acos(-1) * ((double)i + between(-.3, .3)) / (double)corners;
        double reach = between(.2, .5);
        double point[2] = { fmax(0, .45 + reach * cos(turn)), 1.6 * reach * sin(turn) };
        if (i == 0)
            memcpy(first, point, sizeof first);
        add_text(text, size, ", <%.6f, %.6f>", point[0], point[1]);
    }
    if (closed)
        add_text(text, size, ", <%.6f, %.6f>", first[0], first[1]);
    return corners + closed;
}

void add_lathe(char *text, size_t size, bool tangles)
{
    char path[2000] = "";
    size_t sort = below(3 + tangles);
    size_t count = sort == 3   ? add_tangle(path, sizeof path, 2, 0)
                   : sort == 2 ? add_lathe_loop(path, sizeof path)
                               : add_lathe_profile(path, sizeof path);
    add_text(text, size, "lathe { %s%zu%s ", below(2) ? "linear_spline " : "", count,
             path);
}
