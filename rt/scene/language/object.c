/* object.c - solids, their primitives, and lights under construction. */
#include "rt/scene/language/object.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

void pigment_move(struct pigment *pigment, const struct placement *step)
{
    pigment->to_local = transform_then(&step->to_local, &pigment->to_local);
}

static bool add_part(struct scene_object *object,
                     const struct scene_part *part)
{
    struct scene_part *parts = array_grow(object->parts, object->part_count,
                                          sizeof *parts);

    if (!parts)
        return false;
    object->parts = parts;
    parts[object->part_count++] = *part;
    return true;
}

static bool add_branch(struct scene_object *object,
                       enum tree_operation operation, size_t size)
{
    struct branch *branches = array_grow(object->branches,
                                         object->branch_count,
                                         sizeof *branches);

    if (!branches)
        return false;
    object->branches = branches;
    branches[object->branch_count++] = (struct branch){ operation, size };
    return true;
}

bool object_add_primitive(struct scene_object *object,
                          const struct primitive *primitive)
{
    struct scene_part part;

    memset(&part, 0, sizeof part);
    part.primitive = *primitive;
    return add_part(object, &part) && add_branch(object, TREE_LEAF, 1);
}

bool object_add_light(struct scene_object *object, const struct light *light)
{
    struct light *lights = array_grow(object->lights, object->light_count,
                                      sizeof *lights);

    if (!lights)
        return false;
    object->lights = lights;
    lights[object->light_count++] = *light;
    return true;
}

static void inherit(struct scene_part *part,
                    const struct scene_object *object)
{
    if (!part->textured && object->textured) {
        part->primitive.pigment = object->texture.pigment;
        part->primitive.finish = object->texture.finish;
        part->textured = true;
    }
    if (!part->filled && object->filled) {
        part->primitive.ior = object->ior;
        part->filled = true;
    }
}

bool object_add(struct scene_object *object, const struct scene_object *child)
{
    for (size_t i = 0; i < child->part_count; i++) {
        struct scene_part part = child->parts[i];
        inherit(&part, child);
        if (!add_part(object, &part))
            return false;
    }
    for (size_t i = 0; i < child->branch_count; i++)
        if (!add_branch(object, child->branches[i].operation,
                        child->branches[i].size))
            return false;
    for (size_t i = 0; i < child->light_count; i++)
        if (!object_add_light(object, &child->lights[i]))
            return false;
    return true;
}

/* A new root over all branches. */
static bool add_root(struct scene_object *object,
                     enum tree_operation operation)
{
    size_t count = object->branch_count;

    if (!add_branch(object, operation, 1))
        return false;
    memmove(object->branches + 1, object->branches,
            count * sizeof *object->branches);
    object->branches[0] = (struct branch){ operation, count + 1 };
    return true;
}

static void remove_root(struct scene_object *object)
{
    object->branch_count--;
    memmove(object->branches, object->branches + 1,
            object->branch_count * sizeof *object->branches);
}

bool object_join(struct scene_object *object)
{
    bool meet = object->joining == JOIN_INTERSECTION
                || object->joining == JOIN_DIFFERENCE;

    return object->branch_count == 0
           || object->branches[0].size == object->branch_count
           || add_root(object, meet ? TREE_AND : TREE_OR);
}

bool object_invert(struct scene_object *object)
{
    if (!object_join(object))
        return false;
    for (size_t i = 0; i < object->part_count; i++)
        object->parts[i].primitive.inverted ^= true;
    if (object->branch_count == 0)
        return true;
    if (object->branches[0].operation != TREE_NOT)
        return add_root(object, TREE_NOT);
    remove_root(object);
    return true;
}

/* As in POV-Ray it counts on the whole of a solid only. */
static void forget_no_shadow(struct scene_object *object)
{
    for (size_t i = 0; i < object->part_count; i++)
        object->parts[i].primitive.no_shadow = false;
}

bool object_add_child(struct scene_object *object, struct scene_object *child)
{
    bool first = object->child_count++ == 0;

    if (object->joining == JOIN_DIFFERENCE && !first) {
        if (!object_invert(child))
            return false;
    } else if (object->joining != JOIN_APART && !object_join(child)) {
        return false;
    }
    if (object->joining != JOIN_APART)
        forget_no_shadow(child);
    return object_add(object, child);
}

bool object_copy(struct scene_object *copy, const struct scene_object *object)
{
    struct scene_object bare = *object;

    bare.textured = bare.filled = false;
    copy->textured = object->textured;
    copy->texture = object->texture;
    copy->filled = object->filled;
    copy->ior = object->ior;
    copy->is_light = object->is_light;
    return object_add(copy, &bare);
}

static void part_move(struct scene_part *part, const struct placement *step)
{
    struct primitive *primitive = &part->primitive;

    primitive->to_world = transform_then(&primitive->to_world,
                                         &step->to_world);
    primitive->to_local = transform_then(&step->to_local,
                                         &primitive->to_local);
    if (part->textured)
        pigment_move(&primitive->pigment, step);
}

void object_move(struct scene_object *object, const struct placement *step)
{
    for (size_t i = 0; i < object->part_count; i++)
        part_move(&object->parts[i], step);
    for (size_t i = 0; i < object->light_count; i++)
        transform_point(&step->to_world, object->lights[i].position);
    if (object->textured)
        pigment_move(&object->texture.pigment, step);
}

void scene_object_free(struct scene_object *object)
{
    free(object->parts);
    free(object->branches);
    free(object->lights);
    memset(object, 0, sizeof *object);
}
