/* vector.h - the common part of the vector instructions. They process two sources, a
 * control vector and a result in chunks. Functions that return a trap return NONE on
 * success.
 */
#ifndef C205_VECTOR_H
#define C205_VECTOR_H

#include "vm/operand.h"

struct stream {
    struct c205 *machine;
    struct source a, b;
    struct control control;
    struct vector result;
    size_t n;         /* number of elements */
    struct turn turn; /* the part that is processed now */
    size_t chunk;     /* maximum number of elements at once */
    bool scans_b;     /* each element of A reads all of B */
};

/* The operation on the elements. Exactly one of these pointers is not NULL. */
struct operation {
    lanes_unary *unary;
    lanes_binary *binary;
    lanes_compare *compare;
};

/* Returns the function of lanes.h for the element size of the instruction. */
#define SIZED(decoded, name) \
    ((decoded)->fields.g & C205_G_HALF ? halves_##name : lanes_##name)

/* Evaluates the descriptors of the operands. Sets n to the length of the result. */
c205_trap stream_describe(struct stream *stream, struct c205 *machine,
                          const struct decoded *decoded);
/* Evaluates the descriptors of the sources of an instruction whose results are
 * registers. Sets n to the length of a source. */
c205_trap stream_describe_sources(struct stream *stream, struct c205 *machine,
                                  const struct decoded *decoded);
/* Sets n to the length of A, or to the length of B if A is broadcast. */
c205_trap stream_take_length(struct stream *stream, const struct decoded *decoded);
/* Claims all operands (operand.h). Sets stream->chunk to the number of elements that
 * may be read before the first result is stored. */
c205_trap stream_claim(struct stream *stream);
/* Claims the sources of an instruction whose result is a register or is not stored, and
 * sets stream->chunk. */
c205_trap stream_claim_sources(struct stream *stream);
/* Evaluates the descriptors of all operands of an instruction and claims their
 * memory. */
c205_trap stream_open(struct stream *stream, struct c205 *machine,
                      const struct decoded *decoded);
/* Like stream_open, for an instruction that reads all of B for each element of A. */
c205_trap stream_open_scan(struct stream *stream, struct c205 *machine,
                           const struct decoded *decoded);

/* Records in the effect how many of n elements of a result must wait for an earlier
 * result that a source reads. A linked pair has MAX_SOURCES sources. */
enum { MAX_SOURCES = 4 };
void record_recurrence(struct c205 *machine, const struct vector *result, size_t n,
                       const struct source *const *sources, size_t count);

/* Returns the number of elements of the next chunk. */
static inline size_t stream_next(const struct stream *stream, size_t first)
{
    return min_size(stream->turn.end - first, stream->chunk);
}

/* Ends the turn. Returns NONE if all elements are done, and CLOCK_LIMIT otherwise. */
static inline c205_trap stream_end(struct stream *stream)
{
    return machine_end_turn(stream->machine, &stream->turn);
}

/* Computes words := operation(a, b). Only the permitted elements set data flags (NULL:
 * all). */
void operate(struct c205 *machine, const struct operation *operation, c205_word *words,
             const c205_word *a, const c205_word *b, size_t n,
             const uint64_t *permitted);

/* Processes n elements from first on: reads the sources and stores the result.
 * in_place: computes the result in its final place if the sources of the stream permit
 * it. */
void stream_step(struct stream *stream, const struct operation *operation, size_t first,
                 size_t n, bool in_place);

/* Returns the operation of an instruction, for words or for half words as its G bits
 * specify. */
const struct operation *operation_of(const struct decoded *decoded);

#endif
