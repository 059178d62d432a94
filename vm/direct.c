/* direct.c - elementwise instructions and linked pairs whose operands are
 * taken where they stand (direct.h).
 */
#include "vm/direct.h"

#include "vm/vector.h"

/* Where the result goes, and which of it. */
struct result {
    struct c205 *machine;
    size_t n;
    c205_word *words;        /* or .. */
    struct direct_bits bits; /* .. of a comparison */
    struct direct_bits control;
    bool controlled;
    uint64_t blocked; /* as that of a struct control */
};

/* ---- Operands ------------------------------------------------------------ */

/* False: it is to be read otherwise. */
static inline bool find_source(struct direct_source *source,
                               const struct c205 *machine, bool broadcast,
                               uint16_t slot, size_t n)
{
    source->scalar = machine->slot[slot];
    source->words = NULL;
    if (!broadcast)
        source->words = direct_read(machine, source->scalar, n);
    return broadcast || source->words;
}

static inline bool find_result(struct result *result, struct c205 *machine,
                               const struct decoded *decoded, bool compares,
                               size_t n)
{
    c205_word c = machine->slot[decoded->fields.c];
    result->machine = machine;
    result->n = n;
    result->controlled = decoded->z != 0;
    result->blocked = decoded->fields.g & C205_G_ZEROS ? UINT64_MAX : 0;
    if (result->controlled)
        result->control = direct_bits(machine, machine->slot[decoded->z], n,
                                      false);
    if (compares)
        result->bits = direct_bits(machine, c, n, true);
    else
        result->words = direct_write(machine, c, n);
    return (compares ? result->bits.word : result->words)
           && !(result->controlled && !result->control.word);
}

/* Nothing is stored upon a source or the control vector that is read after it
 * is stored. */
static inline bool keeps_control(const struct result *result, bool compares)
{
    size_t n = result->n;
    if (!result->controlled)
        return true;
    return !(compares ? direct_meets(result->bits.word,
                                     direct_bytes(result->bits, n),
                                     result->control.word,
                                     direct_bytes(result->control, n))
                      : direct_meets(result->words,
                                     n * sizeof *result->words,
                                     result->control.word,
                                     direct_bytes(result->control, n)));
}

static inline bool keeps_source(const struct result *result, bool compares,
                                const struct direct_source *source)
{
    size_t n = result->n, bytes = n * sizeof *source->words;
    if (!source->words)
        return true;
    return compares ? !direct_meets(result->bits.word,
                                    direct_bytes(result->bits, n),
                                    source->words, bytes)
                    : !direct_recurs(result->words, source->words, n);
}

/* ---- Telling the clock --------------------------------------------------- */

static inline void touch_source(struct c205 *machine,
                                const struct direct_source *source,
                                size_t n)
{
    if (source->words)
        machine_touch(machine, LOW(source->scalar), (uint64_t)n * WORD_BITS);
}

static inline void touch_result(const struct result *result,
                                const struct decoded *decoded, bool compares)
{
    struct c205 *machine = result->machine;
    if (result->controlled)
        machine_touch(machine, LOW(machine->slot[decoded->z]), result->n);
    machine_touch(machine, LOW(machine->slot[decoded->fields.c]),
                  (uint64_t)result->n * (compares ? 1 : WORD_BITS));
    machine->effect.elements = result->n;
}

/* ---- Elements ------------------------------------------------------------ */

/* A chunk of a source; space is filled already where it is broadcast. */
static inline const c205_word *chunk_of(const struct direct_source *source,
                                        const c205_word *space, size_t first)
{
    return source->words ? source->words + first : space;
}

static inline void fill_space(const struct direct_source *source,
                              c205_word *space, size_t n)
{
    if (!source->words)
        lanes_fill(space, source->scalar, least(n, CHUNK));
}

static inline void read_permitted(const struct result *result, size_t first,
                                  uint64_t *permitted, size_t n)
{
    direct_read_bits(result->control, first, permitted, n);
    for (size_t i = 0; i < (n + 63) / 64; i++)
        permitted[i] ^= result->blocked;
}

static inline void compare_chunk(const struct result *result,
                                 const struct operation *operation,
                                 const c205_word *a, const c205_word *b,
                                 size_t first, size_t n)
{
    uint64_t bits[CHUNK_WORDS], permitted[CHUNK_WORDS];
    operation->compare(bits, a, b, n);
    if (result->controlled)
        read_permitted(result, first, permitted, n);
    direct_write_bits(result->bits, first, bits,
                      result->controlled ? permitted : NULL, n);
}

static inline void operate_chunk(const struct result *result,
                                 const struct operation *operation,
                                 const c205_word *a, const c205_word *b,
                                 size_t first, size_t n)
{
    c205_word words[CHUNK];
    uint64_t permitted[CHUNK_WORDS];
    if (operation->compare) {
        compare_chunk(result, operation, a, b, first, n);
    } else if (!result->controlled) {
        operate(result->machine, operation, result->words + first, a, b, n,
                NULL);
    } else {
        read_permitted(result, first, permitted, n);
        if (n % WORD_BITS)
            permitted[n / WORD_BITS] &= leading_bits(n % WORD_BITS);
        operate(result->machine, operation, words, a, b, n, permitted);
        lanes_store_masked(result->words + first, words, permitted, n);
    }
}

/* ---- The instructions ---------------------------------------------------- */

static inline bool is_broadcast(const struct decoded *decoded, uint8_t bit)
{
    return decoded->fields.g & bit;
}

bool direct_elementwise(struct c205 *machine, const struct decoded *decoded,
                        const struct operation *operation)
{
    size_t n = direct_length(machine->slot[decoded->fields.c]);
    bool compares = operation->compare != NULL;
    struct direct_source a, b = { NULL, 0 };
    struct result result;
    c205_word space_a[CHUNK], space_b[CHUNK];
    if (!decoded->plain || !direct_turn(machine, n)
        || !find_source(&a, machine,
                        is_broadcast(decoded, C205_G_BROADCAST_A), decoded->a,
                        n)
        || !(operation->unary
             || find_source(&b, machine,
                            is_broadcast(decoded, C205_G_BROADCAST_B),
                            decoded->b, n))
        || !find_result(&result, machine, decoded, compares, n)
        || !keeps_source(&result, compares, &a)
        || !keeps_source(&result, compares, &b)
        || !keeps_control(&result, compares))
        return false;
    touch_source(machine, &a, n);
    touch_source(machine, &b, n);
    touch_result(&result, decoded, compares);
    fill_space(&a, space_a, n);
    if (!operation->unary)
        fill_space(&b, space_b, n);
    for (size_t first = 0, some; first < n; first += some) {
        some = least(n - first, CHUNK);
        operate_chunk(&result, operation, chunk_of(&a, space_a, first),
                      chunk_of(&b, space_b, first), first, some);
    }
    return true;
}
