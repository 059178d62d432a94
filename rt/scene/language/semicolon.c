/* semicolon.c - looks ahead for the ';' of a declaration.
 *
 * Whether a value has ended can depend on text that a directive or a macro inserts. The
 * lookahead therefore scans the tokens after the value without executing anything: it
 * skips the heads of directives and the arguments of macros, and stops at the first
 * other token. At the end of a frame it continues in the frame below.
 */
#include "rt/scene/language/semicolon.h"

#include "rt/scene/language/condition.h"
#include "rt/scene/language/scene_expression.h"

#include <string.h>

static bool is_component(const struct scene_token *token)
{
    return token->place.at && token->text[-1] == '.';
}

bool semicolon_may_follow(const struct reader *reader)
{
    const struct scene_token *token = &reader->token;
    if (reader->declared.brackets != 1 + (size_t)token_is_sign(token, ')')
        || reader->braces != reader->hold)
        return false;
    return token->kind == TOKEN_SIGN ? token->sign == ')' || token->sign == '>'
                                     : !is_color_word(token) || is_component(token);
}

/* ---- Lookahead ----------------------------------------------------------- */

static struct scene_token next(struct reader *reader)
{
    return lexer_next(&reader->lexer);
}

/* Skips the parenthesized condition of a directive, or the arguments of a macro. */
static void skip_brackets(struct reader *reader)
{
    struct scene_token token;
    size_t open = 0;
    do {
        token = next(reader);
        open += token_is_sign(&token, '(');
        open -= open && token_is_sign(&token, ')');
    } while (open && token.kind != TOKEN_END);
}

/* Skips the branches of a condition that are not read, up to its #end. */
static void skip_branches(struct reader *reader)
{
    struct scene_token token;
    size_t open = 1;
    do {
        token = next(reader);
        open += is_directive(&token, CONDITION_OPENERS);
        open -= is_directive(&token, "end");
    } while (open && token.kind != TOKEN_END);
}

/* Skips a directive that ends with ';', such as an assignment. Returns false if there
 * is no such ';'. */
static bool skip_statement(struct reader *reader)
{
    struct scene_token token;
    do
        token = next(reader);
    while (token.kind != TOKEN_END && token.kind != TOKEN_DIRECTIVE
           && !token_is_sign(&token, ';') && !token_is_sign(&token, '{'));
    return token_is_sign(&token, ';');
}

/* Skips the head of a directive, or the branches that would not be read. `open` is the
 * number of conditions that began after the value. Returns false if the directive
 * cannot be within a value. */
static bool skip_directive(struct reader *reader, const struct scene_token *token,
                           size_t *open)
{

    if (token_is_text(token, "macro"))
        return false;
    if (is_directive(token, "end")) {
        *open -= *open > 0;
    } else if (is_directive(token, CONDITION_OPENERS)) {
        ++*open;
        skip_brackets(reader);
    } else if (!is_directive(token, "else elseif case range break")) {
        return skip_statement(reader);
    } else if (!*open) {
        skip_branches(reader);
    } else if (!token_is_text(token, "else") && !token_is_text(token, "break")) {
        skip_brackets(reader);
    }
    return true;
}

static bool is_macro(struct reader *reader, struct scene_token *token)
{
    return reader_look_up(reader, token) && token->value->kind == VALUE_MACRO;
}

static bool continues_value(const struct scene_token *token)
{
    return (token->kind == TOKEN_SIGN && token->sign < SIGN_UNEQUAL
            && strchr("+-*/.;", token->sign))
           || is_color_word(token);
}

static bool frame_below_leads_on(struct reader *reader);

/* Returns true if an operator or ';' follows the value, directly or after directives
 * and macros. The lookahead executes nothing, and restores the cursors of the
 * frames. */
static bool leads_on(struct reader *reader, struct scene_token token)
{
    struct lexer *lexer = &reader->lexer;
    struct text_place place = lexer_top(lexer)->place;
    size_t open = 0, bytes;
    bool possible = true;
    for (; possible; token = next(reader))
        if (token.kind == TOKEN_DIRECTIVE)
            possible = skip_directive(reader, &token, &open);
        else if (is_macro(reader, &token))
            skip_brackets(reader);
        else
            break;
    bytes = lexer_top(lexer)->place.at - place.at;
    if (!possible || token.kind != TOKEN_END || lexer->depth == 1)
        possible = possible && continues_value(&token);
    else
        possible = frame_below_leads_on(reader);
    lexer_top(lexer)->place = place;
    return reader_spend(reader, bytes) && possible;
}

static bool frame_below_leads_on(struct reader *reader)
{
    struct lexer *lexer = &reader->lexer;
    struct text_place place;
    bool possible;
    lexer->depth--;
    place = lexer_top(lexer)->place;
    possible = leads_on(reader, next(reader));
    lexer_top(lexer)->place = place;
    lexer->depth++;
    return possible;
}

/* ---- Insertion ----------------------------------------------------------- */

void semicolon_missing(struct reader *reader)
{
    struct scene_token at = reader->token;
    if (reader->declared.source) {
        at.source = reader->declared.source;
        at.place = reader->declared.place;
        at.depth = reader->declared.depth;
    }
    if (reader_is_before(reader, 3.5))
        reader_warn(reader, &at,
                    "';' is missing after the value, as versions below 3.5 allow");
    else
        reader_fault(reader, &at, "';' is missing after the value");
}

/* Records where the value ends. If the value ends in a macro, this is the place after
 * the call. */
static void end_value(struct reader *reader)
{
    const struct open_text *frame;
    reader->declared.source = reader->token.source;
    reader->declared.place = reader->before;
    if (reader->lexer.depth <= reader->declared.depth)
        return;
    frame = &reader->lexer.frames[reader->declared.depth - 1];
    reader->declared.source = frame->source;
    reader->declared.place = frame->place;
}

void semicolon_find(struct reader *reader)
{
    struct scene_token *token = &reader->token;
    if (continues_value(token))
        return;
    end_value(reader);
    if (token->kind != TOKEN_END && token->kind != TOKEN_DIRECTIVE
        && !is_macro(reader, token))
        return;
    if (leads_on(reader, *token))
        return;
    semicolon_missing(reader);
    reader_back(reader);
    token->kind = TOKEN_SIGN;
    token->sign = ';';
}
