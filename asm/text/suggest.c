/* suggest.c - suggests a known name for a misspelt name. */
#include "asm/text/suggest.h"

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
            spelling_try(&nearest, c205_insns[i].mnemonic);
    for (size_t i = 0; kind == SUGGEST_DIRECTIVE && asm_directive(i); i++)
        spelling_try(&nearest, asm_directive(i));
    try_symbols(assembler, kind, &nearest);
    return nearest.name;
}

bool expected_name(struct cursor *cursor, const char *what, enum suggestion kind)
{
    const struct token *token = &cursor->token;
    size_t length = (size_t)(token->end - token->begin);
    const char *meant = NULL;
    if (token->kind == TOKEN_NAME || token->kind == TOKEN_DIRECTIVE)
        meant = suggest(cursor->assembler, kind, token->begin, length);
    if (!meant)
        return expected(cursor, what);
    return report_at(cursor, token->begin,
                     "expected %s, found '%.*s'; did you mean %s?", what,
                     length < 40 ? (int)length : 40, token->begin, meant);
}
