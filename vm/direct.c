/* direct.c - executes elementwise instructions and linked pairs directly on the memory
 * of the host (direct.h).
 */
#include "vm/direct.h"

#include "vm/number/pairs.h"
#include "vm/vector.h"

/* The destination of an instruction's result in the host's memory, and the control
 * vector of the instruction. */
struct direct_result {
    struct c205 *machine;
    size_t n;
    c205_word *words;        /* NULL: the result is bits */
    struct direct_bits bits; /* the bits of a comparison */
    struct direct_bits control;
    bool controlled;
    uint64_t blocked; /* as in struct control */
};

/* ---- Operands ------------------------------------------------------------ */

/* A source: element i is words[i * step]. The step is 0 for a broadcast word, and for
 * the result of the first instruction of a pair, which is replaced for each chunk. */
struct place {
    const c205_word *words;
    size_t step;
    c205_word word; /* the word of the register */
};

/* The sources of an instruction in the host's memory. */
struct direct_sources {
    const struct operation *operation;
    struct place a, b;
    c205_word space_a[CHUNK], space_b[CHUNK]; /* copies of broadcast words */
};

/* Finds the words of a source in the host's memory. Returns false if operand.h must
 * read the source. */
static inline bool find_source(struct place *place, struct c205 *machine,
                               bool broadcast, uint16_t slot, c205_word *space,
                               size_t n)
{
    place->word = machine->slot[slot];
    place->step = !broadcast;
    place->words = broadcast ? space : direct_read(machine, place->word, n);
    if (broadcast)
        lanes_fill(space, place->word, min_size(n, CHUNK));
    return place->words;
}

/* Finds both sources in the host's memory. handed_a and handed_b, if not NULL, are
 * chunks of earlier results that replace A and B. */
static inline bool find_sources(struct direct_sources *sources, struct c205 *machine,
                                const struct decoded *decoded,
                                const struct operation *operation, size_t n,
                                const c205_word *handed_a, const c205_word *handed_b)
{
    struct place a = { handed_a, 0, 0 }, b = { handed_b, 0, 0 };
    uint8_t g = decoded->fields.g;
    bool found = true;
    if (operation->unary)
        b.words = sources->space_b; /* not read */
    sources->operation = operation;
    if (!handed_a)
        found = find_source(&a, machine, g & C205_G_BROADCAST_A, decoded->a,
                            sources->space_a, n);
    if (found && !handed_b && !operation->unary)
        found = find_source(&b, machine, g & C205_G_BROADCAST_B, decoded->b,
                            sources->space_b, n);
    sources->a = a;
    sources->b = b;
    return found;
}

static inline bool find_result(struct direct_result *result, struct c205 *machine,
                               const struct decoded *decoded, bool compares, size_t n)
{
    c205_word c = machine->slot[decoded->fields.c];
    result->machine = machine;
    result->n = n;
    struct direct_bits none = { NULL, 0 };
    result->words = NULL;
    result->bits = result->control = none;
    result->controlled = decoded->z != 0;
    result->blocked = decoded->fields.g & C205_G_ZEROS ? UINT64_MAX : 0;
    if (result->controlled)
        result->control = direct_bits(machine, machine->slot[decoded->z], n, false);
    if (compares)
        result->bits = direct_bits(machine, c, n, true);
    else
        result->words = direct_write(machine, c, n);
    return (compares ? result->bits.word : result->words)
           && !(result->controlled && !result->control.word);
}

/* Return true if no store changes the control vector, or a source, before it is
 * read. */
static inline bool keeps_control(const struct direct_result *result)
{
    size_t n = result->n;
    if (!result->controlled)
        return true;
    return !direct_meets(result->words ? result->words : result->bits.word,
                         result->words ? n * sizeof *result->words
                                       : direct_bytes(result->bits, n),
                         result->control.word, direct_bytes(result->control, n));
}

static inline bool keeps_source(const struct direct_result *result,
                                const struct place *place)
{
    size_t n = result->n;
    if (place->step == 0)
        return true;
    return result->words
               ? !direct_recurs(result->words, place->words, n)
               : !direct_meets(result->bits.word, direct_bytes(result->bits, n),
                               place->words, n * sizeof *place->words);
}

static inline bool keeps_sources(const struct direct_result *result,
                                 const struct direct_sources *sources)
{
    return keeps_source(result, &sources->a) && keeps_source(result, &sources->b);
}

/* ---- Effects for the clock ---------------------------------------------- */

static inline void touch_sources(struct c205 *machine,
                                 const struct direct_sources *sources, size_t n)
{
    uint64_t bits = (uint64_t)n * WORD_BITS;
    if (sources->a.step)
        machine_touch(machine, LOW(sources->a.word), bits);
    if (sources->b.step)
        machine_touch(machine, LOW(sources->b.word), bits);
}

static inline void touch_result(const struct direct_result *result,
                                const struct decoded *decoded)
{
    struct c205 *machine = result->machine;
    size_t width = result->words ? WORD_BITS : 1;
    if (result->controlled)
        machine_touch(machine, LOW(machine->slot[decoded->z]), result->n);
    machine_touch_result(machine, LOW(machine->slot[decoded->fields.c]),
                         (uint64_t)result->n * width);
    machine->effect.elements = result->n;
}

/* ---- Elements ------------------------------------------------------------ */

static inline void read_permitted(const struct direct_result *result, size_t first,
                                  uint64_t *permitted, size_t n)
{
    direct_read_control(result->control, result->blocked, first, permitted, n);
}

