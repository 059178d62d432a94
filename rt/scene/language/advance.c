/* advance.c - advances from token to token, and executes directives and macros. */
#include "rt/scene/language/condition.h"
#include "rt/scene/language/directive.h"
#include "rt/scene/language/array_element.h"
#include "rt/scene/language/semicolon.h"

#include <inttypes.h>

enum { ASKED_EACH = 1 << 20 };

bool reader_stop(struct reader *reader)
{
    reader->stopped = true;
    reader->token.kind = TOKEN_END;
    return false;
}

/* Calls go_on, which may be slow, once per ASKED_EACH bytes. Returns true if go_on has
 * stopped the reading. */
static bool is_stopped(struct reader *reader, size_t bytes)
{
    const struct scene_options *options = reader->options;
    uint64_t period = ASKED_EACH;
    return options && options->go_on
           && reader->bytes / period != (reader->bytes + bytes) / period
           && !options->go_on(options->context);
}

static uint64_t reading_most(const struct reader *reader)
{
    const struct scene_options *options = reader->options;
    return options && options->reading_most ? options->reading_most : MAX_READING;
}

bool reader_spend(struct reader *reader, size_t bytes)
{
    uint64_t most = reading_most(reader);
    if (reader->stopped)
        return false;
    if (is_stopped(reader, bytes)) {
        reader_fault(reader, &reader->token, "reading was stopped here");
        return reader_stop(reader);
    }
    if (bytes <= most - reader->bytes) {
        reader->bytes += bytes;
        return true;
    }
    reader_fault(reader, &reader->token,
                 "the scene takes too long to read: more than %" PRIu64
                 " bytes, with each repetition of loops and macros counted",
                 most);
    return reader_stop(reader);
}

static void count_brackets(struct reader *reader, int sign)
{
    size_t *brackets = &reader->declared.brackets;
    if (sign == '{')
        reader->braces++;
    else if (sign == '}')
        reader->braces -= reader->braces > 0;
    else if (sign == '(' || sign == '[')
        *brackets += *brackets > 0;
    else if (sign == ')' || sign == ']')
        *brackets -= *brackets > 1;
}

/* Reads the next token. Invalid bytes are skipped here, so that all of them are
 * reported. */
void reader_step(struct reader *reader)
{
    if (reader->token.kind == TOKEN_SIGN)
        count_brackets(reader, reader->token.sign);
    while (!reader->stopped) {
        struct open_text *top = lexer_top(&reader->lexer);
        reader->before = top->place;
        reader->token = lexer_next(&reader->lexer);
        if (reader->token.fault)
            reader_fault(reader, &reader->token, "%s", reader->token.fault);
        if (!reader_spend(reader, top->place.at - reader->before.at + TOKEN_COST))
            return;
        if (reader->token.kind != TOKEN_BAD)
            return;
    }
}

struct scene_token reader_peek(struct reader *reader)
{
    struct text_place place = lexer_top(&reader->lexer)->place;
    struct scene_token token = lexer_next(&reader->lexer);
    lexer_top(&reader->lexer)->place = place;
    return token;
}

void reader_back(struct reader *reader)
{
    struct open_text *top = lexer_top(&reader->lexer);
    if (reader->stopped)
        return;
    if (reader->token.depth == reader->lexer.depth)
        top->place = reader->before;
    reader->token.kind = TOKEN_END;
}

void reader_jump(struct reader *reader, const struct text_place *place)
{
    if (reader->stopped)
        return;
    lexer_jump(&reader->lexer, place);
    reader->token.kind = TOKEN_END;
    reader_step(reader);
}

/* Closes a frame at its end. Reading continues in the frame below. */
static bool close_frame(struct reader *reader)
{
    if (reader->token.kind != TOKEN_END || reader->lexer.depth == 1)
        return false;
    conditions_close(reader);
    lexer_close(&reader->lexer);
    symbols_leave(&reader->symbols, reader->lexer.depth);
    reader_step(reader);
    return true;
}

size_t reader_hold(struct reader *reader)
{
    size_t before = reader->hold;
    reader->hold = reader->braces;
    return before;
}

size_t reader_nest(struct reader *reader)
{
    size_t before = reader->hold;
    reader->hold = (size_t)HOLD_NONE;
    return before;
}

static bool carry_out(struct reader *reader)
{
    bool done;
    if (!reader_enter(reader)) {
        reader_step(reader);
        return false;
    }
    done = directive_read(reader);
    reader_leave(reader);
    return done;
}

/* Looks up the word at the current token. If it is a macro, calls the macro and returns
 * true. If it is an array, reads the index of an element. *done becomes false if a call
 * or an index has an error. */
static bool resolve(struct reader *reader, bool *done)
{
    struct scene_token *token = &reader->token;
    if (!reader_look_up(reader, token))
        return false;
    if (token->value->kind == VALUE_MACRO) {
        *done = macro_call(reader);
        return true;
    }
    if (token->value->kind == VALUE_ARRAY)
        *done = element_read(reader) && *done;
    return false;
}

static void finish(struct reader *reader, size_t depth)
{
    size_t hold = reader_nest(reader), brackets = reader->declared.brackets;
    bool directed = false, done = true, again = true;
    reader->declared.brackets = 0;
    while (again && !reader->stopped && reader->lexer.depth > depth) {
        again = false;
        if (close_frame(reader)) {
            again = true;
        } else if (reader->token.kind == TOKEN_DIRECTIVE) {
            done = carry_out(reader);
            directed = again = true;
        } else if (reader->token.kind == TOKEN_WORD) {
            again = resolve(reader, &done);
        }
    }
    reader->hold = hold;
    reader->declared.brackets = brackets;
    reader->directed = directed && done;
    reader->lost = !done;
}

void reader_resolve(struct reader *reader)
{
    finish(reader, 0);
}

void reader_close_frames(struct reader *reader, size_t depth)
{
    finish(reader, depth);
}

void reader_pass(struct reader *reader)
{
    reader_step(reader);
    if (reader->braces != reader->hold)
        reader_resolve(reader);
}

void reader_next(struct reader *reader)
{
    bool closes = reader_at_sign(reader, '}');
    bool ends = reader->declared.brackets && semicolon_may_follow(reader);
    if (reader->stopped)
        return;
    if (closes) {
        reader_pass(reader);
    } else {
        reader_step(reader);
        if (ends)
            semicolon_find(reader);
        reader_resolve(reader);
    }
    reader->closed = closes;
}
