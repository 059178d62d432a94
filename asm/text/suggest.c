/* suggest.c - suggests a known name for a misspelt name. */
#include "asm/text/suggest.h"

#include <ctype.h>
#include <string.h>

#include "base/spelling.h"

static bool is_kind(const struct symbol *symbol, enum suggestion kind)
{
    switch (kind) {
    case SUGGEST_MNEMONIC: return symbol->macro != NULL;
    case SUGGEST_REGISTER:
        return symbol->kind == SYMBOL_REGISTER || symbol->kind == SYMBOL_HALF_REGISTER;
    case SUGGEST_VALUE:
        return symbol->kind == SYMBOL_LABEL || symbol->kind == SYMBOL_CONSTANT;
    default: return false;
    }
}

static void try_symbols(const struct assembler *assembler, enum suggestion kind,
                        struct spelling *nearest)
{
    const struct symbol *symbol;
    for (size_t i = 0; i < SYMBOL_BUCKETS; i++)
        for (symbol = assembler->symbols.buckets[i]; symbol; symbol = symbol->next)
            if (is_kind(symbol, kind))
                spelling_try(nearest, symbol->name);
}

/* ---- Comparisons --------------------------------------------------------- */

/* Returns the two letters of the relation in a mnemonic, as in CMPGEV, or NULL if it is
 * not a comparison. */
static const char *relation_of(const char *mnemonic)
{
    static const char *const prefixes[] = {
        "CMP", "SEL", "SCH", "CFP", "IBX", "BH", "B"
    };
    static const char relations[] = "EQ NE GE GT LE LT";
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++) {
        size_t length = strlen(prefixes[i]);
        if (strncmp(mnemonic, prefixes[i], length) != 0)
            continue;
        for (const char *at = relations; at; at = strchr(at, ' '), at += at != NULL)
            if (strncmp(mnemonic + length, at, 2) == 0)
                return mnemonic + length;
    }
    return NULL;
}

static size_t count_letter(const char *word, int letter)
{
    size_t count = 0;
    for (; *word; word++)
        count += toupper((unsigned char)*word) == letter;
    return count;
}

static bool has_same_letters(const char *word, const char *mnemonic)
{
    if (strlen(word) != strlen(mnemonic))
        return false;
    for (int letter = 'A'; letter <= 'Z'; letter++)
        if (count_letter(word, letter) != count_letter(mnemonic, letter))
            return false;
    return true;
}

/* Returns true if a word contains the relation, or only exchanges letters of the
 * mnemonic. Other words may mean another relation. */
static bool has_relation(const char *word, const char *mnemonic, const char *relation)
{
    for (const char *at = word; *at; at++)
        if (toupper((unsigned char)at[0]) == relation[0]
            && toupper((unsigned char)at[1]) == relation[1])
            return true;
    return has_same_letters(word, mnemonic);
}

static void try_mnemonic(struct spelling *nearest, const char *mnemonic)
{
    const char *relation = relation_of(mnemonic);
    if (!relation || has_relation(nearest->word, mnemonic, relation))
        spelling_try(nearest, mnemonic);
}

/* ---- All names ------------------------------------------------------------- */

typedef const char *name_list(size_t i);

/* Returns the name of directive i in the concatenated lists. */
const char *asm_directive(size_t i)
{
    static name_list *const lists[] = { directive_name, expand_name, condition_name };
    for (size_t list = 0; list < sizeof lists / sizeof *lists; list++) {
        size_t count = 0;
        while (count < i && lists[list](count))
            count++;
        if (lists[list](count))
            return lists[list](count);
        i -= count;
    }
    return NULL;
}

const char *suggest(struct assembler *assembler, enum suggestion kind, const char *name,
                    size_t length)
{
    struct spelling nearest = { .word = arena_text(assembler->arena, name, length) };
    if (!nearest.word)
        return NULL;
    if (kind == SUGGEST_MNEMONIC)
        for (size_t i = 0; i < c205_insn_count; i++)
            try_mnemonic(&nearest, c205_insns[i].mnemonic);
    for (size_t i = 0; kind == SUGGEST_DIRECTIVE && asm_directive(i); i++)
        spelling_try(&nearest, asm_directive(i));
    try_symbols(assembler, kind, &nearest);
    return nearest.name;
}

bool expected_name(struct cursor *cursor, const char *what, enum suggestion kind)
{
    const struct token *token = &cursor->token;
    size_t length = (size_t)(token->end - token->begin);
    const char *meant = NULL, *advice = NULL;
    if (kind == SUGGEST_MNEMONIC)
        advice = foreign_advice(token->begin, length);
    if (advice)
        return report_at(cursor, token->begin, "expected %s, found '%.*s'; %s", what,
                         (int)length, token->begin, advice);
    if (token->kind == TOKEN_NAME || token->kind == TOKEN_DIRECTIVE)
        meant = suggest(cursor->assembler, kind, token->begin, length);
    if (!meant)
        return expected(cursor, what);
    return report_at(cursor, token->begin,
                     "expected %s, found '%.*s'; did you mean %s?", what,
                     length < 40 ? (int)length : 40, token->begin, meant);
}
