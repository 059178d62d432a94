/* observations.h - published figures of the machines' speed, and the same figures
 * as predicted by the emulated machine's own clocks.
 *
 * An observation is a line of a file in rt/study/fit/observations:
 *
 *   program   as in run.h, with an optional ":REGION" or ":REGION/REGION"
 *   machine   a model, or two, MODEL/MODEL; if a MODEL-prior exists, which
 *             no fit has changed, that is used
 *   unit      s/100000   seconds for 100,000 rays
 *             clk        clocks
 *             ns/SYMBOL  nanoseconds, divided by that constant of the program
 *             Mflop/s    FLOPS of the program, divided by its time
 *             Melements/s  ELEMENTS of the program, divided by its time
 *             %          the region's share of the program
 *             ratio      the first region's or machine's time over the second's
 *   value     a number; for a range "MIN to MAX", or a number
 *   uncertainty   relative: one standard deviation; empty for a range
 *   shared    the same, for the error that all rows of a group share
 *   use       fit; compare; or range: a value that is known as a range, or
 *             a program that can be written in several ways, with a row
 *             "NAME, WAY" for each
 *
 * Each program runs once. Its clocks with other constants are computed from the
 * recording, by the machine's own clock (vm/time/recording.c) or by a projection.
 */
#ifndef RT_FIT_OBSERVATIONS_H
#define RT_FIT_OBSERVATIONS_H

#include "rt/study/fit/csv.h"
#include "rt/study/fit/run.h"

#define PRIOR_SUFFIX "-prior"

/* A program on a machine. */
struct run_timing {
    const struct fit_run *run;
    const c205_model *model;
};

/* The seconds of some regions of a timing. */
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
    double least, most; /* of a range */
    enum observation_use use;
    bool rate; /* the value is factor / seconds; else factor x seconds */
    double factor;
    size_t term_count; /* two terms: the first divided by the second */
    struct term terms[2];
};

struct observations {
    size_t count, timing_count, run_count, model_count, file_count;
    struct observation *items;
    struct run_timing *timings;
    struct fit_run **runs;
    c205_model **models;
    struct csv *files; /* hold the texts */
};

/* Adds the observations of a file and runs their programs. The structure must be
 * zero before the first call. Returns false with the reason in the diagnostics. */
bool observations_read(struct observations *observations, const char *path,
                       const struct run_options *options,
                       struct diagnostics *diagnostics);
void observations_free(struct observations *observations);

/* Returns the length of the first words of the name, which a group of observations
 * shares: up to a comma, or up to the last word. */
size_t observation_group(const struct observation *observation);
bool observation_same_group(const struct observation *one,
                            const struct observation *other);
/* Returns the total uncertainty of a row: its own and the shared one. */
double observation_uncertainty(const struct observation *observation);

/* Predicts an observation from the clocks of each timing's regions. */
double observation_predict(const struct observations *observations,
                           const struct observation *observation,
                           double (*clocks)[MAX_RUN_REGIONS]);

#endif
