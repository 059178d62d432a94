/* decode.h - an instruction taken apart, ready to execute, and what its
 * execution did: the two things that time is made from.
 */
#ifndef C205_DECODE_H
#define C205_DECODE_H

#include "vm/c205.h"

/* The register file has two slots more than the machine has registers: where
 * register 0 is read as a number, the decoder names SLOT_MACHINE_ZERO; where
 * it is written, SLOT_SINK.  So no instruction looks for register 0. */
enum { SLOT_MACHINE_ZERO = C205_REGISTERS, SLOT_SINK, SLOTS };

struct c205;
struct decoded;
typedef c205_trap semantics(struct c205 *machine, const struct decoded *decoded);

enum { DECODED_SOURCES = 10, DECODED_RESULTS = 3 };
enum { OPERAND_A, OPERAND_B, OPERAND_C, OPERANDS };

struct decoded {
    semantics *execute;
    uint16_t a, b, c;                 /* slots; for short formats R, S, T */
    uint16_t x, y, z;                 /* slots of offsets and control vector */
    uint16_t index;                   /* slot of the index of a maximum, a minimum */
    uint16_t result[DECODED_RESULTS]; /* slots written; register 0 is not
                                         counted but stands as SLOT_SINK */
    uint8_t width[OPERANDS];          /* of A, B, C: bits of an element */
    uint8_t shift[OPERANDS];          /* bits of the slot left of a half register; 0
                                also for those of register 0 */
    uint8_t source_count, result_count;
    c205_fields fields; /* as written */
    uint64_t next;      /* address of the instruction after; for LINKV,
                           the one after the pair */
    uint64_t pc;
    const c205_insn *insn;
    uint16_t source[DECODED_SOURCES]; /* slots read, register 0 left out */
    uint32_t region;
    bool plain;       /* a vector instruction of words without offsets and signs */
    uint8_t flops;    /* of each element; of LINKV, those of the pair */
    uint64_t version; /* memory.code_changes when it was decoded */
    const struct decoded *linked[2]; /* LINKV: the pair */
};

/* A range of memory that an instruction used. */
struct touch {
    uint64_t address, bits;
    bool stored; /* into it, or into parts of it */
};
/* A vector instruction uses six at most, those of a block one each, but for
 * a SWAP, which is its last and uses two. */
enum { BLOCK_INSNS = 32, EFFECT_TOUCHES = BLOCK_INSNS + 1 };

/* Filled by the semantics, read by the clock and the events.  Semantics know
 * no time: they say what happened, not what it costs. */
struct effect {
    size_t elements;  /* vector length: results made or operands scanned */
    size_t idle;      /* those that took time with nothing done: sparse vectors */
    size_t recurrent; /* those that read what an earlier one stored */
    bool ends;        /* a block: a branch was taken, or code was changed */
    bool taken;       /* a branch that was taken .. */
    uint64_t target;  /* .. and where it went */
    unsigned touch_count;
    struct touch touch[EFFECT_TOUCHES];
    const c205_word *indices; /* gather, scatter: the indices that were used,
                                 in the low 48 bits .. */
    size_t index_count;       /* .. so many; elements less those that the
                                 control vector held back .. */
    uint64_t table;           /* .. counted from this address .. */
    unsigned table_step;      /* .. in steps of so many bits */
    size_t swapped;           /* registers that SWAP moved .. */
    size_t saved;             /* .. so many of them to memory */
};

/* The tables of decoded instructions, blocks and schedules save time of the host
 * only, and results do not depend on their size.  A smaller one costs less to
 * allocate and is emptied more often: make fuzz defines it. */
#ifndef TABLE_BITS
#define TABLE_BITS 14
#endif

/* Recently decoded instructions, found by their address.  There are many machines
 * that run for a short time: what is not yet used is not cleared. */
enum { DECODE_ENTRIES = 1 << TABLE_BITS, INSTRUCTION_STEP = 32 };
#define NOT_DECODED UINT64_MAX
struct decode_cache {
    uint64_t pc[DECODE_ENTRIES]; /* of the entry, or NOT_DECODED */
    struct decoded entry[DECODE_ENTRIES];
};

/* NULL: no memory; the caller frees it. */
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

/* Decode the instruction at pc; marks its words as code. */
c205_trap decode(struct c205 *machine, uint64_t pc, struct decoded *decoded);
/* The instruction at pc, decoded now or before; marks its words as code. */
c205_trap decode_at(struct c205 *machine, uint64_t pc, const struct decoded **decoded);
/* Decode the pair behind a LINKV and put it into its entry.  BAD_LINK: there
 * are not two instructions that may be linked. */
c205_trap decode_pair(struct c205 *machine, const struct decoded *prefix);

#endif
