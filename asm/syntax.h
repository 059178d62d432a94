/* syntax.h - how an instruction is written, from its row of vm/insn.def.
 *
 * The parser and the disassembler both walk these operands; neither knows
 * any instruction by name.
 */
#ifndef ASM_SYNTAX_H
#define ASM_SYNTAX_H

#include "base/sink.h"
#include "vm/c205.h"

enum operand_kind {
    OPERAND_REGISTER, /* R */
    OPERAND_BRACKET,  /* [R] */
    OPERAND_SOURCE,   /* [A] or R, which is broadcast */
    OPERAND_IMMEDIATE,
    OPERAND_TARGET,
    OPERAND_CONTROL /* ? [Z] or ?! [Z] */
};

/* The register after a comma inside brackets is the one after the first. */
#define SECOND_IS_NEXT '+'

struct operand {
    enum operand_kind kind;
    bool half;            /* a bare register is a half register */
    bool in_two;          /* a result in this register and the one after it */
    char field;           /* letter of the c205_fields member */
    char second;          /* inside the brackets, after a comma; 0: none */
    bool may_be_left_out; /* with all that follow it; the field is 0 then */
    uint8_t broadcast;    /* G bits of a bare register, .. */
    uint8_t negate;       /* .. of -[A], .. */
    uint8_t magnitude;    /* .. of |[A]|, .. */
    uint8_t given;        /* .. of ? [Z] in place of , [Z]; 0: not allowed */
    int64_t low, high;    /* of an immediate */
};

enum { MAX_OPERANDS = 8 };

/* Written behind the mnemonic of an instruction on 32-bit operands. */
#define SYNTAX_HALF ",H"

/* half: with SYNTAX_HALF. */
size_t syntax_operands(const c205_insn *insn, bool half,
                       struct operand operands[MAX_OPERANDS]);

/* "ADDNV [r] or r, [r] or r, [r] (? [r])": as it is written; what may be left
 * out is in parentheses. */
void syntax_write(const c205_insn *insn, bool half, const struct sink *sink);

/* The field with a letter of a syntax. */
uint8_t *syntax_field(c205_fields *fields, char letter);

/* Why no machine executes it, whatever its registers hold, and which operand
 * is to blame; NULL: one does.  A control vector that may be left out is
 * taken to be if it is r0. */
const char *syntax_refusal(const c205_insn *insn, const struct operand *operands,
                           size_t count, c205_fields *fields, size_t *blamed);

#endif
