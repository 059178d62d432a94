/* machine.h - the inside of a machine, for the semantics functions. */
#ifndef C205_MACHINE_H
#define C205_MACHINE_H

#include "arith.h"
#include "clock.h"
#include "decode.h"
#include "memory.h"

/* Code from begin to end belongs to a region of the accounts. */
struct region_range {
    uint64_t begin, end;
    uint32_t region;
};

struct tape;

/* Places for vectors that need a copy. */
enum scratch {
    SCRATCH_INDICES,
    SCRATCH_OLD_WORDS,
    SCRATCH_ADDRESSES,
    SCRATCHES
};

enum { REQUEST_EXIT, REQUESTS = 8, NO_REQUEST = REQUESTS };

struct c205 {
    c205_word slot[SLOTS]; /* slot[0] is always 0 */
    uint64_t pc;
    uint64_t data_flags;
    uint64_t program;         /* hash of what was loaded, or 0 */
    struct clock *clock;
    struct decode_cache *cache;
    const c205_model *model;
    struct effect effect;     /* of the instruction being executed */
    uint64_t fault;           /* operand address of a trap */
    unsigned request;         /* that EXIT just made, or NO_REQUEST */
    bool eventful;            /* EXIT was executed, or somebody listens */
    unsigned listener_count;
    struct {
        c205_listener *call;
        void *context;
    } listener[C205_LISTENERS];
    size_t range_count;       /* code ranges of regions, by address */
    struct region_range *ranges;
    c205_word *scratch[SCRATCHES]; /* allocated when first wanted */
    struct memory memory;
};

/* C205_MAX_LENGTH words and one, or NULL: the host has no memory left. */
c205_word *machine_scratch(struct c205 *machine, enum scratch which);

/* The instruction used this range of memory. */
static inline void machine_touch(struct c205 *machine, uint64_t address,
                                 uint64_t bits)
{
    struct effect *effect = &machine->effect;
    effect->touch[effect->touch_count].address = address;
    effect->touch[effect->touch_count++].bits = bits;
}

/* The one thing that semantics may ask of time, for an instruction that reads
 * the clock: how many clocks have been charged before it. */
static inline uint64_t machine_clocks(const struct c205 *machine)
{
    return clock_now(machine->clock);
}

/* A trap that has to do with an operand's address. */
static inline c205_trap machine_fault(struct c205 *machine, c205_trap trap,
                                      uint64_t address)
{
    machine->fault = address;
    return trap;
}

/* Every function named in insn.def. */
#define INSN(mnemonic, opcode, subop, mask, format, operands, unit, timing, \
             flags, function, provenance, effect) \
    semantics execute_##function;
#include "insn.def"

/* Set the regions of a program (vm/region.c). */
bool machine_set_regions(struct c205 *machine, const c205_program *program,
                         c205_error *error);
uint32_t machine_region(const struct c205 *machine, uint64_t pc);
/* Regions and the names of their accounts, to or from a tape. */
void machine_walk_regions(struct c205 *machine, struct tape *tape);

#endif
