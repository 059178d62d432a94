/* reference_sparse.c - sparse vectors: packed elements and their order. */
#include "reference_vector.h"

#include <stdlib.h>

/* A packed vector: as many elements as its order vector has ones. */
struct packed {
    struct source elements, order;
    bool *present; /* as many as the longer order vector has bits */
    uint64_t ones;
};

static uint64_t greater(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

/* Order vectors are read as a whole; a shorter one continues with zeros. */
static void read_order(struct reference *reference, struct packed *packed,
                       uint64_t n)
{
    packed->present = plain_room(NULL, (size_t)n + 1, sizeof(bool));
    packed->ones = 0;
    for (uint64_t i = 0; i < n; i++) {
        packed->present[i] = element(reference, &packed->order, i) & 1;
        packed->ones += packed->present[i];
    }
}

/* The order vectors first, as they are read first. */
static void use_packed(struct reference *reference, const struct packed *a,
                       const struct packed *b, uint64_t n)
{
    use_source(reference, &a->order, n);
    use_source(reference, &b->order, n);
    use_source(reference, &a->elements, a->ones);
    use_source(reference, &b->elements, b->ones);
}

/* Add and subtract: where one is present; multiply and divide: both. */
static bool needs_both(const c205_insn *insn)
{
    return insn->flags & C205_INSN_PADO;
}

static bool is_made(const struct vector *vector, const struct packed *a,
                    const struct packed *b, uint64_t i)
{
    return needs_both(vector->insn) ? a->present[i] && b->present[i]
                                    : a->present[i] || b->present[i];
}

/* The next packed element if place i has one; absent, it is machine zero. */
static c205_word next_element(struct reference *reference,
                              const struct packed *packed, uint64_t i,
                              uint64_t *next)
{
    return packed->present[i]
               ? element(reference, &packed->elements, (*next)++)
               : C205_MACHINE_ZERO;
}

static uint64_t make_elements(struct reference *reference,
                              const struct vector *vector,
                              const struct packed *a, const struct packed *b,
                              uint64_t n)
{
    uint64_t next_a = 0, next_b = 0, made = 0;

    for (uint64_t i = 0; i < n; i++) {
        c205_word x = next_element(reference, a, i, &next_a);
        c205_word y = next_element(reference, b, i, &next_b);
        if (is_made(vector, a, b, i))
            store_element(reference, &vector->c, made++,
                          vector->sources.rule(vector->sources.format, x, y,
                                               &reference->now.flags));
    }
    return made;
}

static void set_lengths(struct reference *reference,
                        const c205_fields *fields, uint64_t made, uint64_t n)
{
    c205_word c = read_bits(reference, fields->c);
    c205_word z = read_bits(reference, fields->z);

    write_register(reference, fields->c, with_length(c, made));
    write_register(reference, fields->z, with_length(z, n));
}

static void do_packed(struct reference *reference,
                      const struct vector *vector, struct packed *a,
                      struct packed *b)
{
    uint64_t n = greater(a->order.length, b->order.length);
    uint64_t made;

    read_order(reference, a, n);
    read_order(reference, b, n);
    use_packed(reference, a, b, n);
    made = make_elements(reference, vector, a, b, n);
    for (uint64_t i = 0; i < n; i++)
        store_element(reference, &vector->z, i, is_made(vector, a, b, i));
    use_target(reference, &vector->c, made);
    use_target(reference, &vector->z, n);
    reference->deed.elements = greater(made, greater(a->ones, b->ones));
    reference->deed.results = made;
    set_lengths(reference, vector->fields, made, n);
    free(a->present);
    free(b->present);
}

void do_sparse(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields)
{
    struct vector vector = { .insn = insn, .fields = fields };
    char letter = reference_letter(insn, fields->g, 'A');
    struct packed a, b;

    vector.sources.rule = reference_rule(insn);
    vector.sources.format = format_of(width_of_letter(letter));
    a.elements = vector_source(reference, insn, letter, fields->a, 0);
    a.order = vector_source(reference, insn, 'b', fields->x, 0);
    b.elements = vector_source(reference, insn, letter, fields->b, 0);
    b.order = vector_source(reference, insn, 'b', fields->y, 0);
    a.order.pad = b.order.pad = 0;
    take_targets(reference, &vector);
    if (!has_bad_operand(reference))
        do_packed(reference, &vector, &a, &b);
}
