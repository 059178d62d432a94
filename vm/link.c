/* link.c - the link prefix, which runs two vector instructions as one stream.
 *
 * The result of the first instruction goes to the second without passing through
 * memory. Memory has two read paths, so at most two of the other sources of the pair
 * may be vectors.
 */
#include "vm/direct.h"
#include "vm/vector.h"

static bool is_vector_a(const struct decoded *decoded)
{
    return !(decoded->fields.g & C205_G_BROADCAST_A);
}

static bool is_vector_b(const struct decoded *decoded)
{
    return decoded->insn->format != C205_FORMAT_UNARY
           && !(decoded->fields.g & C205_G_BROADCAST_B);
}

static bool is_linked_a(const struct decoded *first, const struct decoded *second)
{
    return is_vector_a(second) && second->fields.a == first->fields.c;
}

static bool is_linked_b(const struct decoded *first, const struct decoded *second)
{
    return is_vector_b(second) && second->fields.b == first->fields.c;
}

static int read_paths(const struct decoded *first, const struct decoded *second)
{
    return is_vector_a(first) + is_vector_b(first)
           + (is_vector_a(second) && !is_linked_a(first, second))
           + (is_vector_b(second) && !is_linked_b(first, second));
}

static bool makes_bits(const struct decoded *decoded)
{
    return decoded->width[OPERAND_C] == 1;
}

/* Returns the first rule that the pair breaks, or RULE_NONE. */
static enum rule rule_against(const struct decoded *first, const struct decoded *second)
{
    bool a = is_linked_a(first, second), b = is_linked_b(first, second);
    if (first->insn->unit == second->insn->unit)
        return RULE_PAIR_UNITS;
    if (makes_bits(first))
        return RULE_PAIR_RESULT;
    if ((first->fields.g ^ second->fields.g) & C205_G_HALF)
        return RULE_PAIR_SIZE;
    if (first->fields.z != 0)
        return RULE_PAIR_CONTROL;
    if (first->fields.g & C205_G_OFFSET)
        return RULE_PAIR_OFFSET;
    if (!a && !b)
        return RULE_PAIR_OPERAND;
    if ((a && second->fields.x) || (b && second->fields.y))
        return RULE_PAIR_OPERAND_OFFSET;
    return read_paths(first, second) <= 2 ? RULE_NONE : RULE_PAIR_PATHS;
}

/* ---- The pair as one stream --------------------------------------------- */

struct pair {
    struct stream first, second;
    const struct operation *operation_first, *operation_second;
    c205_word handed[CHUNK]; /* results of the first instruction */
};

static void hand_over(struct source *source, const c205_word *words)
{
    source->handed = words;
    source->vector.length = 0;
}

static c205_trap describe_pair(struct pair *pair, struct c205 *machine,
                               const struct decoded *const *linked)
{
    c205_trap trap = stream_describe(&pair->first, machine, linked[0]);
    if (trap == C205_TRAP_NONE)
        trap = stream_describe(&pair->second, machine, linked[1]);
    if (trap == C205_TRAP_NONE && pair->first.n != pair->second.n)
        trap = machine_refuse(machine, RULE_PAIR_LENGTH);
    if (is_linked_a(linked[0], linked[1]))
        hand_over(&pair->second.a, pair->handed);
    if (is_linked_b(linked[0], linked[1]))
        hand_over(&pair->second.b, pair->handed);
    pair->operation_first = operation_of(linked[0]);
    pair->operation_second = operation_of(linked[1]);
    return trap;
}

static c205_trap claim_pair(struct pair *pair)
{
    const struct vector *result = &pair->second.result;
    c205_trap trap = stream_claim_sources(&pair->first);
    if (trap == C205_TRAP_NONE)
        trap = stream_claim(&pair->second);
    if (trap != C205_TRAP_NONE)
        return trap;
    const struct source *const sources[] = { &pair->first.a, &pair->first.b,
                                             &pair->second.a, &pair->second.b };
    record_recurrence(pair->second.machine, result, pair->second.n, sources, 4);
    size_t chunk = pair->second.chunk;
    chunk = operand_lead(&pair->first.a.vector, result, chunk);
    pair->second.chunk = operand_lead(&pair->first.b.vector, result, chunk);
    return C205_TRAP_NONE;
}

static c205_trap run_pair(struct pair *pair)
{
    struct stream *one = &pair->first, *two = &pair->second;
    bool apart = !operands_overlap(&one->a.vector, &two->result)
                 && !operands_overlap(&one->b.vector, &two->result);
    for (size_t first = two->turn.first, n; first < two->turn.end; first += n) {
        n = stream_next(two, first);
        operate(two->machine, pair->operation_first, pair->handed,
                source_read(&one->a, first, n), source_read(&one->b, first, n), n,
                NULL);
        stream_step(two, pair->operation_second, first, n, apart);
    }
    return stream_end(two);
}

c205_trap execute_link_pair(struct c205 *machine, const struct decoded *decoded)
{
    struct pair pair;
    c205_trap trap = decode_pair(machine, decoded);
    if (trap != C205_TRAP_NONE)
        return trap;
    enum rule rule = rule_against(decoded->linked[0], decoded->linked[1]);
    if (rule != RULE_NONE)
        return machine_refuse(machine, rule);
    if (direct_pair(machine, decoded->linked,
                    is_linked_a(decoded->linked[0], decoded->linked[1]),
                    is_linked_b(decoded->linked[0], decoded->linked[1])))
        return C205_TRAP_NONE;
    trap = describe_pair(&pair, machine, decoded->linked);
    if (trap == C205_TRAP_NONE)
        trap = claim_pair(&pair);
    return trap == C205_TRAP_NONE ? run_pair(&pair) : trap;
}
