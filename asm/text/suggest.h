/* suggest.h - suggests a known name for a misspelt name. Not public. */
#ifndef ASM_SUGGEST_H
#define ASM_SUGGEST_H

#include "asm/text/lex.h"

enum suggestion {
    SUGGEST_MNEMONIC, /* name of an instruction or macro */
    SUGGEST_DIRECTIVE,
    SUGGEST_REGISTER, /* a name of a register */
    SUGGEST_VALUE     /* a label or a constant */
};

/* Returns a known name of a kind that is similar to a misspelt name, or NULL. Never
 * returns a comparison with another relation. */
const char *suggest(struct assembler *assembler, enum suggestion kind, const char *name,
                    size_t length);

/* Returns what this machine has instead of an instruction of another machine, or NULL if
 * the name is not known (foreign.c). */
const char *foreign_advice(const char *name, size_t length);

/* Reports that `what` was expected instead of the next token, and suggests a name.
 * Returns false. */
bool expected_name(struct cursor *cursor, const char *what, enum suggestion kind);

/* Return the name of directive i of directive.c, expand.c and condition.c, or NULL
 * after the last. */
const char *directive_name(size_t i);
const char *expand_name(size_t i);
const char *condition_name(size_t i);

#endif
