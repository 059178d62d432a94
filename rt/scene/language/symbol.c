/* symbol.c - the symbol table, which is a hash table with chains. */
#include "rt/scene/language/symbol.h"
#include "vm/error.h"

#include "base/fnv_hash.h"

#include <stdlib.h>
#include <string.h>

struct declared_name {
    struct declared_name *next;       /* next symbol in the bucket; its level is not
                                       * higher */
    struct declared_name *next_local; /* next symbol in the list of locals */
    size_t level, held;
    struct scene_value value;
    struct reference target; /* target of an alias, which is held; without a symbol this
                              * is not an alias */
    size_t length;
    char name[]; /* without a NUL at its end */
};

static size_t bucket_of(const char *name, size_t length)
{
    return hash_bytes(HASH_START, (const unsigned char *)name, length) % SYMBOL_BUCKETS;
}

static bool has_name(const struct declared_name *symbol, const char *name,
                     size_t length)
{
    return symbol->length == length && !memcmp(symbol->name, name, length);
}

struct declared_name *symbols_find(const struct declared_names *symbols,
                                   const char *name, size_t length)
{
    struct declared_name *symbol = symbols->buckets[bucket_of(name, length)];
    while (symbol && !has_name(symbol, name, length))
        symbol = symbol->next;
    return symbol;
}

struct declared_name *symbols_find_at(const struct declared_names *symbols,
                                      size_t level, const char *name, size_t length)
{
    struct declared_name *symbol = symbols->buckets[bucket_of(name, length)];
    while (symbol && !(symbol->level == level && has_name(symbol, name, length)))
        symbol = symbol->next;
    return symbol;
}

/* Follows the indices of nested arrays from a value. Returns NULL if an element is not
 * set, or if it no longer exists. */
static struct scene_value **walk(struct scene_value **value, const size_t *element,
                                 size_t hops)
{
    for (size_t i = 0; i < hops && value && *value; i++) {
        struct array *array = (*value)->is.array;
        value = (*value)->kind == VALUE_ARRAY && element[i] < array->count
                    ? &array->cell[element[i]]
                    : NULL;
    }
    return value;
}

const struct scene_value *reference_value(const struct reference *reference)
{
    struct scene_value *own = &reference->symbol->value;
    struct scene_value **found = walk(&own, reference->element, reference->hops);
    return found ? *found : NULL;
}

struct reference reference_to(struct declared_name *symbol)
{
    struct reference reference = { symbol, 0, { 0 } };
    return symbol->target.symbol ? symbol->target : reference;
}

void symbol_hold(struct declared_name *symbol)
{
    if (symbol)
        symbol->held++;
}

bool symbol_release(struct declared_name *symbol)
{
    if (!symbol)
        return false;
    if (--symbol->held)
        return true;
    symbol_release(symbol->target.symbol);
    value_free(&symbol->value);
    free(symbol);
    return false;
}

/* Adds a symbol to the table. A bucket is sorted by descending level, so that a lookup
 * finds the innermost symbol. Returns NULL if out of memory. */
static struct declared_name *add(struct declared_names *symbols, size_t level,
                                 const char *name, size_t length)
{
    struct declared_name **bucket = &symbols->buckets[bucket_of(name, length)];
    struct declared_name *symbol = calloc(1, sizeof *symbol + length);
    if (!symbol)
        return NULL;
    symbol->level = level;
    symbol->held = 1;
    symbol->length = length;
    memcpy(symbol->name, name, length);
    while (*bucket && (*bucket)->level > level)
        bucket = &(*bucket)->next;
    symbol->next = *bucket;
    *bucket = symbol;
    if (level) {
        symbol->next_local = symbols->locals;
        symbols->locals = symbol;
    }
    return symbol;
}

const char *symbols_add(struct declared_names *symbols, size_t level, const char *name,
                        size_t length, struct scene_value *value)
{
    struct declared_name *symbol = add(symbols, level, name, length);
    if (!symbol) {
        value_free(value);
        return no_memory;
    }
    symbol->value = *value;
    return NULL;
}

