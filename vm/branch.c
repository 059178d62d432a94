/* branch.c - executes branches and requests to the monitor. */
#include "vm/machine.h"
#include "vm/number/fast_path.h"

static c205_trap go_to(struct c205 *machine, uint64_t target)
{
    target = LOW(target);
    if (target % INSTRUCTION_STEP)
        return machine_fault(machine, machine_refuse(machine, RULE_ALIGNED_CODE),
                             target);
    machine->effect.taken = machine->effect.ends = true;
    machine->effect.target = target;
    return C205_TRAP_NONE;
}

/* ---- Targets in registers ---------------------------------------------- */

#define BRANCH_IF(name, comparison) \
    c205_trap execute_##name(struct c205 *machine, const struct decoded *d) \
    { \
        if (!comparison(machine->slot[d->a], machine->slot[d->b])) \
            return C205_TRAP_NONE; \
        return go_to(machine, machine->slot[d->c]); \
    }

#define BRANCH_IF_HALF(name, comparison) \
    c205_trap execute_##name(struct c205 *machine, const struct decoded *d) \
    { \
        if (!comparison(machine_half(machine, d->a, d->shift[OPERAND_A]), \
                        machine_half(machine, d->b, d->shift[OPERAND_B]))) \
            return C205_TRAP_NONE; \
        return go_to(machine, machine->slot[d->c]); \
    }

