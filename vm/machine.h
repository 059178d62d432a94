/* machine.h - the inside of a machine, for the semantics functions. */
#ifndef C205_MACHINE_H
#define C205_MACHINE_H

#include "vm/number/arith.h"
#include "vm/time/clock.h"
#include "vm/block.h"
#include "vm/memory.h"
#include "vm/resume_state.h"

/* Code from begin to end belongs to a region of the accounts. */
struct region_range {
    uint64_t begin, end;
    uint32_t region;
};

struct serializer;

/* Places for vectors that need a copy. */
enum scratch {
    SCRATCH_KEPT, /* continues with an instruction that was interrupted */
    SCRATCH_OLD_WORDS,
    SCRATCH_ADDRESSES,
    SCRATCH_ORDERS, /* of sparse vectors */
    SCRATCHES
};

/* The job interval timer has run out (R); the others are arithmetic's. */
#define FLAG_TIMER (UINT64_C(1) << (63 - 36))

/* What must hold (rules.def). */
enum rule {
    RULE_NONE,
#define RULE(name, trap, text) RULE_##name,
#include "vm/rules.def"
#undef RULE
    RULES
};

enum { REQUEST_EXIT, REQUESTS = 8, NO_REQUEST = REQUESTS };

struct c205 {
    c205_word slot[SLOTS]; /* slot[0] is always 0 */
    uint64_t pc;
    uint64_t data_flags;
    uint64_t timer;   /* the clock at which the job interval timer
                                 runs out, or 0: it is off */
    uint64_t program; /* hash of what was loaded, or 0 */
    struct clock *clock;
    struct decode_cache *cache;
    struct blocks *blocks;
    const c205_model *model;
    struct effect effect;           /* of the instruction being executed .. */
    const struct decoded *executed; /* .. which listeners are told of */
    c205_times record;              /* .. and its time */
    struct resume_state resume;     /* of the one that was interrupted */
    size_t allowed;                 /* elements of this one before the clock limit
                                 comes, SIZE_MAX: any number */
    uint64_t resumed_at;            /* the clock shown when the run began */
    uint64_t fault;                 /* operand address of a trap .. */
    enum rule rule;                 /* .. and the rule that was broken, if known */
    unsigned request;               /* that EXIT just made, or NO_REQUEST */
    bool eventful; /* EXIT was executed, somebody listens, or there are stops */
    bool pausing;  /* a listener has asked for an end of the run */
    struct machine_breakpoints *breakpoints; /* NULL: none were ever set */
    unsigned listener_count;
    struct {
        c205_listener *call;
        void *context;
    } listener[C205_LISTENERS];
    size_t range_count; /* code ranges of regions, by address */
    struct region_range *ranges;
    c205_word *scratch[SCRATCHES]; /* allocated when first wanted */
    struct memory memory;
};

/* The parts of a descriptor: its length, its address.  Indices and integers
 * have their bits where the address is. */
enum { LENGTH_SHIFT = 48 };
#define HIGH(word) ((word) & ~ADDRESS_MASK)
#define LOW(word) ((word)&ADDRESS_MASK)

static inline c205_word with_length(c205_word descriptor, size_t length)
{
    return LOW(descriptor) | (c205_word)length << LENGTH_SHIFT;
}

/* C205_MAX_LENGTH words and one, or NULL: the host has no memory left. */
c205_word *machine_scratch(struct c205 *machine, enum scratch which);

/* The instruction read this range of memory, or stored into it. */
static inline void machine_touch_as(struct c205 *machine, uint64_t address,
                                    uint64_t bits, bool stored)
{
    struct effect *effect = &machine->effect;
    struct touch *touch = &effect->touch[effect->touch_count++];
    touch->address = address;
    touch->bits = bits;
    touch->stored = stored;
}

static inline void machine_touch(struct c205 *machine, uint64_t address, uint64_t bits)
{
    machine_touch_as(machine, address, bits, false);
}

static inline void machine_touch_result(struct c205 *machine, uint64_t address,
                                        uint64_t bits)
{
    machine_touch_as(machine, address, bits, true);
}

