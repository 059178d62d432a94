/* scene_internal.h - the parts of a scene, and what they are made of.
 *
 * What a statement of the scene's file puts into the world is an object.  Objects of
 * one name, that of the #declare that they come from, and of one material, the name of
 * their texture, are one part; without a name they are called by their line.
 */
#ifndef RT_SCENE_INTERNAL_H
#define RT_SCENE_INTERNAL_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

struct named_part {
    const char *name;
    const char *material; /* NULL: its texture has no name */
    bool mixed;           /* .. it has several textures */
    bool endless;         /* it reaches for ever: rt/mass/bodies.h finds that */
    bool left_out;        /* nobody asks for it */
};

struct named_parts {
    size_t count;
    struct named_part *list; /* in the order of their first objects */
    size_t *part_of;         /* of each of the scene's objects */
    struct arena kept;
};

/* The scene must outlive the parts.  False: no memory. */
bool named_parts_find(const struct scene *scene, struct named_parts *parts);
void named_parts_free(struct named_parts *parts);

/* False: the name is not that of a part or a material; the error lists those that there
 * are. */
bool named_parts_check(const struct named_parts *parts, const char *name,
                       c205_error *error);
/* These names alone, of parts or materials; without names all but those that are
 * endless.  False: one is not there. */
bool named_parts_choose(struct named_parts *parts, const char *const *names,
                        size_t count, c205_error *error);

/* Behind an error's message; lists that are too long for it end in dots. */
void named_parts_add_name(c205_error *error, const char *separator, const char *name);

#endif
