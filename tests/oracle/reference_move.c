/* reference_move.c - vector instructions that move elements. */
#include "reference_vector.h"

/* Records the use of n elements of A, B and Z, then of `stored` elements of C. */
static void use_operands(struct reference *reference, const struct vector *vector,
                         uint64_t n, uint64_t stored)
{
    reference->deed.elements = n;
    use_source(reference, &vector->sources.a, n);
    use_source(reference, &vector->sources.b, n);
    use_control(reference, vector, n);
    use_target(reference, &vector->c, stored);
}

/* Reverses A as if it had the length of C. */
static void reverse(struct reference *reference, const struct vector *vector)
{
    uint64_t length = vector->c.length;
    use_operands(reference, vector, length, length);
    for (uint64_t i = 0; i < length; i++)
        write_element(reference, vector, i,
                      element(reference, &vector->sources.a, length - 1 - i), 0);
}

/* ---- Gather and scatter ------------------------------------------------ */

static void note_index(struct reference *reference, uint64_t address)
{
    struct deed *deed = &reference->deed;
    if (deed->indexed_count == deed->indexed_room) {
        deed->indexed_room = 2 * deed->indexed_room + BITS;
        deed->indexed = plain_room(deed->indexed, deed->indexed_room,
                                   sizeof *deed->indexed);
    }
    deed->indexed[deed->indexed_count++] = address;
}

/* Returns the address of index i: i elements after the address of the table. */
static uint64_t indexed(struct reference *reference, const struct vector *vector,
                        uint64_t i, const struct target *table)
{
    c205_word index = element(reference, &vector->sources.a, i);
    return plain_address(table->address + table->width * (index & LOW_48));
}

/* Returns the address of element i with the period A, which may be negative. */
static uint64_t periodic(struct reference *reference, const struct vector *vector,
                         uint64_t i, const struct target *table)
{
    int64_t period = as_integer(read_bits(reference, vector->fields->a));
    uint64_t count = (uint64_t)(period * (int64_t)i);
    return plain_address(table->address + table->width * count);
}

static void gather_one(struct reference *reference, const struct vector *vector,
                       uint64_t i, uint64_t from)
{
    if (permitted(reference, vector, i)) {
        note_index(reference, from);
        store_element(reference, &vector->c, i,
                      read_memory(reference, from, vector->c.width));
    } else {
        pass_by_memory(reference, from, vector->c.width);
        leave_element(reference, &vector->c, i);
    }
}

static void scatter_one(struct reference *reference, const struct vector *vector,
                        uint64_t i, uint64_t to)
{
    c205_word word = element(reference, &vector->sources.b, i);
    if (permitted(reference, vector, i)) {
        note_index(reference, to);
        write_memory(reference, to, vector->c.width, word);
    } else
        leave_memory(reference, to, vector->c.width);
}

/* Returns the table of a gather, which is B. */
static struct target gathered_table(struct reference *reference,
                                    const struct vector *vector)
{
    return (struct target){
        .width = vector->c.width,
        .address = read_bits(reference, vector->fields->b),
    };
}

/* Executes a gather. Its length is the smaller of the lengths of the indices and the
 * result. */
static void gather(struct reference *reference, const struct vector *vector)
{
    struct target table = gathered_table(reference, vector);
    uint64_t length = lesser(vector->c.length, vector->sources.a.length);
    use_operands(reference, vector, length, length);
    for (uint64_t i = 0; i < length; i++)
        gather_one(reference, vector, i, indexed(reference, vector, i, &table));
}

static void scatter(struct reference *reference, const struct vector *vector)
{
    uint64_t length = vector->sources.a.length;
    use_operands(reference, vector, length, 0);
    for (uint64_t i = 0; i < length; i++)
        scatter_one(reference, vector, i, indexed(reference, vector, i, &vector->c));
}

/* Executes a periodic gather. Its length is the length of the result. */
static void gather_periodic(struct reference *reference, const struct vector *vector)
{
    struct target table = gathered_table(reference, vector);
    uint64_t length = vector->c.length;
    reference->deed.elements = length;
    use_control(reference, vector, length);
    use_target(reference, &vector->c, length);
    for (uint64_t i = 0; i < length; i++)
        gather_one(reference, vector, i, periodic(reference, vector, i, &table));
}

