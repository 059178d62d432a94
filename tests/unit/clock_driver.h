/* clock_driver.h - a clock driven with decoded instructions and effects made
 * by hand; no machine runs.
 */
#ifndef CLOCK_DRIVER_H
#define CLOCK_DRIVER_H

#include "tests/unit/unit.h"
#include "vm/time/clock.h"
#include "vm/memory.h"

struct clock *clock_of(const char *text);
struct clock *two_pipes(void);

/* Where the code continues. */
extern uint64_t driven_pc;

/* The next instruction of the code: of region, with one or two sources and a
 * result (0: none). */
struct decoded insn(const char *name, unsigned r, unsigned s, unsigned t);

extern const struct effect no_effect;
void charge(struct clock *clock, struct decoded decoded, const struct effect *effect);
void scalar(struct clock *clock, const char *name, unsigned r, unsigned s, unsigned t);
void branch(struct clock *clock, const char *name, uint64_t target);
void at_address(struct clock *clock, const char *name, uint64_t address);
uint64_t clocks_for(const struct clock *clock, c205_cause cause);

/* Drain and look at the total, then start again. */
void assert_total(struct clock *clock, uint64_t expected);

#endif
