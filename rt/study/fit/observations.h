/* observations.h - published figures of the machines' speed, and their predictions from
 * the clocks of the emulated machine.
 *
 * An observation is a line of a file in rt/study/fit/observations:
 *
 *   program   as in run.h, with an optional ":REGION" or ":REGION/REGION"
 *   machine   a model, or two models MODEL/MODEL; if there is a model
 *             MODEL-prior, which no fit has changed, it is used
 *   unit      s/100000   seconds for 100,000 rays
 *             clk        clocks
 *             ns/SYMBOL  nanoseconds, divided by the program's constant SYMBOL
 *             Mflop/s    FLOPS of the program, divided by its time
 *             Melements/s  ELEMENTS of the program, divided by its time
 *             %          the region's fraction of the program's time
 *             ratio      time of the first region or machine over the second
 *   value     a number; for a range "MIN to MAX", or a number
 *   uncertainty   relative: one standard deviation; empty for a range
 *   shared    uncertainty of the error that all rows of a group share
 *   use       fit; compare; or range: a value that is known as a range, or
 *             a program that can be written in several ways, with a row
 *             "NAME, WAY" for each
 *
 * Each program runs once. Its clocks with other constants are computed from the
 * recording, by the machine's clock (vm/time/recording.c) or by a projection.
 */
#ifndef RT_FIT_OBSERVATIONS_H
#define RT_FIT_OBSERVATIONS_H

#include "rt/study/fit/csv.h"
#include "rt/study/fit/run.h"

#define PRIOR_SUFFIX "-prior"

/* A recorded program, and the model of the machine on which it is timed. */
struct run_timing {
    const struct fit_run *run;
    const c205_model *model;
};

/* A time from which an observation is predicted: the seconds of the chosen regions of a
 * timing. */
struct term {
    size_t timing;
    bool chosen[MAX_RUN_REGIONS];
};

enum observation_use {
    OBSERVATION_FIT,
    OBSERVATION_COMPARE,
    OBSERVATION_RANGE,
    OBSERVATION_USES
};

struct observation {
    const char *name, *program, *machine, *unit, *source;
    double value, uncertainty, shared;
    double least, most; /* bounds of a range */
    enum observation_use use;
    bool rate; /* the value is factor / seconds, else factor x seconds */
    double factor;
    size_t term_count; /* 2: the value is the ratio of the two terms */
    struct term terms[2];
};

struct observations {
    size_t count, timing_count, run_count, model_count, file_count;
    struct observation *items;
    struct run_timing *timings;
    struct fit_run **runs;
    c205_model **models;
    struct csv *files; /* files that contain the texts */
};

/* Adds the observations of a file, and runs their programs. The structure must
 * initially be zero. On failure reports diagnostics and returns false. */
bool observations_read(struct observations *observations, const char *path,
                       const struct run_options *options,
                       struct diagnostics *diagnostics);
void observations_free(struct observations *observations);

/* Returns the length of the part of the name that all observations of a group share:
 * the name up to its comma, or up to its last space if it has no comma. */
size_t observation_group(const struct observation *observation);
bool observation_same_group(const struct observation *one,
                            const struct observation *other);
/* Returns the total uncertainty of a row, from its own uncertainty and the shared
 * uncertainty: the root of the sum of their squares. */
double observation_uncertainty(const struct observation *observation);

/* Predicts an observation from the clocks of the timings' regions. */
double observation_predict(const struct observations *observations,
                           const struct observation *observation,
                           double (*clocks)[MAX_RUN_REGIONS]);

#endif