/* Executes a periodic scatter. Its length is the length of the source. */
static void scatter_periodic(struct reference *reference, const struct vector *vector)
{
    const struct source *b = &vector->sources.b;
    reference->deed.elements = b->length;
    use_source(reference, b, b->length);
    use_control(reference, vector, b->length);
    for (uint64_t i = 0; i < b->length; i++)
        scatter_one(reference, vector, i, periodic(reference, vector, i, &vector->c));
}

/* ---- Mask, merge, compress --------------------------------------------- */

static void mask(struct reference *reference, const struct vector *vector)
{
    use_operands(reference, vector, vector->c.length, vector->c.length);
    for (uint64_t i = 0; i < vector->c.length; i++) {
        c205_word a = element(reference, &vector->sources.a, i);
        c205_word b = element(reference, &vector->sources.b, i);
        store_element(reference, &vector->c, i,
                      permitted(reference, vector, i) ? a : b);
    }
}

static void merge(struct reference *reference, const struct vector *vector)
{
    const struct pair *sources = &vector->sources;
    uint64_t from_a = 0, from_b = 0;
    use_operands(reference, vector, vector->c.length, vector->c.length);
    may_need(reference, &sources->a, vector->c.length);
    may_need(reference, &sources->b, vector->c.length);
    for (uint64_t i = 0; i < vector->c.length; i++) {
        c205_word word = permitted(reference, vector, i)
                             ? element(reference, &sources->a, from_a++)
                             : element(reference, &sources->b, from_b++);
        store_element(reference, &vector->c, i, word);
    }
}

/* Records stores whose number is not known in advance. */
static void may_store(struct reference *reference, const struct vector *vector,
                      uint64_t length)
{
    for (uint64_t i = 0; i < length; i++)
        leave_element(reference, &vector->c, i);
}

static void compress(struct reference *reference, const struct vector *vector)
{
    uint64_t stored = 0;
    may_store(reference, vector, vector->z.length);
    for (uint64_t i = 0; i < vector->z.length; i++) {
        c205_word word = element(reference, &vector->sources.a, i);
        if (permitted(reference, vector, i))
            store_element(reference, &vector->c, stored++, word);
    }
    use_operands(reference, vector, vector->z.length, stored);
    set_length(reference, vector->fields->c, stored);
}

/* Executes a compress. Its length is the scan length. */
static void sieve(struct reference *reference, const struct vector *vector)
{
    uint64_t stored = 0, flags = 0, length;
    if (!scan_length(reference, vector, &length))
        return;
    may_store(reference, vector, length);
    for (uint64_t i = 0; i < length; i++) {
        c205_word a = element(reference, &vector->sources.a, i);
        c205_word b = element(reference, &vector->sources.b, i);
        bool passes = oracle_not_less(vector->sources.format, a, b, &flags);
        if (passes)
            store_element(reference, &vector->c, stored++, a);
        store_element(reference, &vector->z, i, passes);
    }
    use_operands(reference, vector, length, stored);
    set_length(reference, vector->fields->c, stored);
}

bool do_move(struct reference *reference, const struct vector *vector)
{
    switch (reference_which(vector->insn)) {
    case DO_VREVV: reverse(reference, vector); return true;
    case DO_VXTOV: gather(reference, vector); return true;
    case DO_VTOVX: scatter(reference, vector); return true;
    case DO_VGATHP: gather_periodic(reference, vector); return true;
    case DO_VSCATP: scatter_periodic(reference, vector); return true;
    case DO_MASKV:
    case DO_MASKB: mask(reference, vector); return true;
    case DO_MRGV:
    case DO_MRGB: merge(reference, vector); return true;
    case DO_CPSV:
    case DO_CPSB: compress(reference, vector); return true;
    case DO_ACPSV: sieve(reference, vector); return true;
    default: return false;
    }
}
