/* move.c - executes vector instructions that move elements within a vector: reverse,
 * mask, merge, compress.
 */
#include "vm/direct.h"
#include "vm/vector.h"

#include <string.h>

/* ---- Reverse ------------------------------------------------------------ */

static void reverse_words(c205_word *c, const c205_word *a, size_t n)
{
    for (size_t i = 0; i < n; i++)
        c[i] = a[n - 1 - i];
}

c205_trap execute_vector_reverse(struct c205 *machine, const struct decoded *decoded)
{
    struct stream stream;
    c205_word words[CHUNK];
    c205_trap trap = stream_open(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    if (operands_overlap(&stream.a.vector, &stream.result))
        stream.chunk = 1;
    for (size_t first = stream.turn.first, n; first < stream.turn.end; first += n) {
        n = stream_next(&stream, first);
        reverse_words(words, source_read(&stream.a, stream.n - first - n, n), n);
        result_store(machine, &stream.result, &stream.control, first, words, n);
    }
    return stream_end(&stream);
}

/* ---- Mask, merge -------------------------------------------------------- */

/* A mask or merge instruction. The control vector selects the source of each element,
 * and all elements of the result are stored. Mask takes the element at the same index
 * of the source, merge takes the next element of the source. */
struct choice {
    struct stream stream;
    size_t next_a, next_b;
};

typedef void chooser(struct choice *choice, size_t first, size_t n,
                     const uint64_t *from_a, c205_word *words);

static void mask_words(struct choice *choice, size_t first, size_t n,
                       const uint64_t *from_a, c205_word *words)
{
    memcpy(words, source_read(&choice->stream.b, first, n), n * sizeof *words);
    lanes_store_masked(words, source_read(&choice->stream.a, first, n), from_a, n);
}

static void merge_words(struct choice *choice, size_t first, size_t n,
                        const uint64_t *from_a, c205_word *words)
{
    size_t count = count_ones(from_a, n);
    const c205_word *a = source_read(&choice->stream.a, choice->next_a, count);
    const c205_word *b = source_read(&choice->stream.b, choice->next_b, n - count);
    (void)first;
    for (size_t i = 0; i < n; i++)
        words[i] = bit_at(from_a, i) ? *a++ : *b++;
    choice->next_a += count;
    choice->next_b += n - count;
}

static c205_trap store_chosen(struct choice *choice, chooser *chosen)
{
    struct stream *stream = &choice->stream;
    struct resume_state *resume = &stream->machine->resume;
    c205_word words[CHUNK];
    uint64_t from_a[CHUNK_WORDS];
    choice->next_a = resume->count[0];
    choice->next_b = resume->count[1];
    for (size_t first = stream->turn.first, n; first < stream->turn.end; first += n) {
        n = stream_next(stream, first);
        control_read(&stream->control, first, n, from_a);
        chosen(choice, first, n, from_a, words);
        vector_write(&stream->machine->memory, &stream->result, first, words, n);
    }
    c205_trap trap = stream_end(stream);
    if (trap != C205_TRAP_NONE) {
        resume->count[0] = choice->next_a;
        resume->count[1] = choice->next_b;
    }
    return trap;
}

/* Executes a mask in the host's memory. Returns false, without effect, if the operands
 * are not simple (direct.h). */
static bool mask_directly(struct c205 *machine, const struct decoded *decoded)
{
    c205_word a = machine->slot[decoded->a], b = machine->slot[decoded->b];
    c205_word c = machine->slot[decoded->fields.c];
    c205_word z = machine->slot[decoded->z];
    size_t n = direct_length(c), bytes = n * sizeof c;
    uint8_t g = decoded->fields.g;
    uint64_t blocked = g & C205_G_ZEROS ? UINT64_MAX : 0;
    bool fill_a = g & C205_G_BROADCAST_A, fill_b = g & C205_G_BROADCAST_B;
    c205_word space_a[CHUNK], space_b[CHUNK];
    uint64_t from_a[CHUNK_WORDS];
    if (!decoded->plain || !direct_turn(machine, n))
        return false;
    const c205_word *from = fill_a ? space_a : direct_read(machine, a, n);
    const c205_word *other = fill_b ? space_b : direct_read(machine, b, n);
    struct direct_bits control = direct_bits(machine, z, n, false);
    c205_word *to = direct_write(machine, c, n);
    if (!from || !other || !control.word || !to
        || (!fill_a && direct_meets(to, bytes, from, bytes))
        || (!fill_b && direct_recurs(to, other, n))
        || direct_meets(to, bytes, control.word, direct_bytes(control, n)))
        return false;
    if (fill_a)
        lanes_fill(space_a, a, min_size(n, CHUNK));
    if (fill_b)
        lanes_fill(space_b, b, min_size(n, CHUNK));
    for (size_t first = 0, some; first < n; first += some) {
        some = min_size(n - first, CHUNK);
        direct_read_control(control, blocked, first, from_a, some);
        memmove(to + first, other + (fill_b ? 0 : first), some * sizeof *to);
        lanes_store_masked(to + first, from + (fill_a ? 0 : first), from_a, some);
    }
    if (!fill_a)
        machine_touch(machine, LOW(a), (uint64_t)n * WORD_BITS);
    if (!fill_b)
        machine_touch(machine, LOW(b), (uint64_t)n * WORD_BITS);
    machine_touch(machine, LOW(z), n);
    machine_touch_result(machine, LOW(c), (uint64_t)n * WORD_BITS);
    machine->effect.elements = n;
    return true;
}

c205_trap execute_vector_mask(struct c205 *machine, const struct decoded *decoded)
{
    struct choice choice;
    if (mask_directly(machine, decoded))
        return C205_TRAP_NONE;
    c205_trap trap = stream_open(&choice.stream, machine, decoded);
    return trap == C205_TRAP_NONE ? store_chosen(&choice, mask_words) : trap;
}

/* Executes a merge. Its sources advance more slowly than its result, so overlapping
 * operands are processed one element at a time. */
c205_trap execute_vector_merge(struct c205 *machine, const struct decoded *decoded)
{
    struct choice choice;
    struct stream *stream = &choice.stream;
    c205_trap trap = stream_open(stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    if (operands_overlap(&stream->a.vector, &stream->result)
        || operands_overlap(&stream->b.vector, &stream->result))
        stream->chunk = 1;
    return store_chosen(&choice, merge_words);
}

/* ---- Compress ----------------------------------------------------------- */

/* The state of a compress instruction. The control vector, or a comparison with B,
 * selects the elements that are kept. The result of the comparison is stored as
 * well. */
struct sieve {
    struct stream stream;
    lanes_compare *comparison; /* NULL: the control vector selects */
    struct vector order;       /* destination of the comparison bits */
    size_t kept;               /* elements kept so far */
};

static const c205_word *sieve_words(struct sieve *sieve, size_t first, size_t n,
                                    uint64_t *keep)
{
    struct stream *stream = &sieve->stream;
    const c205_word *a = source_read(&stream->a, first, n);
    if (sieve->comparison)
        sieve->comparison(keep, a, source_read(&stream->b, first, n), n);
    else
        control_read(&stream->control, first, n, keep);
    return a;
}

/* Returns the number of elements that all turns of the instruction keep. */
static size_t count_kept(struct sieve *sieve)
{
    const struct turn *turn = &sieve->stream.turn;
    uint64_t keep[CHUNK_WORDS];
    size_t kept = sieve->kept;
    for (size_t first = turn->first, n; first < turn->n; first += n) {
        n = min_size(turn->n - first, CHUNK);
        sieve_words(sieve, first, n, keep);
        kept += count_ones(keep, n);
    }
    return kept;
}

static void store_kept(struct sieve *sieve)
{
    const struct turn *turn = &sieve->stream.turn;
    struct memory *memory = &sieve->stream.machine->memory;
    c205_word words[CHUNK];
    uint64_t keep[CHUNK_WORDS];
    for (size_t first = turn->first, n; first < turn->end; first += n) {
        n = stream_next(&sieve->stream, first);
        const c205_word *a = sieve_words(sieve, first, n, keep);
        size_t count = compress_words(words, a, keep, n);
        vector_write(memory, &sieve->stream.result, sieve->kept, words, count);
        if (sieve->comparison)
            memory_write_bits(memory, vector_at(&sieve->order, first), keep, n);
        sieve->kept += count;
    }
}

static bool all_ahead(const struct sieve *sieve)
{
    const struct stream *stream = &sieve->stream;
    const struct vector *c = &stream->result, *order = &sieve->order;
    return operand_is_ahead(&stream->a.vector, c)
           && operand_is_ahead(&stream->b.vector, c)
           && operand_is_ahead(&stream->control.vector, c)
           && !operands_overlap(&stream->a.vector, order)
           && !operands_overlap(&stream->b.vector, order)
           && !operands_overlap(c, order);
}

/* Claims the result. Requires room for all n elements if the result overlaps unread
 * operands, because the kept elements cannot be counted in advance. Otherwise room for
 * the kept elements suffices; they are counted only if there is no room for n. */
static c205_trap claim_kept(struct sieve *sieve)
{
    struct stream *stream = &sieve->stream;
    struct c205 *machine = stream->machine;
    unsigned touches = machine->effect.touch_count;
    sieve->kept = min_size(machine->resume.count[0], stream->turn.first);
    stream->result.length = stream->n;
    stream->chunk = all_ahead(sieve) ? CHUNK : 1;
    c205_trap trap = claim_vector(machine, &stream->result, stream->n, true);
    if (trap != C205_TRAP_NONE && stream->chunk == CHUNK) {
        machine->fault = 0;
        trap = claim_vector(machine, &stream->result, count_kept(sieve), true);
    }
    machine->effect.touch_count = touches;
    return trap;
}

static c205_trap finish_sieve(struct sieve *sieve, const struct decoded *decoded)
{
    struct c205 *machine = sieve->stream.machine;
    store_kept(sieve);
    c205_trap trap = stream_end(&sieve->stream);
    if (trap != C205_TRAP_NONE) {
        machine->resume.count[0] = sieve->kept;
        return trap;
    }
    if (sieve->kept > 0)
        machine_touch_result(machine, sieve->stream.result.address,
                             (uint64_t)sieve->kept * sieve->stream.result.width);
    machine->slot[decoded->result[0]] = with_length(machine->slot[decoded->c],
                                                    sieve->kept);
    return C205_TRAP_NONE;
}

/* Executes a compress in the host's memory. Returns false, without effect, if the
 * operands are not simple (direct.h). */
static bool compress_directly(struct c205 *machine, const struct decoded *decoded)
{
    c205_word a = machine->slot[decoded->a], c = machine->slot[decoded->c];
    c205_word z = machine->slot[decoded->z];
    size_t n = direct_length(z), bytes = n * sizeof c, kept = 0;
    uint64_t blocked = decoded->fields.g & C205_G_ZEROS ? UINT64_MAX : 0;
    uint64_t keep[CHUNK_WORDS];
    c205_word space[CHUNK];
    if (!decoded->plain || !direct_turn(machine, n)
        || decoded->fields.g & C205_G_BROADCAST_A)
        return false;
    const c205_word *from = direct_read(machine, a, n);
    struct direct_bits control = direct_bits(machine, z, n, false);
    c205_word *to = direct_write(machine, c, n);
    if (!from || !control.word || !to || direct_recurs(to, from, n)
        || direct_meets(to, bytes, control.word, direct_bytes(control, n)))
        return false;
    for (size_t first = 0, some; first < n; first += some) {
        some = min_size(n - first, CHUNK);
        direct_read_control(control, blocked, first, keep, some);
        size_t count = compress_words(space, from + first, keep, some);
        memcpy(to + kept, space, count * sizeof *to);
        kept += count;
    }
    machine_touch(machine, LOW(a), (uint64_t)n * WORD_BITS);
    machine_touch(machine, LOW(z), n);
    if (kept > 0)
        machine_touch_result(machine, LOW(c), (uint64_t)kept * WORD_BITS);
    machine->effect.elements = n;
    machine->slot[decoded->result[0]] = with_length(c, kept);
    return true;
}

c205_trap execute_vector_compress(struct c205 *machine, const struct decoded *decoded)
{
    struct sieve sieve;
    struct stream *stream = &sieve.stream;
    if (compress_directly(machine, decoded))
        return C205_TRAP_NONE;
    sieve.comparison = NULL;
    sieve.order = describe_bits(0);
    c205_trap trap = stream_describe(stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    stream->n = stream->control.vector.length;
    trap = stream_claim_sources(stream);
    if (trap == C205_TRAP_NONE)
        trap = claim_kept(&sieve);
    return trap == C205_TRAP_NONE ? finish_sieve(&sieve, decoded) : trap;
}

c205_trap execute_arithmetic_compress(struct c205 *machine,
                                      const struct decoded *decoded)
{
    struct sieve sieve;
    struct stream *stream = &sieve.stream;
    sieve.comparison = operation_of(decoded)->compare;
    c205_trap trap = stream_describe(stream, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = stream_take_length(stream, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    sieve.order = stream->control.vector;
    sieve.order.length = stream->n;
    stream->control.present = false;
    trap = stream_claim_sources(stream);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(machine, &sieve.order, stream->n, true);
    if (trap == C205_TRAP_NONE)
        trap = claim_kept(&sieve);
    return trap == C205_TRAP_NONE ? finish_sieve(&sieve, decoded) : trap;
}
