/* macro.h - parses definitions of macros, and expands their calls. */
#ifndef ASM_MACRO_H
#define ASM_MACRO_H

#include "asm/text/lex.h"

struct span {
    const char *begin, *end; /* begin is NULL if absent */
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
    /* Properties for shown_line.h: */
    const char *file; /* of the definition */
    bool is_library;  /* the file is part of asm/lib */
    enum asm_form form;
};

/* The replacements of backslash sequences in a body. */
struct substitution {
    const struct macro *macro; /* replaces \name; NULL: no macro */
    const struct span *arguments;
    const uint64_t *unique; /* replaces \@; NULL: not replaced */
    const uint64_t *count;  /* replaces \+; NULL: not replaced */
};

/* Parses the text after .macro: NAME a, b=default, ... */
struct macro *macro_parse(struct cursor *cursor);
bool macro_add_line(struct assembler *assembler, struct macro *macro,
                    const struct line *line);
/* Parses the arguments after the name of a macro. Returns a span for each parameter.
 * After an error it reports the error and returns NULL. */
const struct span *macro_arguments(struct cursor *cursor, const struct macro *macro);
/* Expands the backslash sequences of a line. Returns the length of the new text. It
 * exceeds MAX_LINE if the line is too long. */
size_t substitute(const struct substitution *substitution, const struct line *line,
                  char text[MAX_LINE]);

#endif
