/* search.c - for each element of one vector, where in another it first
 * compares.
 */
#include "vector.h"

/* How many words of B are compared at once. */
static size_t scan_next(const struct stream *stream, size_t first)
{
    size_t left = stream->b.vector.length - first;
    return left < CHUNK ? left : CHUNK;
}

/* The index of the first B that compares with the word, or the length. */
static size_t search_for(struct stream *stream, c205_word word,
                         lanes_compare *comparison)
{
    c205_word wanted[CHUNK];
    uint64_t bits[CHUNK_WORDS];
    size_t first = 0, place = 0, n = scan_next(stream, 0);
    fill_words(wanted, word, n);
    for (; n > 0 && place == first; n = scan_next(stream, first)) {
        comparison(bits, wanted, source_read(&stream->b, first, n), n);
        place += first_one(bits, n);
        first += n;
    }
    return place;
}

/* The machine stops at the element that it looked for. */
static size_t compared(const struct stream *stream, size_t place)
{
    return place < stream->b.vector.length ? place + 1 : place;
}

static c205_trap search(struct c205 *machine, const struct decoded *decoded,
                        lanes_compare *comparison)
{
    struct stream stream;
    c205_word places[CHUNK];
    c205_trap trap = stream_open_scan(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    machine->effect.elements = 0;
    for (size_t first = 0, n; first < stream.n; first += n) {
        n = stream_next(&stream, first);
        const c205_word *a = source_read(&stream.a, first, n);
        for (size_t i = 0; i < n; i++) {
            places[i] = search_for(&stream, a[i], comparison);
            machine->effect.elements += compared(&stream, (size_t)places[i]);
        }
        result_store(machine, &stream.result, &stream.control, first, places,
                     n);
    }
    return C205_TRAP_NONE;
}

#define SEARCH(name) \
    c205_trap execute_search_##name(struct c205 *machine, \
                                    const struct decoded *decoded) \
    { \
        return search(machine, decoded, lanes_##name); \
    }
SEARCH(equal)
SEARCH(not_equal)
SEARCH(not_less)
SEARCH(less)
