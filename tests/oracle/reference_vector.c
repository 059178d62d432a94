/* reference_vector.c - vector instructions, one element at a time. */
#include "reference_vector.h"

#include <string.h>

/* ---- Element by element ------------------------------------------------ */

static void each_element(struct reference *reference, const struct vector *vector)
{
    for (uint64_t i = 0; i < vector->c.length; i++) {
        uint64_t flags = 0;
        c205_word word = join(reference, &vector->sources, i, &flags);
        write_element(reference, vector, i, word, flags);
    }
}

/* Executes an instruction that combines each element of A with its successor. */
static void each_neighbour(struct reference *reference, const struct vector *vector)
{
    const struct source *a = &vector->sources.a;
    for (uint64_t i = 0; i < vector->c.length; i++) {
        uint64_t flags = 0;
        c205_word here = element(reference, a, i);
        c205_word next = element(reference, a, i + 1);
        c205_word word = vector->sources.rule(vector->sources.format, next, here,
                                              &flags);
        write_element(reference, vector, i, word, flags);
    }
}

/* Evaluates the polynomial with coefficients B, from the highest to the lowest. */
static c205_word polynomial(struct reference *reference, const struct pair *pair,
                            c205_word x, uint64_t *flags)
{
    const struct source *b = &pair->b;
    c205_word value = b->length > 0 ? element(reference, b, 0) : C205_MACHINE_ZERO;
    for (uint64_t j = 1; j < b->length; j++) {
        value = oracle_multiply_significant(pair->format, value, x, flags);
        value = oracle_add_normalised(pair->format, value, element(reference, b, j),
                                      flags);
    }
    return value;
}

/* Returns the first index of B to which x has the relation, or the length. */
static c205_word search(struct reference *reference, const struct pair *pair,
                        c205_word x, uint64_t *compared)
{
    uint64_t flags = 0;
    for (uint64_t j = 0; j < pair->b.length; j++) {
        ++*compared;
        if (pair->rule(pair->format, x, element(reference, &pair->b, j), &flags))
            return j;
    }
    return pair->b.length;
}

/* The most steps of a polynomial or a search. With more, the comparison ends. */
enum { PATIENCE = 100000 };

/* Returns true if a polynomial's A(i) or a coefficient is an earlier result. */
static bool scan_recurs(const struct vector *vector, uint64_t i)
{
    const struct pair *pair = &vector->sources;
    bool found = lies_on_results(&pair->a, i, &vector->c, i);
    for (uint64_t j = 0; j < pair->b.length; j++)
        found |= lies_on_results(&pair->b, j, &vector->c, i);
    return found;
}

/* Executes an instruction that combines each element of A with all elements of B. */
static void each_scan(struct reference *reference, const struct vector *vector)
{
    const struct pair *pair = &vector->sources;
    uint64_t steps = 0;
    if (vector->c.length * pair->b.length > PATIENCE) {
        reference->lost = true;
        return;
    }
    may_need(reference, &pair->b, vector->c.length > 0 ? pair->b.length : 0);
    for (uint64_t i = 0; i < vector->c.length; i++) {
        uint64_t flags = 0;
        c205_word x = element(reference, &pair->a, i);
        c205_word word = pair->rule ? search(reference, pair, x, &steps)
                                    : polynomial(reference, pair, x, &flags);
        if (!pair->rule)
            reference->deed.recurrent += scan_recurs(vector, i);
        write_element(reference, vector, i, word, flags);
    }
    reference->deed.elements = pair->rule ? steps : vector->c.length * pair->b.length;
}

static void interval(struct reference *reference, const struct vector *vector)
{
    c205_word step = element(reference, &vector->sources.b, 0);
    c205_word word = element(reference, &vector->sources.a, 0);
    uint64_t flags = 0;
    for (uint64_t i = 0; i < vector->c.length; i++) {
        write_element(reference, vector, i, word, flags);
        flags = 0;
        word = oracle_add_upper(vector->sources.format, word, step, &flags);
    }
}

