/* check_mass.c - compares the mass properties of random solids with transformed copies,
 * and with counts of points.
 *
 *     check_mass [SCENES [OF SHARE]] [--first]
 *
 * Measures a solid (placed_solid.h) and a copy that is scaled, rotated and moved at
 * random by a matrix M. The test checks these rules:
 *
 * - The volume is multiplied by the determinant of M. The centroid is transformed. The
 *   second moments S become M S M^T times the determinant.
 * - The area is multiplied by the square of the scale, if the scale is uniform.
 * - A count of random points inside (plain_regions.h), in a larger box, gives the same
 *   volume and centroid.
 * - The scalar form and a vector form with another queue length are equal bit for bit.
 * - Solids without volume are rejected, before and after the transform.
 *
 * A failing scene is printed and written to mass_N.pov.
 */
#include "tests/oracle/chance.h"
#include "tests/oracle/many_scenes.h"
#include "tests/oracle/machine_mass.h"
#include "tests/oracle/placed_solid.h"
#include "tests/oracle/plain_regions.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#define STUDENT 2.1314 /* Student's t for 15 degrees of freedom */
enum { SIGMAS = 7 };

static struct columns_options usual(void)
{
    return (struct columns_options){ .mode = TRACE_VECTOR,
                                     .queue = 2000,
                                     .points = POINTS_LATTICE,
                                     .rays_log = 9,
                                     .repeats = 16,
                                     .seed = 1 };
}

/* ---- A solid and its transform ------------------------------------------- */

struct motion {
    double scale[3], turn[3], move[3];
    bool alike;        /* the scale is uniform */
    double rows[3][3]; /* combined matrix */
    double determinant;
};

/* Rotates about one axis. As in the scene language, the axes are left-handed. */
static void turn_rows(double rows[3][3], size_t axis, double degrees)
{
    double angle = degrees * acos(-1) / 180;
    size_t i = (axis + 1) % 3, k = (axis + 2) % 3;
    for (size_t column = 0; column < 3; column++) {
        double a = rows[i][column], b = rows[k][column];
        rows[i][column] = a * cos(angle) - b * sin(angle);
        rows[k][column] = a * sin(angle) + b * cos(angle);
    }
}

static struct motion random_motion(uint64_t *state)
{
    struct motion motion = { .alike = one_in(state, 2), .determinant = 1 };
    for (size_t i = 0; i < 3; i++) {
        motion.scale[i] = motion.alike && i > 0 ? motion.scale[0]
                                                : of_any_size(state, .3, 3);
        motion.rows[i][i] = motion.scale[i];
        motion.determinant *= motion.scale[i];
        motion.turn[i] = between(state, -180, 180);
        motion.move[i] = between(state, -5, 5);
    }
    for (size_t i = 0; i < 3; i++)
        turn_rows(motion.rows, i, motion.turn[i]);
    return motion;
}

static char *text_of(const struct solid *solid, const struct motion *motion)
{
    char *text;
    FILE *file = test_text(&text);
    fprintf(file, "object {\n");
    solid_print(solid, file);
    if (motion)
        fprintf(file,
                "scale <%.17g, %.17g, %.17g>\nrotate <%.17g, %.17g, %.17g>\n"
                "translate <%.17g, %.17g, %.17g>\n",
                motion->scale[0], motion->scale[1], motion->scale[2], motion->turn[0],
                motion->turn[1], motion->turn[2], motion->move[0], motion->move[1],
                motion->move[2]);
    fprintf(file, "}\n");
    fclose(file);
    return text;
}

/* ---- Comparisons --------------------------------------------------------- */

struct comparing {
    char *reason;
    bool good;
};

/* Compares figures within their errors. Rounding errors are relative to `scale`. */
static void compare(struct comparing *comparing, double a, double a_error, double b,
                    double b_error, double scale, const char *what)
{
    double most = SIGMAS / STUDENT * hypot(a_error, b_error) + 1e-4 * fabs(scale);
    if (comparing->good && !(fabs(a - b) <= most)) {
        snprintf(comparing->reason, MANY_REASON,
                 "%s: %.9g and %.9g, which may be %.2g apart", what, a, b, most);
        comparing->good = false;
    }
}

/* Computes the second moments from the central inertia tensor. Returns their size. */
static double second_moments(const double inertia[6], double second[3][3])
{
    double half = (inertia[0] + inertia[1] + inertia[2]) / 2;
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++)
            second[i][k] = i == k ? half - inertia[i] : -inertia[2 + i + k];
    return half;
}

static void compare_seconds(struct comparing *comparing, const struct mass_figures *one,
                            const struct mass_figures *other,
                            const struct motion *motion)
{
    double from[3][3], to[3][3], error[3][3];
    double size = second_moments(other->value + FIGURE_CENTRAL, to);
    second_moments(one->value + FIGURE_CENTRAL, from);
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++) {
            double moved = 0;
            error[i][k] = 0;
            for (size_t a = 0; a < 3; a++)
                for (size_t b = 0; b < 3; b++) {
                    double share = motion->rows[i][a] * motion->rows[k][b]
                                   * motion->determinant;
                    moved += share * from[a][b];
                    for (size_t j = 0; j < 6; j++)
                        error[i][k] += fabs(share) * one->error[FIGURE_CENTRAL + j] / 6;
                }
            for (size_t j = 0; j < 6; j++)
                error[i][k] += other->error[FIGURE_CENTRAL + j];
            compare(comparing, moved, error[i][k], to[i][k], 0, size, "second moments");
        }
}

