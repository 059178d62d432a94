/* decode.h - a decoded instruction, ready to execute, and the effect of its execution.
 * Both are the input of the clock.
 */
#ifndef C205_DECODE_H
#define C205_DECODE_H

#include "vm/c205.h"

/* The register file has two more slots than the machine has registers. The decoder maps
 * register 0 to SLOT_MACHINE_ZERO if it is read as a number and to SLOT_SINK if it is
 * written, so no instruction tests for register 0. */
enum { SLOT_MACHINE_ZERO = C205_REGISTERS, SLOT_SINK, SLOTS };

struct c205;
struct decoded;
typedef c205_trap semantics(struct c205 *machine, const struct decoded *decoded);

enum { DECODED_SOURCES = 10, DECODED_RESULTS = 3 };
enum { OPERAND_A, OPERAND_B, OPERAND_C, OPERANDS };

struct decoded {
    semantics *execute;
    uint16_t a, b, c;                 /* slots of A, B, C, or of R, S, T in short
                                         formats */
    uint16_t x, y, z;                 /* slots of offsets and control vector */
    uint16_t index;                   /* slot of the index of a maximum or minimum */
    uint16_t result[DECODED_RESULTS]; /* slots written; a write to register 0 has
                                         SLOT_SINK and is not counted */
    uint8_t width[OPERANDS];          /* bits per element of A, B, C */
    uint8_t shift[OPERANDS];          /* bits of the slot before a half register; 0 for
                                         register 0 */
    uint8_t source_count, result_count;
    c205_fields fields; /* fields of the word */
    uint64_t next;      /* address of the next instruction; for LINKV, the address after
                           the pair */
    uint64_t pc;
    const c205_insn *insn;
    uint16_t source[DECODED_SOURCES]; /* slots read, except register 0 */
    uint32_t region;
    bool plain;       /* a vector instruction on words without offsets and sign
                         control */
    uint8_t flops;    /* flops per element; for LINKV, of the pair */
    uint64_t version; /* memory.code_changes when it was decoded */
    const struct decoded *linked[2]; /* LINKV: the pair */
};

/* A range of memory that an instruction used. */
struct touch {
    uint64_t address, bits;
    bool stored; /* the range was stored, in whole or in part */
};
/* The effect of a vector instruction has at most six touches, which are ranges of
 * memory. Each instruction of a block has at most one touch, except that a SWAP at the
 * end of the block has two. */
enum { BLOCK_INSNS = 32, EFFECT_TOUCHES = BLOCK_INSNS + 1 };

/* The effect of an instruction. Its semantics fill it; the clock and the events read
 * it. It contains what the instruction did, and not its cost. */
struct effect {
    size_t elements;  /* vector length: elements computed or scanned */
    size_t idle;      /* positions of sparse vectors that took time without an
                         operation */
    size_t recurrent; /* elements that read the result of an earlier element */
    bool ends;        /* the block ends: a branch was taken, or code was changed */
    bool taken;       /* a branch was taken */
    uint64_t target;  /* target of that branch */
    unsigned touch_count;
    struct touch touch[EFFECT_TOUCHES];
    const c205_word *indices; /* gather, scatter: the indices used, in the low 48 bits
                                 of each word */
    size_t index_count;       /* number of indices; blocked elements have none */
    uint64_t table;           /* address of index 0 */
    unsigned table_step;      /* bits per index */
    size_t swapped;           /* number of registers that SWAP moved */
    size_t saved;             /* registers that SWAP saved to memory */
};

/* The sizes of the tables of decoded instructions, blocks and schedules affect the
 * speed of the host but no results. A smaller table is cheaper to allocate but is
 * cleared more often. make fuzz uses a small table. */
#ifndef TABLE_BITS
#define TABLE_BITS 14
#endif

/* A direct-mapped cache of decoded instructions by address. Only pc is initialised
 * before use, because many machines run only for a short time. */
enum { DECODE_ENTRIES = 1 << TABLE_BITS, INSTRUCTION_STEP = 32 };
#define NOT_DECODED UINT64_MAX
struct decode_cache {
    uint64_t pc[DECODE_ENTRIES]; /* address of the entry, or NOT_DECODED */
    struct decoded entry[DECODE_ENTRIES];
};

/* Returns a cache that the caller frees. NULL: out of memory. */
struct decode_cache *decode_cache_new(void);

static inline size_t decode_place(uint64_t pc)
{
    return pc / INSTRUCTION_STEP % DECODE_ENTRIES;
}

static inline const struct decoded *decode_cached(const struct decode_cache *cache,
                                                  uint64_t version, uint64_t pc)
{
    size_t i = decode_place(pc);
    const struct decoded *entry = &cache->entry[i];
    return cache->pc[i] == pc && entry->version == version ? entry : NULL;
}

/* Decodes the instruction at pc and marks its words as code. Returns NONE, or the trap
 * if the words are not an instruction. */
c205_trap decode(struct c205 *machine, uint64_t pc, struct decoded *decoded);
/* Sets *decoded to the cache entry of the instruction at pc. If it is not in the cache,
 * decodes it first. Returns NONE or the trap of decode. */
c205_trap decode_at(struct c205 *machine, uint64_t pc, const struct decoded **decoded);
/* Decodes the pair after a LINKV into the cache entry of the prefix. Returns BAD_LINK
 * if these instructions cannot be linked. */
c205_trap decode_pair(struct c205 *machine, const struct decoded *prefix);

#endif
