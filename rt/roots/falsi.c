/* falsi.c - the names of the rules of falsi. */
#include "rt/roots/falsi.h"

#include <string.h>

static const char *const rules[FALSI_RULES] = {
    [FALSI_PAPER] = "paper",
    [FALSI_ILLINOIS] = "illinois",
    [FALSI_PEGASUS] = "pegasus",
    [FALSI_ANDERSON_BJORCK] = "anderson-bjorck",
};

const char *falsi_name(enum falsi rule)
{
    return rules[rule];
}

bool falsi_named(const char *name, enum falsi *rule)
{
    for (int i = 0; i < FALSI_RULES; i++)
        if (strcmp(name, rules[i]) == 0) {
            *rule = (enum falsi)i;
            return true;
        }
    return false;
}

enum falsi falsi_of(const struct object *program)
{
    const struct asm_symbol *symbol = object_symbol(program, "FALSI");

    return symbol ? (enum falsi)symbol->value : FALSI_DEFAULT;
}
