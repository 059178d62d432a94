/* in_flight.h - stores each distinct state in flight of the scalar unit once.
 *
 * Two states are equal if the same registers, units and loads are pending for the same
 * numbers of clocks. Equal states have the same address, so schedules compare pointers.
 */
#ifndef C205_IN_FLIGHT_H
#define C205_IN_FLIGHT_H

#include "vm/decode.h"
#include "vm/time/clock.h"

enum { MAX_PENDING = 48, FLIGHTS = 1 << (TABLE_BITS - 3) };

/* A pending register, unit or load, with the clocks until it is ready. */
struct pending {
    uint32_t clocks;
    uint16_t place;
    uint16_t awaits; /* the cause of waiting for a register */
};

/* The pending results, units and loads of the scalar unit at some time. All times are
 * in clocks from then on. */
struct in_flight {
    uint64_t results_done, loads_done;
    uint64_t latest;                     /* maximum of all pending times */
    size_t registers, units, loads;      /* number of pending entries of each kind */
    struct pending pending[MAX_PENDING]; /* registers by index, then units by index,
                                            then loads from the oldest */
    struct in_flight *chained;           /* next state with the same hash */
};

struct in_flight_table {
    size_t count;
    struct in_flight *hashed[FLIGHTS];
    struct in_flight nothing;
    struct in_flight flight[FLIGHTS];
};

/* Reads the state in flight of a clock. Returns false if it has too many entries. */
bool in_flight_look(const struct clock *clock, struct in_flight *flight);
bool in_flight_is_nothing(const struct clock *clock);
/* Returns the stored state that equals this state. Stores it if it is new. NULL: there
 * is no room. */
const struct in_flight *in_flight_named(struct in_flight_table *flights,
                                        const struct in_flight *flight);
/* in_flight_init must be called first. The array flight need not be zeroed. */
void in_flight_init(struct in_flight_table *flights);
void in_flight_clear(struct in_flight_table *flights);
/* Writes a state to the fields of a clock from which in_flight_look reads it. */
void in_flight_show(struct clock *clock, const struct in_flight *flight);

#endif
