/* scene_internal.h - the named parts of a scene, and their materials.
 *
 * An object is put into the world by a statement of the scene file. Objects with the
 * same name (that of their #declare) and the same material (the name of their texture)
 * are one part. An object without a name is named after its line.
 */
#ifndef RT_SCENE_INTERNAL_H
#define RT_SCENE_INTERNAL_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

struct named_part {
    const char *name;
    const char *material; /* NULL: its texture has no name */
    bool mixed;           /* it has several textures */
    bool endless;         /* it is unbounded, as rt/mass/bodies.h finds */
    bool left_out;        /* it was not selected */
};

struct named_parts {
    size_t count;
    struct named_part *list; /* in the order of their first objects */
    size_t *part_of;         /* index of the part, for each object of the scene */
    struct arena kept;
};

/* Collects the parts of a scene, which must outlive them. Fails without memory. */
bool named_parts_find(const struct scene *scene, struct named_parts *parts);
void named_parts_free(struct named_parts *parts);

/* Fails if the name is not that of a part or a material; the error lists those that
 * exist. */
bool named_parts_check(const struct named_parts *parts, const char *name,
                       c205_error *error);
/* Selects the parts with these names, or whose materials have them; without names all
 * bounded parts. Fails if a name does not exist. */
bool named_parts_choose(struct named_parts *parts, const char *const *names,
                        size_t count, c205_error *error);

/* Appends a name to the message of an error. A list that is too long for the message
 * ends in dots. */
void named_parts_add_name(c205_error *error, const char *separator, const char *name);

#endif
