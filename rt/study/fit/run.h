/* run.h - runs a program once on the machine, and times it again with other
 * constants.
 *
 * A program is named as in the observations: "SUBJECT scalar" or "SUBJECT vector"
 * for a frame of rt205 speedup, or "FILE.s" for a source file, optionally followed
 * by words NAME=VALUE.
 */
#ifndef RT_FIT_RUN_H
#define RT_FIT_RUN_H

#include "asm/text/assemble.h"
#include "rt/study/speedup.h"

/* The folder of source files, the size of frames in each form, and their view. */
struct run_options {
    const char *folder;
    size_t width[TRACE_FORMS], height[TRACE_FORMS];
    struct speedup_view view;
    const c205_model *model; /* for the one run */
};

#define MAX_RUN_REGIONS 128

struct fit_run {
    char *program;
    size_t rays;                           /* of a frame; 0: not a frame */
    const struct speedup_subject *subject; /* of a frame */
    struct object *object;                 /* of a source file */
    struct trace *trace;                   /* of a frame */
    struct scene *scene;
    c205_recording *recording;
    size_t region_count;
    char *regions[MAX_RUN_REGIONS];
};

/* Runs a program and records it. Returns NULL with the reason in the error. */
struct fit_run *run_new(const char *program, const struct run_options *options,
                        c205_error *error);
void run_free(struct fit_run *run);

/* Returns the value of an integer symbol of a source file. Returns false if there
 * is none. */
bool run_symbol(const struct fit_run *run, const char *name, double *value);

/* Selects regions by name. An empty name selects the regions by which the program
 * is timed: those of the subject for a frame, and all named regions for a source
 * file. Returns false if there is no such region. */
bool run_select(const struct fit_run *run, const char *name,
                bool chosen[MAX_RUN_REGIONS], c205_error *error);

/* Ticks per clock: 1 as on the machine, or a number such that a tenth of a clock
 * shows in a derivative. */
enum { RUN_WHOLE = 1, RUN_FINE = 1000 };

/* Computes the clocks of the regions of a run with changed constants. Time
 * advances in ticks. */
bool run_time(const struct fit_run *run, const c205_model *model,
              const c205_setting *settings, size_t count, unsigned ticks,
              double clocks[MAX_RUN_REGIONS], c205_error *error);

#endif
