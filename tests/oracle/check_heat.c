/* check_heat.c - compares two independent methods for the view factors of random
 * scenes.
 *
 *     check_heat [SCENES [OF SHARE]] [--first]
 *
 * A few solids (placed_solid.h) exchange radiation. The test checks these rules:
 *
 * - Rays from points of the surfaces and lines through the scene give the same areas
 *   and factors, within the errors that both report.
 * - With lines, reciprocity is exact. With rays, each row sums to 1.
 * - The other modes, with another queue length, equal the vector form bit for bit.
 * - Smoothed factors are reciprocal, and each of their rows sums to 1.
 *
 * If a scene fails, it is printed and written to heat_N.pov.
 */
#include "rt/heat/heat.h"
#include "rt/heat/heat_source.h"
#include "tests/oracle/chance.h"
#include "tests/oracle/many_scenes.h"
#include "tests/oracle/placed_solid.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 16, SIGMAS = 8 };

static size_t pair_count; /* factors that both methods computed */

static struct heat_request usual(void)
{
    return (struct heat_request){ .mode = TRACE_VECTOR,
                                  .queue = 2000,
                                  .by = BY_PART,
                                  .drawn = 128,
                                  .repeats = REPEATS,
                                  .lattice = true,
                                  .seed = 1,
                                  .model = check_model };
}

/* ---- Scenes -------------------------------------------------------------- */

/* Returns true for a closed shape. Lines see a surface without an inside from both
 * sides, but rays leave it only from one side. */
static bool is_closed(const char *text)
{
    static const char *const words[] = {
        "open", "height_field", "disc", "steiner_patch", "clipped_by", "lathe { 3,"
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(text, words[i]))
            return false;
    return !strstr(text, "mesh") || strstr(text, "inside_vector");
}

/* Returns the text of a closed solid. The caller frees it. */
static char *closed_solid(uint64_t *state, const struct place *place)
{
    for (;;) {
        struct solid *solid = solid_at(state, place, DULL, (int)below(state, 3));
        char *text;
        FILE *file = test_text(&text);
        solid_print(solid, file);
        fclose(file);
        solid_free(solid);
        if (is_closed(text))
            return text;
        free(text);
    }
}

static struct random_scene draw(uint64_t *state, size_t number UNUSED)
{
    char *text;
    FILE *file = test_text(&text);
    size_t count = 2 + below(state, 2);
    for (size_t i = 0; i < count; i++) {
        struct place place = { .size = between(state, .5, 1) };
        for (int k = 0; k < 3; k++)
            place.at[k] = between(state, -1.5, 1.5);
        FREED char *solid = closed_solid(state, &place);
        fprintf(file, "#declare Part%zu = object {\n%s}\nobject { Part%zu }\n", i,
                solid, i);
    }
    fclose(file);
    return (struct random_scene){ .text = text };
}

/* ---- Comparisons --------------------------------------------------------- */

static bool differs(double a, double a_error, double b, double b_error, double least)
{
    return !(fabs(a - b) <= SIGMAS * hypot(a_error, b_error) + least);
}

/* Returns the error of a factor. With few rays the spread of the repeats may be 0, so
 * one ray with another receiver is the least error. */
static double error_of(const struct surface *surface, size_t to)
{
    return hypot(surface->factor[to].error, 1 / (double)surface->sent);
}

static bool same_factors(const struct heat *rays, const struct heat *lines, size_t from,
                         char *reason)
{
    const struct surface *one = &rays->surfaces.list[from];
    const struct surface *other = &lines->surfaces.list[from];
    for (size_t to = 0; to <= rays->surfaces.count; to++) {
        if (one->sent == 0 || other->sent == 0)
            continue;
        pair_count++;
        if (differs(one->factor[to].value, error_of(one, to), other->factor[to].value,
                    error_of(other, to), 0)) {
            snprintf(reason, MANY_REASON,
                     "from %s to %s: %.6g +- %.2g by rays, %.6g +- %.2g by lines",
                     one->name, heat_receiver(rays, to), one->factor[to].value,
                     error_of(one, to), other->factor[to].value, error_of(other, to));
            return false;
        }
    }
    return true;
}

static bool same_areas(const struct surface *one, const struct surface *other,
                       double largest, char *reason)
{
    double single = largest / (double)(1 + other->sent); /* area that one line
                                                          * represents */
    if (!differs(one->area.value, one->area.error, other->area.value,
                 hypot(other->area.error, single), 1e-4 * largest))
        return true;
    snprintf(reason, MANY_REASON, "%s: the area is %.6g +- %.2g or %.6g +- %.2g",
             one->name, one->area.value, one->area.error, other->area.value,
             other->area.error);
    return false;
}

