/* reader.c - reports of the parser, and the basic operations on its tokens. */
#include "rt/scene/language/reader.h"
#include "vm/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MESSAGE_LONGEST = 1000, TOKEN_LONGEST = 40, CALLS_TOLD = 3 };

static int short_length(const struct scene_token *token)
{
    return token->length > TOKEN_LONGEST ? TOKEN_LONGEST : (int)token->length;
}

/* Appends the calls of the macros that contain the token. The innermost call is the
 * first. */
static void add_calls(const struct reader *reader, const struct scene_token *at,
                      char *message, size_t room)
{
    const struct lexer *lexer = &reader->lexer;
    size_t depth = at->depth < lexer->depth ? at->depth : lexer->depth;
    size_t calls = 0;
    for (; depth && calls < CALLS_TOLD; depth--) {
        const struct open_text *frame = &lexer->frames[depth - 1];
        size_t length = strlen(message);
        struct position position;
        if (!frame->is_macro)
            continue;
        position = token_position(&frame->call);
        snprintf(message + length, room - length, ", in '%.*s' called at %s:%zu:%zu",
                 short_length(&frame->call), frame->call.text, position.file,
                 position.line, position.column);
        calls++;
    }
}

static void add_error(struct reader *reader, const struct scene_token *at,
                      const char *message)
{
    struct diagnostics *reports = reader->reports;
    struct position position = token_position(at);
    diagnostics_add(reports, SEVERITY_ERROR, &position, message);
    if (reports->errors >= MAX_ERRORS) {
        diagnostics_add(reports, SEVERITY_ERROR, &position,
                        "too many errors: the scene is not read further "
                        "after " LIMIT_TEXT(MAX_ERRORS));
        reader_stop(reader);
    }
}

bool reader_fault(struct reader *reader, const struct scene_token *at,
                  const char *format, ...)
{
    char message[MESSAGE_LONGEST];
    va_list arguments;
    for (size_t i = 0; i < reader->fault_count; i++)
        if (reader->faults[i].source == at->source
            && reader->faults[i].at == at->place.at)
            return false;
    if (reader->fault_count < MAX_ERRORS) {
        reader->faults[reader->fault_count].source = at->source;
        reader->faults[reader->fault_count++].at = at->place.at;
    }
    if (reader->stopped)
        return false;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    add_calls(reader, at, message, sizeof message);
    add_error(reader, at, message);
    return false;
}

static void warning(struct reader *reader, const struct scene_token *at,
                    bool in_any_case, const char *format, va_list arguments)
{
    char words[MESSAGE_LONGEST], calls[MESSAGE_LONGEST] = "";
    struct warning_place place = { at->source, at->place.at, token_position(at) };
    if (reader->stopped)
        return;
    vsnprintf(words, sizeof words, format, arguments);
    add_calls(reader, at, calls, sizeof calls);
    (in_any_case ? scene_warning_report : scene_warning_add)(&reader->warnings, &place,
                                                             words, calls);
}

void reader_report(struct reader *reader, const struct scene_token *at,
                   const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    warning(reader, at, false, format, arguments);
    va_end(arguments);
}

void reader_warn(struct reader *reader, const struct scene_token *at,
                 const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    warning(reader, at, true, format, arguments);
    va_end(arguments);
}

bool reader_check(struct reader *reader, const struct scene_token *at,
                  const char *fault)
{
    return !fault || reader_fault(reader, at, "%s", fault);
}

bool reader_no_memory(struct reader *reader)
{
    reader_fault(reader, &reader->token, "there is not enough memory");
    return reader_stop(reader);
}

static bool is_undeclared(const struct reader *reader)
{
    const struct scene_token *token = &reader->token;
    return token->kind == TOKEN_WORD && token->length < TOKEN_LONGEST
           && !reader_value(reader) && token->text[0] >= 'A' && token->text[0] <= 'Z';
}

bool reader_expected(struct reader *reader, const char *what)
{
    const struct scene_token *token = &reader->token;
    const struct scene_value *value = reader_value(reader);
    const char *mark = token->kind == TOKEN_DIRECTIVE ? "#" : "";
    const char *more = token->length > TOKEN_LONGEST ? "..." : "";
    const char *hint = is_undeclared(reader) ? ", which is not declared" : "";
    int length = short_length(token);
    if (value && value->kind == VALUE_FAULTY)
        return false;
    if (token->kind == TOKEN_END)
        return reader_fault(reader, token, "expected %s, found the end of the %s", what,
                            lexer_top(&reader->lexer)->is_macro ? "macro" : "file");
    if (token->kind == TOKEN_STRING)
        return reader_fault(reader, token, "expected %s, found a string", what);
    return reader_fault(reader, token, "expected %s, found '%s%.*s%s'%s", what, mark,
                        length, token->text, more, hint);
}

