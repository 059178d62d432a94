/* in_flight.h - all that is in flight in the scalar unit, by name: what has the
 * same registers, units and loads pending for as long is one flight.
 */
#ifndef C205_IN_FLIGHT_H
#define C205_IN_FLIGHT_H

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
struct in_flight {
    uint64_t results_done, loads_done;
    uint64_t latest;                     /* when the last of it is done */
    size_t registers, units, loads;      /* so many of each are pending .. */
    struct pending pending[MAX_PENDING]; /* .. in this order, each by its
                                             place, loads from the oldest */
    struct in_flight *chained;           /* the next with the same hash */
};

struct in_flight_table {
    size_t count;
    struct in_flight *hashed[FLIGHTS];
    struct in_flight nothing;
    struct in_flight flight[FLIGHTS];
};

/* What is in flight; false: too much. */
bool in_flight_look(const struct clock *clock, struct in_flight *flight);
bool in_flight_is_nothing(const struct clock *clock);
/* The one of all that are the same; NULL: there is no room for it. */
const struct in_flight *in_flight_named(struct in_flight_table *flights,
                                        const struct in_flight *flight);
/* Before all else; the flights themselves need no zeros. */
void in_flight_init(struct in_flight_table *flights);
void in_flight_clear(struct in_flight_table *flights);
/* Put it back to where in_flight_look looks. */
void in_flight_show(struct clock *clock, const struct in_flight *flight);

#endif
