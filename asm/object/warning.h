/* warning.h - warnings: legal code that is probably a mistake, and the choice of
 * those that are reported.
 *
 * Some warnings are found by the assembler in the text, others while a program runs
 * (asm/check/runtime_check.h). All are reported except those that the user disables and those
 * that the program declares as intended, by "; expect-warning: NAME".
 */
#ifndef ASM_WARNING_H
#define ASM_WARNING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/diagnostic.h"

enum warning {
#define WARNING(name, option, text) WARNING_##name,
#include "asm/object/warning.def"
#undef WARNING
    WARNINGS
};

/* A set of warnings, with bit WARNING_x for each. */
typedef uint32_t warning_set;
#define WARNING_BIT(warning) ((warning_set)1 << (warning))

/* The choice of the user; all zero: all are reported. */
struct warning_choice {
    warning_set off;
    bool errors; /* warnings are errors */
};

const char *warning_name(enum warning warning); /* "run-off" */
const char *warning_text(enum warning warning);
/* Returns WARNINGS if there is no warning of this name. */
enum warning warning_named(const char *name);

/* Applies the argument of the option -W: NAME, no-NAME, all, no-all, error or no-error.
 * Returns false if it is none of these. */
bool warning_choose(struct warning_choice *choice, const char *text);

/* Returns whether any warning is enabled. */
bool warning_any(const struct warning_choice *choice);

/* Adds "message [-Wrun-off]" at a position, as a warning or as an error. */
void warning_add(struct diagnostics *diagnostics, const struct warning_choice *choice,
                 enum warning warning, const struct position *position,
                 const char *message);

#endif