#define RELATION(name) \
    BRANCH_IF(branch_##name, fast_##name) \
    BRANCH_IF_HALF(branch_half_##name, half_##name)
#include "vm/arith.def"

/* Returns the branch target, the bit address T + 32 S. */
static uint64_t item_target(const struct c205 *machine, const struct decoded *decoded)
{
    return machine->slot[decoded->c] + machine->slot[decoded->b] * INSTRUCTION_STEP;
}

static c205_trap count_and_branch(struct c205 *machine, const struct decoded *decoded,
                                  uint64_t step)
{
    c205_word count = machine->slot[decoded->a];
    uint64_t target = item_target(machine, decoded);
    c205_trap trap = C205_TRAP_NONE;
    count = HIGH(count) | LOW(count + step);
    if (LOW(count) != 0)
        trap = go_to(machine, target);
    if (trap == C205_TRAP_NONE)
        machine->slot[decoded->result[0]] = count;
    return trap;
}

c205_trap execute_increase_branch(struct c205 *machine, const struct decoded *decoded)
{
    return count_and_branch(machine, decoded, 1);
}

c205_trap execute_decrease_branch(struct c205 *machine, const struct decoded *decoded)
{
    return count_and_branch(machine, decoded, UINT64_MAX);
}

c205_trap execute_branch_save(struct c205 *machine, const struct decoded *decoded)
{
    c205_trap trap = go_to(machine, item_target(machine, decoded));
    if (trap == C205_TRAP_NONE)
        machine->slot[decoded->a] = decoded->next;
    return trap;
}

c205_trap execute_branch_immediate(struct c205 *machine, const struct decoded *decoded)
{
    return go_to(machine,
                 (uint64_t)decoded->fields.immediate + machine->slot[decoded->a]);
}

/* ---- Branch on a bit and alter it -------------------------------------- */

enum { CONDITION_SHIFT = 2, ALTERATION_MASK = 3 };

/* Whether the branch is taken for a zero bit and for a one bit, by the high half of I4:
 * never, always, on a one, on a zero. */
static const bool branches[4][2] = {
    { false, false }, { true, true }, { false, true }, { true, false }
};
/* The new value of a zero bit and of a one bit, by the low half of I4: unchanged,
 * inverted, zero, one. */
static const bool altered[4][2] = {
    { false, true }, { true, false }, { false, false }, { true, true }
};

static c205_trap branch_and_alter(struct c205 *machine, const struct decoded *decoded,
                                  c205_word *word, uint64_t number)
{
    int64_t how = decoded->fields.immediate;
    uint64_t mask = UINT64_C(1) << (63 - number % WORD_BITS);
    bool bit = *word & mask;
    c205_trap trap = C205_TRAP_NONE;
    if (branches[how >> CONDITION_SHIFT][bit])
        trap = go_to(machine, machine->slot[decoded->c]);
    if (trap != C205_TRAP_NONE)
        return trap;
    *word = altered[how & ALTERATION_MASK][bit] ? *word | mask : *word & ~mask;
    return C205_TRAP_NONE;
}

c205_trap execute_alter_register_bit(struct c205 *machine,
                                     const struct decoded *decoded)
{
    c205_word word = machine->slot[decoded->a];
    c205_trap trap = branch_and_alter(machine, decoded, &word,
                                      machine->slot[decoded->b]);
    if (trap == C205_TRAP_NONE)
        machine->slot[decoded->result[0]] = word;
    return trap;
}

c205_trap execute_alter_flag(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t flags = machine_flags(machine);
    c205_trap trap = branch_and_alter(machine, decoded, &flags,
                                      machine->slot[decoded->a]);
    if (trap == C205_TRAP_NONE)
        *machine_raise_flags(machine) = flags;
    return trap;
}

/* Branches on a bit of memory and alters the bit. A bit that remains unaltered may be
 * in read-only memory. */
c205_trap execute_alter_memory_bit(struct c205 *machine, const struct decoded *decoded)
{
    struct memory *memory = &machine->memory;
    uint64_t address = LOW(machine->slot[decoded->a] + machine->slot[decoded->b]);
    uint64_t place = address - address % WORD_BITS;
    bool alters = decoded->fields.immediate & ALTERATION_MASK;
    c205_word word = 0;
    c205_trap trap = memory_check(memory, address, 1, alters, &machine->fault);
    if (trap != C205_TRAP_NONE)
        return trap;
    memory_read_words(memory, place, &word, 1);
    trap = branch_and_alter(machine, decoded, &word, address);
    if (trap == C205_TRAP_NONE && alters)
        memory_write_words(memory, place, &word, 1);
    if (trap == C205_TRAP_NONE)
        machine_touch_as(machine, address, 1, alters);
    return trap;
}

/* ---- Targets by distance, or (Y) + (B) --------------------------------- */

static c205_trap go_to_near(struct c205 *machine, const struct decoded *decoded)
{
    const c205_fields *fields = &decoded->fields;
    if (fields->g & C205_G_RELATIVE)
        return go_to(machine,
                     decoded->pc + (uint64_t)fields->immediate * INSTRUCTION_STEP);
    return go_to(machine, machine->slot[decoded->y] + machine->slot[decoded->b]);
}

#define INDEX_BRANCH_IF(name, comparison) \
    c205_trap execute_##name(struct c205 *machine, const struct decoded *d) \
    { \
        uint64_t sum = LOW(machine->slot[d->a] + machine->slot[d->x]); \
        c205_trap trap = C205_TRAP_NONE; \
        if (word_coefficient(sum) comparison word_coefficient(machine->slot[d->z])) \
            trap = go_to_near(machine, d); \
        if (trap == C205_TRAP_NONE) \
            machine->slot[d->c] = sum; \
        return trap; \
    }

INDEX_BRANCH_IF(index_branch_equal, ==)
INDEX_BRANCH_IF(index_branch_not_equal, !=)
INDEX_BRANCH_IF(index_branch_not_less, >=)
INDEX_BRANCH_IF(index_branch_less, <)
INDEX_BRANCH_IF(index_branch_not_greater, <=)
INDEX_BRANCH_IF(index_branch_greater, >)

static bool not_greater(c205_word a, c205_word b)
{
    return fast_not_less(b, a);
}

static bool greater(c205_word a, c205_word b)
{
    return fast_less(b, a);
}

#define FLOAT_BRANCH_IF(name, comparison) \
    c205_trap execute_##name(struct c205 *machine, const struct decoded *d) \
    { \
        if (!comparison(machine->slot[d->a], machine->slot[d->z])) \
            return C205_TRAP_NONE; \
        return go_to_near(machine, d); \
    }

#define RELATION(name) FLOAT_BRANCH_IF(float_branch_##name, fast_##name)
#include "vm/arith.def"
FLOAT_BRANCH_IF(float_branch_not_greater, not_greater)
FLOAT_BRANCH_IF(float_branch_greater, greater)

/* ---- The monitor ------------------------------------------------------- */

/* The width in bits of the vector elements that each request prints. Operand R is a
 * descriptor if the width is not 0. Request 0 ends the program, 1-3 print R, 4 prints
 * bytes, 5 a newline, 6 words, 7 bits. */
static const unsigned request_width[REQUESTS] = { 0, 0, 0, 0, 8, 0, 64, 1 };

static c205_trap check_request(struct c205 *machine, unsigned request, c205_word r)
{
    uint64_t bits = (r >> LENGTH_SHIFT) * request_width[request];
    if (bits > 0 && LOW(r) % request_width[request])
        return machine_fault(machine, machine_refuse(machine, RULE_ALIGNED_BYTES),
                             LOW(r));
    return memory_check(&machine->memory, LOW(r), bits, false, &machine->fault);
}

c205_trap execute_monitor_request(struct c205 *machine, const struct decoded *decoded)
{
    uint64_t request = (uint64_t)decoded->fields.immediate;
    if (request >= REQUESTS)
        return C205_TRAP_BAD_REQUEST;
    c205_trap trap = check_request(machine, (unsigned)request,
                                   machine->slot[decoded->a]);
    if (trap != C205_TRAP_NONE)
        return trap;
    machine->request = (unsigned)request;
    machine->eventful = true;
    return C205_TRAP_NONE;
}
