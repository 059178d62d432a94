/* search.c - searches a vector, for each element of another vector, for the first
 * element for which a comparison holds.
 */
#include "vm/vector.h"

/* Returns the number of words of B in the next comparison. */
static size_t scan_next(const struct stream *stream, size_t first)
{
    return min_size(stream->b.vector.length - first, CHUNK);
}

/* Returns the index of the first element of B for which the comparison holds, or the
 * length of B. */
static size_t search_for(struct stream *stream, c205_word word,
                         lanes_compare *comparison)
{
    c205_word wanted[CHUNK];
    uint64_t bits[CHUNK_WORDS];
    size_t first = 0, place = 0, n = scan_next(stream, 0);
    lanes_fill(wanted, word, n);
    for (; n > 0 && place == first; n = scan_next(stream, first)) {
        comparison(bits, wanted, source_read(&stream->b, first, n), n);
        place += first_one(bits, n);
        first += n;
    }
    return place;
}

/* Returns the number of comparisons that the machine makes. It stops at the element
 * found. */
static size_t compared(const struct stream *stream, size_t place)
{
    return place < stream->b.vector.length ? place + 1 : place;
}

/* Finds the indices for n words, or for fewer words if the turn ends at the clock
 * limit. Returns the number of indices. */
static size_t search_some(struct stream *stream, const c205_word *a, size_t n,
                          lanes_compare *comparison, c205_word *places)
{
    struct c205 *machine = stream->machine;
    size_t *made = &machine->effect.elements; /* number of comparisons */
    for (size_t i = 0; i < n; i++) {
        places[i] = search_for(stream, a[i], comparison);
        size_t more = compared(stream, (size_t)places[i]);
        if (*made > machine->allowed || more > machine->allowed - *made)
            return i;
        *made += more;
    }
    return n;
}

c205_trap execute_search(struct c205 *machine, const struct decoded *decoded)
{
    lanes_compare *comparison = operation_of(decoded)->compare;
    struct stream stream;
    c205_word places[CHUNK];
    c205_trap trap = stream_open_scan(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    size_t first = stream.turn.first, n = 0, done = 0;
    machine->effect.elements = machine->resume.count[0];
    stream.turn.end = stream.n;
    for (; first < stream.n && done == n; first += done) {
        n = stream_next(&stream, first);
        done = search_some(&stream, source_read(&stream.a, first, n), n, comparison,
                           places);
        result_store(machine, &stream.result, &stream.control, first, places, done);
    }
    stream.turn.end = first;
    trap = stream_end(&stream);
    if (trap != C205_TRAP_NONE)
        machine->resume.count[0] = machine->effect.elements;
    return trap;
}
