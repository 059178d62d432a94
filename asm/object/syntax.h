/* syntax.h - the syntax of names, and that of an instruction, which is derived from its
 * row of vm/insn.def.
 *
 * The parser and the disassembler iterate over these operands. Neither has code for
 * single instructions.
 */
#ifndef ASM_SYNTAX_H
#define ASM_SYNTAX_H

#include "base/sink.h"
#include "vm/c205.h"

bool is_name_start(char c);
bool is_name_part(char c);
/* Returns whether a name is r0 .. r255 or h0 .. h255. Names with leading zeros, such as
 * r05, are not registers. */
bool is_register_name(const char *name, size_t length);

enum operand_kind {
    OPERAND_REGISTER, /* R */
    OPERAND_BRACKET,  /* [R] */
    OPERAND_SOURCE,   /* [A] or R, which is broadcast */
    OPERAND_IMMEDIATE,
    OPERAND_TARGET,
    OPERAND_CONTROL /* ? [Z] or ?! [Z] */
};

/* Means that the register after the comma is the one after the first. */
#define SECOND_IS_NEXT '+'

struct operand {
    enum operand_kind kind;
    bool half;            /* a register without brackets is a half register */
    bool in_two;          /* the result is in this register and the one after it */
    char field;           /* letter of the c205_fields member */
    char second;          /* field after a comma inside the brackets; 0: none */
    bool may_be_left_out; /* optional, with all operands after
                           * it; its field is then 0 */
    uint8_t broadcast;    /* bits of G for a register without brackets */
    uint8_t negate;       /* bits of G for -[A] */
    uint8_t magnitude;    /* bits of G for |[A]| */
    uint8_t given;        /* bits of G for ? [Z] in place of , [Z]; 0: not allowed */
    int64_t low, high;    /* of an immediate */
};

enum { MAX_OPERANDS = 8 };

/* Follows the mnemonic of an instruction with 32-bit operands. */
#define SYNTAX_HALF ",H"

/* Returns the number of operands. half: with SYNTAX_HALF. */
size_t syntax_operands(const c205_insn *insn, bool half,
                       struct operand operands[MAX_OPERANDS]);

/* Writes "ADDNV [r] or r, [r] or r, [r] (? [r])"; optional
 * operands are in parentheses. */
void syntax_write(const c205_insn *insn, bool half, const struct sink *sink);

/* Returns the field for a letter of the syntax. */
uint8_t *syntax_field(c205_fields *fields, char letter);

/* Returns the reason why the machine rejects the instruction for any contents of
 * registers, and the operand in *blamed. Returns NULL if it is valid. An optional
 * control vector counts as absent if it is r0. */
const char *syntax_refusal(const c205_insn *insn, const struct operand *operands,
                           size_t count, c205_fields *fields, size_t *blamed);

#endif
