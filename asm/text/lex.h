/* lex.h - the lexer, which splits a line of program text into tokens. */
#ifndef ASM_LEX_H
#define ASM_LEX_H

#include "asm/object/syntax.h"
#include "asm/text/assembler.h"

enum token_kind {
    TOKEN_END, /* end of the line; begin is its comment, if any */
    TOKEN_NAME,
    TOKEN_DIRECTIVE, /* ".name" */
    TOKEN_NUMBER,    /* integer, floating-point or X'..', in value */
    TOKEN_STRING,
    TOKEN_OPERATOR, /* in code; see operators.h */
    TOKEN_BAD       /* problem is the error message */
};

struct token {
    enum token_kind kind;
    const char *begin, *end;
    struct value value;
    int code;
    const char *problem;
};

/* A position in a line. token is the next token. */
struct cursor {
    struct assembler *assembler;
    const struct line *line;
    struct token token;
    unsigned depth; /* nesting of the expression that is parsed */
};

/* Reports an error at a position in the line of the cursor. Returns false. */
#define report_at(cursor, ...) report((cursor)->assembler, (cursor)->line, __VA_ARGS__)

struct cursor cursor_start(struct assembler *assembler, const struct line *line);
void cursor_next(struct cursor *cursor);
bool cursor_at(const struct cursor *cursor, int code);
/* Takes the next token and returns true if it is this operator. */
bool cursor_take(struct cursor *cursor, int code);
bool cursor_at_end(const struct cursor *cursor);

/* Continues after an error, at the next comma or control vector after `start` or at the
 * end of the line. Errors of later operands are therefore reported, too. */
void cursor_skip(struct cursor *cursor, const struct cursor *start);

/* Reports that `what` was expected instead of the next token. Returns false. */
bool expected(struct cursor *cursor, const char *what);
bool expect_operator(struct cursor *cursor, int code, const char *what);
bool expect_end(struct cursor *cursor);
/* Takes an identifier and returns its text and length. */
bool expect_name(struct cursor *cursor, const char *what, const char **name,
                 size_t *length);
/* Takes a string and returns its bytes, with escapes decoded, in the arena. */
char *expect_string(struct cursor *cursor, size_t *length);

bool token_is(const struct token *token, const char *text); /* ignores case */

#endif
