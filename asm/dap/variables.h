/* variables.h - what the scopes are made of.  Not public.
 *
 * A reference says all about what it stands for: its kind, and a number.  So there is
 * no table of them, and one of an earlier stop means the same of this one.
 */
#ifndef ASM_DAP_VARIABLES_H
#define ASM_DAP_VARIABLES_H

#include "asm/dap/dap_internal.h"

enum reference_kind {
    OF_NAMED = 1, /* registers that the program has named */
    OF_OPERANDS,  /* of the next instruction */
    OF_VECTORS,   /* what registers describe */
    OF_REGISTERS, /* all */
    OF_TIME,
    OF_WORDS, /* elements of what a register describes, in three ways .. */
    OF_HALVES,
    OF_BITS,
    OF_OPERAND, /* .. and of an operand of the next instruction */
    OF_LAST,    /* the time of the last instruction */
    OF_REGION,  /* an account */
    KINDS = 16
};

static inline int64_t reference_of(enum reference_kind kind, size_t number)
{
    return (int64_t)kind + (int64_t)number * KINDS;
}

/* An object whose further members and end are the caller's. */
void put_variable(struct json *json, const char *name, const char *value,
                  int64_t reference);
/* "100 words from 801900 on" */
void put_extent(const struct vector_view *vector, const struct sink *sink);
/* The name that the program has for a register, if that means no other; or its number. */
enum { REGISTER_NAME = 8 };
const char *name_of(const struct dap *dap, unsigned number, char text[REGISTER_NAME]);

/* operands.c */
void put_operands(struct dap *dap, struct json *json);
bool operand_vector(const struct dap *dap, size_t number, struct vector_view *vector);

/* time.c */
void put_time(struct dap *dap, struct json *json);
void put_region(struct dap *dap, struct json *json, size_t number);
void put_last(struct dap *dap, struct json *json);

#endif
