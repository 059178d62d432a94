/* check_ray_query.c - compares all forms of the all-hits ray query on random scenes.
 *
 *     check_ray_query [SCENES [OF SHARE]] [--first]        (many_scenes.h)
 *
 * Follows lines through random scenes (random_scenes.h), which alternately have
 * coincident faces and many regions. The test checks these rules:
 *
 * - The scalar form and some random configurations of the vector form (queues, packets,
 *   bounds) find the same hits bit for bit.
 * - The hits obey the rules of ray_query_rules.h.
 * - Another order of the parts gives the same distances bit for bit.
 * - Where rounding does not decide, the plain tracer finds the same hits.
 *
 * A failing scene is reduced line by line while it fails, printed, and written to
 * lines_N.pov.
 */
#include "tests/oracle/chance.h"
#include "tests/oracle/random_scenes.h"
#include "tests/oracle/ray_query_rules.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINES = 40, WAYS = 3 };

/* --- ways ----------------------------------------------------------------- */

static struct ray_query_options random_way(uint64_t *state)
{
    static const size_t queues[] = { 1, 7, 7, LINES - 1, LINES, 2000 };
    struct ray_query_options way = { .queue = queues[below(state, 6)] };
    way.packet = one_in(state, 3) ? 1 + below(state, LINES) : 0;
    way.mode = one_in(state, 3) ? TRACE_KERNELS : TRACE_VECTOR;
    way.no_bounds = one_in(state, 5);
    way.flat = one_in(state, 4);
    return way;
}

static struct ray_hits find_in(const struct scene *scene, struct ray_query_options way,
                               double behind, const struct scene_ray *list)
{
    way.normals = way.bodies = true;
    way.behind = behind;
    way.model = check_model;
    return find_lines(scene, &way, list, LINES);
}

/* ---- Scenes -------------------------------------------------------------- */

static struct random_scene draw(uint64_t *state, size_t number)
{
    return number % 2 ? many_regions(state) : grid_scene(state);
}

/* Generates the lines for a scene. In scenes on the grid, every second line is on the
 * grid, unless the plain tracer follows the lines, too. */
static void draw_lines(const struct random_scene *sight, const struct scene *scene,
                       struct scene_ray list[LINES])
{
    uint64_t state = sight->state;
    draw_camera_lines(&state, scene, list, LINES);
    if (sight->number % 2 == 0 && sight->certainty == NOTHING_CERTAIN)
        draw_grid_lines(&state, list, LINES / 2);
}

static bool same_in_ways(const struct scene *scene, uint64_t state, double behind,
                         const struct scene_ray *list, const struct ray_hits *expected,
                         char *reason)
{
    bool same = true;
    for (size_t i = 0; same && i < WAYS; i++) {
        struct ray_query_options way = random_way(&state);
        SCOPED_VALUE(ray_hits) found = find_in(scene, way, behind, list);
        same = same_crossings(expected, &found, reason);
        if (!same)
            snprintf(reason + strlen(reason), LINE_REASON - strlen(reason),
                     " with %s, a queue of %zu%s%s", trace_mode_name(way.mode),
                     way.queue, way.no_bounds ? ", without bounds" : "",
                     way.flat ? ", flat" : "");
    }
    return same;
}

static bool same_in_any_order(const struct random_scene *sight, double behind,
                              const struct scene_ray *list,
                              const struct ray_hits *expected, char *reason)
{
    const struct ray_query_options way = { .mode = TRACE_VECTOR, .queue = 77 };
    if (!sight->other)
        return true;
    SCOPED(scene) *scene = scene_of(sight->other);
    SCOPED_VALUE(ray_hits) found = find_in(scene, way, behind, list);
    bool same = same_distances(expected, &found, reason);
    if (!same)
        strcat(reason, " with parts in another order");
    return same;
}

static bool passes(struct random_scene *sight, char *reason)
{
    const struct ray_query_options serial = { .mode = TRACE_SCALAR, .queue = 1 };
    SCOPED(scene) *scene = scene_of(sight->text);
    struct scene_ray list[LINES];
    double behind = sight->state % 3 == 0 ? 100 : 0;
    draw_lines(sight, scene, list);
    SCOPED_VALUE(ray_hits) found = find_in(scene, serial, behind, list);
    return same_in_ways(scene, sight->state, behind, list, &found, reason)
           && keep_line_rules(scene, list, &found, behind, reason)
           && same_in_any_order(sight, behind, list, &found, reason)
           && (sight->certainty == NOTHING_CERTAIN
               || same_as_plain_lines(scene, list, &found, behind,
                                      sight->certainty == ALL_CERTAIN, reason));
}

RANDOM_CHECK("lines", UINT64_C(0xA0761D6478BD642F), draw, passes, true, NULL, 0)
