/* vector.h - what the vector instructions share: two sources, a control
 * vector and a result that run side by side in chunks.
 */
#ifndef C205_VECTOR_H
#define C205_VECTOR_H

#include "vm/operand.h"

struct stream {
    struct c205 *machine;
    struct source a, b;
    struct control control;
    struct vector result;
    size_t n;         /* elements */
    struct turn turn; /* those of them that are gone through this time */
    size_t chunk;     /* at most so many at once */
    bool scans_b;     /* all of B is read for each element of A */
};

/* What is done with the elements: one of these. */
struct operation {
    lanes_unary *unary;
    lanes_binary *binary;
    lanes_compare *compare;
};

/* The function on spans of the size that the instruction works on. */
#define SIZED(decoded, name) \
    ((decoded)->fields.g & C205_G_HALF ? halves_##name : lanes_##name)

/* Describe the operands; n is the length of the result. */
c205_trap stream_describe(struct stream *stream, struct c205 *machine,
                          const struct decoded *decoded);
/* The same for results that are registers: n is the length of a source. */
c205_trap stream_describe_sources(struct stream *stream, struct c205 *machine,
                                  const struct decoded *decoded);
/* n := the length of A, or that of B where A is broadcast. */
c205_trap stream_take_length(struct stream *stream, const struct decoded *decoded);
/* Claim what will be read and written, and settle the chunk. */
c205_trap stream_claim(struct stream *stream);
/* .. where the result is a register, or not stored. */
c205_trap stream_claim_sources(struct stream *stream);
/* Describe and claim. */
c205_trap stream_open(struct stream *stream, struct c205 *machine,
                      const struct decoded *decoded);
/* .. where all of B is read for each element of A. */
c205_trap stream_open_scan(struct stream *stream, struct c205 *machine,
                           const struct decoded *decoded);

/* Tell the clock of n elements of a result how many must wait for an earlier
 * one, which one of these sources reads; MAX_SOURCES of them, a pair's. */
enum { MAX_SOURCES = 4 };
void record_recurrence(struct c205 *machine, const struct vector *result, size_t n,
                       const struct source *const *sources, size_t count);

/* How many elements come next. */
static inline size_t stream_next(const struct stream *stream, size_t first)
{
    return least(stream->turn.end - first, stream->chunk);
}

/* All that come next are done: NONE, or CLOCK_LIMIT if there are more. */
static inline c205_trap stream_end(struct stream *stream)
{
    return machine_end_turn(stream->machine, &stream->turn);
}

/* words := operation(a, b); data flags come from the elements permitted
 * (NULL: all). */
void operate(struct c205 *machine, const struct operation *operation, c205_word *words,
             const c205_word *a, const c205_word *b, size_t n,
             const uint64_t *permitted);

/* n elements from first on: sources read, result stored.  in_place: it may be
 * made where it belongs, as far as the stream's own sources allow. */
void stream_step(struct stream *stream, const struct operation *operation, size_t first,
                 size_t n, bool in_place);

/* What the instruction does with each element, in its size. */
const struct operation *operation_of(const struct decoded *decoded);

#endif
