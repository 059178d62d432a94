/* declare.h - executes #declare, #local and #undef, which assign values to names. */
#ifndef RT_SCENE_DECLARE_H
#define RT_SCENE_DECLARE_H

#include "rt/scene/language/scene_block.h"

item_reader read_declare; /* detail: true for #local */
item_reader read_undef;

/* The target of an assignment: a name, or an element of an array. */
struct target {
    struct scene_token name;
    bool is_element, local;
    size_t level; /* level of the frame that contains the directive */
};
/* Reads the target of an assignment. Uses reader_step to advance past its last
 * token. */
bool target_read(struct reader *reader, struct target *target);
/* Assigns a value. As in POV-Ray, #declare changes the innermost symbol with the name,
 * and #local changes the symbol at its own level. Takes ownership of the value even
 * after a failure. Returns the reason of the failure, or NULL. */
const char *target_assign(struct reader *reader, const struct target *target,
                          struct scene_value *value);

/* Reads a value of any kind that a name can have. */
bool value_read(struct reader *reader, struct scene_value *value);

/* Returns true if the token is a keyword of the language, which cannot be a name. */
bool is_reserved(const struct scene_token *token);
/* Reports an error if the token `name` cannot be declared. */
bool name_expected(struct reader *reader, const struct scene_token *name);

#endif
