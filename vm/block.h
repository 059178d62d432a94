/* block.h - blocks of scalar instructions, which are decoded once. A block ends at a
 * branch or before an instruction that must run alone. It continues after a conditional
 * forward branch, where control may leave it.
 *
 * The semantics do not depend on time, so a whole block can be executed first and
 * charged afterwards. Vector instructions, requests to the monitor, and instructions
 * that read the clock run alone. SWAP is the last instruction of its block.
 *
 * A block remains until its code changes or the tables are full.
 */
#ifndef C205_BLOCK_H
#define C205_BLOCK_H

#include "vm/decode.h"

struct schedule;

struct code_block {
    uint64_t pc;
    uint64_t version;     /* memory.code_changes when the block was made */
    uint64_t next;        /* the address after its last instruction */
    unsigned count;       /* 0: the instruction at pc must run alone */
    uint32_t region;      /* the region of all its instructions */
    struct decoded *insn; /* `count` decoded instructions */
    /* Schedules that the clock has computed (vm/time/schedule.h): */
    struct schedule *schedules;
    uint64_t generation; /* the clock's generation of the schedules */
    unsigned schedule_count;
    uint64_t longest; /* upper bound of its clocks, without waits for earlier
                         instructions */
};

enum {
    BLOCKS = 1 << TABLE_BITS,
    BLOCK_PLACES = 2 * BLOCKS,
    BLOCK_DECODED = 4 * BLOCKS /* instructions of all blocks */
};
struct blocks {
    struct code_block *at[BLOCK_PLACES]; /* indexed by address; NULL: no block */
    size_t count, decoded_count;
    struct code_block block[BLOCKS];
    struct decoded decoded[BLOCK_DECODED];
};

/* Returns tables without blocks, or NULL if out of memory. The caller frees them. */
struct blocks *blocks_new(void);

/* Executes blocks from the program counter on, without listeners. Stops before an
 * instruction that must run alone and before a block that may reach the limit. Returns
 * the trap that stopped it, and sets *insn to the instruction that trapped. */
c205_trap blocks_run(struct c205 *machine, uint64_t limit, const c205_insn **insn);

#endif
