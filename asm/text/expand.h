/* expand.h - produces the lines of a program for the parser.
 *
 * A stack contains the current texts: files, bodies of macros, repeated lines. The next
 * line comes from the top of the stack. Directives of this pass (.include, .macro,
 * .rept, .if and similar) are executed here and not passed to the parser.
 */
#ifndef ASM_EXPAND_H
#define ASM_EXPAND_H

#include "asm/text/macro.h"
#include "asm/text/source.h"

enum frame_kind { FRAME_FILE, FRAME_MACRO, FRAME_REPEAT };

struct expansion {
    enum frame_kind kind;
    /* For FRAME_FILE: the name of the file, its unread text, and the line number. */
    const char *name;
    const char *at, *end;
    size_t number;
    /* For FRAME_MACRO and FRAME_REPEAT, the members from call to repeats: */
    struct call *call;
    const struct macro *body;
    size_t next;
    const struct span *arguments;
    uint64_t unique, count, repeats;
    unsigned conditions; /* number of open conditions at its start */
};

struct asm_condition {
    const struct line *line;
    bool outside; /* the code around the condition is assembled */
    bool active;  /* this branch is assembled */
    bool decided; /* a branch has been assembled */
    bool last;    /* .else was read */
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
    bool halted;        /* a limit was exceeded, and no lines follow */
    char scratch[MAX_LINE];
};

struct expander *expander_new(struct assembler *assembler,
                              const struct asm_source *source);
/* Returns the next line for the parser, or NULL at the end. */
const struct line *expander_next(struct expander *expander);

/* Executes .if and similar directives. Returns false if the next token is not such a
 * directive (condition.c). */
bool condition_directive(struct expander *expander, struct cursor *cursor);
bool condition_names(const struct token *token);
bool condition_skips(const struct expander *expander);
void condition_close(struct expander *expander, unsigned depth);

#endif
