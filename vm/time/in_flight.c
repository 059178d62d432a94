/* in_flight.c - stores the states in flight of the scalar unit in a hash table, and
 * reads and writes them.
 */
#include "vm/time/in_flight.h"

#include "vm/hash.h"
#include "vm/time/clock_parts.h"

#include <string.h>

/* ---- The hash table ----------------------------------------------------- */

static size_t pending_count(const struct in_flight *flight)
{
    return flight->registers + flight->units + flight->loads;
}

static uint64_t hash_flight(const struct in_flight *flight)
{
    uint64_t hash = hash_word(HASH_BEGIN, flight->results_done);
    hash = hash_word(hash, flight->loads_done);
    hash = hash_word(hash,
                     flight->registers << 16 | flight->units << 8 | flight->loads);
    for (size_t i = 0; i < pending_count(flight); i++)
        hash = hash_word(hash, (uint64_t)flight->pending[i].clocks << 32
                                   | (uint64_t)flight->pending[i].place << 16
                                   | flight->pending[i].awaits);
    return hash;
}

static bool same_flight(const struct in_flight *one, const struct in_flight *other)
{
    return one->results_done == other->results_done
           && one->loads_done == other->loads_done && one->registers == other->registers
           && one->units == other->units && one->loads == other->loads
           && memcmp(one->pending, other->pending,
                     pending_count(one) * sizeof *one->pending)
                  == 0;
}

const struct in_flight *in_flight_named(struct in_flight_table *flights,
                                        const struct in_flight *flight)
{
    struct in_flight **first = &flights->hashed[hash_flight(flight) % FLIGHTS];
    struct in_flight *known = *first;
    while (known && !same_flight(known, flight))
        known = known->chained;
    if (known)
        return known;
    if (flights->count == FLIGHTS)
        return NULL;
    known = &flights->flight[flights->count++];
    *known = *flight;
    known->chained = *first;
    return *first = known;
}

void in_flight_init(struct in_flight_table *flights)
{
    memset(&flights->nothing, 0, sizeof flights->nothing);
    in_flight_clear(flights);
}

void in_flight_clear(struct in_flight_table *flights)
{
    memset(flights->hashed, 0, sizeof flights->hashed);
    flights->count = 0;
}

/* ---- Reading and writing ------------------------------------------------ */

static uint64_t from_now(const struct clock *clock, uint64_t time)
{
    return time > clock->now ? time - clock->now : 0;
}

/* Adds a pending entry. Returns false if the table is full or the time is too long. */
static bool add_pending(struct in_flight *flight, size_t *count, size_t place,
                        uint64_t clocks, unsigned awaits)
{
    size_t i = flight->registers + flight->units + flight->loads;
    if (clocks == 0)
        return true;
    if (i == MAX_PENDING || clocks > UINT32_MAX)
        return false;
    struct pending pending = { (uint32_t)clocks, (uint16_t)place, (uint16_t)awaits };
    flight->pending[i] = pending;
    ++*count;
    if (flight->latest < clocks)
        flight->latest = clocks;
    return true;
}

bool in_flight_look(const struct clock *clock, struct in_flight *flight)
{
    size_t loads = (size_t)clock->loads_in_flight;
    bool fits = true;
    flight->results_done = from_now(clock, clock->results_done);
    flight->loads_done = from_now(clock, clock->loads_done);
    flight->latest = flight->results_done;
    flight->registers = flight->units = flight->loads = 0;
    for (size_t i = 0; i < SLOTS && fits; i++)
        fits = add_pending(flight, &flight->registers, i,
                           from_now(clock, clock->ready[i]), clock->awaits[i]);
    for (size_t i = 0; i < C205_UNITS && fits; i++)
        fits = add_pending(flight, &flight->units, i,
                           from_now(clock, clock->free_at[i]), 0);
    for (size_t i = 0; i < loads && fits; i++)
        fits = add_pending(flight, &flight->loads, i,
                           from_now(clock, clock->load_end[(clock->load + i) % loads]),
                           0);
    return fits;
}

bool in_flight_is_nothing(const struct clock *clock)
{
    bool nothing = clock->results_done <= clock->now;
    for (size_t i = 0; i < C205_UNITS; i++)
        nothing = nothing && clock->free_at[i] <= clock->now;
    return nothing;
}

void in_flight_show(struct clock *clock, const struct in_flight *flight)
{
    const struct pending *pending = flight->pending;
    clock->results_done = clock->now + flight->results_done;
    clock->loads_done = clock->now + flight->loads_done;
    for (size_t i = 0; i < flight->registers; i++, pending++) {
        clock->ready[pending->place] = clock->now + pending->clocks;
        clock->awaits[pending->place] = (uint8_t)pending->awaits;
    }
    for (size_t i = 0; i < flight->units; i++, pending++)
        clock->free_at[pending->place] = clock->now + pending->clocks;
    memset(clock->load_end, 0, sizeof clock->load_end);
    clock->load = 0;
    for (size_t i = 0; i < flight->loads; i++, pending++)
        clock->load_end[pending->place] = clock->now + pending->clocks;
}
