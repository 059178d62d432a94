/* vector.c - executes vector instructions that work element by element. */
#include "vm/vector.h"

#include "vm/direct.h"

/* ---- Streams ----------------------------------------------------------- */

c205_trap stream_describe(struct stream *stream, struct c205 *machine,
                          const struct decoded *decoded)
{
    stream->machine = machine;
    stream->scans_b = false;
    c205_trap trap = describe_a(&stream->a, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = describe_b(&stream->b, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = describe_result(&stream->result, &stream->control, machine, decoded);
    stream->n = stream->result.length;
    return trap;
}

c205_trap stream_take_length(struct stream *stream, const struct decoded *decoded)
{
    const struct source *a = &stream->a, *b = &stream->b;
    bool unary = decoded->insn->format == C205_FORMAT_REDUCE
                 || decoded->insn->format == C205_FORMAT_EXTREME;
    if (a->broadcast && (unary || b->broadcast))
        return machine_refuse(stream->machine, RULE_VECTOR);
    stream->n = a->broadcast ? b->vector.length : a->vector.length;
    return C205_TRAP_NONE;
}

c205_trap stream_describe_sources(struct stream *stream, struct c205 *machine,
                                  const struct decoded *decoded)
{
    stream->machine = machine;
    stream->scans_b = false;
    stream->result.length = 0;
    describe_control(&stream->control, machine, decoded);
    c205_trap trap = describe_a(&stream->a, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = describe_b(&stream->b, machine, decoded);
    return trap == C205_TRAP_NONE ? stream_take_length(stream, decoded) : trap;
}

/* Returns the number of elements of B that are read. */
static size_t count_b(const struct stream *stream)
{
    return stream->scans_b && stream->n > 0 ? stream->b.vector.length : stream->n;
}

c205_trap stream_claim_sources(struct stream *stream)
{
    struct c205 *machine = stream->machine;
    machine->effect.elements = stream->n;
    stream->chunk = CHUNK;
    stream->turn = machine_turn(machine, stream->n, machine->allowed);
    c205_trap trap = claim_source(machine, &stream->a, stream->n);
    if (trap == C205_TRAP_NONE)
        trap = claim_source(machine, &stream->b, count_b(stream));
    if (trap == C205_TRAP_NONE)
        trap = claim_control(machine, &stream->control, stream->n);
    return trap;
}

c205_trap stream_claim(struct stream *stream)
{
    c205_trap trap = stream_claim_sources(stream);
    if (trap == C205_TRAP_NONE)
        trap = claim_vector(stream->machine, &stream->result, stream->n, true);
    if (trap != C205_TRAP_NONE)
        return trap;
    const struct vector *result = &stream->result;
    size_t a = operand_lead(&stream->a.vector, result, CHUNK);
    size_t b = operand_lead(&stream->b.vector, result, a);
    stream->chunk = operand_lead(&stream->control.vector, result, b);
    return C205_TRAP_NONE;
}

c205_trap stream_open(struct stream *stream, struct c205 *machine,
                      const struct decoded *decoded)
{
    c205_trap trap = stream_describe(stream, machine, decoded);
    return trap == C205_TRAP_NONE ? stream_claim(stream) : trap;
}

c205_trap stream_open_scan(struct stream *stream, struct c205 *machine,
                           const struct decoded *decoded)
{
    c205_trap trap = stream_describe(stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    stream->scans_b = true;
    trap = stream_claim(stream);
    if (operands_overlap(&stream->b.vector, &stream->result))
        stream->chunk = 1;
    return trap;
}

/* ---- Recurrences -------------------------------------------------------- */

/* A range of elements from first to end - 1. */
struct elements {
    size_t first, end;
};

/* Returns the elements that wait for an earlier result: all elements from the first
 * that overlaps the result. Source and result must have the same width. */
static struct elements waiting(const struct vector *read, const struct vector *result,
                               size_t n)
{
    struct elements none = { 0, 0 };
    if (!operands_overlap(read, result) || result->address <= read->address)
        return none;
    uint64_t lead = (result->address - read->address) / read->width;
    struct elements some = { (size_t)lead, min_size(n, read->length) };
    return some;
}

/* Returns the number of elements in the union of some ranges. */
static size_t count_elements(const struct elements *some, size_t count)
{
    size_t sum = 0, at = 0;
    for (;;) {
        struct elements next = { SIZE_MAX, SIZE_MAX };
        for (size_t k = 0; k < count; k++)
            if (some[k].end > at && some[k].first < next.first)
                next = some[k];
        if (next.end == SIZE_MAX)
            return sum;
        sum += next.end - (next.first > at ? next.first : at);
        at = next.end;
    }
}

static bool recurs(const struct vector *result, size_t i,
                   const struct source *const *sources, size_t count)
{
    bool found = false;
    for (size_t k = 0; k < count; k++)
        found = found || operand_recurs(&sources[k]->vector, i, result, i);
    return found;
}

void record_recurrence(struct c205 *machine, const struct vector *result, size_t n,
                       const struct source *const *sources, size_t count)
{
    struct elements some[MAX_SOURCES];
    bool overlap = false, alike = true;
    for (size_t k = 0; k < count; k++) {
        const struct vector *read = &sources[k]->vector;
        overlap = overlap || operands_overlap(read, result);
        alike = alike && read->width == result->width;
        some[k] = waiting(read, result, n);
    }
    if (overlap && alike)
        machine->effect.recurrent += count_elements(some, count);
    for (size_t i = 1; overlap && !alike && i < n; i++)
        machine->effect.recurrent += recurs(result, i, sources, count);
}

static void record_recurrence_of(const struct stream *stream)
{
    const struct source *const sources[] = { &stream->a, &stream->b };
    record_recurrence(stream->machine, &stream->result, stream->n, sources, 2);
}

/* ---- Operations -------------------------------------------------------- */

static uint64_t flags_of(const struct operation *operation, c205_word *words,
                         const c205_word *a, const c205_word *b, size_t n)
{
    uint64_t flags = 0;
    if (operation->unary)
        operation->unary(words, a, n, &flags);
    else
        operation->binary(words, a, b, n, &flags);
    return flags;
}

/* Returns the flags that the permitted elements set. Flags are rare, so the permitted
 * elements are compressed and computed again only if some element sets a flag. */
static uint64_t permitted_flags(const struct operation *operation, const c205_word *a,
                                const c205_word *b, size_t n, const uint64_t *permitted)
{
    c205_word words[CHUNK], some_a[CHUNK], some_b[CHUNK];
    size_t count = compress_words(some_a, a, permitted, n);
    if (operation->binary)
        compress_words(some_b, b, permitted, n);
    return flags_of(operation, words, some_a, some_b, count);
}

void operate(struct c205 *machine, const struct operation *operation, c205_word *words,
             const c205_word *a, const c205_word *b, size_t n,
             const uint64_t *permitted)
{
    uint64_t flags = flags_of(operation, words, a, b, n);
    if (flags && permitted)
        flags = permitted_flags(operation, a, b, n, permitted);
    machine->data_flags |= flags;
}

/* Returns the memory of the result, for a computation in place, if it is contiguous and
 * overlaps no source and the instruction has no control vector. Otherwise returns
 * `words`. */
static c205_word *result_space(struct stream *stream, size_t first, size_t n,
                               c205_word *words)
{
    if (stream->control.present || operands_overlap(&stream->a.vector, &stream->result)
        || operands_overlap(&stream->b.vector, &stream->result))
        return words;
    c205_word *span = vector_span(&stream->machine->memory, &stream->result, first, n);
    return span ? span : words;
}

void stream_step(struct stream *stream, const struct operation *operation, size_t first,
                 size_t n, bool in_place)
{
    const c205_word *a = source_read(&stream->a, first, n);
    const c205_word *b = operation->unary ? NULL : source_read(&stream->b, first, n);
    c205_word words[CHUNK], *c = words;
    uint64_t bits[CHUNK_WORDS], permitted[CHUNK_WORDS];
    if (operation->compare) {
        operation->compare(bits, a, b, n);
        result_store_bits(stream->machine, &stream->result, &stream->control, first,
                          bits, n);
        return;
    }
    if (in_place)
        c = result_space(stream, first, n, words);
    control_read(&stream->control, first, n, permitted);
    operate(stream->machine, operation, c, a, b, n,
            stream->control.present ? permitted : NULL);
    if (c == words)
        result_store(stream->machine, &stream->result, &stream->control, first, words,
                     n);
}

static c205_trap run_stream(struct stream *stream, const struct operation *operation)
{
    record_recurrence_of(stream);
    for (size_t first = stream->turn.first, n; first < stream->turn.end; first += n) {
        n = stream_next(stream, first);
        stream_step(stream, operation, first, n, true);
    }
    return stream_end(stream);
}

/* The functions of each elementwise operation, for words and for half words. */
static const struct operation operations[C205_OPERATIONS][2] = {
/* clang-format off */
#define OF_BOTH_SIZES(name, kind) \
    [C205_OPERATION_##name] = { { .kind = lanes_##name }, \
                                { .kind = halves_##name } },
#define OF_ANY_SIZE(name) \
    [C205_OPERATION_##name] = { { .unary = lanes_##name }, \
                                { .unary = lanes_##name } },
/* clang-format on */
#define BINARY(name, ...) OF_BOTH_SIZES(name, binary)
#define BITWISE(name) OF_BOTH_SIZES(name, binary)
#define UNARY(name, ...) OF_BOTH_SIZES(name, unary)
#define RELATION(name) OF_BOTH_SIZES(name, compare)
#define CONVERSION(name, ...) OF_ANY_SIZE(name)
#define COPY(name, ...) OF_ANY_SIZE(name)
#include "vm/arith.def"
};

const struct operation *operation_of(const struct decoded *decoded)
{
    bool half = decoded->fields.g & C205_G_HALF;
    return &operations[decoded->insn->operation][half];
}

c205_trap execute_elementwise(struct c205 *machine, const struct decoded *decoded)
{
    const struct operation *operation = operation_of(decoded);
    struct stream stream;
    if (direct_elementwise(machine, decoded, operation))
        return C205_TRAP_NONE;
    c205_trap trap = stream_open(&stream, machine, decoded);
    return trap == C205_TRAP_NONE ? run_stream(&stream, operation) : trap;
}

/* ---- Neighbours -------------------------------------------------------- */

/* Executes an operation on neighbours. Both sources are A, and the first is one element
 * ahead of the second. */
c205_trap execute_neighbours(struct c205 *machine, const struct decoded *decoded)
{
    struct stream stream;
    c205_trap trap = stream_describe(&stream, machine, decoded);
    if (trap == C205_TRAP_NONE)
        trap = describe_a(&stream.b, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    if (stream.a.vector.length > 0) {
        stream.a.vector.address = vector_at(&stream.a.vector, 1) & ADDRESS_MASK;
        stream.a.vector.length--;
    }
    trap = stream_claim(&stream);
    return trap == C205_TRAP_NONE ? run_stream(&stream, operation_of(decoded)) : trap;
}

/* ---- Interval ---------------------------------------------------------- */

struct progression {
    arith_binary *add;
    c205_word value, step;
    uint64_t raised; /* flags of value */
};

/* Makes n elements by repeated upper addition, starting with value, and leaves the next
 * element in value. The elements do not depend on the control vector. The flags do:
 * only the addition of a stored element sets flags. */
static void make_interval(struct c205 *machine, struct progression *progression,
                          c205_word *words, size_t n, const uint64_t *permitted)
{
    for (size_t i = 0; i < n; i++) {
        words[i] = progression->value;
        if (bit_at(permitted, i))
            machine->data_flags |= progression->raised;
        progression->raised = 0;
        progression->value = progression->add(progression->value, progression->step,
                                              &progression->raised);
    }
}

static c205_trap run_interval(struct stream *stream)
{
    struct resume_state *resume = &stream->machine->resume;
    bool half = stream->result.width == HALF_BITS;
    struct progression progression = { half ? half_add_upper : arith_add_upper,
                                       stream->a.padding, stream->b.padding, 0 };
    c205_word words[CHUNK];
    uint64_t permitted[CHUNK_WORDS];
    if (stream->turn.first > 0) {
        progression.value = resume->word;
        progression.raised = resume->flags;
    }
    for (size_t first = stream->turn.first, n; first < stream->turn.end; first += n) {
        n = stream_next(stream, first);
        control_read(&stream->control, first, n, permitted);
        make_interval(stream->machine, &progression, words, n, permitted);
        result_store(stream->machine, &stream->result, &stream->control, first, words,
                     n);
    }
    c205_trap trap = stream_end(stream);
    if (trap != C205_TRAP_NONE) {
        resume->word = progression.value;
        resume->flags = progression.raised;
    }
    return trap;
}

c205_trap execute_vector_interval(struct c205 *machine, const struct decoded *decoded)
{
    struct stream stream;
    c205_trap trap = stream_open(&stream, machine, decoded);
    return trap == C205_TRAP_NONE ? run_interval(&stream) : trap;
}

/* ---- Polynomial -------------------------------------------------------- */

struct horner {
    struct operation times, plus;
};

/* Computes the polynomial at each element of a by Horner's rule. */
static void evaluate(struct stream *stream, const struct horner *horner,
                     c205_word *values, const c205_word *a, size_t n,
                     const uint64_t *permitted)
{
    size_t count = stream->b.vector.length;
    c205_word products[CHUNK], coefficients[CHUNK];
    lanes_fill(values, count > 0 ? *source_read(&stream->b, 0, 1) : C205_MACHINE_ZERO,
               n);
    for (size_t i = 1; i < count; i++) {
        lanes_fill(coefficients, *source_read(&stream->b, i, 1), n);
        operate(stream->machine, &horner->times, products, values, a, n, permitted);
        operate(stream->machine, &horner->plus, values, products, coefficients, n,
                permitted);
    }
}

/* Counts the elements of the result that must wait for an earlier one. Every element
 * reads one element of A and all coefficients, which are B. */
static void record_recurrence_of_polynomial(const struct stream *stream)
{
    const struct vector *a = &stream->a.vector, *b = &stream->b.vector;
    struct vector all = { b->address, b->length > 0, (unsigned)b->length * b->width };
    size_t *recurrent = &stream->machine->effect.recurrent;
    bool overlap = operands_overlap(a, &stream->result)
                   || operands_overlap(&all, &stream->result);
    for (size_t i = 1; overlap && i < stream->n; i++)
        *recurrent += operand_recurs(a, i, &stream->result, i)
                      || operand_recurs(&all, 0, &stream->result, i);
}

c205_trap execute_vector_polynomial(struct c205 *machine, const struct decoded *decoded)
{
    const struct horner horner = { { .binary = SIZED(decoded, multiply_significant) },
                                   { .binary = SIZED(decoded, add_normalised) } };
    struct stream stream;
    c205_word words[CHUNK];
    uint64_t permitted[CHUNK_WORDS];
    c205_trap trap = stream_open_scan(&stream, machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    size_t count = stream.b.vector.length;
    machine->effect.elements = stream.n * count;
    record_recurrence_of_polynomial(&stream);
    stream.turn = machine_turn(machine, stream.n,
                               count > 0 ? machine->allowed / count : stream.n);
    for (size_t first = stream.turn.first, n; first < stream.turn.end; first += n) {
        n = stream_next(&stream, first);
        control_read(&stream.control, first, n, permitted);
        evaluate(&stream, &horner, words, source_read(&stream.a, first, n), n,
                 stream.control.present ? permitted : NULL);
        result_store(machine, &stream.result, &stream.control, first, words, n);
    }
    return stream_end(&stream);
}
