/* reference_sparse.c - instructions on packed elements and order vectors. */
#include "reference_vector.h"

#include <stdlib.h>

/* A packed vector. It has an element for each one-bit of its order vector. */
struct packed {
    struct source elements, order;
    bool *present; /* has the length of the longer order vector */
    uint64_t ones;
};

static uint64_t greater(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

/* The order vector of the result. */
struct order {
    bool given;
    bool *present;
    uint64_t places, ones;
};

/* Reads a whole order vector. Zeros follow a shorter order vector. */
static void read_order(struct reference *reference, struct packed *packed, uint64_t n)
{
    packed->present = plain_room(NULL, (size_t)n + 1, sizeof(bool));
    packed->ones = 0;
    for (uint64_t i = 0; i < n; i++) {
        packed->present[i] = element(reference, &packed->order, i) & 1;
        packed->ones += packed->present[i];
    }
}

/* Records the use of the order vectors first, because they are read first. */
static void use_packed(struct reference *reference, const struct vector *vector,
                       const struct packed *a, const struct packed *b,
                       const struct order *z)
{
    use_source(reference, &a->order, z->places);
    use_source(reference, &b->order, z->places);
    if (z->given)
        use_target(reference, &vector->z, z->places);
    use_source(reference, &a->elements, a->ones);
    use_source(reference, &b->elements, b->ones);
}

/* Returns true for multiply and divide, which need both elements, not one. */
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

/* Determines which places have a result. If Z is given, Z decides. */
static void find_results(struct reference *reference, const struct vector *vector,
                         const struct packed *a, const struct packed *b,
                         struct order *z)
{
    z->present = plain_room(NULL, (size_t)z->places + 1, sizeof(bool));
    z->ones = 0;
    for (uint64_t i = 0; i < z->places; i++) {
        z->present[i] = z->given ? read_memory(reference, vector->z.address + i, BIT)
                                 : is_made(vector, a, b, i);
        z->ones += z->present[i];
    }
}

/* Returns the next packed element if place i has an element, else machine zero. */
static c205_word next_element(struct reference *reference, const struct packed *packed,
                              uint64_t i, uint64_t *next)
{
    return packed->present[i] ? element(reference, &packed->elements, (*next)++)
                              : C205_MACHINE_ZERO;
}

static bool recurs(const struct packed *packed, uint64_t i, uint64_t next,
                   const struct vector *vector, uint64_t made)
{
    return packed->present[i]
           && lies_on_results(&packed->elements, next, &vector->c, made);
}

static void make_elements(struct reference *reference, const struct vector *vector,
                          const struct packed *a, const struct packed *b,
                          const struct order *z)
{
    uint64_t next_a = 0, next_b = 0, made = 0;
    for (uint64_t i = 0; i < z->places; i++) {
        reference->deed.recurrent += z->present[i]
                                     && (recurs(a, i, next_a, vector, made)
                                         || recurs(b, i, next_b, vector, made));
        c205_word x = next_element(reference, a, i, &next_a);
        c205_word y = next_element(reference, b, i, &next_b);
        if (z->present[i])
            store_element(reference, &vector->c, made++,
                          vector->sources.rule(vector->sources.format, x, y,
                                               &reference->now.flags));
    }
}

/* Stores the order vector Z of the result after its elements: one bit for a place. */
static void store_order(struct reference *reference, const struct vector *vector,
                        const struct order *z)
{
    for (uint64_t i = 0; i < z->places; i++)
        store_element(reference, &vector->z, i, z->present[i]);
    use_target(reference, &vector->z, z->places);
    set_length(reference, vector->fields->z, z->places);
}

static void do_packed(struct reference *reference, const struct vector *vector,
                      struct packed *a, struct packed *b)
{
    struct order z = { .given = vector->fields->g & C205_G_GIVEN };
    z.places = z.given ? vector->z.length : greater(a->order.length, b->order.length);
    read_order(reference, a, z.places);
    read_order(reference, b, z.places);
    find_results(reference, vector, a, b, &z);
    use_packed(reference, vector, a, b, &z);
    make_elements(reference, vector, a, b, &z);
    use_target(reference, &vector->c, z.ones);
    reference->deed.elements = greater(z.ones, greater(a->ones, b->ones));
    reference->deed.results = z.ones;
    set_length(reference, vector->fields->c, z.ones);
    if (!z.given)
        store_order(reference, vector, &z);
    free(a->present);
    free(b->present);
    free(z.present);
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
    a.elements.magnitude = fields->g & C205_G_MAGNITUDE_A;
    a.elements.negate = fields->g & C205_G_NEGATE_A;
    b.elements.magnitude = fields->g & C205_G_MAGNITUDE_B;
    take_targets(reference, &vector);
    if (!has_bad_operand(reference))
        do_packed(reference, &vector, &a, &b);
}