static const char *assign_element(const struct reference *reference,
                                  struct scene_value *value)
{
    struct scene_value *own = &reference->symbol->value;
    size_t last = reference->hops - 1;
    struct scene_value **found = walk(&own, reference->element, last);
    struct array *array = found && *found && (*found)->kind == VALUE_ARRAY
                              ? (*found)->is.array
                              : NULL;
    const char *fault = NULL;
    if (!array || reference->element[last] >= array->count)
        fault = "the array of this element no longer exists";
    else if (value->kind == VALUE_ARRAY
             && reference->hops + array_nesting(value->is.array) > MAX_ARRAY_NESTING)
        fault = "too many nested arrays: at most " LIMIT_TEXT(MAX_ARRAY_NESTING);
    if (!fault)
        return array_set(array, reference->element[last], value);
    value_free(value);
    return fault;
}

const char *reference_assign(const struct reference *reference,
                             struct scene_value *value)
{
    struct declared_name *symbol = reference->symbol;
    if (reference->hops)
        return assign_element(reference, value);
    value_free(&symbol->value);
    symbol->value = *value;
    return NULL;
}

const char *symbols_assign(struct declared_names *symbols, struct declared_name *symbol,
                           size_t level, const struct scene_token *name,
                           struct scene_value *value)
{
    struct reference reference;
    if (!symbol)
        return symbols_add(symbols, level, name->text, name->length, value);
    reference = reference_to(symbol);
    return reference_assign(&reference, value);
}

const char *symbols_refer(struct declared_names *symbols, size_t level,
                          const char *name, size_t length,
                          const struct reference *reference)
{
    struct declared_name *symbol = add(symbols, level, name, length);
    if (!symbol)
        return no_memory;
    symbol->target = *reference;
    symbol_hold(reference->symbol);
    return NULL;
}

/* Removes a symbol from its bucket. The caller removes it from the list of locals. */
static void unlink_symbol(struct declared_names *symbols, struct declared_name *symbol)
{
    struct declared_name *
        *link = &symbols->buckets[bucket_of(symbol->name, symbol->length)];
    while (*link != symbol)
        link = &(*link)->next;
    *link = symbol->next;
    symbol_release(symbol);
}

bool symbols_remove(struct declared_names *symbols, const char *name, size_t length)
{
    struct declared_name *symbol = symbols_find(symbols, name, length);
    struct declared_name **link = &symbols->locals;
    if (!symbol)
        return false;
    while (*link && *link != symbol)
        link = &(*link)->next_local;
    if (*link)
        *link = symbol->next_local;
    unlink_symbol(symbols, symbol);
    return true;
}

void symbols_leave(struct declared_names *symbols, size_t level)
{
    while (symbols->locals && symbols->locals->level > level) {
        struct declared_name *symbol = symbols->locals;
        symbols->locals = symbol->next_local;
        unlink_symbol(symbols, symbol);
    }
}

void symbols_free(struct declared_names *symbols)
{
    symbols_leave(symbols, 0);
    for (size_t i = 0; i < SYMBOL_BUCKETS; i++)
        while (symbols->buckets[i])
            unlink_symbol(symbols, symbols->buckets[i]);
}

void symbols_walk(const struct declared_names *symbols,
                  void (*visit)(void *context, const char *name, size_t length,
                                const struct scene_value *value),
                  void *context)
{
    for (size_t i = 0; i < SYMBOL_BUCKETS; i++)
        for (const struct declared_name *symbol = symbols->buckets[i]; symbol;
             symbol = symbol->next)
            if (symbol->level == 0 && !symbol->target.symbol)
                visit(context, symbol->name, symbol->length, &symbol->value);
}

const char *symbol_name(const struct declared_name *symbol, size_t *length)
{
    *length = symbol->length;
    return symbol->name;
}
