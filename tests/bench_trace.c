/* bench_trace.c - how long the trace of a frame takes.
 *
 *     bench_trace SCENE.pov WIDTH HEIGHT [JOBS]
 *
 * Traces the scene in vector form, JOBS bands at a time (1), and prints
 * processor seconds, seconds, clocks of the machine, and the most kilobytes
 * that the process had.  Reading the scene and assembling the kernels are not
 * counted in the seconds, as POV-Ray does not count its parsing.
 */
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

#include "base/diagnostic.h"
#include "rt/scene/language/scene_read.h"
#include "rt/trace/trace.h"
#include "tests/timed_program.h"

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

static long kilobytes(void)
{
    struct rusage usage;

    return getrusage(RUSAGE_SELF, &usage) ? 0 : usage.ru_maxrss;
}

static bool time_trace(struct trace *trace, c205_error *error)
{
    double processor = processor_seconds(), begin = wall_seconds();

    if (!trace_run(trace, error))
        return false;
    printf("%.4f %.4f %llu %ld\n", processor_seconds() - processor,
           wall_seconds() - begin,
           (unsigned long long)trace_accounts(trace)->clocks, kilobytes());
    return true;
}

static bool trace_scene(const struct scene *scene,
                        const struct trace_options *options)
{
    c205_error error = { "no memory" };
    struct trace *trace = trace_new(scene, options, &error);
    bool good = trace && time_trace(trace, &error);

    if (!good)
        fprintf(stderr, "bench_trace: %s\n", error.message);
    trace_free(trace);
    return good;
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

    if (count < 4 || count > 5) {
        fputs("usage: bench_trace SCENE.pov WIDTH HEIGHT [JOBS]\n", stderr);
        return 2;
    }
    options.width = strtoul(words[2], NULL, 10);
    options.height = strtoul(words[3], NULL, 10);
    if (count == 5)
        options.jobs = strtoul(words[4], NULL, 10);
    options.model = model = c205_model_find("cyber205-2pipe", &error);
    scene = read_scene(words[1], options.width, options.height);
    if (!model)
        fprintf(stderr, "bench_trace: %s\n", error.message);
    good = model && scene && trace_scene(scene, &options);
    scene_free(scene);
    c205_model_free(model);
    return good ? 0 : 1;
}
