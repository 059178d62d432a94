/* warning.h - warnings about legal code that is probably a mistake, and the choice of
 * reported warnings.
 *
 * The assembler finds some warnings in the text. Others occur while a program runs
 * (asm/check/runtime_check.h). A warning is not reported if the user disables it or the
 * program declares it as intended by "; expect-warning: NAME".
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

/* A set of warnings. Bit WARNING_x represents a warning. */
typedef uint32_t warning_set;
#define WARNING_BIT(warning) ((warning_set)1 << (warning))

/* The choice of the user. All warnings are reported if it is zeroed. */
struct warning_choice {
    warning_set off;
    bool errors; /* warnings count as errors */
};

const char *warning_name(enum warning warning); /* for example "run-off" */
const char *warning_text(enum warning warning);
/* Returns the warning with a name, or WARNINGS if there is none. */
enum warning warning_named(const char *name);

/* Applies the argument of the option -W: NAME, no-NAME, all, no-all, error or no-error.
 * Returns false if it is any other text. */
bool warning_choose(struct warning_choice *choice, const char *text);

/* Returns true if any warning is enabled. */
bool warning_any(const struct warning_choice *choice);

/* Adds a warning or an error such as "message [-Wrun-off]" at a position. */
void warning_add(struct diagnostics *diagnostics, const struct warning_choice *choice,
                 enum warning warning, const struct position *position,
                 const char *message);

#endif
