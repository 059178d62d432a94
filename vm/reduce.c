/* reduce.c - vectors to one number in a register. */
#include "vm/vector.h"

static c205_trap open_sources(struct stream *stream, struct c205 *machine,
                              const struct decoded *decoded)
{
    c205_trap trap = stream_describe_sources(stream, machine, decoded);
    return trap == C205_TRAP_NONE ? stream_claim_sources(stream) : trap;
}

/* ---- Sum, product, dot -------------------------------------------------- */

typedef void fold(c205_word *accumulator, const c205_word *a, size_t n,
                  uint64_t *flags);

struct reduction {
    c205_word start;    /* the result of no element */
    lanes_binary *pair; /* makes one number of A and B; NULL: take A */
    fold *fold;
};

/* The elements that the control vector lets through, in their order. */
struct some {
    c205_word a[CHUNK], b[CHUNK];
};

static size_t take_permitted(const struct stream *stream, size_t first,
                             size_t n, struct some *some, const c205_word **a,
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

/* What the accumulator holds at first, and when the turn is over. */
static c205_trap run_reduction(struct stream *stream,
                               const struct reduction *reduction,
                               c205_word *accumulator)
{
    struct package *progress = &stream->machine->progress;
    uint64_t *flags = &stream->machine->data_flags;
    c205_word pairs[CHUNK];
    struct some some;
    *accumulator = stream->turn.first > 0 ? progress->word : reduction->start;
    for (size_t first = stream->turn.first, n; first < stream->turn.end;
         first += n) {
        n = stream_next(stream, first);
        const c205_word *a = source_read(&stream->a, first, n);
        const c205_word *b = reduction->pair
                                 ? source_read(&stream->b, first, n)
                                 : a;
        size_t count = take_permitted(stream, first, n, &some, &a, &b);
        if (reduction->pair) {
            reduction->pair(pairs, a, b, count, flags);
            a = pairs;
        }
        reduction->fold(accumulator, a, count, flags);
    }
    c205_trap trap = stream_end(stream);
    if (trap != C205_TRAP_NONE)
        progress->word = *accumulator;
    return trap;
}

static c205_trap reduce(struct c205 *machine, const struct decoded *decoded,
                        const struct reduction *reduction)
{
    struct stream stream;
    c205_word accumulator;
    c205_trap trap = open_sources(&stream, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = run_reduction(&stream, reduction, &accumulator);
    if (trap == C205_TRAP_NONE)
        machine_deliver(machine, decoded, accumulator);
    return trap;
}

c205_trap execute_vector_sum(struct c205 *machine,
                             const struct decoded *decoded)
{
    const struct reduction sum = { C205_MACHINE_ZERO, NULL,
                                   SIZED(decoded, sum) };
    return reduce(machine, decoded, &sum);
}

c205_trap execute_vector_product(struct c205 *machine,
                                 const struct decoded *decoded)
{
    const struct reduction product = { decoded->width[OPERAND_A] == HALF_BITS
                                           ? C205_HALF_ONE
                                           : C205_ONE,
                                       NULL, SIZED(decoded, product) };
    return reduce(machine, decoded, &product);
}

c205_trap execute_vector_dot(struct c205 *machine,
                             const struct decoded *decoded)
{
    const struct reduction dot = { C205_MACHINE_ZERO,
                                   SIZED(decoded, multiply_significant),
                                   SIZED(decoded, sum) };
    return reduce(machine, decoded, &dot);
}

/* ---- Maximum, minimum --------------------------------------------------- */

/* The best element so far; the first of equals.  An indefinite one cannot
 * be compared: the first of them is the result. */
struct best {
    c205_word word;
    size_t index;
    bool found, indefinite;
    bool greatest; /* wanted; else the least */
    arith_relation *less;
};

static bool is_better(const struct best *best, c205_word word)
{
    if (!best->found || word_is_indefinite(word))
        return true;
    return best->greatest ? best->less(best->word, word)
                          : best->less(word, best->word);
}

static void find_best(struct best *best, const c205_word *a, size_t first,
                      size_t n, const uint64_t *permitted)
{
    for (size_t i = 0; i < n && !best->indefinite; i++)
        if (bit_at(permitted, i) && is_better(best, a[i])) {
            best->word = a[i];
            best->index = first + i;
            best->found = true;
            best->indefinite = word_is_indefinite(a[i]);
        }
}

/* The one found before the instruction was interrupted, if it was. */
static void resume_extreme(struct best *best, const struct package *progress)
{
    if (!progress->found)
        return;
    best->word = progress->word;
    best->index = progress->count[0];
    best->found = true;
    best->indefinite = word_is_indefinite(best->word);
}

static c205_trap interrupt_extreme(struct package *progress,
                                   const struct best *best)
{
    progress->word = best->word;
    progress->count[0] = best->index;
    progress->found = best->found;
    return C205_TRAP_CLOCK_LIMIT;
}

static c205_trap extreme(struct c205 *machine, const struct decoded *decoded,
                         bool greatest)
{
    bool half = decoded->width[OPERAND_A] == HALF_BITS;
    struct best best = { C205_INDEFINITE, 0,
                         false,           false,
                         greatest,        half ? half_less : arith_less };
    struct stream stream;
    uint64_t permitted[CHUNK_WORDS];
    c205_trap trap = open_sources(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    resume_extreme(&best, &machine->progress);
    for (size_t first = stream.turn.first, n; first < stream.turn.end;
         first += n) {
        n = stream_next(&stream, first);
        control_read(&stream.control, first, n, permitted);
        find_best(&best, source_read(&stream.a, first, n), first, n,
                  permitted);
    }
    if (stream_end(&stream) != C205_TRAP_NONE)
        return interrupt_extreme(&machine->progress, &best);
    if (word_is_indefinite(best.word))
        machine->data_flags |= FLAG_INDEFINITE;
    if (word_is_machine_zero(best.word))
        machine->data_flags |= FLAG_MACHINE_ZERO;
    machine_deliver(machine, decoded, best.word);
    machine->slot[decoded->fields.c + 1] = best.found ? best.index : stream.n;
    return C205_TRAP_NONE;
}

c205_trap execute_vector_maximum(struct c205 *machine,
                                 const struct decoded *decoded)
{
    return extreme(machine, decoded, true);
}

c205_trap execute_vector_minimum(struct c205 *machine,
                                 const struct decoded *decoded)
{
    return extreme(machine, decoded, false);
}

/* ---- Select ------------------------------------------------------------- */

c205_trap execute_select(struct c205 *machine, const struct decoded *decoded)
{
    lanes_compare *comparison = operation_of(decoded)->compare;
    struct stream stream;
    struct package *progress = &machine->progress;
    uint64_t bits[CHUNK_WORDS], permitted[CHUNK_WORDS];
    bool found = progress->found;
    c205_trap trap = open_sources(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    size_t first = found ? progress->count[0] : stream.turn.first;
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
        progress->found = found;
        progress->count[0] = first;
    }
    return trap;
}
