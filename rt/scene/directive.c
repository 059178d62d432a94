/* directive.c - the directives: words after '#'. */
#include "rt/scene/directive.h"

#include "rt/scene/condition.h"
#include "rt/scene/expression.h"
#include "rt/scene/statement.h"

#include <errno.h>
#include <string.h>

enum { GLOBAL_LEVEL = 0, NAME_LONGEST = 1000, MESSAGE_IS_ERROR = 1 };

static bool declare_object(struct reader *reader, void *subject,
                           const struct item *item)
{
    struct value *value = subject;

    value->kind = VALUE_OBJECT;
    return shape_read(reader, &value->is.object, item);
}

static bool declare_pigment(struct reader *reader, void *subject,
                            const struct item *item)
{
    struct value *value = subject;

    (void)item;
    value->kind = VALUE_PIGMENT;
    value->is.pigment = reader->default_texture.pigment;
    return pigment_read(reader, &value->is.pigment);
}

static bool declare_finish(struct reader *reader, void *subject,
                           const struct item *item)
{
    struct value *value = subject;

    (void)item;
    value->kind = VALUE_FINISH;
    value->is.finish = reader->default_texture.finish;
    return finish_read(reader, &value->is.finish);
}

static bool declare_texture(struct reader *reader, void *subject,
                            const struct item *item)
{
    struct value *value = subject;

    (void)item;
    value->kind = VALUE_TEXTURE;
    value->is.texture = reader->default_texture;
    return texture_read(reader, &value->is.texture);
}

static bool declare_transform(struct reader *reader, void *subject,
                              const struct item *item)
{
    struct value *value = subject;

    (void)item;
    value->kind = VALUE_TRANSFORM;
    return transform_read(reader, &value->is.transform);
}

static bool declare_camera(struct reader *reader, void *subject,
                           const struct item *item)
{
    struct value *value = subject;

    value->kind = VALUE_CAMERA;
    value->is.camera = camera_default;
    return camera_read(reader, &item->at, &value->is.camera);
}

