/* symbol.c - the symbol table, a hash table with chains, and the rules of
 * redefinition. */
#include "asm/text/assembler.h"

#include "asm/object/syntax.h"
#include "base/fnv_hash.h"

#include <stdio.h>
#include <string.h>

static size_t bucket_of(const char *name, size_t length)
{
    return hash_bytes(HASH_START, (const unsigned char *)name, length) % SYMBOL_BUCKETS;
}

struct symbol *symbol_find(const struct assembler *assembler, const char *name,
                           size_t length)
{
    struct symbol *symbol;
    symbol = assembler->symbols.buckets[bucket_of(name, length)];
    while (symbol
           && (symbol->length != length || memcmp(symbol->name, name, length) != 0))
        symbol = symbol->next;
    return symbol;
}

/* Returns the symbol of a name, and adds it if it is new. Symbols are neither moved nor
 * removed during an assembly, so pointers to them remain valid. Two names are equal
 * exactly if their symbols are the same. */
struct symbol *symbol_intern(struct assembler *assembler, const char *name,
                             size_t length)
{
    struct symbol **bucket = &assembler->symbols.buckets[bucket_of(name, length)];
    struct symbol *symbol = symbol_find(assembler, name, length);
    if (symbol)
        return symbol;
    symbol = arena_take(assembler->arena, sizeof *symbol);
    if (!symbol)
        return NULL;
    symbol->name = arena_text(assembler->arena, name, length);
    if (!symbol->name)
        return NULL;
    symbol->length = length;
    symbol->next = *bucket;
    *bucket = symbol;
    assembler->symbols.count++;
    return symbol;
}

static bool is_register(enum symbol_kind kind)
{
    return kind == SYMBOL_REGISTER || kind == SYMBOL_HALF_REGISTER;
}

static bool is_same(const struct symbol *symbol, enum symbol_kind kind,
                    struct value value)
{
    if (is_register(kind)) /* a register may be renamed at any point */
        return is_register(symbol->kind);
    return kind == SYMBOL_CONSTANT && symbol->kind == kind
           && symbol->value.kind == value.kind && symbol->value.bits == value.bits;
}

static const char defined_by_command[] = "'%s' is already defined by the command";

/* Defines a symbol. A name has one meaning in a program, with two exceptions. Each
 * routine may declare a register name again. A constant may be defined again with the
 * same value. */
bool symbol_define(struct assembler *assembler, const struct line *line, const char *at,
                   struct symbol *symbol, enum symbol_kind kind, struct value value)
{
    if (!symbol)
        return false;
    if (is_register_name(symbol->name, symbol->length))
        return report(assembler, line, at, "'%s' is a register", symbol->name);
    if (symbol->kind != SYMBOL_UNDEFINED && !is_same(symbol, kind, value)) {
        if (!symbol->defined)
            return report(assembler, line, at, defined_by_command, symbol->name);
        return report(assembler, line, at, "'%s' is already defined, in %s:%zu",
                      symbol->name, symbol->defined->file, symbol->defined->number);
    }
    symbol->kind = kind;
    symbol->value = value;
    symbol->defined = line;
    return true;
}

bool asm_is_redefined(const struct diagnostic *diagnostic, const char *name)
{
    char text[160];
    snprintf(text, sizeof text, defined_by_command, name);
    return strcmp(diagnostic->message, text) == 0;
}
