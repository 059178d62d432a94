/* warning.c - the names of warnings, and the choice of reported warnings. */
#include "asm/object/warning.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *name, *text;
} warnings[WARNINGS] = {
#define WARNING(name, option, text) { option, text },
#include "asm/object/warning.def"
#undef WARNING
};

const char *warning_name(enum warning warning)
{
    return warnings[warning].name;
}

const char *warning_text(enum warning warning)
{
    return warnings[warning].text;
}

enum warning warning_named(const char *name)
{
    unsigned i = 0;
    while (i < WARNINGS && strcmp(warnings[i].name, name) != 0)
        i++;
    return (enum warning)i;
}

static bool names_all(const char *name, warning_set *set)
{
    enum warning warning = warning_named(name);
    *set = ~(warning_set)0;
    if (strcmp(name, "all") == 0)
        return true;
    if (warning == WARNINGS)
        return false;
    *set = WARNING_BIT(warning);
    return true;
}

bool warning_choose(struct warning_choice *choice, const char *text)
{
    bool off = strncmp(text, "no-", 3) == 0;
    const char *name = text + (off ? 3 : 0);
    warning_set set;
    if (strcmp(name, "error") == 0) {
        choice->errors = !off;
        return true;
    }
    if (!names_all(name, &set))
        return false;
    choice->off = off ? choice->off | set : choice->off & ~set;
    return true;
}

bool warning_any(const struct warning_choice *choice)
{
    return ~choice->off & (WARNING_BIT(WARNINGS) - 1);
}

void warning_add(struct diagnostics *diagnostics, const struct warning_choice *choice,
                 enum warning warning, const struct position *position,
                 const char *message)
{
    char text[640];
    snprintf(text, sizeof text, "%.560s [-W%s]", message, warning_name(warning));
    diagnostics_add(diagnostics, choice->errors ? SEVERITY_ERROR : SEVERITY_WARNING,
                    position, text);
}
