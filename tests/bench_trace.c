/* bench_trace.c - the time of tracing a frame.
 *
 *     bench_trace SCENE.pov WIDTH HEIGHT [JOBS]
 *
 * Traces the scene in vector form, JOBS bands at a time (1), and prints processor
 * seconds, wall seconds, clocks of the machine, and the maximum size of the process in
 * kilobytes. The seconds exclude reading the scene and assembling the kernels, as
 * POV-Ray's exclude parsing.
 */
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

#include "rt/trace/trace.h"
#include "tests/timed_program.h"

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
           wall_seconds() - begin, (unsigned long long)trace_accounts(trace)->clocks,
           kilobytes());
    return true;
}

static bool trace_scene(const struct scene *scene, const struct trace_options *options)
{
    c205_error error = { "out of memory" };
    SCOPED(trace) *trace = trace_new(scene, options, &error);
    bool good = trace && time_trace(trace, &error);
    if (!good)
        fprintf(stderr, "bench_trace: %s\n", error.message);
    return good;
}

int main(int count, char **words)
{
    struct trace_options options = { .mode = TRACE_VECTOR,
                                     .queue = TRACE_QUEUE,
                                     .jobs = 1 };
    c205_error error;
    c205_model *model;
    if (count < 4 || count > 5) {
        fputs("usage: bench_trace SCENE.pov WIDTH HEIGHT [JOBS]\n", stderr);
        return 2;
    }
    options.width = strtoul(words[2], NULL, 10);
    options.height = strtoul(words[3], NULL, 10);
    if (count == 5)
        options.jobs = strtoul(words[4], NULL, 10);
    options.model = model = c205_model_find("cyber205-2pipe", &error);
    struct scene *scene = scene_to_time(words[1], (int)options.width,
                                        (int)options.height);
    if (!model)
        fprintf(stderr, "bench_trace: %s\n", error.message);
    bool good = model && trace_scene(scene, &options);
    scene_free(scene);
    c205_model_free(model);
    return good ? 0 : 1;
}
