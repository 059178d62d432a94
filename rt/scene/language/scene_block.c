/* scene_block.c - parses blocks by grammars, and recovers from errors. */
#include "rt/scene/language/scene_block.h"

#include "rt/scene/language/scene_expression.h"

#include <string.h>

const struct grammar no_words = { "'}'", .tables = { NULL } };

static bool is_object(const struct scene_token *token)
{
    return token->value && token->value->kind == VALUE_OBJECT;
}

const struct keyword *keyword_find(const struct keyword *table,
                                   const struct scene_token *token)
{
    for (; table && table->words; table++)
        if (*table->words ? token_is_among(token, table->words) : is_object(token))
            return table;
    return NULL;
}

const struct keyword *grammar_find(const struct grammar *grammar,
                                   const struct scene_token *token)
{
    const struct keyword *found = NULL;
    if (token->kind != TOKEN_WORD)
        return NULL;
    for (size_t i = 0; i < GRAMMAR_TABLES && !found; i++)
        found = keyword_find(grammar->tables[i], token);
    if (!found && grammar->object)
        found = keyword_find(object_words, token);
    if (!found && grammar->move)
        found = keyword_find(step_words, token);
    return found;
}

struct item item_find(const struct reader *reader, const struct grammar *grammar,
                      void *subject)
{
    return (struct item){ grammar_find(grammar, &reader->token), reader->token, subject,
                          grammar };
}

struct block block_file(const struct reader *reader)
{
    struct block block = { reader->token, 0, 0 };
    return block;
}

bool block_open(struct reader *reader, struct block *block, int opening)
{
    block->open = reader->token;
    block->closing = opening == '[' ? ']' : '}';
    if (!reader_at_sign(reader, opening))
        return reader_expect_sign(reader, opening);
    if (!reader_enter(reader))
        return false;
    reader_next(reader);
    block->level = reader->braces;
    return true;
}

bool block_open_from(struct reader *reader, struct block *block,
                     enum scene_value_kind kind, void *subject, size_t size)
{
    const struct scene_value *value;
    if (!block_open(reader, block, '{'))
        return false;
    value = reader_use(reader, kind);
    if (value) {
        memcpy(subject, &value->is, size);
        reader_next(reader);
    }
    return true;
}

static bool at_close(const struct reader *reader, const struct block *block)
{
    return reader->token.kind == TOKEN_END
           || (block->closing && reader->braces == block->level
               && (reader_at_sign(reader, block->closing)
                   || reader_at_sign(reader, '}')));
}

static bool block_close(struct reader *reader, const struct block *block)
{
    if (!block->closing)
        return true;
    reader_leave(reader);
    if (reader_accept_sign(reader, block->closing))
        return true;
    return reader_fault(reader, &reader->token,
                        "expected '%c' to close the '%c' of line %zu", block->closing,
                        block->open.sign, block->open.place.line);
}

/* Recovers from an error: skips to the next keyword of the grammar, to the token after
 * a directive or an inner block, or to the end of the block. */
static void recover(struct reader *reader, const struct block *block,
                    const struct grammar *grammar)
{
    while (!at_close(reader, block)) {
        const struct scene_token *token = &reader->token;
        if (reader->braces == block->level
            && (reader->closed || reader->directed || grammar_find(grammar, token)
                || (grammar->then && grammar_find(grammar->then, token))))
            break;
        reader_next(reader);
    }
}

static bool read_item(struct reader *reader, const struct grammar **grammar,
                      void *subject)
{
    struct item item = item_find(reader, *grammar, subject);
    if (!item.keyword && (*grammar)->then) {
        item = item_find(reader, (*grammar)->then, subject);
        if (item.keyword)
            *grammar = item.grammar;
    }
    if (!item.keyword) {
        reader_expected(reader, (*grammar)->expected);
        reader_next(reader);
        return false;
    }
    if (item.keyword->read != item_unmarked && *item.keyword->words)
        reader_next(reader);
    return item.keyword->read(reader, &item);
}

bool block_items(struct reader *reader, const struct block *block,
                 const struct grammar *grammar, void *subject, bool good)
{
    bool lost = !good;
    for (;;) {
        if (lost || reader->lost) {
            recover(reader, block, grammar);
            good = reader->lost = false;
        }
        if (at_close(reader, block))
            break;
        lost = !read_item(reader, &grammar, subject);
    }
    return block_close(reader, block) && good;
}

bool block_read(struct reader *reader, const struct grammar *grammar, void *subject)
{
    struct block block;
    return block_open(reader, &block, '{')
           && block_items(reader, &block, grammar, subject, true);
}

bool block_read_from(struct reader *reader, const struct grammar *grammar,
                     enum scene_value_kind kind, void *subject, size_t size)
{
    struct block block;
    return block_open_from(reader, &block, kind, subject, size)
           && block_items(reader, &block, grammar, subject, true);
}

void block_pass(struct reader *reader, const struct block *block)
{
    while (!at_close(reader, block))
        reader_next(reader);
}

bool block_finish(struct reader *reader, const struct block *block)
{
    block_pass(reader, block);
    return block_close(reader, block);
}

void block_skip(struct reader *reader)
{
    size_t outside = reader->braces;
    do
        reader_next(reader);
    while (reader->braces > outside && reader->token.kind != TOKEN_END);
}

void skip_arguments(struct reader *reader)
{
    struct numbers ignored;
    for (;;) {
        if (starts_expression(reader)) {
            if (!read_expression(reader, &ignored))
                return;
        } else if (starts_color(reader)) {
            if (!read_color(reader, &ignored))
                return;
        } else if (reader->token.kind == TOKEN_STRING) {
            reader_next(reader);
        } else {
            break;
        }
        reader_comma(reader);
    }
    if (reader_at_sign(reader, '{'))
        block_skip(reader);
}

bool item_left_out(struct reader *reader, const struct item *item)
{
    reader_report(reader, &item->at, "'%.*s' is not supported and is ignored",
                  ITEM_WORD(item));
    skip_arguments(reader);
    return true;
}

bool item_ignored(struct reader *reader, const struct item *item)
{
    (void)item;
    skip_arguments(reader);
    return true;
}

bool item_unsupported(struct reader *reader, const struct item *item)
{
    reader_fault(reader, &item->at, "'%.*s' is not supported", ITEM_WORD(item));
    skip_arguments(reader);
    return false;
}

bool item_unmarked(struct reader *reader, const struct item *item)
{
    reader_warn(reader, &item->at, "'%.*s' without '#' is read as '#%.*s'",
                ITEM_WORD(item), ITEM_WORD(item));
    reader->token.kind = TOKEN_DIRECTIVE;
    reader_resolve(reader);
    return true;
}
