/* declare.h - names get values: #declare, #local, #undef. */
#ifndef RT_SCENE_DECLARE_H
#define RT_SCENE_DECLARE_H

#include "rt/scene/language/block.h"

item_reader read_declare; /* its detail: whether it is #local */
item_reader read_undef;

/* A name, or an element: what is to get a value. */
struct target {
    struct scene_token name;
    bool is_element, local;
    size_t level; /* where the directive stands */
};
/* The next token begins it; what is behind it is left by reader_step. */
bool target_read(struct reader *reader, struct target *target);
/* As in POV-Ray, #declare changes the innermost value of a name that there
 * is, and #local one of its own level.  It takes the value over in any
 * case, and returns why it failed, or NULL. */
const char *target_assign(struct reader *reader, const struct target *target,
                          struct scene_value *value);

/* Anything that a name may stand for. */
bool value_read(struct reader *reader, struct scene_value *value);

/* A word of the language: it cannot be a name. */
bool is_reserved(const struct scene_token *token);
/* Whether the token, which is `name`, can be declared. */
bool name_expected(struct reader *reader, const struct scene_token *name);

#endif
