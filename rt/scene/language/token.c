/* token.c - the lexer of scene texts: splits the bytes of a file into tokens. */
#include "rt/scene/language/token.h"
#include "vm/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NUMBER_LONGEST 300 /* in characters */

struct open_text *lexer_top(struct lexer *lexer)
{
    return &lexer->frames[lexer->depth - 1];
}

/* Opens a frame at the beginning of the source. Returns NULL if the nesting is too
 * deep. */
static struct open_text *open_frame(struct lexer *lexer,
                                    const struct scene_source *source)
{
    struct open_text *frame = &lexer->frames[lexer->depth];
    if (lexer->depth == MAX_FRAMES)
        return NULL;
    lexer->depth++;
    memset(frame, 0, sizeof *frame);
    frame->source = source;
    frame->place.line = 1;
    frame->end = source->length;
    frame->serial = lexer->serial++;
    return frame;
}

bool lexer_open(struct lexer *lexer, const struct scene_source *source)
{
    if (lexer->files == INCLUDE_DEPTH || !open_frame(lexer, source))
        return false;
    lexer->files++;
    return true;
}

bool lexer_call(struct lexer *lexer, const struct scene_source *source,
                struct text_place place, size_t end, const struct scene_token *call)
{
    struct open_text *frame = open_frame(lexer, source);
    if (!frame)
        return false;
    frame->place = place;
    frame->end = end;
    frame->is_macro = frame->comes_again = true;
    frame->call = *call;
    return true;
}

void lexer_jump(struct lexer *lexer, const struct text_place *place)
{
    struct open_text *frame = lexer_top(lexer);
    frame->place = *place;
    frame->comes_again = true;
}

void lexer_close(struct lexer *lexer)
{
    lexer->files -= !lexer_top(lexer)->is_macro;
    lexer->depth--;
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\f' || c == '\v';
}

/* Returns the byte at this offset from the cursor. It is NUL after the end. */
static char look(const struct lexer *lexer, size_t ahead)
{
    const struct open_text *frame = &lexer->frames[lexer->depth - 1];
    size_t at = frame->place.at + ahead;
    return at < frame->end ? frame->source->text[at] : '\0';
}

static bool at_end(const struct lexer *lexer)
{
    const struct open_text *frame = &lexer->frames[lexer->depth - 1];
    return frame->place.at >= frame->end;
}

static void step(struct lexer *lexer, size_t count)
{
    struct text_place *place = &lexer_top(lexer)->place;
    for (; count && !at_end(lexer); count--) {
        char c = look(lexer, 0);
        place->at++;
        if (c == '\n') {
            place->line++;
            place->line_at = place->at;
        }
    }
}

static bool at_line_comment(const struct lexer *lexer)
{
    return look(lexer, 0) == '/' && look(lexer, 1) == '/';
}

static bool at_comment(const struct lexer *lexer)
{
    return look(lexer, 0) == '/' && look(lexer, 1) == '*';
}

static void skip_line(struct lexer *lexer)
{
    while (!at_end(lexer) && look(lexer, 0) != '\n')
        step(lexer, 1);
}

static bool skip_comment(struct lexer *lexer)
{
    size_t depth = 0;
    while (!at_end(lexer)) {
        bool opens = at_comment(lexer);
        bool closes = look(lexer, 0) == '*' && look(lexer, 1) == '/';
        step(lexer, opens || closes ? 2 : 1);
        depth += opens;
        depth -= closes && depth;
        if (depth == 0)
            return true;
    }
    return false;
}

static struct scene_token here(const struct lexer *lexer, enum scene_token_kind kind)
{
    const struct open_text *frame = &lexer->frames[lexer->depth - 1];
    struct scene_token token;
    memset(&token, 0, sizeof token);
    token.kind = kind;
    token.source = frame->source;
    token.place = frame->place;
    token.depth = lexer->depth;
    token.main_line = lexer->frames[0].place.line;
    token.text = token.source->text + token.place.at;
    return token;
}

static struct scene_token bad(struct scene_token token, size_t length,
                              const char *fault)
{
    token.kind = TOKEN_BAD;
    token.length = length;
    token.fault = fault;
    return token;
}

