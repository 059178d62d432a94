/* operand_letters.h - the operands of an instruction according to the instruction
 * table: their letters (vm/insn.def), and which of them are half registers. */
#ifndef OPERAND_LETTERS_H
#define OPERAND_LETTERS_H

#include "vm/c205.h"

/* The fields R, S, T of the short formats are A, B, C. */
enum role { ROLE_A, ROLE_B, ROLE_C, ROLE_X, ROLE_Y, ROLE_Z, ROLES };

/* Returns the role of a letter of the syntax, or -1. */
int role_of_letter(char letter);
uint8_t *field_of_role(c205_fields *fields, const c205_insn *row, enum role role);

/* Returns the letter of a role, or 0 if the row does not have this role. */
char letter_of(const c205_insn *row, enum role role);

/* Returns the letter of a role as a capital if the operand has 32 bits. An operand may
 * be a result in some cases and a source in others; g decides which letter it has. */
char sized_letter(const c205_insn *row, unsigned g, enum role role);

/* Returns true if the operand is a register, which a vector may broadcast. */
bool is_scalar(const c205_insn *row, unsigned g, enum role role);
bool is_half_register(const c205_insn *row, unsigned g, enum role role);

#endif
