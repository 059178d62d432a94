/* object.h - an object of a scene file while it is read.
 *
 * An object is a row of solids, each a tree in preorder of which the parts, in
 * their order, are the leaves.  A union is its children's solids from the
 * start: what its transform does to its children is what it does to each
 * primitive.  Only texture, interior and the rays that do not see it wait: an
 * object's own go to its parts, texture and interior to those that have none, and
 * only when the object is part of another, since `object { NAME texture {...} }`
 * may still change them.
 */
#ifndef RT_SCENE_OBJECT_H
#define RT_SCENE_OBJECT_H

#include "rt/scene/transform.h"
#include "rt/shapes/primitive.h"

struct texture {
    const char *name; /* of the #declare that it comes from, or NULL */
    struct pigment pigment;
    struct bumps bumps;
    struct finish finish;
};

struct scene_part {
    struct primitive primitive; /* pigment, bumps and finish once textured,
                                   ior and interior once filled */
    bool textured, filled;
    const char *material;              /* the texture's name, once textured */
    const struct bicubic_patch *patch; /* a mesh is made of it, in the world */
    bool smooth_field;                 /* a mesh whose normals are settled there */
    bool field; /* a mesh, that gets a body if its inside matters */
};

/* How the children of an object belong together: a union's stay apart. */
enum joining { JOIN_APART, JOIN_MERGE, JOIN_INTERSECTION, JOIN_DIFFERENCE };

struct branch {
    enum tree_operation operation;
    size_t size; /* branches from this one to the last below it */
    bool clips;  /* an intersection with what clips its first child */
};

struct scene_object {
    size_t part_count;
    struct scene_part *parts;
    size_t branch_count;
    struct branch *branches;
    size_t light_count;
    struct light *lights;
    bool is_light; /* one, perhaps with what it looks like */
    enum joining joining;
    size_t child_count; /* lights counted */
    bool textured;
    const char *name; /* its own, of the #declare that it comes from, or NULL */
    bool named;       /* the name is its own (part.h) */
    struct texture texture;
    bool filled;
    double ior;
    size_t interior;
    unsigned hidden_from; /* as a primitive's */
};

void pigment_move(struct pigment *pigment, const struct placement *step);
void texture_move(struct texture *texture, const struct placement *step);

/* Those that return false are out of memory. */
bool object_add_primitive(struct scene_object *object,
                          const struct primitive *primitive);
bool object_add_light(struct scene_object *object, const struct light *light);
/* Add the solids of another; parts without texture or interior get its own, if
 * any, and all are hidden from the rays that it is hidden from. */
bool object_add(struct scene_object *object, const struct scene_object *child);
/* The same as the object's joining says: one solid of the child's, or what is
 * outside of it. */
bool object_add_child(struct scene_object *object, struct scene_object *child);
/* The rays that do not see some of its parts. */
unsigned object_hidden_from(const struct scene_object *object);
/* All rays see all parts that are not hidden by a clip. */
void object_show(struct scene_object *object);
/* All solids become one. */
bool object_join(struct scene_object *object);
/* The same, and what was outside becomes inside; what clips stays. */
bool object_invert(struct scene_object *object);
/* Each solid is cut by all those of another, which are not seen. */
bool object_clip(struct scene_object *object, const struct scene_object *clip);
/* Takes out what is empty, and what that decides of the solids. */
void object_prune(struct scene_object *object);
bool object_copy(struct scene_object *copy, const struct scene_object *object);
/* Its interiors are others, numbered behind last, which becomes the greatest. */
bool object_renumber(struct scene_object *object, size_t *last);
void object_move(struct scene_object *object, const struct placement *step);
void scene_object_free(struct scene_object *object);

#endif
