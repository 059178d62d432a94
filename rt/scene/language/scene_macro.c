/* scene_macro.c - defines macros (#macro), and executes calls of macros.
 *
 * A call of a macro is replaced by the macro's body. Each call has its own scope, which
 * contains the parameters. An argument that is only a name or an array element is
 * passed by reference, any other argument by value.
 */
#include "rt/scene/language/directive.h"

#include "rt/scene/language/condition.h"
#include "rt/scene/language/declare.h"
#include "base/plural.h"

#include <stdlib.h>
#include <string.h>

/* ---- Definition ---------------------------------------------------------- */

static bool read_parameter(struct reader *reader, struct scene_macro *macro)
{
    const struct scene_token *token = &reader->token;
    if (token->kind != TOKEN_WORD)
        return reader_expected(reader, "the name of a parameter or ')'");
    if (is_reserved(token))
        return reader_fault(reader, token, "'%.*s' is a keyword, not a name",
                            TOKEN_TEXT(token));
    if (macro->count == MAX_PARAMETERS)
        return reader_fault(reader, token, "more than %d parameters", MAX_PARAMETERS);
    macro->parameters[macro->count].text = token->text;
    macro->parameters[macro->count].length = token->length;
    macro->count++;
    reader_step(reader);
    if (reader_at_sign(reader, ','))
        reader_step(reader);
    return true;
}

/* Reads the parameters of a macro, from "(" to the start of its body. */
static bool read_parameters(struct reader *reader, struct scene_macro *macro)
{
    if (!reader_require_sign(reader, '('))
        return false;
    reader_step(reader);
    while (!reader_at_sign(reader, ')'))
        if (!read_parameter(reader, macro))
            return false;
    macro->source = reader->token.source;
    macro->body = lexer_top(&reader->lexer)->place;
    return true;
}

static bool add_macro(struct reader *reader, const struct scene_token *name,
                      struct scene_macro *macro)
{
    struct declared_name *before = symbols_find(&reader->symbols, name->text,
                                                name->length);
    struct scene_value value = { .kind = VALUE_MACRO, .is.macro = macro };
    return reader_check(reader, name,
                        symbols_assign(&reader->symbols, before, 0, name, &value));
}

bool macro_define(struct reader *reader, const struct item *item)
{
    struct scene_macro *macro = calloc(1, sizeof *macro);
    struct scene_token name = reader->token;
    bool done = macro || reader_no_memory(reader);
    bool found;
    done = done && name_expected(reader, &name);
    if (done) {
        reader_step(reader);
        done = read_parameters(reader, macro);
    }
    found = condition_skip(reader, &item->at, "end", 1);
    if (done)
        macro->end = reader->token.place.at;
    if (found)
        reader_step(reader);
    if (!done || !found) {
        free(macro);
        return false;
    }
    return add_macro(reader, &name, macro);
}

/* ---- Call ---------------------------------------------------------------- */

struct argument {
    struct reference reference; /* an argument passed by reference: its target, held
                                 * during the call; without a symbol, the argument is
                                 * `value`: */
    struct scene_value value;
};

struct scene_call {
    struct scene_macro macro; /* a copy, because an argument may redefine the macro */
    struct scene_token at;
    size_t count;
    struct argument arguments[]; /* one for each parameter */
};

static bool is_alone(struct reader *reader)
{
    struct scene_token behind;
    if (reader->token.kind != TOKEN_WORD || !reader->token.reference.symbol)
        return false;
    behind = reader_peek(reader);
    return token_is_sign(&behind, ',') || token_is_sign(&behind, ')');
}

static bool read_argument(struct reader *reader, struct argument *argument)
{
    if (!is_alone(reader))
        return value_read(reader, &argument->value);
    argument->reference = reader->token.reference;
    symbol_hold(argument->reference.symbol);
    reader_next(reader);
    return true;
}

static bool read_arguments(struct reader *reader, struct scene_call *call)
{
    const struct scene_macro *macro = &call->macro;
    while (call->count < macro->count) {
        if (reader_at_sign(reader, ')'))
            return reader_fault(reader, &reader->token,
                                "'%.*s' takes %zu argument%s, found %zu",
                                TOKEN_TEXT(&call->at), macro->count,
                                plural(macro->count), call->count);
        call->count++;
        if (!read_argument(reader, &call->arguments[call->count - 1]))
            return false;
        if (!reader_at_sign(reader, ')') && !reader_expect_sign(reader, ','))
            return false;
    }
    return reader_require_sign(reader, ')');
}

/* Declares the parameters of the macro in the scope of its body. */
static bool bind(struct reader *reader, struct scene_call *call)
{
    const char *fault = NULL;
    for (size_t i = 0; i < call->count && !fault; i++) {
        struct argument *argument = &call->arguments[i];
        const char *name = call->macro.parameters[i].text;
        size_t length = call->macro.parameters[i].length;
        if (argument->reference.symbol)
            fault = symbols_refer(&reader->symbols, reader->lexer.depth, name, length,
                                  &argument->reference);
        else
            fault = symbols_add(&reader->symbols, reader->lexer.depth, name, length,
                                &argument->value);
        memset(&argument->value, 0, sizeof argument->value);
    }
    return reader_check(reader, &call->at, fault);
}

/* Opens a frame for the body. The current token is the closing bracket, so that the
 * body is read before the text after the bracket. */
static bool enter_body(struct reader *reader, struct scene_call *call)
{
    const struct scene_macro *macro = &call->macro;
    if (!lexer_call(&reader->lexer, macro->source, macro->body, macro->end,
                    &call->at)) {
        reader_fault(reader, &call->at, "more than %d nested macros and files",
                     MAX_FRAMES);
        return reader_stop(reader);
    }
    if (!bind(reader, call))
        return false;
    reader_step(reader);
    return true;
}

static void call_free(struct scene_call *call)
{
    for (size_t i = 0; i < call->count; i++) {
        struct argument *argument = &call->arguments[i];
        symbol_release(argument->reference.symbol);
        value_free(&argument->value);
    }
    free(call);
}

static struct scene_call *new_call(const struct reader *reader)
{
    const struct scene_macro *macro = reader->token.value->is.macro;
    struct scene_call *call = calloc(1, sizeof *call
                                            + macro->count * sizeof *call->arguments);
    if (call) {
        call->macro = *macro;
        call->at = reader->token;
    }
    return call;
}

static bool read_call(struct reader *reader, struct scene_call *call)
{
    reader_step(reader);
    if (!reader_require_sign(reader, '('))
        return false;
    reader_next(reader);
    return read_arguments(reader, call) && enter_body(reader, call);
}

bool macro_call(struct reader *reader)
{
    struct scene_call *call;
    size_t hold = reader_nest(reader);
    bool done;
    if (!reader_enter(reader)) {
        reader_step(reader);
        reader->hold = hold;
        return false;
    }
    call = new_call(reader);
    done = call ? read_call(reader, call) : reader_no_memory(reader);
    if (call)
        call_free(call);
    reader_leave(reader);
    reader->hold = hold;
    return done;
}
