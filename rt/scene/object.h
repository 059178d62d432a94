/* object.h - an object of a scene file while it is read.
 *
 * A union is a list of primitives from the start: what a union's transform
 * does to its children is what it does to each primitive.  Only the texture
 * waits: an object's own texture goes to those parts that have none, and only
 * when the object is part of another, since `object { NAME texture {...} }`
 * may still change it.
 */
#ifndef RT_SCENE_OBJECT_H
#define RT_SCENE_OBJECT_H

#include "rt/scene/transform.h"

struct texture {
    struct pigment pigment;
    struct finish finish;
};

struct part {
    struct primitive primitive; /* pigment and finish once textured */
    bool textured;
};

struct object {
    size_t part_count, part_room;
    struct part *parts;
    size_t light_count, light_room;
    struct light *lights;
    bool textured;
    struct texture texture;
};

void pigment_move(struct pigment *pigment, const struct placement *step);

/* Those that return false are out of memory. */
bool object_add_primitive(struct object *object,
                          const struct primitive *primitive);
bool object_add_light(struct object *object, const struct light *light);
/* Add the parts of another; those without a texture get its own, if any. */
bool object_add(struct object *object, const struct object *child);
bool object_copy(struct object *copy, const struct object *object);
void object_move(struct object *object, const struct placement *step);
void scene_object_free(struct object *object);

/* Room for one more element in an array that grows by doubling. */
bool array_room(void **items, size_t *room, size_t count, size_t size);

#endif
