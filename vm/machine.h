/* machine.h - the internal state of a machine, for the functions that execute
 * instructions.
 */
#ifndef C205_MACHINE_H
#define C205_MACHINE_H

#include "vm/number/arith.h"
#include "vm/time/clock.h"
#include "vm/block.h"
#include "vm/memory.h"
#include "vm/resume_state.h"

/* A range of code that belongs to a region of the accounts. */
struct region_range {
    uint64_t begin, end;
    uint32_t region;
};

struct serializer;

/* Buffers for instructions that must copy vectors, C205_MAX_LENGTH + 1 words each. */
enum scratch {
    SCRATCH_KEPT, /* saved with an interrupted instruction */
    SCRATCH_OLD_WORDS,
    SCRATCH_ADDRESSES,
    SCRATCH_ORDERS, /* order vectors of sparse vectors */
    SCRATCHES
};

/* The flag of an expired job interval timer (reconstructed). arith.h defines the other
 * flags. */
#define FLAG_TIMER (UINT64_C(1) << (63 - 36))

/* The rules of rules.def. A broken rule is a trap. */
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
    uint64_t timer;   /* the clock at which the job interval timer expires; 0: off */
    uint64_t program; /* hash of the loaded program, or 0 */
    struct clock *clock;
    struct decode_cache *cache;
    struct blocks *blocks;
    const c205_model *model;
    struct effect effect;           /* of the current instruction */
    const struct decoded *executed; /* the instruction of which listeners are
                                       notified */
    c205_times record;              /* times of that instruction */
    struct resume_state resume;     /* state of an interrupted instruction */
    size_t allowed;                 /* elements of the current instruction before the
                                       clock limit; SIZE_MAX: no limit */
    uint64_t resumed_at;            /* the clock when the run began */
    uint64_t fault;                 /* the operand address of a trap */
    enum rule rule;                 /* the rule that was broken, or RULE_NONE */
    unsigned request;               /* number of the EXIT just executed, or
                                       NO_REQUEST */
    bool eventful; /* EXIT was executed, or there are listeners, breakpoints or
                      watchpoints */
    bool pausing;  /* a listener requested the end of the run */
    struct machine_breakpoints
        *breakpoints; /* breakpoints and watchpoints; NULL: none */
    unsigned listener_count;
    struct {
        c205_listener *call;
        void *context;
    } listener[C205_LISTENERS];
    size_t range_count; /* code ranges of regions, in the order of addresses */
    struct region_range *ranges;
    c205_word *scratch[SCRATCHES]; /* allocated on first use */
    struct memory memory;
};

/* A descriptor has a length in its high 16 bits and an address in the low 48. An index
 * or an integer is in the low 48 bits, too. */
enum { LENGTH_SHIFT = 48 };
#define HIGH(word) ((word) & ~ADDRESS_MASK)
#define LOW(word) ((word)&ADDRESS_MASK)

static inline c205_word with_length(c205_word descriptor, size_t length)
{
    return LOW(descriptor) | (c205_word)length << LENGTH_SHIFT;
}

/* Returns a buffer of C205_MAX_LENGTH + 1 words, or NULL if the host is out of
 * memory. */
c205_word *machine_scratch(struct c205 *machine, enum scratch which);

/* Records that the instruction read or stored a range of memory. */
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

/* Returns a half register in the left half of a word. */
static inline c205_word machine_half(const struct c205 *machine, uint16_t slot,
                                     uint8_t shift)
{
    return machine->slot[slot] << shift & LEFT_HALF;
}

/* Sets a half register. The other half is unchanged. */
static inline void machine_set_half(struct c205 *machine, uint16_t slot, uint8_t shift,
                                    c205_word half)
{
    c205_word other = ~(LEFT_HALF >> shift);
    machine->slot[slot] = (machine->slot[slot] & other) | half >> shift;
}

/* Stores a result in C, which is a register or a half register. */
static inline void machine_deliver(struct c205 *machine, const struct decoded *decoded,
                                   c205_word number)
{
    if (decoded->width[OPERAND_C] == HALF_BITS)
        machine_set_half(machine, decoded->c, decoded->shift[OPERAND_C], number);
    else
        machine->slot[decoded->c] = number;
}

/* Stores a result of two words in C and the next register, or a result of two half
 * words in the halves of C. */
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

/* Returns the part of n elements that an instruction processes now. The part begins at
 * the point of the interruption, if any, and ends at element `allowed`. */
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

/* Ends a turn. Returns CLOCK_LIMIT if elements are left; the caller must then store its
 * loop state in machine->resume. */
static inline c205_trap machine_end_turn(struct c205 *machine, const struct turn *turn)
{
    if (turn->end == turn->n)
        return C205_TRAP_NONE;
    machine->resume.first = turn->end;
    return C205_TRAP_CLOCK_LIMIT;
}

/* Returns the clocks charged before the current instruction. Only instructions that
 * read the clock or the timer may call this, and no block contains them (block.c). */
static inline uint64_t machine_clocks(const struct c205 *machine)
{
    return clock_now(machine->clock);
}

static inline bool machine_timer_has_run_out(const struct c205 *machine)
{
    return machine->timer && machine_clocks(machine) >= machine->timer;
}

/* Returns the data flags, including the flag of an expired timer. */
static inline uint64_t machine_flags(const struct c205 *machine)
{
    return machine->data_flags | (machine_timer_has_run_out(machine) ? FLAG_TIMER : 0);
}
/* Moves the flag of an expired timer into the data flags, switches the timer off, and
 * returns the data flags for writing. */
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

/* Records a broken rule and returns its trap. */
static inline c205_trap machine_refuse(struct c205 *machine, enum rule rule)
{
    machine->rule = rule;
    return rule_trap(rule);
}

/* Records the operand address of a trap and returns the trap. */
static inline c205_trap machine_fault(struct c205 *machine, c205_trap trap,
                                      uint64_t address)
{
    machine->fault = address;
    return trap;
}

/* Returns the recorded rule, or else the first rule of the trap, as a sentence. NULL:
 * the trap has no rule (vm/stop_text.c). */
const char *machine_broken_rule(const struct c205 *machine, c205_trap trap);

/* Discards the resume state of an interrupted vector instruction. */
void machine_clear_resume(struct c205 *machine);

/* The functions that execute the instructions of insn.def. */
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, flags, \
             function, operation, provenance, effect) \
    semantics execute_##function;
#include "vm/insn.def"

/* Sets the regions of a program (vm/region.c). */
bool machine_set_regions(struct c205 *machine, const c205_program *program,
                         c205_error *error);
uint32_t machine_region(const struct c205 *machine, uint64_t pc);
/* Serializes the regions and the names of their accounts. */
void machine_walk_regions(struct c205 *machine, struct serializer *serializer);

#endif
