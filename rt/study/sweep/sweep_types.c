/* sweep_types.c - the list of sweep types, and their lengths. */
#include "rt/study/sweep/sweep_types.h"

#include <string.h>

const struct sweep_kind *const sweep_kinds[] = { &sweep_queue, &sweep_pipes,
                                                 &sweep_hits, &sweep_length, NULL };

static size_t usual_lengths(size_t most, size_t lengths[MAX_SWEEP_LENGTHS])
{
    size_t count = 0;
    for (size_t length = 1; length < MAX_TRACE_QUEUE && length <= most; length *= 2) {
        lengths[count++] = length;
        if (length < TRACE_QUEUE && 2 * length > TRACE_QUEUE && TRACE_QUEUE <= most)
            lengths[count++] = TRACE_QUEUE;
    }
    if (MAX_TRACE_QUEUE <= most)
        lengths[count++] = MAX_TRACE_QUEUE;
    return count;
}

size_t sweep_lengths(const struct sweep *sweep, size_t most,
                     size_t lengths[MAX_SWEEP_LENGTHS])
{
    if (sweep->length_count == 0)
        return usual_lengths(most, lengths);
    memcpy(lengths, sweep->lengths, sweep->length_count * sizeof *lengths);
    return sweep->length_count;
}

const struct sweep_measure *sweep_best(const struct sweep *sweep)
{
    const struct sweep_measure *best = &sweep->measures[0];
    for (size_t i = 1; i < sweep->count; i++)
        if (sweep_cost(&sweep->measures[i], SWEEP_QUEUED)
            < sweep_cost(best, SWEEP_QUEUED))
            best = &sweep->measures[i];
    return best;
}

const struct sweep_measure *sweep_with_queue(const struct sweep *sweep, size_t queue)
{
    for (size_t i = 0; i < sweep->count; i++)
        if (sweep->measures[i].point.trace.queue == queue)
            return &sweep->measures[i];
    return NULL;
}
