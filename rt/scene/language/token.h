/* token.h - a scene as a row of tokens, through its files and macros.
 *
 * The tokens come from frames: a frame is a file, or a macro's body while it
 * is called, and lies on the one that includes or calls it.  Its end is a
 * TOKEN_END that stays until the frame is closed.  Comments, nested ones too,
 * are left out here.  Any bytes make tokens: what is not of the language is
 * TOKEN_BAD with the reason.
 */
#ifndef RT_SCENE_TOKEN_H
#define RT_SCENE_TOKEN_H

#include "base/diagnostic.h"
#include "rt/scene/language/source.h"

#include <stdint.h>

enum scene_token_kind {
    TOKEN_END,
    TOKEN_WORD,
    TOKEN_DIRECTIVE, /* text is the word after '#' */
    TOKEN_NUMBER,
    TOKEN_STRING, /* text is without the quotes, escapes as they are */
    TOKEN_SIGN,
    TOKEN_BAD
};

/* Signs of one character are that character. */
enum sign { SIGN_UNEQUAL = 256, SIGN_NOT_ABOVE, SIGN_NOT_BELOW };

/* A place between two tokens of a source. */
struct text_place {
    size_t at;      /* offset in the source */
    size_t line;    /* from 1 */
    size_t line_at; /* offset of its line */
};

struct declared_name;
struct scene_value;

/* A symbol's value, or an element of an array in it: `hops` arrays are within
 * each other, each with its element. */
#define MAX_ARRAY_NESTING 5
struct reference {
    struct declared_name *symbol;
    size_t hops;
    size_t element[MAX_ARRAY_NESTING];
};

struct scene_token {
    enum scene_token_kind kind;
    const struct scene_source *source;
    struct text_place place; /* before its first byte */
    size_t depth;            /* of frames, when it was read */
    size_t main_line;        /* the line of the main file: its own or that of the
                           #include or the macro that leads to it */
    const char *text;
    size_t length;
    double number;
    int sign;
    const char *fault; /* of TOKEN_BAD, or of a number, which is then 0 */

    /* What a word names, once the reader has looked it up; or NULL. */
    struct reference reference;
    const struct scene_value *value;
};

enum {
    INCLUDE_DEPTH = 16,
    MAX_INCLUDE = 1000,
    MAX_FRAMES = 200 /* files and macros within each other */
};

struct open_text {
    const struct scene_source *source;
    struct text_place place; /* what comes next */
    size_t end;              /* offset */
    size_t serial;           /* no other frame has it */
    bool is_macro;
    bool comes_again;        /* a macro's body, or some of it is a loop's */
    struct scene_token call; /* the macro's name where it is called */
};

/* A token of what comes again, as it was read. */
struct kept_token {
    size_t from; /* offset in its source, before blanks and comments */
    struct scene_token token;
    struct text_place behind; /* it */
};
enum { KEPT_TOKENS = 4096 };

struct lexer {
    size_t depth, files; /* open frames, and those of files */
    size_t serial;
    struct open_text frames[MAX_FRAMES];
    struct kept_token kept[KEPT_TOKENS]; /* by the offset */
};

/* The tokens of a source come next; false: too deep. */
bool lexer_open(struct lexer *lexer, const struct scene_source *source);
/* .. those of a macro's body, which `call` calls. */
bool lexer_call(struct lexer *lexer, const struct scene_source *source,
                struct text_place place, size_t end, const struct scene_token *call);
/* The frame below continues. */
void lexer_close(struct lexer *lexer);
/* On from another place of the frame, as a loop's turn begins. */
void lexer_jump(struct lexer *lexer, const struct text_place *place);
struct open_text *lexer_top(struct lexer *lexer);
struct scene_token lexer_next(struct lexer *lexer);

/* Whether the text is this word, which begins as it does. */
bool token_is_text(const struct scene_token *token, const char *word);
/* Asked of each word for many others. */
static inline bool is_token(const struct scene_token *token, const char *word)
{
    return token->kind == TOKEN_WORD && *token->text == *word
           && token_is_text(token, word);
}
bool is_one_of(const struct scene_token *token, const char *const *words);
bool is_directive(const struct scene_token *token, const char *const *words);
bool token_is_sign(const struct scene_token *token, int sign);
struct position token_position(const struct scene_token *token);

#endif