/* Computes comparisons and bit strings. */
static void each_bit(struct reference *reference, const struct vector *vector)
{
    for (uint64_t i = 0; i < vector->c.length; i++) {
        uint64_t flags = 0;
        write_element(reference, vector, i,
                      join(reference, &vector->sources, i, &flags), 0);
    }
}

static void count_bits(struct reference *reference, const c205_fields *fields,
                       bool leading)
{
    c205_word string = read_bits(reference, fields->r);
    bool first = length_of(string) > 0 && read_memory(reference, string, BIT);
    uint64_t count = 0;
    bool equal = true;
    reference->deed.elements = length_of(string);
    add_extent(reference, string, length_of(string));
    for (uint64_t i = 0; i < length_of(string); i++) {
        bool bit = read_memory(reference, string + i, BIT);
        equal = equal && bit == first;
        count += leading ? equal : bit;
    }
    write_register(reference, fields->t, count);
}

/* Fills groups of S bits. The first R bits of each group are equal. */
static void repeat_bits(struct reference *reference, const c205_fields *fields,
                        bool ones)
{
    int64_t r = as_integer(read_bits(reference, fields->r));
    int64_t s = as_integer(read_bits(reference, fields->s));
    c205_word string = read_bits(reference, fields->t);
    if (s < 1) {
        add_fault(reference, C205_TRAP_BAD_DESCRIPTOR, 0, true);
        return;
    }
    reference->deed.elements = length_of(string);
    add_extent(reference, string, length_of(string));
    for (uint64_t i = 0; i < length_of(string); i++)
        write_memory(reference, string + i, BIT,
                     ((int64_t)(i % (uint64_t)s) < r) == ones);
}

/* ---- Which of them ----------------------------------------------------- */

static bool takes_neighbours(const c205_insn *insn)
{
    return reference_which(insn) == DO_DELTAV || reference_which(insn) == DO_ADJMV;
}

/* Returns the second source of an instruction on neighbours: A(1) and later. */
static struct source next_of(const struct vector *vector)
{
    struct source next = vector->sources.a;
    if (!takes_neighbours(vector->insn) || next.length == 0)
        return (struct source){ .kind = NUMBER };
    next.address = plain_address(next.address + next.width);
    next.length--;
    return next;
}

/* Records the use of n elements of A, B, Z and C. */
static void use_operands(struct reference *reference, const struct vector *vector)
{
    uint64_t n = vector->c.length;
    struct source next = next_of(vector);
    reference->deed.elements = n;
    use_source(reference, &next, n);
    use_source(reference, &vector->sources.a, n);
    use_source(reference, &vector->sources.b,
               n > 0 && vector->insn->format == C205_FORMAT_SCAN ? C205_MAX_LENGTH : n);
    use_control(reference, vector, n);
    use_target(reference, &vector->c, n);
}

/* ---- Recurrences ------------------------------------------------------- */

bool lies_on_results(const struct source *source, uint64_t i, const struct target *c,
                     uint64_t stored)
{
    uint64_t address = source->address + source->width * i;
    return source->kind == VECTOR && i < source->length
           && address + source->width > c->address
           && address < c->address + c->width * stored;
}

/* Counts the elements of the result with a source among earlier results. */
static uint64_t recurrences(const struct source *sources, size_t count,
                            const struct target *c)
{
    uint64_t elements = 0;
    for (uint64_t i = 1; i < c->length; i++) {
        bool found = false;
        for (size_t k = 0; k < count; k++)
            found |= lies_on_results(sources + k, i, c, i);
        elements += found;
    }
    return elements;
}

static uint64_t own_recurrences(const struct vector *vector)
{
    const struct source sources[] = { vector->sources.a, vector->sources.b,
                                      next_of(vector) };
    return recurrences(sources, sizeof sources / sizeof sources[0], &vector->c);
}

/* Counts the sources of both instructions that are earlier results of the second. */
static uint64_t linked_recurrences(const struct vector *first,
                                   const struct vector *second)
{
    const struct source sources[] = { first->sources.a, first->sources.b,
                                      second->sources.a, second->sources.b };
    return recurrences(sources, sizeof sources / sizeof sources[0], &second->c);
}

/* ---- By kind ----------------------------------------------------------- */

