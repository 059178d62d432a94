/* measure.h - measures how long a vector instruction takes.
 *
 * The instruction is measured at many lengths. Its clocks are the difference between a
 * program with the instruction and the same program without it. Each program runs
 * twice, and the second run counts, because all pages are then resident. A line through
 * the points, T = startup + per_element x n (least squares), gives
 *
 *   r-infinity = flops / (per_element x period)   the rate of long vectors
 *   n-half     = startup / per_element            length with half of this rate
 *
 * Source: R. W. Hockney and C. R. Jesshope, Parallel Computers (1981).
 */
#ifndef ASM_MEASURE_H
#define ASM_MEASURE_H

#include "vm/c205.h"

enum { MEASURE_POINTS = 18, MEASURE_NAME_SIZE = 16 };

struct measure_point {
    size_t length;
    uint64_t clocks;
};

struct measurement {
    char name[MEASURE_NAME_SIZE];
    const char *timing;
    double flops; /* per element; 0: results are not flops */
    struct measure_point points[MEASURE_POINTS];
    double startup;     /* in clocks */
    double per_element; /* in clocks */
    double deviation;   /* largest distance of a point from the line, in clocks */
};

/* The linked triad B + s A, measured as one instruction. */
extern const char measure_triad[];

/* Returns true if a name can be measured: a vector instruction or the triad. ",H" may
 * follow if the instruction allows 32-bit operands. */
bool measure_knows(const char *name);

/* Measures an instruction for whose name measure_knows returns true. */
bool measure(const c205_model *model, const char *name, struct measurement *result,
             c205_error *error);

/* measure_rate returns millions of flops per second at the clock period of the model,
 * or millions of results if the instruction has no flops. measure_half_length returns
 * n-half. */
double measure_rate(const struct measurement *measurement, const c205_model *model);
double measure_half_length(const struct measurement *measurement);

#endif
