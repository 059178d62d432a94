/* expand.h - produces the lines of a program for the parser.
 *
 * The texts in use are on a stack: files, bodies of macros, repeated lines. The top of
 * the stack gives the next line. Directives of this pass (.include .macro .rept .if and
 * similar ones) are executed here and are not passed to the parser.
 */
#ifndef ASM_EXPAND_H
#define ASM_EXPAND_H

#include "asm/text/macro.h"
#include "asm/text/source.h"

enum frame_kind { FRAME_FILE, FRAME_MACRO, FRAME_REPEAT };

struct expansion {
    enum frame_kind kind;
    const char *name; /* of FRAME_FILE, like the next two lines */
    const char *at, *end;
    size_t number;
    const struct line *caller; /* of the other kinds, like the rest */
    const struct macro *body;
    size_t next;
    const struct span *arguments;
    uint64_t unique, count, repeats;
    unsigned conditions; /* open conditions at its start */
};

struct asm_condition {
    const struct line *line;
    bool outside; /* the enclosing branch is assembled */
    bool active;  /* this branch is assembled */
    bool decided; /* a branch has been assembled */
    bool last;    /* .else has been read */
};

struct expander {
    struct assembler *assembler;
    struct expansion frames[MAX_FRAMES];
    unsigned depth;
    struct asm_condition conditions[MAX_CONDITIONS];
    unsigned condition_depth;
    const struct line *pending; /* the rest of a line after its labels */
    uint64_t unique;
    uint64_t expansion; /* bytes generated so far */
    bool halted;        /* a limit was exceeded: no more lines */
    char scratch[MAX_LINE];
};

struct expander *expander_new(struct assembler *assembler,
                              const struct asm_source *source);
/* Returns NULL at the end. */
const struct line *expander_next(struct expander *expander);

/* Executes .if and similar directives; returns false if the next token is none
 * of them (condition.c). */
bool condition_directive(struct expander *expander, struct cursor *cursor);
bool condition_names(const struct token *token);
bool condition_skips(const struct expander *expander);
void condition_close(struct expander *expander, unsigned depth);

#endif
