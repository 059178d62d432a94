/* syntax.h - the syntax of names and of instructions. The syntax of an instruction is
 * derived from its row in vm/insn.def.
 *
 * The parser and the disassembler iterate over the operands of this syntax. They have
 * no code for individual instructions.
 */
#ifndef ASM_SYNTAX_H
#define ASM_SYNTAX_H

#include "base/sink.h"
#include "vm/c205.h"

bool is_name_start(char c);
bool is_name_part(char c);
/* Returns true for the names r0 .. r255 and h0 .. h255. Names with leading zeros, such
 * as r05, are not registers. */
bool is_register_name(const char *name, size_t length);

enum operand_kind {
    OPERAND_REGISTER, /* R */
    OPERAND_BRACKET,  /* [R] */
    OPERAND_SOURCE,   /* [A] or R, which is broadcast */
    OPERAND_IMMEDIATE,
    OPERAND_TARGET,
    OPERAND_CONTROL /* ? [Z] or ?! [Z] */
};

/* Value of operand.second: the second register follows the first. */
#define SECOND_IS_NEXT '+'

struct operand {
    enum operand_kind kind;
    bool half;            /* a register without brackets is a half register */
    bool in_two;          /* the result is in this register and the next one */
    char field;           /* letter of a member of c205_fields */
    char second;          /* field after a comma in the brackets; 0: none */
    bool may_be_left_out; /* optional, like all operands after it; the field of an
                             omitted operand is 0 */
    uint8_t broadcast;    /* bits of G for a register without brackets */
    uint8_t negate;       /* bits of G for -[A] */
    uint8_t magnitude;    /* bits of G for |[A]| */
    uint8_t given;        /* bits of G for ? [Z] in place of , [Z]; 0: not permitted */
    int64_t low, high;    /* range of an immediate */
};

enum { MAX_OPERANDS = 8 };

/* The suffix of a mnemonic for 32-bit operands. */
#define SYNTAX_HALF ",H"

/* Returns the number of operands. half: the mnemonic has the suffix SYNTAX_HALF. */
size_t syntax_operands(const c205_insn *insn, bool half,
                       struct operand operands[MAX_OPERANDS]);

/* Writes the syntax, as in "ADDNV [r] or r, [r] or r, [r] (? [r])". Optional operands
 * are in parentheses. */
void syntax_write(const c205_insn *insn, bool half, const struct sink *sink);

/* Returns the member of *fields for a letter of the syntax. */
uint8_t *syntax_field(c205_fields *fields, char letter);

/* Returns the reason for which the machine rejects the instruction, whatever its
 * registers contain, and the operand in *blamed. Returns NULL if it is valid. An
 * optional control vector is absent if it is r0. */
const char *syntax_refusal(const c205_insn *insn, const struct operand *operands,
                           size_t count, c205_fields *fields, size_t *blamed);

#endif
