/* block.c - makes and executes blocks of decoded scalar instructions. */
#include "vm/block.h"

#include "vm/machine.h"
#include "vm/time/schedule.h"

#include <stdlib.h>
#include <string.h>

/* ---- Instructions that a block may contain ------------------------------ */

/* Returns true for an instruction that reads the clock. The clock must then be charged
 * up to this instruction (machine_clocks). */
static bool asks_for_the_time(const struct decoded *decoded)
{
    static semantics *const functions[] = {
        execute_read_clock,     execute_read_timer, execute_set_timer,
        execute_exchange_flags, execute_alter_flag,
    };
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (decoded->execute == functions[i])
            return true;
    return false;
}

static bool goes_by_itself(const struct decoded *decoded)
{
    c205_timing timing = decoded->insn->timing;
    return c205_unit_is_vector(decoded->insn->unit) || timing == C205_TIMING_monitor
           || asks_for_the_time(decoded);
}

/* Returns true if a block may continue after this instruction. The words after an
 * unconditional or backward branch may not be code, so only a conditional forward
 * branch may be within a block. A program that has changed decoded code has no branch
 * within a block. The cost of SWAP depends on its operands, so SWAP ends its block. */
static bool may_go_on(const struct c205 *machine, const struct decoded *decoded)
{
    const c205_fields *fields = &decoded->fields;
    if (decoded->insn->timing == C205_TIMING_swap)
        return false;
    return decoded->insn->unit != C205_UNIT_BRANCH
           || (fields->g & C205_G_RELATIVE && fields->immediate > 0
               && !machine->memory.rewritten);
}

/* ---- Making blocks ------------------------------------------------------ */

static void forget_all(struct blocks *blocks)
{
    memset(blocks->at, 0, sizeof blocks->at);
    blocks->count = blocks->decoded_count = 0;
}

struct blocks *blocks_new(void)
{
    struct blocks *blocks = malloc(sizeof *blocks);
    if (blocks)
        forget_all(blocks);
    return blocks;
}

static void make_room_for_block(struct blocks *blocks)
{
    if (blocks->count < BLOCKS && blocks->decoded_count + BLOCK_INSNS <= BLOCK_DECODED)
        return;
    forget_all(blocks);
}

/* Adds the next instruction if the block may contain it. Returns true if the block may
 * continue. An instruction that cannot be decoded ends the block, and traps when
 * control reaches it. */
static bool take_in(struct c205 *machine, struct code_block *block)
{
    struct decoded *decoded = &block->insn[block->count];
    c205_trap trap = decode(machine, block->next, decoded);
    machine->fault = 0;
    machine->rule = RULE_NONE;
    if (trap != C205_TRAP_NONE || goes_by_itself(decoded))
        return false;
    if (block->count == 0)
        block->region = decoded->region;
    if (decoded->region != block->region)
        return false;
    block->count++;
    block->next = decoded->next;
    return may_go_on(machine, decoded);
}

static inline struct code_block **block_place(struct blocks *blocks, uint64_t pc)
{
    return &blocks->at[pc / INSTRUCTION_STEP % BLOCK_PLACES];
}

/* Makes the block that begins at pc and decodes all of its instructions. */
static struct code_block *block_make(struct c205 *machine, uint64_t pc)
{
    struct blocks *blocks = machine->blocks;
    make_room_for_block(blocks);
    struct code_block *block = &blocks->block[blocks->count++];
    memset(block, 0, sizeof *block);
    block->pc = block->next = pc;
    block->version = machine->memory.code_changes;
    block->insn = &blocks->decoded[blocks->decoded_count];
    while (block->count < BLOCK_INSNS && take_in(machine, block))
        continue;
    blocks->decoded_count += block->count;
    clock_measure(machine->clock, block);
    *block_place(blocks, pc) = block;
    return block;
}

/* ---- Execution ---------------------------------------------------------- */

/* Executes a block. Returns the number of executed instructions, which is below the
 * block's count after a trap or a change of code. */
static inline unsigned execute_block(struct c205 *machine,
                                     const struct code_block *block, c205_trap *trap)
{
    const struct decoded *insn = block->insn, *end = insn + block->count;
    struct effect *effect = &machine->effect;
    effect->taken = effect->ends = false;
    effect->touch_count = 0;
    effect->swapped = 0;
    do
        *trap = insn->execute(machine, insn);
    while (*trap == C205_TRAP_NONE && ++insn < end && !effect->ends);
    return (unsigned)(insn - block->insn);
}

/* Executes a block until it ends or an instruction traps, and charges the executed
 * instructions. Sets *insn to an instruction that traps. */
static inline c205_trap run_block(struct c205 *machine, struct code_block *block,
                                  const c205_insn **insn)
{
    c205_trap trap;
    struct effect *effect = &machine->effect;
    unsigned count = execute_block(machine, block, &trap);
    if (!clock_repeat(machine->clock, block, count, effect))
        clock_charge_block(machine->clock, block, count, effect);
    machine->pc = effect->taken ? effect->target
                  : count > 0   ? block->insn[count - 1].next
                                : block->pc;
    if (trap != C205_TRAP_NONE)
        *insn = block->insn[count].insn;
    return trap;
}

/* Returns the block at the program counter. Returns NULL if the instruction there must
 * run alone, or if the block may reach the limit. */
static inline struct code_block *next_block(struct c205 *machine, uint64_t limit)
{
    uint64_t pc = machine->pc;
    struct code_block *block = *block_place(machine->blocks, pc);
    if (!block || block->pc != pc || block->version != machine->memory.code_changes)
        block = block_make(machine, pc);
    return block->count > 0
                   && (limit == C205_NO_LIMIT
                       || clock_ends_before(machine->clock, block, limit))
               ? block
               : NULL;
}

c205_trap blocks_run(struct c205 *machine, uint64_t limit, const c205_insn **insn)
{
    struct code_block *block;
    c205_trap trap = C205_TRAP_NONE;
    while (trap == C205_TRAP_NONE && (block = next_block(machine, limit)))
        trap = run_block(machine, block, insn);
    clock_materialize(machine->clock);
    return trap;
}
