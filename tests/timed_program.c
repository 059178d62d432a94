/* timed_program.c - measures the time of programs, frames and processes on the host. */
#include "tests/timed_program.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "rt/picture/picture.h"
#include "rt/scene/language/scene_read.h"

void stop_bench(const char *message)
{
    fprintf(stderr, "bench: %s\n", message);
    exit(1);
}

static double seconds_of(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

double processor_seconds(void)
{
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

double wall_seconds(void)
{
    return seconds_of(CLOCK_MONOTONIC);
}

struct object *program_to_time(const char *text)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct sink messages = stream_sink(stderr);
    struct object *object = assemble_text("bench", text, NULL, &errors);
    if (!object) {
        diagnostics_put(&errors, &messages);
        stop_bench("the program has errors");
    }
    return object;
}

struct scene *scene_to_time(const char *path, int width, int height)
{
    const struct scene_options options = { .width = width,
                                           .height = height,
                                           .read_raster = picture_read_raster };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = scene_read(path, &options, &reports);
    if (!scene) {
        diagnostics_print(&reports, stderr);
        stop_bench("the scene has errors");
    }
    return scene;
}

double time_program(c205 *machine, const c205_program *program, int trials)
{
    c205_error error;
    double best = HUGE_VAL;
    for (int trial = 0; trial < trials; trial++) {
        if (!c205_load(machine, program, &error))
            stop_bench(error.message);
        double start = processor_seconds();
        c205_stop end = c205_run(machine, C205_NO_LIMIT);
        best = fmin(best, processor_seconds() - start);
        if (end.trap != C205_TRAP_NONE) {
            c205_describe_stop(machine, &end, &error);
            stop_bench(error.message);
        }
    }
    return best;
}
