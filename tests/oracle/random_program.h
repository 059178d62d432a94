/* random_program.h - random programs that depend only on a seed.
 *
 * A program consists of instructions of the instruction table, its initial registers,
 * and the contents of a few areas of memory. Its registers are grouped in pools:
 * numbers, integers, half registers, vectors of words, half words and bits, index
 * lists, code addresses and so on. An operand mostly comes from the pool that it needs,
 * so that most instructions have an effect, and some trap. Vectors of both sizes
 * overlap, cross pages, and extend beyond their areas to unmapped or read-only memory.
 *
 * Some programs are a loop of scalar instructions. Every second loop modifies its code
 * by a scatter. In other programs half of the instructions are gathers and scatters,
 * whose tables are at ends of pages, on read-only pages, or in the program's code.
 */
#ifndef RANDOM_PROGRAM_H
#define RANDOM_PROGRAM_H

#include "vm/c205.h"

struct program_insn {
    c205_word word; /* a short instruction is in the high half */
    unsigned halves;
};

enum { PROGRAM_INSNS = 40 };

struct random_program {
    uint64_t seed;
    size_t model; /* index into random_models */
    uint64_t code;
    size_t insn_count;
    struct program_insn insns[PROGRAM_INSNS];
    c205_word registers[C205_REGISTERS];
    bool loop;       /* a loop, mostly of scalar instructions */
    bool transfers;  /* half of the instructions are gathers and scatters */
    bool rewrites;   /* a loop with a scatter to its own code */
    bool plain_data; /* all numbers are 1 and all bits are 1, for reducing */
};

/* Machine models with different numbers of pipes, page sizes and memory sizes. */
extern const char *const random_models[];
extern const size_t random_model_count;

/* All mapped pages. The first page contains the program. */
struct random_page {
    uint64_t address;
    c205_access access;
};
enum { RANDOM_PAGES = 6 };
extern const struct random_page random_pages[RANDOM_PAGES];

/* The areas of data. The words around an area are not used. */
struct random_area {
    uint64_t address;
    size_t words;
    c205_access access;
    enum {
        NUMBERS,
        HALF_NUMBERS,
        INDICES,
        WILD_INDICES,
        FAR_INDICES,
        BIT_STRINGS
    } contents;
};
extern const struct random_area random_areas[];
extern const size_t random_area_count;

struct random_program random_program(uint64_t seed);

/* Returns the bit address of instruction i, or of the program's end. */
uint64_t program_address(const struct random_program *program, size_t i);

/* Sets `words` to the contents of an area, which has area->words words. */
void program_data(const struct random_program *program, const struct random_area *area,
                  c205_word *words);

/* Loads the program, its data and registers.  The first half of the program is the
 * region "first", up to random_region_end. */
bool random_load(c205 *machine, const struct random_program *program,
                 c205_error *error);
/* Like random_load, with shared writable pages. The caller frees the pages after the
 * machine has been loaded again. After an error, ends the program. */
struct random_shared {
    c205_shared *page[RANDOM_PAGES]; /* NULL: not shared */
};
void random_load_shared(c205 *machine, const struct random_program *program,
                        struct random_shared *shared);
void random_shared_free(struct random_shared *shared);
uint64_t random_region_end(const struct random_program *program);

#endif
