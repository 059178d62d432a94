/* variables.h - writes the variables of the scopes: registers, operands, vectors and
 * times. Not public.
 *
 * A reference consists of its kind and a number. It needs no table, and it remains
 * valid after later stops.
 */
#ifndef ASM_DAP_VARIABLES_H
#define ASM_DAP_VARIABLES_H

#include "asm/dap/dap_internal.h"

enum reference_kind {
    OF_NAMED = 1, /* registers that the program names */
    OF_OPERANDS,  /* operands of the next instruction */
    OF_VECTORS,   /* vectors that registers describe */
    OF_REGISTERS, /* all registers */
    OF_TIME,
    OF_WORDS, /* elements of the vector of a register */
    OF_HALVES,
    OF_BITS,
    OF_OPERAND, /* elements of an operand of the next instruction */
    OF_LAST,    /* times of the last instruction */
    OF_REGION,  /* clocks of a region */
    KINDS = 16
};

static inline int64_t reference_of(enum reference_kind kind, size_t number)
{
    return (int64_t)kind + (int64_t)number * KINDS;
}

/* Opens the JSON object of a variable with its name, value and reference. The caller
 * adds other members and closes the object. */
void put_variable(struct json *json, const char *name, const char *value,
                  int64_t reference);
/* Returns the program's name of a register. Returns its number, such as r10, if there
 * is no name or if the debugger would read the name as another register. */
enum { REGISTER_NAME = 8 };
const char *name_of(const struct dap *dap, unsigned number, char text[REGISTER_NAME]);

/* put_operands writes the operands of the next instruction. operand_vector sets the
 * vector of one of them (operands.c). */
void put_operands(struct dap *dap, struct json *json);
bool operand_vector(const struct dap *dap, size_t number, struct vector_view *vector);

/* put_time writes the variables of the scope that shows times: step, clock, last
 * instruction and regions. put_region and put_last write the variables of a region and
 * of the last instruction (time.c). */
void put_time(struct dap *dap, struct json *json);
void put_region(struct dap *dap, struct json *json, size_t number);
void put_last(struct dap *dap, struct json *json);

#endif