/* Executes an instruction with one word, half word or bit of result per element. */
static void each_result(struct reference *reference, const struct vector *vector)
{
    if (strchr(vector->insn->operands, 'e'))
        each_bit(reference, vector);
    else
        each_element(reference, vector);
}

static void do_operands(struct reference *reference, const struct vector *vector)
{
    if (strpbrk(vector->insn->operands, "wkp")) {
        do_reduction(reference, vector);
        return;
    }
    if (do_move(reference, vector))
        return;
    use_operands(reference, vector);
    if (vector->insn->format == C205_FORMAT_SCAN) {
        each_scan(reference, vector);
        return;
    }
    if (vector->insn->format != C205_FORMAT_STRING)
        reference->deed.recurrent = own_recurrences(vector);
    if (takes_neighbours(vector->insn))
        each_neighbour(reference, vector);
    else if (reference_which(vector->insn) == DO_INTVLV)
        interval(reference, vector);
    else
        each_result(reference, vector);
}

void do_vector(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields)
{
    struct vector vector;
    if (insn->format == C205_FORMAT_BITS1)
        count_bits(reference, fields, reference_which(insn) == DO_CNTLB);
    else if (insn->format == C205_FORMAT_REPEAT)
        repeat_bits(reference, fields, reference_which(insn) == DO_MRKO);
    else if (insn->format == C205_FORMAT_SPARSE)
        do_sparse(reference, insn, fields);
    else if (take_operands(reference, insn, fields, &vector))
        do_operands(reference, &vector);
}

/* ---- Linked pairs ------------------------------------------------------ */

/* Returns the number of streams that a pair of sources reads from memory. */
static unsigned streams(const struct pair *sources)
{
    return (sources->a.kind == VECTOR ? 1u : 0u)
           + (sources->b.kind == VECTOR ? 1u : 0u);
}

/* Replaces a source by the first instruction's result if both have the same register.
 * Returns false if the source has an offset, because it cannot be linked then. */
static bool link_source(struct source *source, unsigned number, unsigned offset,
                        const struct vector *first)
{
    if (source->kind != VECTOR || number != first->fields->c)
        return true;
    source->kind = STREAM;
    source->stream = &first->sources;
    return offset == 0;
}

/* Returns true if the first instruction can be linked. It must have no control vector
 * and no offset. It must not compare, because its results would be bits. */
static bool is_plain(const struct vector *first)
{
    return first->c.width != BIT && first->fields->z == 0
           && !(first->fields->g & C205_G_OFFSET);
}

static bool can_be_linked(const struct vector *first, struct vector *second)
{
    const c205_fields *fields = second->fields;
    bool a = link_source(&second->sources.a, fields->a, fields->x, first);
    bool b = link_source(&second->sources.b, fields->b, fields->y, first);
    bool linked = second->sources.a.kind == STREAM || second->sources.b.kind == STREAM;
    return is_plain(first) && linked && a && b
           && first->c.width == second->sources.a.width
           && first->c.length == second->c.length
           && streams(&first->sources) + streams(&second->sources) <= PAIR;
}

/* Returns true if both units work element by element, and are different. */
static bool may_link(const struct deed *deed)
{
    c205_unit first = deed->insns[1]->unit, second = deed->insns[2]->unit;
    return c205_unit_links(first) && c205_unit_links(second) && first != second;
}

void do_linked(struct reference *reference)
{
    const struct deed *deed = &reference->deed;
    struct vector first, second;
    if (!may_link(deed)) {
        add_fault(reference, C205_TRAP_BAD_LINK, deed->pc, true);
        return;
    }
    take_operands(reference, deed->insns[1], deed->fields + 1, &first);
    take_operands(reference, deed->insns[2], deed->fields + 2, &second);
    if (!can_be_linked(&first, &second))
        add_fault(reference, C205_TRAP_BAD_LINK, deed->pc, true);
    else if (!has_bad_operand(reference)) {
        use_source(reference, &first.sources.a, first.c.length);
        use_source(reference, &first.sources.b, first.c.length);
        use_operands(reference, &second);
        reference->deed.recurrent = linked_recurrences(&first, &second);
        each_result(reference, &second);
    }
}
