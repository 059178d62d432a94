/* warning.h - what is no error but hardly meant, and which of it to tell.
 *
 * Some warnings are found in the text, by the assembler, the others while a
 * program runs (asm/runtime_check.h).  All are reported except those that the user turns
 * off, and those that a program says it means, by "; expect-warning: NAME".
 */
#ifndef ASM_WARNING_H
#define ASM_WARNING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/diagnostic.h"

enum warning {
#define WARNING(name, option, text) WARNING_##name,
#include "asm/warning.def"
#undef WARNING
    WARNINGS
};

/* A set: bit WARNING_x. */
typedef uint32_t warning_set;
#define WARNING_BIT(warning) ((warning_set)1 << (warning))

/* What the user chose; all zero: to hear of each. */
struct warning_choice {
    warning_set off;
    bool errors; /* each is one */
};

const char *warning_name(enum warning warning); /* "run-off" */
const char *warning_text(enum warning warning);
/* WARNINGS: there is none of this name. */
enum warning warning_named(const char *name);

/* As the option -W gives it: NAME, no-NAME, all, no-all, error or no-error.
 * False: it is none of these. */
bool warning_choose(struct warning_choice *choice, const char *text);

/* Whether any is told. */
bool warning_any(const struct warning_choice *choice);

/* "message [-Wrun-off]" at a place, as a warning or as an error. */
void warning_add(struct diagnostics *diagnostics, const struct warning_choice *choice,
                 enum warning warning, const struct position *position,
                 const char *message);

#endif
