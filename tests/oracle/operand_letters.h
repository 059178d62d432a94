/* operand_letters.h - what the instruction table says of the operands of an
 * instruction: their letters (vm/insn.def), and which are half registers.
 */
#ifndef OPERAND_LETTERS_H
#define OPERAND_LETTERS_H

#include "vm/c205.h"

/* R, S, T of the short formats are A, B, C. */
enum role { ROLE_A, ROLE_B, ROLE_C, ROLE_X, ROLE_Y, ROLE_Z, ROLES };

uint8_t *field_of_role(c205_fields *fields, const c205_insn *row, enum role role);

/* What the row's operands say of a role; 0: it has none. */
char letter_of(const c205_insn *row, enum role role);

/* The same, a capital where the operands are of 32 bits; of what may be made or
 * given, which of both. */
char sized_letter(const c205_insn *row, unsigned g, enum role role);

/* A register and no vector, though it may be broadcast as one. */
bool is_scalar(const c205_insn *row, unsigned g, enum role role);
bool is_half_register(const c205_insn *row, unsigned g, enum role role);

#endif
