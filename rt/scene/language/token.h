/* token.h - the tokens of a scene, across its files and macros.
 *
 * Tokens come from a stack of frames. A frame is a file, or the body of a macro during
 * a call. It is on top of the frame that includes or calls it. At the end of a frame
 * the lexer returns TOKEN_END until the frame is closed. The lexer skips comments,
 * which may be nested. Any byte sequence can be tokenised: text that is not in the
 * language becomes TOKEN_BAD with the reason.
 */
#ifndef RT_SCENE_TOKEN_H
#define RT_SCENE_TOKEN_H

#include "base/diagnostic.h"
#include "rt/scene/language/scene_source.h"

#include <stdint.h>

enum scene_token_kind {
    TOKEN_END,
    TOKEN_WORD,
    TOKEN_DIRECTIVE, /* the text is the word after '#' */
    TOKEN_NUMBER,
    TOKEN_STRING, /* the text is without quotes; escapes are not decoded */
    TOKEN_SIGN,
    TOKEN_BAD
};

/* The codes of signs with several characters, such as "!=". The code of any other sign
 * is its character. */
enum sign { SIGN_UNEQUAL = 256, SIGN_NOT_ABOVE, SIGN_NOT_BELOW };

/* A position between two tokens of a source. */
struct text_place {
    size_t at;      /* offset of the position in the source */
    size_t line;    /* line number from 1 */
    size_t line_at; /* offset of the line's start */
};

struct declared_name;
struct scene_value;

/* Refers to the value of a symbol, or to an element of its array. `hops` is the number
 * of nested arrays up to the element. element[i] is the index in array i of these. */
#define MAX_ARRAY_NESTING 5
struct reference {
    struct declared_name *symbol;
    size_t hops;
    size_t element[MAX_ARRAY_NESTING];
};

struct scene_token {
    enum scene_token_kind kind;
    const struct scene_source *source;
    struct text_place place; /* position before its first byte */
    size_t depth;            /* number of open frames when it was read */
    size_t main_line;        /* line of the token in the main file; for a token of
                              * another file or a macro, the line of the #include or
                              * call */
    const char *text;
    size_t length;
    double number;
    int sign;
    const char *fault; /* reason of TOKEN_BAD, or fault of a number that is too long or
                        * too large */

    /* The value of a word that the reader has looked up; else NULL. */
    struct reference reference;
    const struct scene_value *value;
};

enum {
    INCLUDE_DEPTH = 16,
    MAX_INCLUDE = 1000,
    MAX_FRAMES = 200 /* depth of nested files and macros */
};

struct open_text {
    const struct scene_source *source;
    struct text_place place; /* position of the next token */
    size_t end;              /* offset of the frame's end */
    size_t serial;           /* serial number of the frame */
    bool is_macro;
    bool comes_again;        /* the text belongs to a macro or a loop, so it may be read
                              * again */
    struct scene_token call; /* the name of the macro at its call */
};

/* A cached token of text that is read repeatedly. */
struct kept_token {
    size_t from; /* offset in the source before blanks and comments */
    struct scene_token token;
    struct text_place behind; /* position after the token */
};
enum { KEPT_TOKENS = 4096 };

struct lexer {
    size_t depth, files; /* number of open frames and of open files */
    size_t serial;
    struct open_text frames[MAX_FRAMES];
    struct kept_token kept[KEPT_TOKENS]; /* cache of tokens, indexed by the offset
                                          * modulo KEPT_TOKENS */
};

/* Opens a frame for a source. Returns false if the nesting is too deep. */
bool lexer_open(struct lexer *lexer, const struct scene_source *source);
/* Opens a frame for the body of the macro that `call` calls. */
bool lexer_call(struct lexer *lexer, const struct scene_source *source,
                struct text_place place, size_t end, const struct scene_token *call);
/* Closes the innermost frame. */
void lexer_close(struct lexer *lexer);
/* Continues at another place of the frame: the start of a loop's iteration. */
void lexer_jump(struct lexer *lexer, const struct text_place *place);
struct open_text *lexer_top(struct lexer *lexer);
struct scene_token lexer_next(struct lexer *lexer);

/* Returns true if the token's text is this word. */
bool token_is_text(const struct scene_token *token, const char *word);
/* Returns true if the token is this word. The first byte is compared inline, because
 * each token is compared with many words. */
static inline bool is_token(const struct scene_token *token, const char *word)
{
    return token->kind == TOKEN_WORD && *token->text == *word
           && token_is_text(token, word);
}
/* Returns true if the token's text is one of the words, which are separated by
 * blanks. */
bool token_is_among(const struct scene_token *token, const char *words);
/* Returns the row whose first member contains the word among its words, or NULL. */
#define TOKEN_ROW(token, rows) \
    token_row(token, rows, sizeof *(rows), sizeof(rows) / sizeof *(rows))
const void *token_row(const struct scene_token *token, const void *rows, size_t size,
                      size_t count);
bool is_directive(const struct scene_token *token, const char *words);
bool token_is_sign(const struct scene_token *token, int sign);
/* The text of a token, as two arguments of "%.*s". */
#define TOKEN_TEXT(token) (int)(token)->length, (token)->text
struct position token_position(const struct scene_token *token);

#endif
