/* decode.h - a decoded instruction, ready to execute, and the effect of its execution.
 * These two are the input of the clock.
 */
#ifndef C205_DECODE_H
#define C205_DECODE_H

#include "vm/c205.h"

/* The register file has two more slots than the machine has registers. The decoder maps
 * register 0 to SLOT_MACHINE_ZERO where it is read as a number and to SLOT_SINK where
 * it is written, so no instruction tests for register 0. */
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
    uint16_t index;                   /* slot of the index of a maximum or minimum */
    uint16_t result[DECODED_RESULTS]; /* slots written; register 0 is SLOT_SINK and is
                                         not counted */
    uint8_t width[OPERANDS];          /* of A, B, C: bits of an element */
    uint8_t shift[OPERANDS];          /* bits of the slot to the left of a half
                                         register; also 0 for those of register 0 */
    uint8_t source_count, result_count;
    c205_fields fields; /* as encoded */
    uint64_t next;      /* address of the next instruction; for LINKV, the one after the
                           pair */
    uint64_t pc;
    const c205_insn *insn;
    uint16_t source[DECODED_SOURCES]; /* slots read, without register 0 */
    uint32_t region;
    bool plain;       /* a vector instruction on words without offsets and sign
                         control */
    uint8_t flops;    /* per element; for LINKV, of the pair */
    uint64_t version; /* memory.code_changes at the time of decoding */
    const struct decoded *linked[2]; /* LINKV: the pair */
};

/* A range of memory that an instruction used. */
struct touch {
    uint64_t address, bits;
    bool stored; /* the range, or parts of it, were stored */
};
/* A vector instruction has at most six touches. The instructions of a block have one
 * each, except that a SWAP, which must be the last, has two. */
enum { BLOCK_INSNS = 32, EFFECT_TOUCHES = BLOCK_INSNS + 1 };

/* The effect of an instruction, filled by its semantics and read by the clock and the
 * events. The semantics record the events of the instruction, not their cost. */
struct effect {
    size_t elements;  /* vector length: results made or operands scanned */
    size_t idle;      /* elements that took time without an operation: sparse vectors */
    size_t recurrent; /* elements that read the result of an earlier one */
    bool ends;        /* the block ends: a branch was taken, or code was changed */
    bool taken;       /* a branch was taken */
    uint64_t target;  /* its target */
    unsigned touch_count;
    struct touch touch[EFFECT_TOUCHES];
    const c205_word *indices; /* gather, scatter: the indices used, in the low 48
                                 bits */
    size_t index_count;       /* number of them: elements without those that the control
                                 vector blocked */
    uint64_t table;           /* the address that they count from */
    unsigned table_step;      /* bits per index */
    size_t swapped;           /* registers that SWAP moved */
    size_t saved;             /* number of them saved to memory */
};

/* The sizes of the tables of decoded instructions, blocks and schedules affect the
 * speed of the host but no results. A smaller table is cheaper to allocate and is
 * cleared more often; make fuzz defines one. */
#ifndef TABLE_BITS
#define TABLE_BITS 14
#endif

/* A direct-mapped cache of decoded instructions by address. Many machines run only for
 * a short time, so entries are not cleared before use. */
enum { DECODE_ENTRIES = 1 << TABLE_BITS, INSTRUCTION_STEP = 32 };
#define NOT_DECODED UINT64_MAX
struct decode_cache {
    uint64_t pc[DECODE_ENTRIES]; /* of the entry, or NOT_DECODED */
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

/* Decodes the instruction at pc and marks its words as code. */
c205_trap decode(struct c205 *machine, uint64_t pc, struct decoded *decoded);
/* Returns the instruction at pc from the cache, or decodes it and marks its words as
 * code. */
c205_trap decode_at(struct c205 *machine, uint64_t pc, const struct decoded **decoded);
/* Decodes the pair after a LINKV and puts it into the entry of the prefix. BAD_LINK:
 * these are not two instructions that can be linked. */
c205_trap decode_pair(struct c205 *machine, const struct decoded *prefix);

#endif
