/* flight.h - all that is in flight in the scalar unit, by name: what has the
 * same registers, units and loads pending for as long is one flight.
 */
#ifndef C205_FLIGHT_H
#define C205_FLIGHT_H

#include "vm/decode.h"
#include "vm/time/clock.h"

enum { MAX_PENDING = 48, FLIGHTS = 1 << (TABLE_BITS - 3) };

/* A register, a unit or a load, and how long it takes yet. */
struct pending {
    uint32_t clocks;
    uint16_t place;
    uint16_t awaits; /* registers: the cause of waiting for it */
};

/* In clocks from now. */
struct flight {
    uint64_t results_done, loads_done;
    uint64_t latest;                     /* when the last of it is done */
    size_t registers, units, loads;      /* so many of each are pending .. */
    struct pending pending[MAX_PENDING]; /* .. in this order, each by its
                                             place, loads from the oldest */
    struct flight *chained;              /* the next with the same hash */
};

struct flights {
    size_t count;
    struct flight *hashed[FLIGHTS];
    struct flight nothing;
    struct flight flight[FLIGHTS];
};

/* What is in flight; false: too much. */
bool flight_look(const struct clock *clock, struct flight *flight);
bool flight_is_nothing(const struct clock *clock);
/* The one of all that are the same; NULL: there is no room for it. */
const struct flight *flight_named(struct flights *flights, const struct flight *flight);
/* Before all else; the flights themselves need no zeros. */
void flights_init(struct flights *flights);
void flights_forget(struct flights *flights);
/* Put it back to where flight_look looks. */
void flight_show(struct clock *clock, const struct flight *flight);

#endif
