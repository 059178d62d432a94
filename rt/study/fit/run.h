/* run.h - runs a program once on the machine, and times it again with other constants.
 *
 * Programs have the names that observations use. "SUBJECT scalar" and "SUBJECT vector"
 * are frames of rt205 speedup. "FILE.s NAME=VALUE .." is a source file and the
 * constants that are defined for its assembly.
 */
#ifndef RT_FIT_RUN_H
#define RT_FIT_RUN_H

#include "asm/text/assemble.h"
#include "rt/study/speedup.h"

/* The folder of source files, and the size and view of frames in each form. */
struct run_options {
    const char *folder;
    size_t width[TRACE_FORMS], height[TRACE_FORMS];
    struct speedup_view view;
    const c205_model *model; /* model of the only run */
};

#define MAX_RUN_REGIONS 128

struct fit_run {
    char *program;
    size_t rays;                           /* number of rays of a frame; 0: not a
                                            * frame */
    const struct speedup_subject *subject; /* subject of a frame */
    struct object *object;                 /* program of a source file */
    struct trace *trace;                   /* trace of a frame */
    struct scene *scene;
    c205_recording *recording;
    size_t region_count;
    char *regions[MAX_RUN_REGIONS];
};

/* Runs a program and records it. On failure sets the error and returns NULL. */
struct fit_run *run_new(const char *program, const struct run_options *options,
                        c205_error *error);
void run_free(struct fit_run *run);

/* Reads the value of an integer symbol of a source file. Returns false if there is no
 * such symbol. */
bool run_symbol(const struct fit_run *run, const char *name, double *value);

/* Selects regions by name. An empty name selects the regions that count for the
 * program: the regions of the subject for a frame, and all named regions for a source
 * file. Returns false if there is no such region. */
bool run_select(const struct fit_run *run, const char *name,
                bool chosen[MAX_RUN_REGIONS], c205_error *error);

/* The number of ticks per clock. RUN_WHOLE is the machine's time. RUN_FINE is so large
 * that a tenth of a clock affects a derivative. */
enum { RUN_WHOLE = 1, RUN_FINE = 1000 };

/* Computes the clocks of a run's regions with changed constants. There are `ticks`
 * steps of time per clock. */
bool run_time(const struct fit_run *run, const c205_model *model,
              const c205_setting *settings, size_t count, unsigned ticks,
              double clocks[MAX_RUN_REGIONS], c205_error *error);

#endif
