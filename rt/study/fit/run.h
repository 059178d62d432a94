/* run.h - a program that has run once on the machine, and is timed again with
 * other constants.
 *
 * A program is named as the observations name it: "SUBJECT scalar" or "SUBJECT
 * vector" for a frame of rt205 speedup, or "FILE.s", perhaps with words
 * NAME=VALUE behind it, for a program text.
 */
#ifndef RT_FIT_RUN_H
#define RT_FIT_RUN_H

#include "asm/assemble.h"
#include "rt/study/speedup.h"

/* Where program texts lie, the frames' size in each form, and their view. */
struct run_options {
    const char *folder;
    size_t width[TRACE_FORMS], height[TRACE_FORMS];
    struct speedup_view view;
    const c205_model *model; /* on which they run, once */
};

#define MAX_RUN_REGIONS 128

struct fit_run {
    char *program;
    size_t rays;                           /* of a frame; 0: it is none */
    const struct speedup_subject *subject; /* of a frame */
    struct object *object;                 /* of a program text */
    struct trace *trace;                   /* of a frame */
    struct scene *scene;
    c205_recording *recording;
    size_t region_count;
    char *regions[MAX_RUN_REGIONS];
};

/* NULL: the error says why. */
struct fit_run *run_new(const char *program, const struct run_options *options,
                        c205_error *error);
void run_free(struct fit_run *run);

/* The value of an integer symbol of a program text.  False: there is none. */
bool run_symbol(const struct fit_run *run, const char *name, double *value);

/* Which regions: that of the name, or where it is empty those by which the
 * program is timed: a frame by its subject's regions, a program text by all
 * that have names.  False: there is no such region. */
bool run_select(const struct fit_run *run, const char *name,
                bool chosen[MAX_RUN_REGIONS], c205_error *error);

/* Ticks of a clock: 1 as the machine has it, or so many that a tenth of a clock
 * more shows in a derivative. */
enum { RUN_WHOLE = 1, RUN_FINE = 1000 };

/* Clocks of its regions; time advances in ticks. */
bool run_time(const struct fit_run *run, const c205_model *model,
              const c205_setting *settings, size_t count, unsigned ticks,
              double clocks[MAX_RUN_REGIONS], c205_error *error);

#endif