static bool keeps_rules(const struct heat *heat, char *reason)
{
    const struct surfaces *surfaces = &heat->surfaces;
    for (size_t i = 0; i < surfaces->count; i++) {
        const struct surface *surface = &surfaces->list[i];
        double sum = 0, smooth = 0;
        for (size_t j = 0; surface->sent > 0 && j <= surfaces->count; j++) {
            sum += surface->factor[j].value;
            smooth += surface_factor(surface, j);
        }
        if (surface->sent > 0
            && (fabs(sum - 1) > 1e-11
                || (surface->smooth && fabs(smooth - 1) > 1e-10))) {
            snprintf(reason, MANY_REASON, "the factors of %s are %.15g in all",
                     surface->name, fabs(sum - 1) > 1e-11 ? sum : smooth);
            return false;
        }
        for (size_t j = 0; surface->smooth && j < i; j++) {
            const struct surface *other = &surfaces->list[j];
            double there = surface->area.value * surface_factor(surface, j);
            double back = other->area.value * surface_factor(other, i);
            if (fabs(there - back) > 1e-10 * surface->area.value) {
                snprintf(reason, MANY_REASON, "smoothed, %s and %s differ",
                         surface->name, other->name);
                return false;
            }
        }
    }
    return true;
}

static bool find(const struct scene *scene, const struct heat_request *request,
                 struct heat *heat, c205_error *error)
{
    return heat_begin(scene, request, heat, error) && heat_find(heat, error);
}

/* Compares with another mode, queue length and number of jobs, for fewer points. */
static bool same_stages(const struct scene *scene, struct heat_request request,
                        uint64_t *state, char *reason)
{
    struct heat vector, other;
    c205_error error = { "" };
    request.drawn /= 8;
    bool there = find(scene, &request, &vector, &error);
    request.mode = one_in(state, 2) ? TRACE_SCALAR : TRACE_KERNELS;
    request.queue = 1 + below(state, 40);
    request.jobs = 2;
    bool good = find(scene, &request, &other, &error) == there
                && (!there || heat_is_same(&vector, &other));
    if (!good)
        snprintf(reason, MANY_REASON, "%s finds others than vector, by %s",
                 trace_mode_name(request.mode), request.by_lines ? "lines" : "rays");
    heat_free(&vector);
    heat_free(&other);
    return good;
}

static bool same_ways(const struct heat *rays, const struct heat *lines, char *reason)
{
    double largest = 0;
    for (size_t i = 0; i < rays->surfaces.count; i++)
        largest = fmax(largest, lines->surfaces.list[i].area.value);
    for (size_t i = 0; i < rays->surfaces.count; i++) {
        const struct surface *one = &rays->surfaces.list[i];
        if (!one->receives_alone
            && (!same_areas(one, &lines->surfaces.list[i], largest, reason)
                || !same_factors(rays, lines, i, reason)))
            return false;
    }
    return true;
}

static bool emits_all(const struct scene *scene)
{
    const char **refusals = source_refusals(scene);
    bool all = refusals;
    for (size_t i = 0; all && i < scene->primitive_count; i++)
        all = !refusals[i];
    free(refusals);
    return all;
}

static bool passes_as(const struct scene *scene, uint64_t *state, char *reason)
{
    struct heat_request by_rays = usual(), by_lines = usual();
    struct heat rays, lines;
    c205_error error = { "" };
    by_lines.by_lines = true;
    by_lines.drawn = 1024;
    by_rays.smooth = emits_all(scene);
    bool found = find(scene, &by_lines, &lines, &error);
    if (!found && strstr(error.message, "has unknown bounds")) {
        heat_free(&lines);
        return true;
    }
    bool good = found && find(scene, &by_rays, &rays, &error);
    if (!good && strstr(error.message, "no surface is visible")) {
        by_rays.smooth = false;
        heat_free(&rays);
        good = find(scene, &by_rays, &rays, &error);
    }
    snprintf(reason, MANY_REASON, "%.250s", error.message);
    good = good && same_ways(&rays, &lines, reason) && keeps_rules(&rays, reason)
           && keeps_rules(&lines, reason) && same_stages(scene, by_rays, state, reason)
           && same_stages(scene, by_lines, state, reason);
    if (found)
        heat_free(&rays);
    heat_free(&lines);
    return good;
}

static bool passes(struct random_scene *random, char *reason)
{
    SCOPED(scene) *scene = scene_of(random->text);
    return passes_as(scene, &random->state, reason);
}

int main(int count, char **words)
{
    static const struct random_check check = {
        "heat", UINT64_C(0xA0761D6478BD642F), draw, passes, false, NULL, 0
    };
    int code = check_random(count, words, &check);
    printf("%zu factors were found by both\n", pair_count);
    return code;
}
