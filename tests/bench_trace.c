/* bench_trace.c - how long the trace of a frame takes.
 *
 *     bench_trace SCENE.pov WIDTH HEIGHT TRIALS
 *
 * Traces the scene in vector form, one band at a time, and prints the least
 * of the trials' processor seconds.  Reading the scene and assembling the
 * kernels are not counted, as POV-Ray does not count its parsing.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "base/diagnostic.h"
#include "rt/scene/language/scene_read.h"
#include "rt/trace/trace.h"

static struct scene *read_scene(const char *path, size_t width, size_t height)
{
    const struct scene_options options = { .width = (int)width,
                                           .height = (int)height };
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read(path, &options, &reports);

    if (!scene)
        diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    return scene;
}

/* Seconds; below 0: the error says why not. */
static double time_trace(const struct scene *scene,
                         const struct trace_options *options,
                         c205_error *error)
{
    struct trace *trace = trace_new(scene, options, error);
    clock_t begin = clock();
    bool good = trace && trace_run(trace, error);
    clock_t end = clock();

    trace_free(trace);
    return good ? (double)(end - begin) / CLOCKS_PER_SEC : -1;
}

static bool print_best(const struct scene *scene,
                       const struct trace_options *options, int trials)
{
    c205_error error = { "no memory" };
    double best = time_trace(scene, options, &error);

    for (int i = 1; i < trials && best >= 0; i++) {
        double seconds = time_trace(scene, options, &error);
        best = seconds < best ? seconds : best;
    }
    if (best < 0)
        fprintf(stderr, "bench_trace: %s\n", error.message);
    else
        printf("%.3f\n", best);
    return best >= 0;
}

int main(int count, char **words)
{
    struct trace_options options = { .mode = TRACE_VECTOR,
                                     .queue = TRACE_QUEUE,
                                     .jobs = 1 };
    c205_error error;
    c205_model *model;
    struct scene *scene;
    bool good;

    if (count != 5) {
        fputs("usage: bench_trace SCENE.pov WIDTH HEIGHT TRIALS\n", stderr);
        return 2;
    }
    options.width = strtoul(words[2], NULL, 10);
    options.height = strtoul(words[3], NULL, 10);
    options.model = model = c205_model_find("cyber205-2pipe", &error);
    scene = read_scene(words[1], options.width, options.height);
    if (!model)
        fprintf(stderr, "bench_trace: %s\n", error.message);
    good = model && scene && print_best(scene, &options, atoi(words[4]));
    scene_free(scene);
    c205_model_free(model);
    return good ? 0 : 1;
}
