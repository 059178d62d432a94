/* model.h - a machine model, for the clock.
 *
 * A model that was parsed is complete and in range: it has a value for every
 * row of constants.def and for every timing class, or, if it is a projection,
 * for every row of projection.def, so that reading one cannot fail.  Values
 * are exact decimals, kept as integers in millionths: no figure of the clock
 * ever passes through floating point.
 */
#ifndef C205_MODEL_H
#define C205_MODEL_H

#include "vm/c205.h"

enum constant {
#define CONSTANT(id, name, kind, unit, least, most) CONSTANT_##id,
#include "vm/time/constants.def"
    TIMING_CONSTANTS, /* two for each timing class from here on */
    CONSTANTS = TIMING_CONSTANTS + 2 * C205_TIMINGS
};
/* Those of a projection, which is read by model_whole as well. */
enum projection_constant {
#define CONSTANT(id, name, kind, unit, least, most) PROJECTION_##id,
#include "vm/time/projection.def"
    PROJECTION_CONSTANTS
};

enum { MILLION = 1000000, MAX_LOADS = 64 };

/* As c205_model_change, and with all times in ticks, so many of them a clock:
 * the values need not be whole then. */
c205_model *model_in_ticks(const c205_model *model, const c205_setting *settings,
                           size_t count, uint64_t ticks, c205_error *error);
uint64_t model_ticks(const c205_model *model);

/* In millionths of the constant's unit. */
uint64_t model_millionths(const c205_model *model, enum constant id);
/* Of a WHOLE constant, in its unit. */
uint64_t model_whole(const c205_model *model, enum constant id);

/* A rate per element (or bit) as a fraction: clocks = ceil(n x clocks / per).
 * Rates in "clk*pipe/element" are shared among the pipes, each of which takes
 * vector.word_rate elements at once. */
struct rate {
    uint64_t clocks, per;
};
struct rate model_rate(const c205_model *model, enum constant id);
/* The same for elements of 32 bits: vector.half_rate at once. */
struct rate model_half_rate(const c205_model *model, enum constant id);

static inline enum constant latency_constant(c205_timing scalar)
{
    return (enum constant)(TIMING_CONSTANTS + 2 * scalar);
}

static inline enum constant busy_constant(c205_timing scalar)
{
    return (enum constant)(TIMING_CONSTANTS + 2 * scalar + 1);
}

static inline enum constant startup_constant(c205_timing vector)
{
    return latency_constant(vector);
}

static inline enum constant stream_constant(c205_timing vector)
{
    return busy_constant(vector);
}

#endif
