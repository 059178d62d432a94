/* reduce.c - executes vector instructions that reduce a vector to one number, in one or
 * two registers.
 */
#include "vm/vector.h"

static c205_trap open_sources(struct stream *stream, struct c205 *machine,
                              const struct decoded *decoded)
{
    c205_trap trap = stream_describe_sources(stream, machine, decoded);
    return trap == C205_TRAP_NONE ? stream_claim_sources(stream) : trap;
}

/* ---- Sum, product, dot -------------------------------------------------- */

/* The intermediate result of a reduction, in two parts, which are not normalised. A
 * product uses the upper part only. */
struct parts {
    c205_word upper, lower;
};

/* The functions with which reductions compute, for words or for half words. */
struct arithmetic {
    c205_word one;
    arith_binary *add_upper, *add_lower;
    lanes_binary *multiply_upper, *multiply_lower;
    lanes_reduction *product;
};
static const struct arithmetic of_words = { C205_ONE,
                                            arith_add_upper,
                                            arith_add_lower,
                                            lanes_multiply_upper,
                                            lanes_multiply_lower,
                                            lanes_product };
static const struct arithmetic of_halves = {
    C205_HALF_ONE,         half_add_upper,        half_add_lower,
    halves_multiply_upper, halves_multiply_lower, halves_product
};

typedef void folding(const struct arithmetic *arithmetic, struct parts *parts,
                     const c205_word *a, const c205_word *b, size_t n, uint64_t *flags);

struct reduction {
    const struct arithmetic *arithmetic;
    folding *fold;
    struct parts start; /* the result if there are no elements */
    bool of_pairs;      /* the reduction reads B, too */
};

static void fold_sum(const struct arithmetic *arithmetic, struct parts *parts,
                     const c205_word *a, const c205_word *b, size_t n, uint64_t *flags)
{
    struct parts sum = *parts;
    (void)b;
    for (size_t i = 0; i < n; i++) {
        c205_word rest = arithmetic->add_lower(sum.upper, a[i], flags);
        sum.upper = arithmetic->add_upper(sum.upper, a[i], flags);
        sum.lower = arithmetic->add_upper(sum.lower, rest, flags);
    }
    *parts = sum;
}

/* Adds the upper part of each product to the sum, then its lower part to the lower part
 * of the sum. */
static void fold_dot(const struct arithmetic *arithmetic, struct parts *parts,
                     const c205_word *a, const c205_word *b, size_t n, uint64_t *flags)
{
    c205_word upper[CHUNK], lower[CHUNK];
    arithmetic->multiply_upper(upper, a, b, n, flags);
    arithmetic->multiply_lower(lower, a, b, n, flags);
    for (size_t i = 0; i < n; i++) {
        fold_sum(arithmetic, parts, &upper[i], NULL, 1, flags);
        parts->lower = arithmetic->add_upper(parts->lower, lower[i], flags);
    }
}

static void fold_product(const struct arithmetic *arithmetic, struct parts *parts,
                         const c205_word *a, const c205_word *b, size_t n,
                         uint64_t *flags)
{
    (void)b;
    arithmetic->product(&parts->upper, a, n, flags);
}

/* The permitted elements of a chunk, packed, in their order. */
struct some {
    c205_word a[CHUNK], b[CHUNK];
};

static size_t take_permitted(const struct stream *stream, size_t first, size_t n,
                             struct some *some, const c205_word **a,
                             const c205_word **b)
{
    uint64_t permitted[CHUNK_WORDS];
    if (!stream->control.present)
        return n;
    control_read(&stream->control, first, n, permitted);
    bool same = *b == *a;
    if (!same)
        compress_words(some->b, *b, permitted, n);
    n = compress_words(some->a, *a, permitted, n);
    *a = some->a;
    *b = same ? some->a : some->b;
    return n;
}

/* Reduces the elements of this turn, starting with the start value or with the parts
 * that an interruption saved. Saves the parts if the turn ends before the last
 * element. */
static c205_trap run_reduction(struct stream *stream, const struct reduction *reduction,
                               struct parts *parts)
{
    struct resume_state *resume = &stream->machine->resume;
    struct parts kept = { resume->word, resume->lower };
    struct some some;
    *parts = stream->turn.first > 0 ? kept : reduction->start;
    for (size_t first = stream->turn.first, n; first < stream->turn.end; first += n) {
        n = stream_next(stream, first);
        const c205_word *a = source_read(&stream->a, first, n);
        const c205_word *b = reduction->of_pairs ? source_read(&stream->b, first, n)
                                                 : a;
        size_t count = take_permitted(stream, first, n, &some, &a, &b);
        reduction->fold(reduction->arithmetic, parts, a, b, count,
                        &stream->machine->data_flags);
    }
    c205_trap trap = stream_end(stream);
    if (trap != C205_TRAP_NONE) {
        resume->word = parts->upper;
        resume->lower = parts->lower;
    }
    return trap;
}

static c205_trap reduce(struct c205 *machine, const struct decoded *decoded,
                        folding *fold, bool of_pairs, struct parts *parts)
{
    bool half = decoded->width[OPERAND_A] == HALF_BITS;
    struct reduction reduction = { half ? &of_halves : &of_words,
                                   fold,
                                   { C205_MACHINE_ZERO, C205_MACHINE_ZERO },
                                   of_pairs };
    struct stream stream;
    if (fold == fold_product)
        reduction.start.upper = reduction.arithmetic->one;
    c205_trap trap = open_sources(&stream, machine, decoded);
    return trap == C205_TRAP_NONE ? run_reduction(&stream, &reduction, parts) : trap;
}