static struct scene_token read_word(struct lexer *lexer)
{
    struct scene_token token = here(lexer, TOKEN_WORD);
    while (is_letter(look(lexer, token.length)) || is_digit(look(lexer, token.length)))
        token.length++;
    step(lexer, token.length);
    return token;
}

static size_t digits(const struct lexer *lexer, size_t from)
{
    size_t n = 0;
    while (is_digit(look(lexer, from + n)))
        n++;
    return n;
}

static size_t number_length(const struct lexer *lexer)
{
    size_t length = digits(lexer, 0), exponent;
    if (look(lexer, length) == '.')
        length += 1 + digits(lexer, length + 1);
    if (look(lexer, length) != 'e' && look(lexer, length) != 'E')
        return length;
    exponent = length + 1;
    if (look(lexer, exponent) == '+' || look(lexer, exponent) == '-')
        exponent++;
    return digits(lexer, exponent) ? exponent + digits(lexer, exponent) : length;
}

static struct scene_token read_number(struct lexer *lexer)
{
    struct scene_token token = here(lexer, TOKEN_NUMBER);
    char text[NUMBER_LONGEST + 1];
    token.length = number_length(lexer);
    step(lexer, token.length);
    if (token.length > NUMBER_LONGEST) {
        token.fault = "the number has too many digits: "
                      "at most " LIMIT_TEXT(NUMBER_LONGEST);
        return token;
    }
    memcpy(text, token.text, token.length);
    text[token.length] = '\0';
    token.number = strtod(text, NULL);
    if (!isfinite(token.number)) {
        token.fault = "the number is too large: at most 1.8e308";
        token.number = 1; /* not 0, so that no shape degenerates because of the error */
    }
    return token;
}

static struct scene_token read_string(struct lexer *lexer)
{
    struct scene_token token = here(lexer, TOKEN_STRING);
    step(lexer, 1);
    token.text++;
    while (!at_end(lexer) && look(lexer, 0) != '"') {
        size_t escaped = look(lexer, 0) == '\\' ? 2 : 1;
        step(lexer, escaped);
    }
    if (at_end(lexer))
        return bad(token, 1, "the string is not closed by '\"'");
    token.length = lexer_top(lexer)->place.at - token.place.at - 1;
    step(lexer, 1);
    return token;
}

static struct scene_token read_directive(struct lexer *lexer)
{
    struct scene_token token = here(lexer, TOKEN_DIRECTIVE);
    struct scene_token word;
    step(lexer, 1);
    while (is_blank(look(lexer, 0)))
        step(lexer, 1);
    if (!is_letter(look(lexer, 0)))
        return bad(token, 1, "expected the name of a directive after '#'");
    word = read_word(lexer);
    token.text = word.text;
    token.length = word.length;
    return token;
}

static struct scene_token read_sign(struct lexer *lexer)
{
    struct scene_token token = here(lexer, TOKEN_SIGN);
    char c = look(lexer, 0);
    size_t rest = 0; /* number of bytes after the first byte of a UTF-8 character */
    token.length = 1;
    token.sign = (unsigned char)c;
    if (look(lexer, 1) == '=' && c && strchr("!<>", c)) {
        token.length = 2;
        token.sign = c == '!'   ? SIGN_UNEQUAL
                     : c == '<' ? SIGN_NOT_ABOVE
                                : SIGN_NOT_BELOW;
    }
    step(lexer, token.length);
    if (c && strchr("{}()<>[],;=+-*/.?:&|!", c))
        return token;
    for (; (c & 0x80) && (look(lexer, 0) & 0xC0) == 0x80; rest++)
        step(lexer, 1);
    return bad(token, 1 + rest, "unknown character");
}

/* Skips blanks and comments. If a comment is not closed, sets *opened to its start and
 * returns false. */
static bool skip_blank(struct lexer *lexer, struct scene_token *opened)
{
    while (!at_end(lexer)) {
        if (is_blank(look(lexer, 0))) {
            step(lexer, 1);
        } else if (at_line_comment(lexer)) {
            skip_line(lexer);
        } else if (at_comment(lexer)) {
            *opened = here(lexer, TOKEN_BAD);
            if (!skip_comment(lexer))
                return false;
        } else {
            break;
        }
    }
    return true;
}

