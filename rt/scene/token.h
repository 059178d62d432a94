/* token.h - a scene file as a row of tokens, through its includes.
 *
 * Comments, nested ones too, are left out here.  Any bytes make tokens: what
 * is not of the language is TOKEN_BAD with the reason.
 */
#ifndef RT_SCENE_TOKEN_H
#define RT_SCENE_TOKEN_H

#include "rt/scene/report.h"
#include "rt/scene/source.h"

enum token_kind {
    TOKEN_END,
    TOKEN_WORD,
    TOKEN_DIRECTIVE, /* text is the word after '#' */
    TOKEN_NUMBER,
    TOKEN_STRING, /* text is without the quotes */
    TOKEN_SIGN,
    TOKEN_BAD
};

/* Signs of one character are that character. */
enum sign { SIGN_UNEQUAL = 256, SIGN_NOT_ABOVE, SIGN_NOT_BELOW };

struct token {
    enum token_kind kind;
    const struct source *source;
    size_t offset;    /* in the source, of its first byte */
    size_t line;      /* from 1 */
    size_t line_at;   /* offset of its line */
    size_t main_line; /* the line of the main file: its own or that of the
                         #include that leads to it */
    const char *text;
    size_t length;
    double number;
    int sign;
    const char *fault; /* of TOKEN_BAD, or of a number, which is then 0 */
};

enum { INCLUDE_DEPTH = 16, INCLUDE_MOST = 1000 };

struct lexer {
    size_t depth; /* open files */
    struct {
        const struct source *source;
        size_t at, line, line_at;
    } open[INCLUDE_DEPTH];
};

/* The tokens of a source come next; false: too deep. */
bool lexer_open(struct lexer *lexer, const struct source *source);
/* At the end of a file the one that includes it goes on. */
struct token lexer_next(struct lexer *lexer);
/* Go to the end of the line. */
void lexer_skip_line(struct lexer *lexer);

bool is_token(const struct token *token, const char *word);
bool token_is_sign(const struct token *token, int sign);
struct position token_position(const struct token *token);

#endif
