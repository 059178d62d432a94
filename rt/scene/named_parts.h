/* named_parts.h - the named parts of a scene, and their materials.
 *
 * A statement of the scene file adds an object to the world. The name of an object is
 * the name of its #declare; its material is the name of its texture. Objects with the
 * same name and material are one part. An object without a name is named after its
 * line.
 */
#ifndef RT_NAMED_PARTS_H
#define RT_NAMED_PARTS_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

struct named_part {
    const char *name;
    const char *material; /* NULL: its texture has no name */
    bool mixed;           /* it has several textures */
    bool endless;         /* it is unbounded (rt/mass/bodies.h) */
    bool left_out;        /* it is not selected */
};

struct named_parts {
    size_t count;
    struct named_part *list; /* in the order of each part's first object */
    size_t *part_of;         /* index of the part of each object */
    struct arena kept;
};

/* Collects the parts of a scene. The scene must outlive them. Returns false if out of
 * memory. */
bool named_parts_find(const struct scene *scene, struct named_parts *parts);
void named_parts_free(struct named_parts *parts);

/* Checks that the name is the name of a part or a material. If it is not, sets an error
 * that lists the existing names, and returns false. */
bool named_parts_check(const struct named_parts *parts, const char *name,
                       c205_error *error);
/* Selects the parts with these names or with materials of these names. Without names it
 * selects all bounded parts. Returns false if a name does not exist. */
bool named_parts_choose(struct named_parts *parts, const char *const *names,
                        size_t count, c205_error *error);

/* Appends a name to the message of an error. A list that is too long for the message
 * ends in dots. */
void named_parts_add_name(c205_error *error, const char *separator, const char *name);

#endif
