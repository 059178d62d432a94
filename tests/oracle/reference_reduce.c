/* reference_reduce.c - reductions of vectors to one number or one index. */
#include "reference_vector.h"

/* Executes a select. All elements are evaluated, because all their addresses are
 * used. */
static void select_first(struct reference *reference, const struct vector *vector,
                         uint64_t length)
{
    uint64_t first = length, flags = 0;
    for (uint64_t i = length; i-- > 0;) {
        bool passes = join(reference, &vector->sources, i, &flags);
        if (permitted(reference, vector, i) && passes)
            first = i;
    }
    write_register(reference, vector->fields->c, first);
}

/* Writes to the register or half register C plus `behind`. */
static void write_result(struct reference *reference, const struct vector *vector,
                         unsigned behind, c205_word word)
{
    const c205_fields *fields = vector->fields;
    write_operand(reference, reference_letter(vector->insn, fields->g, 'C'),
                  fields->c + behind, word);
}

/* An unnormalised sum in double precision. */
struct parts {
    c205_word upper, lower;
};

/* Adds a term, which has an upper part and, if `both` is true, a lower part. */
static struct parts add_term(const struct oracle_format *format, struct parts sum,
                             const struct parts *term, bool both, uint64_t *flags)
{
    c205_word below = oracle_add_lower(format, sum.upper, term->upper, flags);
    sum.lower = oracle_add_upper(format, sum.lower, below, flags);
    if (both)
        sum.lower = oracle_add_upper(format, sum.lower, term->lower, flags);
    sum.upper = oracle_add_upper(format, sum.upper, term->upper, flags);
    return sum;
}

/* Returns element i of A, or the parts of its product with element i of B. */
static struct parts term(struct reference *reference, const struct vector *vector,
                         uint64_t i, uint64_t *flags)
{
    const struct pair *sources = &vector->sources;
    c205_word a = element(reference, &sources->a, i), b;
    if (!sources->has_b)
        return (struct parts){ a, 0 };
    b = element(reference, &sources->b, i);
    return (struct parts){
        .upper = oracle_multiply_upper(sources->format, a, b, flags),
        .lower = oracle_multiply_lower(sources->format, a, b, flags),
    };
}

/* Executes a sum. If C is register 0, neither part of the sum is written. */
static void sum_up(struct reference *reference, const struct vector *vector,
                   uint64_t length)
{
    const struct pair *sources = &vector->sources;
    struct parts sum = { C205_MACHINE_ZERO, C205_MACHINE_ZERO };
    for (uint64_t i = 0; i < length; i++) {
        uint64_t flags = 0;
        struct parts next = term(reference, vector, i, &flags);
        next = add_term(sources->format, sum, &next, sources->has_b, &flags);
        if (permitted(reference, vector, i)) {
            reference->now.flags |= flags;
            sum = next;
        }
    }
    if (vector->fields->c == 0)
        return;
    write_result(reference, vector, 0, sum.upper);
    write_result(reference, vector, 1, sum.lower);
}

static void multiply_up(struct reference *reference, const struct vector *vector,
                        uint64_t length)
{
    const struct oracle_format *format = vector->sources.format;
    c205_word total = format == &oracle_half ? HALF_ONE : C205_ONE;
    for (uint64_t i = 0; i < length; i++) {
        uint64_t flags = 0;
        c205_word next = element(reference, &vector->sources.a, i);
        next = oracle_multiply_significant(format, total, next, &flags);
        if (permitted(reference, vector, i)) {
            reference->now.flags |= flags;
            total = next;
        }
    }
    write_result(reference, vector, 0, total);
}

static bool is_indefinite(c205_word word)
{
    return word >> 60 == 7;
}

/* Returns true if word replaces best. An equal element does not replace it, and nothing
 * replaces an indefinite best. */
static bool surpasses(const struct oracle_format *format, c205_word word,
                      c205_word best, bool greatest)
{
    uint64_t flags = 0;
    if (is_indefinite(best))
        return false;
    return is_indefinite(word)
           || (greatest ? oracle_less(format, best, word, &flags)
                        : oracle_less(format, word, best, &flags));
}

/* Executes a maximum or minimum. If value and index have the same register, the
 * register receives the value. */
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
    reference->now.flags |= is_indefinite(best) ? FLAG_INDEFINITE
                            : best >> 60 == 8   ? FLAG_MACHINE_ZERO
                                                : 0;
    write_register(reference, vector->fields->b, index);
    write_result(reference, vector, 0, best);
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
    case DO_DOTV: sum_up(reference, vector, length); break;
    case DO_PRODV: multiply_up(reference, vector, length); break;
    case DO_MAXV:
    case DO_MINV: extreme(reference, vector, length, which == DO_MAXV); break;
    default: select_first(reference, vector, length);
    }
}
