/* vector_case.h - random operands for any vector instruction. They are made from its
 * row of the instruction table, for tests of properties that all instructions share.
 *
 * Each operand is in its own zone, so that operands do not overlap. A case records the
 * bits of memory and registers that the instruction may read (defined), and the bits
 * that it may change (written).
 */
#ifndef VECTOR_CASE_H
#define VECTOR_CASE_H

#include "machine_fixture.h"

#include "tests/oracle/operand_letters.h"
#include "tests/oracle/operands.h"
#include "tests/oracle/reference.h"

enum {
    WORD = 64,
    HALF = 32,
    ZONE_WORDS = 1024,
    MEMORY_WORDS = (ROLES + 1) * ZONE_WORDS, /* no operand is in the last zone */
    LEAD = 40,                               /* number of words of a zone before its
                                              * operand */
    LENGTH = 700,                            /* number of elements of the longest
                                              * operand */
    MAX_OFFSET = 9
};

/* A vector without its offset: the address of the first element, and the length. */
struct extent_of {
    uint64_t address;
    size_t length;
    unsigned width;
};

/* A mask of the bits of memory and of registers. */
struct bits_of {
    c205_word memory[MEMORY_WORDS], reg[C205_REGISTERS];
};

struct vector_case {
    const c205_insn *row;
    c205_fields fields;
    struct extent_of vector[ROLES];
    bool scalar[ROLES]; /* the operand is a register, not a vector */
    size_t n;           /* number of elements of the result, or of the scanned
                         * operand */
    int64_t period;     /* period of a periodic gather or scatter */
    c205_word memory[MEMORY_WORDS], reg[C205_REGISTERS];
    struct bits_of defined, written;
};

#define ADDRESS_BITS UINT64_C(0xFFFFFFFFFFFF)

/* ---- Properties of an instruction --------------------------------------- */

bool is_row_of(const c205_insn *row, const char *names);

/* Returns true for rows whose Z selects where elements go, without suppressing any. */
bool z_selects(const c205_insn *row);
bool has_control(const struct vector_case *one);
/* Returns true if the order vector of a sparse result is an operand. */
bool is_given(const struct vector_case *one);

/* ---- Bits --------------------------------------------------------------- */

void mark(struct bits_of *bits, uint64_t address, uint64_t count);
void mark_element(struct bits_of *bits, const struct extent_of *vector, size_t i);
bool bit_of(const struct vector_case *one, enum role role, size_t i);

/* is_chosen returns true if the control vector selects element i. */
bool is_chosen(const struct vector_case *one, size_t i);
bool is_permitted(const struct vector_case *one, size_t i);
size_t count_chosen(const struct vector_case *one, bool chosen);

/* ---- Registers ---------------------------------------------------------- */

/* The register of each role. The registers that follow A, B and C contain their
 * offsets. A half register is the left or the right half of a separate register. */
extern const uint8_t role_register[ROLES], role_half[ROLES];

bool is_half(const struct vector_case *one, enum role role);

/* Returns the number in the register field of the instruction. */
uint8_t register_name(const struct vector_case *one, enum role role);

void define(struct vector_case *one, unsigned number, c205_word word, c205_word bits);
void define_half(struct vector_case *one, unsigned number, c205_word word);

/* ---- Lengths and places ------------------------------------------------- */

size_t draw(uint64_t *random, size_t low, size_t high);
size_t draw_size(uint64_t *random);
c205_word draw_word(uint64_t *random);

/* Returns a random half word, right-justified. */
c205_word draw_half(uint64_t *random);
size_t source_length(uint64_t *random, size_t n);

/* ---- Contents ----------------------------------------------------------- */

/* The elements of a table that an index list or a period addresses. table_of returns
 * the role of the table, and indexed the address of element i. */
bool has_indices(const c205_insn *row);
enum role table_of(const c205_insn *row);
uint64_t indexed(const struct vector_case *one, size_t i);

/* ---- The complete case ----------------------------------------------------- */

/* draw_case makes random operands for a row, mark_case marks their bits. */
void draw_case(struct vector_case *one, const c205_insn *row, uint64_t *random,
               size_t n);

#endif
