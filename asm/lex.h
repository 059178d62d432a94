/* lex.h - a line of program text as tokens, one after another. */
#ifndef ASM_LEX_H
#define ASM_LEX_H

#include "asm/assembler.h"

enum token_kind {
    TOKEN_END, /* of the line; begin is at its comment if it has one */
    TOKEN_NAME,
    TOKEN_DIRECTIVE, /* ".name" */
    TOKEN_NUMBER,    /* integer, floating or X'..', in value */
    TOKEN_STRING,
    TOKEN_OPERATOR, /* in code, see OPERATOR */
    TOKEN_BAD       /* problem tells why */
};

/* The code of an operator of two characters; of one: the character. */
#define OPERATOR(first, second) ((first) | (second) << 8)

struct token {
    enum token_kind kind;
    const char *begin, *end;
    struct value value;
    int code;
    const char *problem;
};

/* A place in a line: token is the next one to be taken. */
struct cursor {
    struct assembler *assembler;
    const struct line *line;
    struct token token;
    unsigned depth; /* of the expression being parsed */
};

struct cursor cursor_start(struct assembler *assembler, const struct line *line);
void cursor_next(struct cursor *cursor);
bool cursor_at(const struct cursor *cursor, int code);
/* Take this operator if it is the next token. */
bool cursor_take(struct cursor *cursor, int code);
bool cursor_at_end(const struct cursor *cursor);

/* From a place on to the next comma or control vector, or to the end, past what
 * was wrong: what follows may be wrong as well. */
void cursor_skip(struct cursor *cursor, const struct cursor *start);

/* Report what was expected in place of the next token; false. */
bool expected(struct cursor *cursor, const char *what);
bool expect_operator(struct cursor *cursor, int code, const char *what);
bool expect_end(struct cursor *cursor);
/* An identifier: its text and length. */
bool expect_name(struct cursor *cursor, const char *what, const char **name,
                 size_t *length);
/* The bytes of a string, escapes done, in the arena. */
char *expect_string(struct cursor *cursor, size_t *length);

bool is_name_start(char c);
bool is_name_part(char c);
bool token_is(const struct token *token, const char *text); /* any case */

#endif
