/* directive.c - executes the directives that are neither conditions nor
 * declarations. */
#include "rt/scene/language/directive.h"

#include "rt/scene/language/condition.h"
#include "rt/scene/language/declare.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"
#include "rt/scene/language/string_value.h"

#include <stdlib.h>
#include <string.h>

enum { MESSAGE_SAYS, MESSAGE_WARNS, MESSAGE_IS_ERROR };

/* Reads the file name at the end of a directive. The text of this file is read before
 * the text that follows the name, so reader_hold prevents the tokens after the name
 * from being executed. */
static char *read_file_name(struct reader *reader, size_t depth)
{
    size_t hold = reader_hold(reader);
    char *name = NULL;
    if (!starts_string(reader))
        reader_expected(reader, "a file name in quotes");
    else if (!file_name_read(reader, &name))
        name = NULL;
    reader->hold = hold;
    reader_close_frames(reader, depth);
    return name;
}

static bool open_file(struct reader *reader, const struct scene_token *at,
                      const char *name)
{
    const struct scene_source *source;
    bool opened;
    if (!*name)
        return reader_fault(reader, at, "the file name is empty");
    source = reader_find(reader, at, name, true);
    if (!source)
        return false;
    if (reader->includes++ >= MAX_INCLUDE)
        return reader_fault(reader, at, "more than %d files are included", MAX_INCLUDE);
    reader_back(reader);
    opened = lexer_open(&reader->lexer, source);
    reader_step(reader);
    return opened
           || reader_fault(reader, at, "more than %d nested include files",
                           INCLUDE_DEPTH);
}

static bool read_include(struct reader *reader, const struct item *item)
{
    size_t depth = reader->lexer.depth;
    struct scene_token at;
    char *name;
    bool done;
    (void)item;
    reader_resolve(reader);
    at = reader->token;
    name = read_file_name(reader, depth);
    done = name && open_file(reader, &at, name);
    free(name);
    return done;
}

/* Sets the version. In versions below 3.5 the words of a camera were applied in the
 * order of the text. */
static bool read_version(struct reader *reader, const struct item *item)
{
    struct scene_token at;
    double version;
    (void)item;
    reader_resolve(reader);
    at = reader->token;
    if (!read_number(reader, &version))
        return false;
    if (reader_at_sign(reader, ';'))
        reader_step(reader);
    if (version < 3.5 || version >= 4)
        reader_warn(reader, &at,
                    "this version is not supported; the scene is read as version 3.7");
    reader->version = version;
    reader->version_at = at;
    return true;
}

static const struct keyword default_words[] = {
    { "texture", item_texture_part, TEXTURE_WHOLE },
    { "pigment", item_texture_part, TEXTURE_PIGMENT },
    { "finish", item_texture_part, TEXTURE_FINISH },
    { "normal", item_texture_part, TEXTURE_NORMAL },
    { "camera", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar default_grammar = { "texture, pigment, normal or finish",
                                                .tables = { default_words } };

bool default_read(struct reader *reader, const struct item *item)
{
    struct texture texture = reader->default_texture;
    bool done = block_read(reader, &default_grammar, &texture);
    (void)item;
    if (done)
        reader->default_texture = texture;
    return done;
}

static bool read_default(struct reader *reader, const struct item *item)
{
    struct warning_page *page = reader->warnings.page;
    size_t hold = reader_hold(reader);
    bool done;
    reader->warnings.page = NULL; /* the warnings belong to the scene */
    done = default_read(reader, item);
    reader->hold = hold;
    reader->warnings.page = page;
    return done;
}

/* Outputs the text of a directive: #debug, #render and #statistics print the text,
 * #warning reports it as a warning, #error as an error. */
static bool append_text(struct reader *reader, const struct item *item,
                        const char *text)
{
    if (item->keyword->detail == MESSAGE_IS_ERROR)
        return reader_fault(reader, &item->at, "%s", text);
    if (item->keyword->detail == MESSAGE_WARNS)
        reader_warn(reader, &item->at, "%s", text);
    else if (!diagnostics_append(reader->reports, text))
        reader_warn(reader, &item->at,
                    "more than %d bytes of messages: the rest is omitted", MAX_SAID);
    return true;
}

static bool read_message(struct reader *reader, const struct item *item)
{
    size_t hold;
    char *text;
    bool done;
    reader_resolve(reader);
    hold = reader_hold(reader);
    done = string_read(reader, &text);
    reader->hold = hold;
    if (!done)
        return false;
    done = append_text(reader, item, text);
    free(text);
    return done;
}

static const struct keyword words[] = {
    { "break", condition_break, 0 },
    { "case", switch_case, SWITCH_CASE },
    { "debug render statistics", read_message, MESSAGE_SAYS },
    { "declare", read_declare, false },
    { "default", read_default, 0 },
    { "else elseif", condition_else, 0 },
    { "end", condition_end, 0 },
    { "error", read_message, MESSAGE_IS_ERROR },
    { "fclose", data_file_close, 0 },
    { "fopen", data_file_open, 0 },
    { "for", loop_for, 0 },
    { "if", condition_if, 0 },
    { "ifdef", condition_ifdef, CONDITION_WHEN_DEFINED },
    { "ifndef", condition_ifdef, CONDITION_UNLESS_DEFINED },
    { "include", read_include, 0 },
    { "local", read_declare, true },
    { "macro", macro_define, 0 },
    { "range", switch_case, SWITCH_RANGE },
    { "read", data_file_read, 0 },
    { "switch", switch_begin, 0 },
    { "undef", read_undef, 0 },
    { "version", read_version, 0 },
    { "warning", read_message, MESSAGE_WARNS },
    { "while", loop_while, 0 },
    { "write", data_file_write, 0 },
    { NULL, NULL, 0 },
};

/* Executes a directive. Some directives have no arguments, so the keyword may be the
 * last token. */
bool directive_read(struct reader *reader)
{
    struct item item = { keyword_find(words, &reader->token), reader->token, NULL,
                         NULL };
    reader_step(reader);
    if (!item.keyword)
        return reader_fault(reader, &item.at, "unknown directive '#%.*s'",
                            TOKEN_TEXT(&item.at));
    return item.keyword->read(reader, &item);
}
