/* suggest.h - the name that was meant by one that is misspelt.  Not public. */
#ifndef ASM_SUGGEST_H
#define ASM_SUGGEST_H

#include "asm/lex.h"

enum suggestion {
    SUGGEST_MNEMONIC, /* an instruction or a macro */
    SUGGEST_DIRECTIVE,
    SUGGEST_REGISTER, /* the name of one */
    SUGGEST_VALUE     /* a label or a constant */
};

/* NULL: nothing is near. */
const char *suggest(struct assembler *assembler, enum suggestion kind, const char *name,
                    size_t length);

/* Report what was expected in place of the next token, and what was meant by
 * it; false. */
bool expected_name(struct cursor *cursor, const char *what, enum suggestion kind);

/* directive.c, expand.c, condition.c: the names of those that each obeys, NULL behind the last. */
const char *directive_name(size_t i);
const char *expand_name(size_t i);
const char *condition_name(size_t i);

#endif