/* A half register, in the left half of a word. */
static inline c205_word machine_half(const struct c205 *machine, uint16_t slot,
                                     uint8_t shift)
{
    return machine->slot[slot] << shift & LEFT_HALF;
}

/* The other half of the register stays. */
static inline void machine_set_half(struct c205 *machine, uint16_t slot, uint8_t shift,
                                    c205_word half)
{
    c205_word other = ~(LEFT_HALF >> shift);
    machine->slot[slot] = (machine->slot[slot] & other) | half >> shift;
}

/* To C, a register or a half register. */
static inline void machine_deliver(struct c205 *machine, const struct decoded *decoded,
                                   c205_word number)
{
    if (decoded->width[OPERAND_C] == HALF_BITS)
        machine_set_half(machine, decoded->c, decoded->shift[OPERAND_C], number);
    else
        machine->slot[decoded->c] = number;
}

/* To C and the register behind it, or the two halves of a register. */
static inline void machine_deliver_parts(struct c205 *machine,
                                         const struct decoded *decoded, c205_word upper,
                                         c205_word lower)
{
    bool half = decoded->width[OPERAND_C] == HALF_BITS;
    if (decoded->c == SLOT_SINK)
        return;
    if (half)
        machine->slot[decoded->c] = upper | lower >> HALF_BITS;
    else {
        machine->slot[decoded->c] = upper;
        machine->slot[decoded->c + 1] = lower;
    }
}

/* Of n elements those from where the instruction was interrupted up to where
 * it will be, which is after so many. */
static inline struct turn machine_turn(const struct c205 *machine, size_t n,
                                       size_t allowed)
{
    struct turn turn = { machine->resume.first, allowed, n };
    if (turn.first > n)
        turn.first = n;
    if (turn.end > n)
        turn.end = n;
    if (turn.end < turn.first)
        turn.end = turn.first;
    return turn;
}

/* The elements of a turn are done.  CLOCK_LIMIT: there are more, and what the
 * loop carries on to them must go to machine->resume. */
static inline c205_trap machine_end_turn(struct c205 *machine, const struct turn *turn)
{
    if (turn->end == turn->n)
        return C205_TRAP_NONE;
    machine->resume.first = turn->end;
    return C205_TRAP_CLOCK_LIMIT;
}

/* The one thing that semantics may ask of time, for instructions that read
 * the clock or the timer: how many clocks have been charged before it.  Those
 * instructions go into no block (block.c). */
static inline uint64_t machine_clocks(const struct c205 *machine)
{
    return clock_now(machine->clock);
}

static inline bool machine_timer_has_run_out(const struct c205 *machine)
{
    return machine->timer && machine_clocks(machine) >= machine->timer;
}

/* The data flags, with that of the timer when it has run out. */
static inline uint64_t machine_flags(const struct c205 *machine)
{
    return machine->data_flags | (machine_timer_has_run_out(machine) ? FLAG_TIMER : 0);
}
/* The same, to be changed; a timer that has run out is off then. */
uint64_t *machine_raise_flags(struct c205 *machine);

static inline c205_trap rule_trap(enum rule rule)
{
    switch (rule) {
#define RULE(name, trap, text) \
    case RULE_##name: \
        return C205_TRAP_##trap;
#include "vm/rules.def"
#undef RULE
    default: return C205_TRAP_NONE;
    }
}

/* The trap for a rule that does not hold. */
static inline c205_trap machine_refuse(struct c205 *machine, enum rule rule)
{
    machine->rule = rule;
    return rule_trap(rule);
}

/* A trap that has to do with an operand's address. */
static inline c205_trap machine_fault(struct c205 *machine, c205_trap trap,
                                      uint64_t address)
{
    machine->fault = address;
    return trap;
}

/* Every function named in insn.def. */
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, flags, \
             function, operation, provenance, effect) \
    semantics execute_##function;
#include "vm/insn.def"

/* Set the regions of a program (vm/region.c). */
bool machine_set_regions(struct c205 *machine, const c205_program *program,
                         c205_error *error);
uint32_t machine_region(const struct c205 *machine, uint64_t pc);
/* Regions and the names of their accounts, to or from a serializer. */
void machine_walk_regions(struct c205 *machine, struct serializer *serializer);

#endif