static bool same_moved(const struct measured *one, const struct measured *other,
                       const struct motion *motion, char *reason)
{
    struct comparing comparing = { reason, true };
    const struct mass_figures *a = &one->part[0], *b = &other->part[0];
    double det = motion->determinant, size = motion->scale[0];
    compare(&comparing, a->value[FIGURE_VOLUME] * det, a->error[FIGURE_VOLUME] * det,
            b->value[FIGURE_VOLUME], b->error[FIGURE_VOLUME], b->value[FIGURE_VOLUME],
            "volumes");
    if (motion->alike)
        compare(&comparing, a->value[FIGURE_AREA] * size * size,
                a->error[FIGURE_AREA] * size * size, b->value[FIGURE_AREA],
                b->error[FIGURE_AREA], b->value[FIGURE_AREA], "areas");
    for (size_t i = 0; i < 3; i++) {
        double moved = motion->move[i], error = 0;
        for (size_t k = 0; k < 3; k++) {
            moved += motion->rows[i][k] * a->value[FIGURE_CENTROID + k];
            error += fabs(motion->rows[i][k]) * a->error[FIGURE_CENTROID + k];
        }
        compare(&comparing, moved, error, b->value[FIGURE_CENTROID + i],
                b->error[FIGURE_CENTROID + i], other->width[i], "centroids");
    }
    compare_seconds(&comparing, a, b, motion);
    return comparing.good;
}

/* Compares with a count of random points in a box that is a quarter larger. */
static bool same_plain(const char *text, const struct measured *measured,
                       uint64_t *state, char *reason)
{
    struct comparing comparing = { reason, true };
    SCOPED(scene) *scene = scene_of(text);
    const struct mass_figures *figures = &measured->part[0];
    double value[PLAIN_MASS_FIGURES], error[PLAIN_MASS_FIGURES], width[3];
    double volume = figures->value[FIGURE_VOLUME];
    for (size_t i = 0; i < 3; i++)
        width[i] = 1.25 * measured->width[i];
    plain_mass(scene, measured->middle, width, state, value, error);
    /* The sum equals the integral, because no bodies of an object overlap here. */
    compare(&comparing, volume, figures->error[FIGURE_VOLUME], value[0],
            STUDENT * error[0], volume, "volume, and points inside");
    for (size_t i = 0; i < 3; i++)
        compare(&comparing,
                volume * (figures->value[FIGURE_CENTROID + i] - measured->middle[i]),
                volume * figures->error[FIGURE_CENTROID + i]
                    + width[i] * figures->error[FIGURE_VOLUME],
                value[1 + i], STUDENT * error[1 + i], volume * width[i],
                "first moment, and points inside");
    return comparing.good;
}

static bool same_forms(const char *text, uint64_t *state, char *reason)
{
    struct columns_options options = usual();
    struct measured vector, other;
    options.rays_log = 4;
    options.repeats = 2;
    options.seed = below(state, 1000);
    options.points = (enum columns_points)below(state, POINTS_KINDS);
    options.queue = 1 + below(state, 20);
    bool good = measure_scene(text, options, &vector);
    options.mode = one_in(state, 2) ? TRACE_SCALAR : TRACE_KERNELS;
    good = measure_scene(text, options, &other) == good
           && (!good || other.checksum == vector.checksum);
    if (!good)
        snprintf(reason, MANY_REASON, "the forms differ");
    return good;
}

/* ---- Scenes -------------------------------------------------------------- */

static size_t measured_count;

static bool is_empty(const struct measured *measured, char *reason)
{
    bool empty = measured->part[0].value[FIGURE_VOLUME] == 0
                 && isnan(measured->part[0].value[FIGURE_CENTROID]);
    if (!empty)
        snprintf(reason, MANY_REASON, "of two one is empty");
    return empty;
}

static struct motion motion; /* transform of the second text */

static struct random_scene draw(uint64_t *state, size_t number UNUSED)
{
    const struct place place = { .at = { 0 }, .size = 1 };
    struct solid *solid = solid_at(state, &place, DULL, (int)below(state, 3));
    motion = random_motion(state);
    struct random_scene scene = { .text = text_of(solid, &motion),
                                  .other = text_of(solid, NULL) };
    solid_free(solid);
    return scene;
}

static bool passes(struct random_scene *scene, char *reason)
{
    struct measured one, other;
    bool there = measure_scene(scene->other, usual(), &one);
    if (measure_scene(scene->text, usual(), &other) != there) {
        snprintf(reason, MANY_REASON, "one is refused: %.150s",
                 there ? other.error.message : one.error.message);
        return false;
    }
    if (!there)
        return true;
    if (one.part[0].value[FIGURE_VOLUME] == 0)
        return is_empty(&other, reason);
    measured_count++;
    return same_moved(&one, &other, &motion, reason)
           && same_plain(scene->text, &other, &scene->state, reason)
           && same_forms(scene->text, &scene->state, reason);
}

int main(int count, char **words)
{
    static const struct random_check check = {
        "mass", UINT64_C(0xA0761D6478BD642F), draw, passes, false, NULL, 0
    };
    int code = check_random(count, words, &check);
    printf("%zu solids were measured\n", measured_count);
    return code;
}
