/* timed_program.h - measures the time of a program or a frame on the host. */
#ifndef TESTS_TIMED_PROGRAM_H
#define TESTS_TIMED_PROGRAM_H

#include "asm/text/assemble.h"
#include "rt/scene/scene.h"
#include "tests/scoped.h"

/* Prints the reason and exits with status 1. */
void stop_bench(const char *message);
/* Returns the processor seconds of this process alone. */
double processor_seconds(void);
/* Returns the seconds of a monotonic wall clock. */
double wall_seconds(void);
/* Assembles a text; stops the benchmark if it has errors. */
struct object *program_to_time(const char *text);
/* Reads a file's scene for frames of this size. Errors stop the benchmark. */
struct scene *scene_to_time(const char *path, int width, int height);
/* Returns the seconds of the fastest of `trials` runs. The last run's accounts stay. */
double time_program(c205 *machine, const c205_program *program, int trials);

#endif