static struct scene_token read_token(struct lexer *lexer)
{
    struct scene_token opened;
    char c;
    if (!skip_blank(lexer, &opened))
        return bad(opened, 2, "the comment is not closed by '*/'");
    c = look(lexer, 0);
    if (at_end(lexer))
        return here(lexer, TOKEN_END);
    if (is_letter(c))
        return read_word(lexer);
    if (is_digit(c) || (c == '.' && is_digit(look(lexer, 1))))
        return read_number(lexer);
    if (c == '"')
        return read_string(lexer);
    return c == '#' ? read_directive(lexer) : read_sign(lexer);
}

/* ---- Cache of tokens ----------------------------------------------------- */

static struct kept_token *kept_at(struct lexer *lexer, const struct open_text *frame)
{
    return &lexer->kept[frame->place.at % KEPT_TOKENS];
}

static bool is_kept(const struct kept_token *kept, const struct open_text *frame)
{
    return kept->token.source == frame->source && kept->from == frame->place.at
           && kept->behind.at <= frame->end;
}

/* Caches a token. To find the end of a token, the lexer looks at up to two bytes after
 * it (as in 1e+5). A token that is closer to the end of its frame is not cached,
 * because in a longer frame it may be longer. */
static void keep(struct kept_token *kept, const struct scene_token *token, size_t from,
                 const struct open_text *frame)
{
    enum { LOOKED_AT = 2 };
    if (token->kind == TOKEN_END || token->fault
        || frame->place.at + LOOKED_AT >= frame->end)
        return;
    *kept = (struct kept_token){ from, *token, frame->place };
}

/* Returns a cached token, and updates its depth and line to those of the current
 * frame. */
static struct scene_token again(struct lexer *lexer, const struct kept_token *kept)
{
    struct scene_token token = kept->token;
    lexer_top(lexer)->place = kept->token.place;
    token.depth = lexer->depth;
    token.main_line = lexer->frames[0].place.line;
    lexer_top(lexer)->place = kept->behind;
    return token;
}

struct scene_token lexer_next(struct lexer *lexer)
{
    struct open_text *frame = lexer_top(lexer);
    struct kept_token *kept = kept_at(lexer, frame);
    size_t from = frame->place.at;
    struct scene_token token;
    if (!frame->comes_again)
        return read_token(lexer);
    if (is_kept(kept, frame))
        return again(lexer, kept);
    token = read_token(lexer);
    keep(kept, &token, from, frame);
    return token;
}

/* ---- Tests of tokens ----------------------------------------------------- */

bool token_is_text(const struct scene_token *token, const char *word)
{
    return !strncmp(token->text, word, token->length) && word[token->length] == '\0';
}

bool token_is_among(const struct scene_token *token, const char *words)
{
    size_t length = token->length;
    while (words) {
        if (*words == *token->text && !strncmp(words, token->text, length)
            && (words[length] == ' ' || words[length] == '\0'))
            return true;
        words = strchr(words, ' ');
        words = words ? words + 1 : NULL;
    }
    return false;
}

const void *token_row(const struct scene_token *token, const void *rows, size_t size,
                      size_t count)
{
    for (const char *row = rows; count > 0; row += size, count--) {
        const char *word;
        memcpy(&word, row, sizeof word);
        if (token->kind == TOKEN_WORD && token_is_among(token, word))
            return row;
    }
    return NULL;
}

bool is_directive(const struct scene_token *token, const char *words)
{
    return token->kind == TOKEN_DIRECTIVE && token_is_among(token, words);
}

bool token_is_sign(const struct scene_token *token, int sign)
{
    return token->kind == TOKEN_SIGN && token->sign == sign;
}

struct position token_position(const struct scene_token *token)
{
    const struct scene_source *source = token->source;
    struct position position;
    const char *line = source->text + token->place.line_at;
    const char *end = memchr(line, '\n', source->length - token->place.line_at);
    position.file = source->name;
    position.line = token->place.line;
    position.column = token->place.at - token->place.line_at + 1;
    position.source = line;
    position.source_length = end ? (size_t)(end - line)
                                 : source->length - token->place.line_at;
    return position;
}
