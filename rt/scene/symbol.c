/* symbol.c - the table of declared names. */
#include "rt/scene/value.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct symbol {
    struct symbol *next;
    size_t level;
    struct value value;
    size_t length;
    char name[]; /* not ended */
};

/* FNV-1a, 32 bits. */
static size_t bucket_of(const char *name, size_t length)
{
    uint32_t hash = 2166136261u;

    for (size_t i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)name[i]) * 16777619u;
    return hash % SYMBOL_BUCKETS;
}

static bool has_name(const struct symbol *symbol, const char *name,
                     size_t length)
{
    return symbol->length == length && !memcmp(symbol->name, name, length);
}

static void symbol_free(struct symbol *symbol)
{
    value_free(&symbol->value);
    free(symbol);
}

/* Where the innermost symbol of the name hangs; a link to NULL if none. */
static struct symbol **innermost(struct symbol **link, const char *name,
                                 size_t length)
{
    struct symbol **best = NULL;

    for (; *link; link = &(*link)->next)
        if (has_name(*link, name, length)
            && (!best || (*link)->level > (*best)->level))
            best = link;
    return best ? best : link;
}

const struct value *symbols_find(const struct symbols *symbols,
                                 const char *name, size_t length)
{
    struct symbol *first = symbols->buckets[bucket_of(name, length)];
    struct symbol *found = *innermost(&first, name, length);

    return found ? &found->value : NULL;
}

static struct symbol *find_at(struct symbol *symbol, size_t level,
                              const char *name, size_t length)
{
    while (symbol
           && !(symbol->level == level && has_name(symbol, name, length)))
        symbol = symbol->next;
    return symbol;
}

bool symbols_set(struct symbols *symbols, size_t level, const char *name,
                 size_t length, struct value *value)
{
    struct symbol **bucket = &symbols->buckets[bucket_of(name, length)];
    struct symbol *symbol = find_at(*bucket, level, name, length);

    if (symbol) {
        value_free(&symbol->value);
    } else {
        symbol = malloc(sizeof *symbol + length);
        if (!symbol) {
            value_free(value);
            return false;
        }
        symbol->level = level;
        symbol->length = length;
        memcpy(symbol->name, name, length);
        symbol->next = *bucket;
        *bucket = symbol;
    }
    symbol->value = *value;
    return true;
}

bool symbols_remove(struct symbols *symbols, const char *name, size_t length)
{
    struct symbol **bucket = &symbols->buckets[bucket_of(name, length)];
    struct symbol **link = innermost(bucket, name, length);
    struct symbol *symbol = *link;

    if (!symbol)
        return false;
    *link = symbol->next;
    symbol_free(symbol);
    return true;
}

static void leave(struct symbol **link, size_t level)
{
    while (*link) {
        struct symbol *symbol = *link;
        if (symbol->level > level) {
            *link = symbol->next;
            symbol_free(symbol);
        } else {
            link = &symbol->next;
        }
    }
}

void symbols_leave(struct symbols *symbols, size_t level)
{
    for (size_t i = 0; i < SYMBOL_BUCKETS; i++)
        leave(&symbols->buckets[i], level);
}

void symbols_free(struct symbols *symbols)
{
    for (size_t i = 0; i < SYMBOL_BUCKETS; i++)
        while (symbols->buckets[i]) {
            struct symbol *symbol = symbols->buckets[i];
            symbols->buckets[i] = symbol->next;
            symbol_free(symbol);
        }
}
