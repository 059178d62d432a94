/* symbol.h - names and their values.
 *
 * Level 0 holds what #declare makes; level n what #local makes in the n-th
 * open frame, the main file being the first.  A symbol may stand for another,
 * or for an element of its array: so a macro's parameters stand for the names
 * that the macro is called with.
 */
#ifndef RT_SCENE_SYMBOL_H
#define RT_SCENE_SYMBOL_H

#include "rt/scene/language/value.h"

enum { SYMBOL_BUCKETS = 1024 };
struct declared_names {
    struct declared_name *buckets[SYMBOL_BUCKETS];
    struct declared_name *locals; /* above level 0, the innermost level first */
};

/* The symbol of the innermost level that has the name, or NULL. */
struct declared_name *symbols_find(const struct declared_names *symbols,
                                   const char *name, size_t length);
/* .. of that level. */
struct declared_name *symbols_find_at(const struct declared_names *symbols,
                                      size_t level, const char *name, size_t length);
/* What a symbol stands for: itself, or what it refers to. */
struct reference reference_to(struct declared_name *symbol);
/* NULL: an element that is not set, or that is not there any more. */
const struct scene_value *reference_value(const struct reference *reference);

/* These take the value over in any case, and return why they failed, or NULL.
 * A new symbol of a level above 0 must be of the innermost level. */
const char *reference_assign(const struct reference *reference,
                             struct scene_value *value);
const char *symbols_add(struct declared_names *symbols, size_t level, const char *name,
                        size_t length, struct scene_value *value);
/* A new symbol that stands for another. */
const char *symbols_refer(struct declared_names *symbols, size_t level,
                          const char *name, size_t length,
                          const struct reference *reference);

/* A symbol lives on, without its name, as long as it is held. */
void symbol_hold(struct declared_name *symbol);
/* False: nobody held it any more. */
bool symbol_release(struct declared_name *symbol);
/* Its name, which is not ended. */
const char *symbol_name(const struct declared_name *symbol, size_t *length);
/* Each of level 0, in no order. */
void symbols_walk(const struct declared_names *symbols,
                  void (*visit)(void *context, const char *name, size_t length,
                                const struct scene_value *value),
                  void *context);
/* Forget the innermost symbol of a name; false: there is none. */
bool symbols_remove(struct declared_names *symbols, const char *name, size_t length);
/* Forget all names of the levels above. */
void symbols_leave(struct declared_names *symbols, size_t level);
void symbols_free(struct declared_names *symbols);

#endif
