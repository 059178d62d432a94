/* reference_reduce.c - vectors brought to one number or one index. */
#include "reference_vector.h"

/* All of them are looked at, as all addresses are. */
static void select_first(struct reference *reference,
                         const struct vector *vector, uint64_t length)
{
    uint64_t first = length, flags = 0;

    for (uint64_t i = length; i-- > 0;) {
        bool passes = join(reference, &vector->sources, i, &flags);
        if (permitted(reference, vector, i) && passes)
            first = i;
    }
    write_register(reference, vector->fields->c, first);
}

/* Element i of A, or its product with that of B. */
static c205_word term(struct reference *reference,
                      const struct vector *vector, uint64_t i,
                      uint64_t *flags)
{
    const struct pair *sources = &vector->sources;
    c205_word a = element(reference, &sources->a, i);

    if (!sources->has_b)
        return a;
    return oracle_multiply_significant(sources->format, a,
                                       element(reference, &sources->b, i),
                                       flags);
}

/* To the register, or half register, C. */
static void write_result(struct reference *reference,
                         const struct vector *vector, c205_word word)
{
    const c205_fields *fields = vector->fields;

    write_operand(reference, reference_letter(vector->insn, fields->g, 'C'),
                  fields->c, word);
}

/* From a first value on, in element order. */
static void accumulate(struct reference *reference,
                       const struct vector *vector, uint64_t length,
                       c205_word total, oracle_rule *rule)
{
    for (uint64_t i = 0; i < length; i++) {
        uint64_t flags = 0;
        c205_word next = term(reference, vector, i, &flags);
        c205_word sum = rule(vector->sources.format, total, next, &flags);
        if (permitted(reference, vector, i)) {
            reference->now.flags |= flags;
            total = sum;
        }
    }
    write_result(reference, vector, total);
}

static bool is_indefinite(c205_word word)
{
    return word >> 60 == 7;
}

static bool is_machine_zero(c205_word word)
{
    return word >> 60 == 8;
}

/* The first of equals stays, and so does the first indefinite. */
static bool surpasses(const struct oracle_format *format, c205_word word,
                      c205_word best, bool greatest)
{
    uint64_t flags = 0;

    if (is_indefinite(best))
        return false;
    if (is_indefinite(word))
        return true;
    return greatest ? oracle_less(format, best, word, &flags)
                    : oracle_less(format, word, best, &flags);
}

static void extreme(struct reference *reference, const struct vector *vector,
                    uint64_t length, bool greatest)
{
    c205_word best = C205_INDEFINITE;
    uint64_t index = length;

    for (uint64_t i = 0; i < length; i++) {
        c205_word word = element(reference, &vector->sources.a, i);
        if (permitted(reference, vector, i)
            && (index == length
                || surpasses(vector->sources.format, word, best, greatest))) {
            best = word;
            index = i;
        }
    }
    reference->now.flags |= is_indefinite(best)     ? FLAG_INDEFINITE
                            : is_machine_zero(best) ? FLAG_MACHINE_ZERO
                                                    : 0;
    write_result(reference, vector, best);
    write_register(reference, vector->fields->c + 1u, index);
}

void do_reduction(struct reference *reference, const struct vector *vector)
{
    enum reference_insn which = reference_which(vector->insn);
    uint64_t length;

    if (!scan_length(reference, vector, &length))
        return;
    reference->deed.elements = length;
    use_source(reference, &vector->sources.a, length);
    use_source(reference, &vector->sources.b, length);
    use_control(reference, vector, length);
    switch (which) {
    case DO_SUMV:
    case DO_DOTV:
        accumulate(reference, vector, length, C205_MACHINE_ZERO,
                   oracle_add_normalised);
        break;
    case DO_PRODV:
        accumulate(reference, vector, length,
                   vector->c.width == HALF_BITS ? HALF_ONE : C205_ONE,
                   oracle_multiply_significant);
        break;
    case DO_MAXV:
    case DO_MINV: extreme(reference, vector, length, which == DO_MAXV); break;
    default: select_first(reference, vector, length);
    }
}
