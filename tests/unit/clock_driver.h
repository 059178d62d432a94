/* clock_driver.h - drives a clock with instructions and effects, without a machine. */
#ifndef CLOCK_DRIVER_H
#define CLOCK_DRIVER_H

#include "tests/unit/unit.h"
#include "vm/time/clock.h"
#include "vm/memory.h"

struct clock *clock_of(const char *text);
struct clock *two_pipes(void);

/* The address of the next instruction. */
extern uint64_t driven_pc;

/* Decodes the next instruction of the driven code. It has one or two sources and a
 * result. Register 0 means that the source or result is absent. */
struct decoded insn(const char *name, unsigned r, unsigned s, unsigned t);

extern const struct effect no_effect;
void charge(struct clock *clock, struct decoded decoded, const struct effect *effect);
void scalar(struct clock *clock, const char *name, unsigned r, unsigned s, unsigned t);
void branch(struct clock *clock, const char *name, uint64_t target);
void at_address(struct clock *clock, const char *name, uint64_t address);
uint64_t clocks_for(const struct clock *clock, c205_cause cause);

/* Drains the clock, fails unless its total is `expected`, and resets it. */
void assert_total(struct clock *clock, uint64_t expected);

#endif