static inline void compare_chunk(const struct direct_result *result,
                                 const struct operation *operation, const c205_word *a,
                                 const c205_word *b, size_t first, size_t n)
{
    uint64_t bits[CHUNK_WORDS], permitted[CHUNK_WORDS];
    operation->compare(bits, a, b, n);
    if (result->controlled)
        read_permitted(result, first, permitted, n);
    direct_write_bits(result->bits, first, bits, result->controlled ? permitted : NULL,
                      n);
}

/* Computes n elements, all of which the control vector permits. */
static inline void operate_all(struct c205 *machine, const struct operation *operation,
                               c205_word *c, const c205_word *a, const c205_word *b,
                               size_t n)
{
    if (operation->unary)
        operation->unary(c, a, n, &machine->data_flags);
    else
        operation->binary(c, a, b, n, &machine->data_flags);
}

/* Stores the results of a chunk. A copy under a control vector needs no temporary array
 * unless the result overlaps the source. */
static inline void store_chunk(const struct direct_result *result,
                               const struct operation *operation, const c205_word *a,
                               const c205_word *b, size_t first, size_t n)
{
    c205_word space[CHUNK], *c = result->words + first;
    uint64_t permitted[CHUNK_WORDS];
    if (!result->controlled) {
        operate_all(result->machine, operation, c, a, b, n);
        return;
    }
    read_permitted(result, first, permitted, n);
    if (operation->unary == lanes_copy
        && !direct_meets(c, n * sizeof *c, a, n * sizeof *a)) {
        lanes_store_masked(c, a, permitted, n);
        return;
    }
    operate(result->machine, operation, space, a, b, n, permitted);
    lanes_store_masked(c, space, permitted, n);
}

static inline void take_chunk(const struct direct_result *result,
                              const struct direct_sources *sources, size_t first,
                              size_t n)
{
    const c205_word *a = sources->a.words + first * sources->a.step;
    const c205_word *b = sources->b.words + first * sources->b.step;
    if (result->words)
        store_chunk(result, sources->operation, a, b, first, n);
    else
        compare_chunk(result, sources->operation, a, b, first, n);
}

/* The two instructions of a linked pair and what passes between them. */
struct direct_both {
    struct direct_sources one, two;
    c205_word handed[CHUNK]; /* results of the first instruction */
    lanes_pair *in_one_pass; /* function for both instructions in one pass, or NULL */
};

static inline pair_operand operand_at(struct place place, size_t first)
{
    pair_operand operand = { place.words + first * place.step, place.step == 0 };
    return operand;
}

/* Executes both operations of a linked pair in one pass. Returns false if they must run
 * separately. */
static inline bool take_in_one_pass(const struct direct_result *result,
                                    const struct direct_both *pair, size_t first,
                                    size_t n)
{
    bool done = false;
    struct place other = pair->two.a.words == pair->handed ? pair->two.b : pair->two.a;
    if (pair->in_one_pass)
        pair->in_one_pass(&done, result->words + first, operand_at(pair->one.a, first),
                          operand_at(pair->one.b, first),
                          operand_at(other, first).words, n,
                          &result->machine->data_flags);
    return done;
}

static inline void take_pair(const struct direct_result *result,
                             struct direct_both *pair, size_t first, size_t n)
{
    if (take_in_one_pass(result, pair, first, n))
        return;
    operate_all(result->machine, pair->one.operation, pair->handed,
                operand_at(pair->one.a, first).words,
                operand_at(pair->one.b, first).words, n);
    take_chunk(result, &pair->two, first, n);
}

/* ---- The instructions ---------------------------------------------------- */

bool direct_elementwise(struct c205 *machine, const struct decoded *decoded,
                        const struct operation *operation)
{
    size_t n = direct_length(machine->slot[decoded->fields.c]);
    struct direct_sources sources;
    struct direct_result result;
    if (!decoded->plain || !direct_turn(machine, n)
        || !find_result(&result, machine, decoded, operation->compare, n)
        || !find_sources(&sources, machine, decoded, operation, n, NULL, NULL)
        || !keeps_sources(&result, &sources) || !keeps_control(&result))
        return false;
    touch_sources(machine, &sources, n);
    touch_result(&result, decoded);
    for (size_t first = 0, some; first < n; first += some) {
        some = min_size(n - first, CHUNK);
        take_chunk(&result, &sources, first, some);
    }
    return true;
}

bool direct_pair(struct c205 *machine, const struct decoded *const *linked, bool hand_a,
                 bool hand_b)
{
    const struct operation *first_one = operation_of(linked[0]);
    const struct operation *second_one = operation_of(linked[1]);
    size_t n = direct_length(machine->slot[linked[1]->fields.c]);
    struct direct_result result;
    struct direct_both pair;
    if (!linked[0]->plain || !linked[1]->plain || !direct_turn(machine, n)
        || direct_length(machine->slot[linked[0]->fields.c]) != n
        || !find_result(&result, machine, linked[1], second_one->compare, n)
        || !find_sources(&pair.one, machine, linked[0], first_one, n, NULL, NULL)
        || !find_sources(&pair.two, machine, linked[1], second_one, n,
                         hand_a ? pair.handed : NULL, hand_b ? pair.handed : NULL)
        || !keeps_sources(&result, &pair.one) || !keeps_sources(&result, &pair.two)
        || !keeps_control(&result))
        return false;
    pair.in_one_pass = result.words && !result.controlled
                           ? lanes_pair_of(first_one->binary, second_one->binary,
                                           hand_a, hand_b)
                           : NULL;
    touch_sources(machine, &pair.one, n);
    touch_sources(machine, &pair.two, n);
    touch_result(&result, linked[1]);
    for (size_t first = 0, some; first < n; first += some) {
        some = min_size(n - first, CHUNK);
        take_pair(&result, &pair, first, some);
    }
    return true;
}
