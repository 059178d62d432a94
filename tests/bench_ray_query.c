/* bench_ray_query.c - the machine's clocks of all-hits ray queries.
 *
 *     bench_ray_query SCENE.pov ..
 *
 * For each scene, 4,800 lines from its camera pass through the centres of 80 x 60
 * pixels, in both forms, the vector form in queues of 2,000. The table has the
 * crossings per line and the clocks per line: without options, with bodies counted, and
 * with normals as well. Exit status 1: the forms give different crossings.
 */
#include <stdio.h>

#include "rt/trace/ray_query.h"
#include "tests/timed_program.h"

enum { ACROSS = 80, DOWN = 60, LINES = ACROSS * DOWN };

static const struct asked {
    const char *name;
    bool bodies, normals;
} asked[] = {
    { "crossings", false, false },
    { "bodies, too", true, false },
    { "normals, too", true, true },
};

static void put_lines(const struct camera *camera, struct scene_ray list[LINES])
{
    for (size_t i = 0; i < LINES; i++) {
        double u = ((double)(i % ACROSS) + .5) / ACROSS - .5;
        double v = .5 - ((double)(i / ACROSS) + .5) / DOWN;
        for (int k = 0; k < 3; k++) {
            double aside = u * camera->right[k] + v * camera->up[k];
            list[i].origin[k] = camera->location[k]
                                + (camera->orthographic ? aside : 0);
            list[i].direction[k] = camera->direction[k]
                                   + (camera->orthographic ? 0 : aside);
        }
    }
}

/* Returns the clocks per line. */
static double follow(const struct scene *scene, const c205_model *model,
                     enum trace_mode mode, const struct asked *what,
                     const struct scene_ray list[LINES], struct ray_hits *found)
{
    const struct ray_query_options options = { .mode = mode,
                                               .queue = TRACE_QUEUE,
                                               .bodies = what->bodies,
                                               .normals = what->normals,
                                               .model = model };
    c205_error error = { "out of memory" };
    SCOPED(ray_query) *lines = ray_query_new(scene, &options, &error);
    if (!lines || !ray_query_find(lines, list, LINES, found, &error))
        stop_bench(error.message);
    return (double)found->accounts.clocks / LINES;
}

static bool are_same(const struct ray_hits *a, const struct ray_hits *b)
{
    bool same = a->first[LINES] == b->first[LINES];
    for (size_t i = 0; same && i < a->first[LINES]; i++)
        same = a->list[i].distance == b->list[i].distance
               && a->list[i].primitive == b->list[i].primitive;
    return same;
}

static void print_row(const char *path, const struct scene *scene,
                      const c205_model *model, const struct asked *what)
{
    static struct scene_ray list[LINES];
    struct ray_hits scalar, vector;
    double slow, fast;
    put_lines(&scene->camera, list);
    slow = follow(scene, model, TRACE_SCALAR, what, list, &scalar);
    fast = follow(scene, model, TRACE_VECTOR, what, list, &vector);
    if (!are_same(&scalar, &vector))
        stop_bench("the two forms do not find the same");
    printf("%-24s %-13s %15.2f %9.0f %9.0f %8.1f\n", path, what->name,
           (double)scalar.first[LINES] / LINES, slow, fast, slow / fast);
    ray_hits_free(&scalar);
    ray_hits_free(&vector);
}

int main(int count, char **paths)
{
    c205_error error;
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &error);
    if (!model)
        stop_bench(error.message);
    printf("%-38s %15s %9s %9s %8s\n", "", "crossings", "scalar,", "vector,", "");
    printf("%-24s %-13s %15s %9s %9s %8s\n", "scene", "asked", "a line", "clocks",
           "clocks", "speedup");
    for (int i = 1; i < count; i++) {
        SCOPED(scene) *scene = scene_to_time(paths[i], ACROSS, DOWN);
        for (size_t k = 0; k < sizeof asked / sizeof *asked; k++)
            print_row(paths[i], scene, model, &asked[k]);
    }
    return 0;
}
