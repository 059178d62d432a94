/* model.h - reads the constants of a machine model, for the clock.
 *
 * A parsed model is complete and its values are in range. It has a value for every
 * timing class and every row of constants.def. A projection has a value for every row
 * of projection.def. Reading a constant therefore cannot fail. Values are exact
 * decimals, stored as integers in millionths, so the clock never uses floating point.
 */
#ifndef C205_MODEL_H
#define C205_MODEL_H

#include "vm/c205.h"

enum constant {
#define CONSTANT(id, name, kind, unit, least, most) CONSTANT_##id,
#include "vm/time/constants.def"
    TIMING_CONSTANTS, /* two constants for each timing class follow */
    CONSTANTS = TIMING_CONSTANTS + 2 * C205_TIMINGS
};
/* The constants of a projection. They can be read with model_whole, too. */
enum projection_constant {
#define CONSTANT(id, name, kind, unit, least, most) PROJECTION_##id,
#include "vm/time/projection.def"
    PROJECTION_CONSTANTS
};

enum { MILLION = 1000000, MAX_LOADS = 64 };

/* Like c205_model_change, but all times are in ticks. A clock has the given number of
 * ticks. Times need not be whole clocks. Returns NULL with the message in *error. */
c205_model *model_in_ticks(const c205_model *model, const c205_setting *settings,
                           size_t count, uint64_t ticks, c205_error *error);
uint64_t model_ticks(const c205_model *model);

/* Returns a constant in millionths of its unit. */
uint64_t model_millionths(const c205_model *model, enum constant id);
/* Returns an integer constant (kind WHOLE) in its unit. */
uint64_t model_whole(const c205_model *model, enum constant id);

/* A rate per element (or bit) as a fraction: n elements take ceil(n x clocks / per)
 * clocks. A rate in "clk*pipe/element" is divided by the number of pipes and by
 * vector.word_rate, the elements that each pipe takes per clock. */
struct rate {
    uint64_t clocks, per;
};
struct rate model_rate(const c205_model *model, enum constant id);
/* Returns the rate for half words. Each pipe takes vector.half_rate of them per
 * clock. */
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