bool reader_at_sign(const struct reader *reader, int sign)
{
    return token_is_sign(&reader->token, sign);
}

bool reader_accept_sign(struct reader *reader, int sign)
{
    bool there = reader_at_sign(reader, sign);
    if (there)
        reader_next(reader);
    return there;
}

bool reader_require_sign(struct reader *reader, int sign)
{
    const char what[] = { '\'', (char)sign, '\'', '\0' };
    return reader_at_sign(reader, sign) || reader_expected(reader, what);
}

bool reader_expect_sign(struct reader *reader, int sign)
{
    return reader_require_sign(reader, sign) && reader_accept_sign(reader, sign);
}

bool reader_accept(struct reader *reader, const char *word)
{
    bool there = is_token(&reader->token, word);
    if (there)
        reader_next(reader);
    return there;
}

void reader_comma(struct reader *reader)
{
    reader_accept_sign(reader, ',');
}

bool reader_look_up(struct reader *reader, struct scene_token *token)
{
    struct declared_name *symbol = token->kind == TOKEN_WORD
                                       ? symbols_find(&reader->symbols, token->text,
                                                      token->length)
                                       : NULL;
    if (!symbol)
        return false;
    token->reference = reference_to(symbol);
    token->value = reference_value(&token->reference);
    return token->value;
}

const struct scene_value *reader_value(const struct reader *reader)
{
    return reader->token.value;
}

const char *reader_keep_name(struct reader *reader)
{
    size_t length;
    const char *name = symbol_name(reader->token.reference.symbol, &length);
    return arena_text(&reader->scene->kept, name, length);
}

bool reader_keep_float(struct reader *reader, const char *name, size_t length,
                       double value)
{
    struct scene *scene = reader->scene;
    struct declared_float declared = { arena_text(&scene->kept, name, length), value };
    return declared.name
           && arena_add(&scene->kept, &scene->floats, &scene->float_count,
                        &reader->floats_room, &declared, sizeof declared);
}

void *reader_keep(struct reader *reader, const void *items, size_t size)
{
    void *kept = arena_take(&reader->scene->kept, size + 1);
    if (!kept)
        reader_no_memory(reader);
    else if (size > 0)
        memcpy(kept, items, size);
    return kept;
}

const struct scene_value *reader_value_of(const struct reader *reader,
                                          enum scene_value_kind kind)
{
    const struct scene_value *value = reader_value(reader);
    return value && value->kind == kind ? value : NULL;
}

const struct scene_value *reader_use(struct reader *reader, enum scene_value_kind kind)
{
    const struct scene_value *value = reader_value_of(reader, kind);
    if (value)
        value_warnings_use(&reader->warnings, value->value_warnings);
    return value;
}

/* POV-Ray treats a scene without #version as version 3.62. */
bool reader_is_before(const struct reader *reader, double version)
{
    return (reader->version_at.source ? reader->version : 3.62) < version;
}

const struct scene_source *reader_find(struct reader *reader,
                                       const struct scene_token *at, const char *name,
                                       bool is_text)
{
    const struct scene_source *before = reader->sources, *source;
    const struct source_request request = {
        name, at->source, reader->options ? reader->options->search : NULL, is_text
    };
    c205_error error;
    source = source_include(&reader->sources, &request, &error);
    if (!source)
        reader_fault(reader, at, "%s", error.message);
    else if (source_is_other(source, name))
        reader_warn(reader, at,
                    "the file '%s' is read; its name differs only in letter case",
                    source->name);
    if (reader->sources == before || ++reader->files <= MAX_FILES)
        return source;
    reader_fault(reader, at, "more than %d files are read", MAX_FILES);
    return NULL;
}

bool reader_enter(struct reader *reader)
{
    if (reader->nesting == MAX_NESTING)
        return reader_fault(reader, &reader->token, "more than %d levels of nesting",
                            MAX_NESTING);
    reader->nesting++;
    return true;
}

void reader_leave(struct reader *reader)
{
    reader->nesting--;
}
