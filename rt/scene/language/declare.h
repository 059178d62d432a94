/* declare.h - names get values: #declare, #local, #undef. */
#ifndef RT_SCENE_DECLARE_H
#define RT_SCENE_DECLARE_H

#include "rt/scene/language/block.h"

item_reader read_declare; /* its detail: whether it is #local */
item_reader read_undef;

/* Anything that a name may stand for. */
bool value_read(struct reader *reader, struct scene_value *value);

/* A word of the language: it cannot be a name. */
bool is_reserved(const struct scene_token *token);
/* Whether the token, which is `name`, can be declared. */
bool name_expected(struct reader *reader, const struct scene_token *name);

#endif
