/* macro.h - definitions of macros and the text they expand to. */
#ifndef ASM_MACRO_H
#define ASM_MACRO_H

#include "asm/lex.h"

struct span {
    const char *begin, *end; /* begin NULL: not given */
};

struct parameter {
    struct span name, otherwise;
};

struct macro {
    const char *name;
    size_t parameter_count, parameter_capacity;
    struct parameter *parameters;
    size_t line_count, line_capacity;
    struct line *lines;
};

/* What the backslashes of a body stand for. */
struct substitution {
    const struct macro *macro; /* NULL: no \name */
    const struct span *arguments;
    const uint64_t *unique; /* \@, or NULL */
    const uint64_t *count;  /* \+, or NULL */
};

/* After .macro: NAME a, b=default, ... */
struct macro *macro_parse(struct cursor *cursor);
bool macro_add_line(struct assembler *assembler, struct macro *macro,
                    const struct line *line);
/* After the macro's name: one span for each parameter; NULL: reported. */
const struct span *macro_arguments(struct cursor *cursor, const struct macro *macro);
/* The length of the new text; above MAX_LINE: it is too long. */
size_t substitute(const struct substitution *substitution, const struct line *line,
                  char text[MAX_LINE]);

#endif
