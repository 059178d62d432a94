/* observations.h - what has been published of the machines' speed, and what
 * the emulated machine's own clocks say of the same.
 *
 * An observation is a line of a file in rt/study/fit/observations:
 *
 *   program   as run.h has it, ":REGION" or ":REGION/REGION" in it
 *   machine   a model, or two, MODEL/MODEL; where there is a MODEL-prior, which
 *             no fit has touched, it is that
 *   unit      s/100000   seconds for 100,000 rays
 *             clk        clocks
 *             ns/SYMBOL  nanoseconds, divided by that constant of the program
 *             Mflop/s    FLOPS of the program, by its time
 *             Melements/s  ELEMENTS of the program, by its time
 *             %          the region's share of the program
 *             ratio      the first region's or machine's time by the second's
 *   value     a number; of a range "LEAST to MAX", or a number
 *   uncertainty   relative: one standard deviation; of a range empty
 *   shared    the same, of what is off alike in all rows of a group
 *   use       fit; compare; or range: what is known as a range, or from a
 *             program that can be written in several ways, a row for each,
 *             "NAME, WAY"
 *
 * Each program runs once; its clocks with other constants come from the
 * recording, by the machine's own clock (vm/time/recording.c) or a projection.
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

/* The seconds of some of its regions. */
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
    bool rate; /* factor / seconds; else factor x seconds */
    double factor;
    size_t term_count; /* of two: the first by the second */
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

/* Zero it to begin.  Add the observations of a file and run their programs.
 * False: the error says why. */
bool observations_read(struct observations *observations, const char *path,
                       const struct run_options *options,
                       struct diagnostics *diagnostics);
void observations_free(struct observations *observations);

/* The first words of its name, which a group of observations shares: up to a
 * comma, or up to the last word. */
size_t observation_group(const struct observation *observation);
bool observation_same_group(const struct observation *one,
                            const struct observation *other);
/* Of the row alone: its own uncertainty and the shared one. */
double observation_uncertainty(const struct observation *observation);

/* From the clocks of each timing's regions. */
double observation_predict(const struct observations *observations,
                           const struct observation *observation,
                           double (*clocks)[MAX_RUN_REGIONS]);

#endif
