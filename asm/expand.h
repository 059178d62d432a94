/* expand.h - the lines of a program as the parser gets to see them.
 *
 * Texts being read lie on a stack: files, bodies of macros, repeated lines.
 * The top one gives the next line; directives of this pass (.include .macro
 * .rept .if and their kin) are obeyed here and not handed on.
 */
#ifndef ASM_EXPAND_H
#define ASM_EXPAND_H

#include "asm/macro.h"
#include "asm/source.h"

enum frame_kind { FRAME_FILE, FRAME_MACRO, FRAME_REPEAT };

struct expansion {
    enum frame_kind kind;
    const char *name; /* FRAME_FILE .. */
    const char *at, *end;
    size_t number;
    const struct line *caller; /* the others .. */
    const struct macro *body;
    size_t next;
    const struct span *arguments;
    uint64_t unique, count, repeats;
    unsigned conditions; /* open when it began */
};

struct asm_condition {
    const struct line *line;
    bool outside; /* what stands around it is assembled */
    bool active;  /* so is this branch */
    bool decided; /* some branch was */
    bool last;    /* .else has been seen */
};

struct expander {
    struct assembler *assembler;
    struct expansion frames[MAX_FRAMES];
    unsigned depth;
    struct asm_condition conditions[MAX_CONDITIONS];
    unsigned condition_depth;
    const struct line *pending; /* the rest of a line after its labels */
    uint64_t unique;
    uint64_t expansion; /* bytes made so far */
    bool halted;        /* bounds passed: nothing more comes */
    char scratch[MAX_LINE];
};

struct expander *expander_new(struct assembler *assembler,
                              const struct asm_source *source);
/* NULL at the end. */
const struct line *expander_next(struct expander *expander);

/* condition.c: .if and its kin; false: the next token is none of them. */
bool condition_directive(struct expander *expander, struct cursor *cursor);
bool condition_names(const struct token *token);
bool condition_skips(const struct expander *expander);
void condition_close(struct expander *expander, unsigned depth);

#endif
