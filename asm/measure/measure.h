/* measure.h - measures how long a vector instruction takes.
 *
 * The instruction is measured at many lengths. Its clocks are those of a program with
 * the instruction minus those of the same program without it. Each run is the second of
 * its kind, so all pages are resident. A line through the points, T = startup +
 * per_element x n (least squares), gives
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
    double flops; /* per element; 0: the results are not flops */
    struct measure_point points[MEASURE_POINTS];
    double startup;     /* clocks */
    double per_element; /* clocks */
    double deviation;   /* clocks: largest distance of a point from the line */
};

/* The linked triad B + s A, measured as one instruction. */
extern const char measure_triad[];

/* Returns whether a name can be measured: a vector instruction or the triad, with ",H"
 * after it for 32-bit operands if the instruction allows them. */
bool measure_knows(const char *name);

/* name: one for which measure_knows returns true. */
bool measure(const c205_model *model, const char *name, struct measurement *result,
             c205_error *error);

/* Returns the millions of flops per second, or of results, by the model's clock. */
double measure_rate(const struct measurement *measurement, const c205_model *model);
double measure_half_length(const struct measurement *measurement);

#endif