static const struct keyword declared_words[] = {
    SHAPE_WORDS(declare_object),
    { "pigment", declare_pigment, 0 },
    { "finish", declare_finish, 0 },
    { "texture", declare_texture, 0 },
    { "transform", declare_transform, 0 },
    { "camera", declare_camera, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar declared_grammar = {
    "a value", { declared_words, other_shapes }, NULL
};

static bool copy_value(struct reader *reader, struct value *value)
{
    const struct value *from = reader_value(reader);

    if (from->kind == VALUE_OBJECT) {
        value->kind = VALUE_OBJECT;
        if (!shape_copy(reader, &value->is.object, &from->is.object))
            return false;
    } else {
        *value = *from;
    }
    reader_next(reader);
    return true;
}

/* Only after numbers must there be a semicolon. */
static bool read_numbers(struct reader *reader, struct value *value)
{
    value->kind = VALUE_NUMBERS;
    return (is_color_word(&reader->token)
                ? read_color(reader, &value->is.numbers)
                : read_expression(reader, &value->is.numbers))
        && reader_expect_sign(reader, ';');
}

static bool read_right_side(struct reader *reader, struct value *value)
{
    struct item item = { grammar_find(&declared_grammar, &reader->token),
                         reader->token };
    const struct value *named = reader_value(reader);
    bool done;

    if (is_color_word(&item.at) || starts_expression(reader))
        return read_numbers(reader, value);
    if (!item.keyword && (!named || named->kind == VALUE_FAULTY))
        return reader_expected(reader, declared_grammar.expected);
    if (item.keyword) {
        reader_next(reader);
        done = item.keyword->read(reader, value, &item);
    } else {
        done = copy_value(reader, value);
    }
    reader_accept_sign(reader, ';');
    return done;
}

static bool is_reserved(const struct token *token)
{
    return is_expression_word(token) || is_color_word(token)
        || grammar_find(&file_grammar, token)
        || grammar_find(&modifier_grammar, token);
}

/* A name whose declaration is wrong is known as such, so that the error is
 * not told again at each use. */
static bool declare(struct reader *reader, size_t level)
{
    struct token name = reader->token;
    struct value value;
    bool done;

    memset(&value, 0, sizeof value);
    if (name.kind != TOKEN_WORD)
        return reader_expected(reader, "a name");
    reader_next(reader);
    if (is_reserved(&name))
        return reader_fault(reader, &name,
                            "'%.*s' is a word of the language, not a name",
                            (int)name.length, name.text);
    done = reader_expect_sign(reader, '=') && read_right_side(reader, &value);
    if (!done) {
        value_free(&value);
        value.kind = VALUE_FAULTY;
    }
    if (!symbols_set(&reader->symbols, level, name.text, name.length, &value))
        return reader_no_memory(reader);
    return done;
}

static bool read_declare(struct reader *reader, void *subject,
                         const struct item *item)
{
    (void)subject;
    (void)item;
    return declare(reader, GLOBAL_LEVEL);
}

static bool read_local(struct reader *reader, void *subject,
                       const struct item *item)
{
    (void)subject;
    (void)item;
    return declare(reader, reader->lexer.depth);
}

static bool read_undef(struct reader *reader, void *subject,
                       const struct item *item)
{
    struct token name = reader->token;

    (void)subject;
    (void)item;
    if (name.kind != TOKEN_WORD)
        return reader_expected(reader, "a name");
    reader_next(reader);
    if (!symbols_remove(&reader->symbols, name.text, name.length))
        reader_report(reader, &name, "'%.*s' is not declared",
                      (int)name.length, name.text);
    return true;
}

static bool cannot_include(struct reader *reader, const struct token *at)
{
    int why = errno;

    reader_next(reader);
    if (why == ENOENT)
        return reader_fault(reader, at, "there is no such file");
    return reader_fault(reader, at, "the file cannot be read: %s",
                        strerror(why));
}

static bool read_include(struct reader *reader, void *subject,
                         const struct item *item)
{
    const struct token at = reader->token;
    const struct source *source;
    char name[NAME_LONGEST + 1];

    (void)subject;
    (void)item;
    if (at.kind != TOKEN_STRING)
        return reader_expected(reader, "the name of a file in quotes");
    if (at.length > NAME_LONGEST || at.length == 0
        || memchr(at.text, '\0', at.length))
        return reader_expected(reader, "the name of a file");
    memcpy(name, at.text, at.length);
    name[at.length] = '\0';
    source = source_include(&reader->sources, name, at.source,
                            reader->options ? reader->options->search : NULL);
    if (!source)
        return cannot_include(reader, &at);
    if (reader->includes++ == INCLUDE_MOST)
        return reader_fault(reader, &at, "more than %d files are included",
                            INCLUDE_MOST);
    if (!lexer_open(&reader->lexer, source))
        return reader_fault(reader, &at,
                            "more than %d files include each other",
                            INCLUDE_DEPTH);
    reader_next(reader);
    return true;
}

/* Before 3.5 a camera's words were applied in the order of the text. */
static bool read_version(struct reader *reader, void *subject,
                         const struct item *item)
{
    struct token at = reader->token;
    double version;

    (void)subject;
    (void)item;
    if (!read_number(reader, &version))
        return false;
    reader_accept_sign(reader, ';');
    if (version < 3.5 || version >= 4)
        reader_report(reader, &at, "the scene is read as of version 3.7");
    return true;
}

static bool default_texture(struct reader *reader, void *subject,
                            const struct item *item)
{
    (void)item;
    return texture_read(reader, subject);
}

static bool default_pigment(struct reader *reader, void *subject,
                            const struct item *item)
{
    struct texture *texture = subject;

    (void)item;
    return pigment_read(reader, &texture->pigment);
}

static bool default_finish(struct reader *reader, void *subject,
                           const struct item *item)
{
    struct texture *texture = subject;

    (void)item;
    return finish_read(reader, &texture->finish);
}

static const struct keyword default_words[] = {
    { "texture", default_texture, 0 },
    { "pigment", default_pigment, 0 },
    { "finish", default_finish, 0 },
    { "camera", item_left_out, 0 },
    { "normal", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar default_grammar = {
    "texture, pigment or finish", { default_words }, NULL
};

static bool read_default(struct reader *reader, void *subject,
                         const struct item *item)
{
    struct texture texture = reader->default_texture;

    (void)subject;
    (void)item;
    if (!block_read(reader, &default_grammar, &texture))
        return false;
    reader->default_texture = texture;
    return true;
}

/* #warning and #error say what follows; other streams are left out. */
static bool read_message(struct reader *reader, void *subject,
                         const struct item *item)
{
    struct token text = reader->token;

    (void)subject;
    if (text.kind != TOKEN_STRING)
        return reader_expected(reader, "a string");
    reader_next(reader);
    if (item->keyword->detail == MESSAGE_IS_ERROR)
        return reader_fault(reader, &item->at, "%.*s", (int)text.length,
                            text.text);
    reader_report(reader, &item->at, "%.*s", (int)text.length, text.text);
    return true;
}

static bool skip_line(struct reader *reader, void *subject,
                      const struct item *item)
{
    (void)subject;
    reader_report(reader, &item->at, "'#%s' is left out: its line is skipped",
                  item->keyword->word);
    if (reader->token.line == item->at.line
        && reader->token.source == item->at.source
        && reader->token.kind != TOKEN_END) {
        lexer_skip_line(&reader->lexer);
        reader_next(reader);
    }
    return true;
}

static bool unsupported(struct reader *reader, void *subject,
                        const struct item *item)
{
    (void)subject;
    return reader_fault(reader, &item->at, "'#%s' is not supported",
                        item->keyword->word);
}

static const struct keyword words[] = {
    { "declare", read_declare, 0 },
    { "local", read_local, 0 },
    { "undef", read_undef, 0 },
    { "include", read_include, 0 },
    { "version", read_version, 0 },
    { "default", read_default, 0 },
    { "error", read_message, MESSAGE_IS_ERROR },
    { "warning", read_message, 0 },
    { "debug", skip_line, 0 },
    { "render", skip_line, 0 },
    { "statistics", skip_line, 0 },
    { "fclose", unsupported, 0 },
    { "fopen", unsupported, 0 },
    { "read", unsupported, 0 },
    { "write", unsupported, 0 },
    { "break", unsupported, 0 },
    { "case", unsupported, 0 },
    { "else", condition_else, 0 },
    { "elseif", unsupported, 0 },
    { "end", condition_end, 0 },
    { "range", unsupported, 0 },
    { "for", condition_unsupported, 0 },
    { "if", condition_unsupported, 0 },
    { "ifdef", condition_read, CONDITION_WHEN_DEFINED },
    { "ifndef", condition_read, CONDITION_UNLESS_DEFINED },
    { "macro", condition_unsupported, 0 },
    { "switch", condition_unsupported, 0 },
    { "while", condition_unsupported, 0 },
    { NULL, NULL, 0 },
};

static const struct keyword *find(const struct token *token)
{
    const struct keyword *keyword = words;

    while (keyword->word
           && (strlen(keyword->word) != token->length
               || memcmp(keyword->word, token->text, token->length)))
        keyword++;
    return keyword->word ? keyword : NULL;
}

bool directive_read(struct reader *reader)
{
    struct item item = { find(&reader->token), reader->token };

    reader_next(reader);
    if (!item.keyword)
        return reader_fault(reader, &item.at,
                            "'#%.*s' is not a directive of the language",
                            (int)item.at.length, item.at.text);
    return item.keyword->read(reader, NULL, &item);
}
