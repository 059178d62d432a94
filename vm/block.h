/* block.h - scalar instructions that control goes through one after the
 * other, decoded once: up to a branch, or to one that goes by itself.  Where
 * the branch is a forward one that depends on something, the block continues
 * behind it: control leaves the block there, or does not.
 *
 * Semantics know no time, so all of a block can be executed first and then
 * charged as a whole.  By themselves go vector instructions, requests to the
 * monitor, and those that do ask for the time.  SWAP is the last of its block.
 *
 * Blocks stay until their code changes or there is no room left for more.
 */
#ifndef C205_BLOCK_H
#define C205_BLOCK_H

#include "vm/decode.h"

struct schedule;

struct code_block {
    uint64_t pc;
    uint64_t version;     /* memory.code_changes when it was made */
    uint64_t next;        /* the address after the last one */
    unsigned count;       /* 0: the one at pc goes by itself */
    uint32_t region;      /* all are of one */
    struct decoded *insn; /* so many of them */
    /* What the clock remembers of it (vm/time/schedule.h): */
    struct schedule *schedules;
    uint64_t generation; /* of the schedules */
    unsigned schedule_count;
    uint64_t longest; /* clocks, besides waiting for what was in flight */
};

enum {
    BLOCKS = 1 << TABLE_BITS,
    BLOCK_PLACES = 2 * BLOCKS,
    BLOCK_DECODED = 4 * BLOCKS /* instructions of all blocks */
};
struct blocks {
    struct code_block *at[BLOCK_PLACES]; /* by address, or NULL */
    size_t count, decoded_count;
    struct code_block block[BLOCKS];
    struct decoded decoded[BLOCK_DECODED];
};

/* NULL: no memory; the caller frees them.  What is not yet used is not cleared. */
struct blocks *blocks_new(void);

static inline struct code_block **block_place(struct blocks *blocks, uint64_t pc)
{
    return &blocks->at[pc / INSTRUCTION_STEP % BLOCK_PLACES];
}

/* Make the block that begins there; counts as decoding all of it. */
struct code_block *block_make(struct c205 *machine, uint64_t pc);

#endif
