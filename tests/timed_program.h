/* timed_program.h - how long a program or a frame of the machine takes on the host. */
#ifndef TESTS_TIMED_PROGRAM_H
#define TESTS_TIMED_PROGRAM_H

#include "asm/assemble.h"
#include "rt/scene/scene.h"

/* Say why, and end the program with 1. */
void stop_bench(const char *message);
/* Seconds of this process, so that others on the host do not count. */
double processor_seconds(void);
/* .. and by the clock, from some time on. */
double wall_seconds(void);
/* Stops the bench where the text has errors. */
struct object *program_to_time(const char *text);
/* The scene of a file, for frames of this size; stops the bench where the file has errors. */
struct scene *scene_to_time(const char *path, int width, int height);
/* Seconds of the fastest of so many runs; what the last one did is left in the
 * machine's accounts. */
double time_program(c205 *machine, const c205_program *program, int trials);

#endif