static c205_trap deliver_sum(struct c205 *machine, const struct decoded *decoded,
                             folding *fold, bool of_pairs)
{
    struct parts parts;
    c205_trap trap = reduce(machine, decoded, fold, of_pairs, &parts);
    if (trap == C205_TRAP_NONE)
        machine_deliver_parts(machine, decoded, parts.upper, parts.lower);
    return trap;
}

c205_trap execute_vector_sum(struct c205 *machine, const struct decoded *decoded)
{
    return deliver_sum(machine, decoded, fold_sum, false);
}

c205_trap execute_vector_dot(struct c205 *machine, const struct decoded *decoded)
{
    return deliver_sum(machine, decoded, fold_dot, true);
}

c205_trap execute_vector_product(struct c205 *machine, const struct decoded *decoded)
{
    struct parts parts;
    c205_trap trap = reduce(machine, decoded, fold_product, false, &parts);
    if (trap == C205_TRAP_NONE)
        machine_deliver(machine, decoded, parts.upper);
    return trap;
}

/* ---- Maximum, minimum --------------------------------------------------- */

/* The extreme element so far. Of equal elements the first counts. The first indefinite
 * element is the result, because it cannot be compared. */
struct best {
    c205_word word;
    size_t index;
    bool found, indefinite;
    bool greatest; /* true: maximum; false: minimum */
    arith_relation *less;
};

static bool is_better(const struct best *best, c205_word word)
{
    if (!best->found || word_is_indefinite(word))
        return true;
    return best->greatest ? best->less(best->word, word) : best->less(word, best->word);
}

static void find_best(struct best *best, const c205_word *a, size_t first, size_t n,
                      const uint64_t *permitted)
{
    for (size_t i = 0; i < n && !best->indefinite; i++)
        if (bit_at(permitted, i) && is_better(best, a[i])) {
            best->word = a[i];
            best->index = first + i;
            best->found = true;
            best->indefinite = word_is_indefinite(a[i]);
        }
}

/* Continues with the best element that was found before the interruption, if any. */
static void resume_extreme(struct best *best, const struct resume_state *resume)
{
    if (!resume->found)
        return;
    best->word = resume->word;
    best->index = resume->count[0];
    best->found = true;
    best->indefinite = word_is_indefinite(best->word);
}

static c205_trap interrupt_extreme(struct resume_state *resume, const struct best *best)
{
    resume->word = best->word;
    resume->count[0] = best->index;
    resume->found = best->found;
    return C205_TRAP_CLOCK_LIMIT;
}

static c205_trap extreme(struct c205 *machine, const struct decoded *decoded,
                         bool greatest)
{
    bool half = decoded->width[OPERAND_A] == HALF_BITS;
    struct best best = { C205_INDEFINITE, 0,        false,
                         false,           greatest, half ? half_less : arith_less };
    struct stream stream;
    uint64_t permitted[CHUNK_WORDS];
    c205_trap trap = open_sources(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    resume_extreme(&best, &machine->resume);
    for (size_t first = stream.turn.first, n; first < stream.turn.end; first += n) {
        n = stream_next(&stream, first);
        control_read(&stream.control, first, n, permitted);
        find_best(&best, source_read(&stream.a, first, n), first, n, permitted);
    }
    if (stream_end(&stream) != C205_TRAP_NONE)
        return interrupt_extreme(&machine->resume, &best);
    if (word_is_indefinite(best.word))
        machine->data_flags |= FLAG_INDEFINITE;
    if (word_is_machine_zero(best.word))
        machine->data_flags |= FLAG_MACHINE_ZERO;
    machine->slot[decoded->index] = best.found ? best.index : stream.n;
    machine_deliver(machine, decoded, best.word);
    return C205_TRAP_NONE;
}

c205_trap execute_vector_maximum(struct c205 *machine, const struct decoded *decoded)
{
    return extreme(machine, decoded, true);
}

c205_trap execute_vector_minimum(struct c205 *machine, const struct decoded *decoded)
{
    return extreme(machine, decoded, false);
}

/* ---- Select ------------------------------------------------------------- */

c205_trap execute_select(struct c205 *machine, const struct decoded *decoded)
{
    lanes_compare *comparison = operation_of(decoded)->compare;
    struct stream stream;
    struct resume_state *resume = &machine->resume;
    uint64_t bits[CHUNK_WORDS], permitted[CHUNK_WORDS];
    bool found = resume->found;
    c205_trap trap = open_sources(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    size_t first = found ? resume->count[0] : stream.turn.first;
    while (!found && first < stream.turn.end) {
        size_t n = stream_next(&stream, first);
        const c205_word *a = source_read(&stream.a, first, n);
        comparison(bits, a, source_read(&stream.b, first, n), n);
        control_read(&stream.control, first, n, permitted);
        for (size_t i = 0; i < CHUNK_WORDS && i * 64 < n; i++)
            bits[i] &= permitted[i];
        size_t place = first_one(bits, n);
        found = place < n;
        first += place;
    }
    trap = stream_end(&stream);
    if (trap == C205_TRAP_NONE) {
        machine->slot[decoded->c] = first;
    } else {
        resume->found = found;
        resume->count[0] = first;
    }
    return trap;
}
