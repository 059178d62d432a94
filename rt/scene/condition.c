/* condition.c - #ifdef, #ifndef, #else and #end. */
#include "rt/scene/condition.h"

#include <string.h>

static bool is_one_of(const struct token *token, const char *const *words)
{
    for (; *words; words++)
        if (token->length == strlen(*words)
            && !memcmp(token->text, *words, token->length))
            return true;
    return false;
}

static bool is_directive(const struct token *token, const char *const *words)
{
    return token->kind == TOKEN_DIRECTIVE && is_one_of(token, words);
}

static const char *const openers[] = { "for",   "if",     "ifdef", "ifndef",
                                       "macro", "switch", "while", NULL };
static const char *const end[] = { "end", NULL };
static const char *const other[] = { "else", NULL };
static const char *const other_if[] = { "elseif", NULL };

/* What is not to be read, to the #end or, if asked, to the #else of the same
 * depth.  Returns that token; the one behind it comes next. */
static struct token skip(struct reader *reader, bool to_else)
{
    size_t depth = 1, braces = reader->braces;
    struct token at;

    do {
        at = reader->token;
        if (is_directive(&at, openers))
            depth++;
        else if (is_directive(&at, end)
                 || (to_else && depth == 1 && is_directive(&at, other)))
            depth--;
        else if (to_else && depth == 1 && is_directive(&at, other_if))
            reader_fault(reader, &at, "'#elseif' is not supported");
        reader_next(reader);
    } while (depth && at.kind != TOKEN_END);
    reader->braces = braces;
    return at;
}

bool condition_unsupported(struct reader *reader, void *subject,
                           const struct item *item)
{
    (void)subject;
    reader_fault(reader, &item->at, "'#%s' is not supported",
                 item->keyword->word);
    skip(reader, false);
    return true;
}

static bool is_defined(const struct reader *reader, const struct token *name)
{
    static const char *const own[] = { "elliptical_torus", "steiner_patch",
                                       NULL };

    return is_one_of(name, own)
        || symbols_find(&reader->symbols, name->text, name->length);
}

static bool read_name(struct reader *reader, bool *defined)
{
    if (!reader_expect_sign(reader, '('))
        return false;
    if (reader->token.kind != TOKEN_WORD)
        return reader_expected(reader, "a name");
    *defined = is_defined(reader, &reader->token);
    reader_next(reader);
    return reader_expect_sign(reader, ')');
}

bool condition_read(struct reader *reader, void *subject,
                    const struct item *item)
{
    bool wanted = item->keyword->detail == CONDITION_WHEN_DEFINED;
    bool defined = false, done = read_name(reader, &defined);
    struct condition *condition;
    struct token last;

    (void)subject;
    if (done && reader->condition_count == CONDITIONS_MOST)
        done = reader_fault(reader, &item->at,
                            "more than %d conditions within each other",
                            CONDITIONS_MOST);
    if (!done) {
        skip(reader, false);
        return false;
    }
    condition = &reader->conditions[reader->condition_count++];
    condition->at = item->at;
    condition->in_else = false;
    if (defined == wanted)
        return true;
    last = skip(reader, true);
    condition->in_else = is_directive(&last, other);
    reader->condition_count -= is_directive(&last, end);
    return true;
}

/* The innermost open condition, if it stands in the file of the token. */
static const struct condition *innermost(const struct reader *reader,
                                         const struct token *at)
{
    size_t count = reader->condition_count;

    return count && reader->conditions[count - 1].at.source == at->source
        ? &reader->conditions[count - 1]
        : NULL;
}

/* What stands before an #else has been read, so the rest is not. */
bool condition_else(struct reader *reader, void *subject,
                    const struct item *item)
{
    const struct condition *condition = innermost(reader, &item->at);
    struct token last;

    (void)subject;
    if (!condition || condition->in_else)
        return reader_fault(reader, &item->at,
                            "there is no '#ifdef' for this '#else'");
    last = skip(reader, false);
    reader->condition_count -= is_directive(&last, end);
    return true;
}

bool condition_end(struct reader *reader, void *subject,
                   const struct item *item)
{
    (void)subject;
    if (!innermost(reader, &item->at))
        return reader_fault(reader, &item->at,
                            "there is no '#ifdef' for this '#end'");
    reader->condition_count--;
    return true;
}

void conditions_close(struct reader *reader)
{
    for (size_t i = 0; i < reader->condition_count; i++)
        reader_fault(reader, &reader->conditions[i].at,
                     "no '#end' closes this '#%.*s'",
                     (int)reader->conditions[i].at.length,
                     reader->conditions[i].at.text);
}
