/* symbol.h - the symbol table: names and their values.
 *
 * Level 0 contains the names of #declare. Level n contains the names of #local in the
 * n-th open frame; the main file is the first frame. A symbol may be an alias of
 * another symbol, or of an element of another symbol's array. The parameters of a macro
 * are aliases of the names that are passed by reference.
 */
#ifndef RT_SCENE_SYMBOL_H
#define RT_SCENE_SYMBOL_H

#include "rt/scene/language/value.h"

enum { SYMBOL_BUCKETS = 1024 };
struct declared_names {
    struct declared_name *buckets[SYMBOL_BUCKETS];
    struct declared_name *locals; /* symbols of levels above 0; the innermost level is
                                   * the first */
};

/* Returns the innermost symbol with this name, or NULL. */
struct declared_name *symbols_find(const struct declared_names *symbols,
                                   const char *name, size_t length);
/* Returns the symbol with this name at this level, or NULL. */
struct declared_name *symbols_find_at(const struct declared_names *symbols,
                                      size_t level, const char *name, size_t length);
/* Returns a reference to the symbol, or to the target of an alias. */
struct reference reference_to(struct declared_name *symbol);
/* Returns the value of a reference, or NULL if the element is not set or no longer
 * exists. */
const struct scene_value *reference_value(const struct reference *reference);

/* These functions take ownership of the value even after a failure. They return the
 * reason of the failure, or NULL. A new symbol at a level above 0 must be at the
 * innermost level. */
const char *reference_assign(const struct reference *reference,
                             struct scene_value *value);
const char *symbols_add(struct declared_names *symbols, size_t level, const char *name,
                        size_t length, struct scene_value *value);
/* Assigns a value to a symbol, or to the target of an alias. If the symbol is NULL, a
 * symbol with the name of the token is added at the level. */
const char *symbols_assign(struct declared_names *symbols, struct declared_name *symbol,
                           size_t level, const struct scene_token *name,
                           struct scene_value *value);
/* Adds a name that is an alias of a symbol or of an element of an array. */
const char *symbols_refer(struct declared_names *symbols, size_t level,
                          const char *name, size_t length,
                          const struct reference *reference);

/* Increments the reference count of a symbol, so that the symbol outlives its removal
 * from the table. */
void symbol_hold(struct declared_name *symbol); /* a NULL symbol has no effect, here and
                                                 * in the functions below */
/* Decrements the reference count of a symbol. Returns false if this was the last
 * reference. */
bool symbol_release(struct declared_name *symbol);
/* Returns the name of a symbol, which has no NUL at its end. */
const char *symbol_name(const struct declared_name *symbol, size_t *length);
/* Calls `visit` for each symbol of level 0 that is not an alias, in an unspecified
 * order. */
void symbols_walk(const struct declared_names *symbols,
                  void (*visit)(void *context, const char *name, size_t length,
                                const struct scene_value *value),
                  void *context);
/* Removes the innermost symbol with this name. Returns false if there is none. */
bool symbols_remove(struct declared_names *symbols, const char *name, size_t length);
/* Removes all symbols whose level is above this level. */
void symbols_leave(struct declared_names *symbols, size_t level);
void symbols_free(struct declared_names *symbols);

#endif
