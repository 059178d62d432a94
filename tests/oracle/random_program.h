/* random_program.h - random programs, the same for the same seed.
 *
 * A program is a row of instructions drawn from the instruction table, the
 * registers it starts with and the contents of a few areas of memory.  Its
 * registers lie in pools (numbers, integers, half registers, descriptors of
 * vectors of words, half words and bits, of index lists, code addresses ..)
 * and each operand is mostly taken from the pool it needs, so that most
 * instructions do something, and some trap.  Vectors of both sizes overlap,
 * cross pages, run off their ends and into memory that is not there or may
 * only be read.  Some programs are a loop of scalar instructions; every second
 * one of these changes the program by a scatter.  In some programs half of the
 * instructions are gathers and scatters, whose tables are at ends of pages, on pages
 * that are only read, or in the program itself.
 */
#ifndef RANDOM_PROGRAM_H
#define RANDOM_PROGRAM_H

#include "vm/c205.h"

struct program_insn {
    c205_word word; /* a short one in its high half */
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
    bool loop;       /* of scalar instructions, for the most part */
    bool transfers;  /* half of it gathers and scatters */
    bool rewrites;   /* a loop with a scatter upon itself */
    bool plain_data; /* all numbers one, all bits ones: for shrinking */
};

/* Machine models worth running on: pipes, pages, little memory. */
extern const char *const random_models[];
extern const size_t random_model_count;

/* All pages there are; the first holds the program. */
struct random_page {
    uint64_t address;
    c205_access access;
};
enum { RANDOM_PAGES = 6 };
extern const struct random_page random_pages[RANDOM_PAGES];

/* Where the data lie; the words around an area belong to nobody. */
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

/* The bit address of an instruction, or of the end when there is no such. */
uint64_t program_address(const struct random_program *program, size_t i);

/* The contents of an area, area->words of them. */
void program_data(const struct random_program *program, const struct random_area *area,
                  c205_word *words);

/* The machine as the program finds it.  The first half of the program is the
 * region "first", up to random_region_end. */
bool random_load(c205 *machine, const struct random_program *program,
                 c205_error *error);
/* The same, with pages to be written that it has in common with others, which the
 * caller frees when the machine is loaded again. */
struct random_shared {
    c205_shared *page[RANDOM_PAGES]; /* NULL: its own */
};
bool random_load_shared(c205 *machine, const struct random_program *program,
                        struct random_shared *shared, c205_error *error);
void random_shared_free(struct random_shared *shared);
/* A page of them, as it is; on a machine that is free for it. */
bool random_shared_read(c205 *machine, const struct random_shared *shared, size_t page,
                        c205_word *words, c205_error *error);
uint64_t random_region_end(const struct random_program *program);

#endif
