/* measure.h - how long a vector instruction takes, measured on the machine.
 *
 * The instruction runs at many lengths, alone: its clocks are those of a
 * program that has it less those of a program that has not.  All pages are
 * resident, as each run is the second of its kind.  A line through the points,
 * T = startup + per_element x n (least squares), gives
 *
 *   r-infinity = flops / (per_element x period)   the rate of long vectors
 *   n-half     = startup / per_element            the length of half that rate
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
    double flops; /* done for each element; 0: it makes results, not flops */
    struct measure_point points[MEASURE_POINTS];
    double startup;     /* clocks */
    double per_element; /* clocks */
    double deviation;   /* clocks: the point farthest from the line */
};

/* The linked triad B + s A, as if it were one instruction. */
extern const char measure_triad[];

/* Whether a name can be measured: a vector instruction or the triad, behind
 * it ",H" for 32-bit operands where the row allows them. */
bool measure_knows(const char *name);

/* name: one that measure_knows. */
bool measure(const c205_model *model, const char *name, struct measurement *result,
             c205_error *error);

/* Millions a second of flops, or of results, by the model's clock. */
double measure_rate(const struct measurement *measurement, const c205_model *model);
double measure_half_length(const struct measurement *measurement);

#endif
