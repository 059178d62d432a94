/* scene_object.c - builds the solids, primitives and lights of an object. */
#include "rt/scene/language/scene_object.h"

#include "base/array.h"
#include "base/rank_index.h"

#include <stdlib.h>
#include <string.h>

void pigment_move(void *subject, const struct placement *step)
{
    struct pigment *pigment = subject;
    pigment->to_local = transform_then(&step->to_local, &pigment->to_local);
}

/* Transforms the bumps of a texture. As in POV-Ray, a transform that precedes the
 * normal in the text has no effect on it. */
static void bumps_move(struct bumps *bumps, const struct placement *step)
{
    if (bumps->list)
        bumps->to_local = transform_then(&step->to_local, &bumps->to_local);
}

void texture_move(void *subject, const struct placement *step)
{
    struct texture *texture = subject;
    pigment_move(&texture->pigment, step);
    bumps_move(&texture->bumps, step);
}

static bool add_part(struct scene_object *object, const struct scene_part *part)
{
    return array_add(&object->parts, &object->part_count, part, sizeof *part);
}

static bool add_branch(struct scene_object *object, enum tree_operation operation,
                       size_t size)
{
    struct branch branch = { operation, size, false };
    return array_add(&object->branches, &object->branch_count, &branch, sizeof branch);
}

/* add_branches appends branches of another object, add_parts appends the parts that are
 * their leaves. */
static bool add_branches(struct scene_object *object, const struct branch *branches,
                         size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!add_branch(object, branches[i].operation, branches[i].size))
            return false;
        object->branches[object->branch_count - 1].clips = branches[i].clips;
    }
    return true;
}

static bool add_parts(struct scene_object *object, const struct scene_part *parts,
                      size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!add_part(object, &parts[i]))
            return false;
    return true;
}

bool object_add_primitive(struct scene_object *object,
                          const struct primitive *primitive)
{
    struct scene_part part = { .primitive = *primitive };
    return add_part(object, &part) && add_branch(object, TREE_LEAF, 1);
}

bool object_add_light(struct scene_object *object, const struct light *light)
{
    return array_add(&object->lights, &object->light_count, light, sizeof *light);
}

static void inherit(struct scene_part *part, const struct scene_object *object)
{
    if (!part->textured && object->textured) {
        part->primitive.pigment = object->texture.pigment;
        part->primitive.bumps = object->texture.bumps;
        part->primitive.finish = object->texture.finish;
        part->material = object->texture.name;
        part->textured = true;
    }
    if (!part->filled && object->filled) {
        part->primitive.ior = object->ior;
        part->primitive.interior = object->interior;
        part->filled = true;
    }
    part->primitive.hidden_from |= object->hidden_from;
}

bool object_add(struct scene_object *object, const struct scene_object *child)
{
    for (size_t i = 0; i < child->part_count; i++) {
        struct scene_part part = child->parts[i];
        inherit(&part, child);
        if (!add_part(object, &part))
            return false;
    }
    if (!add_branches(object, child->branches, child->branch_count))
        return false;
    for (size_t i = 0; i < child->light_count; i++)
        if (!object_add_light(object, &child->lights[i]))
            return false;
    return true;
}

/* Inserts a root with an operation above all branches of an object's tree. */
static bool add_root(struct scene_object *object, enum tree_operation operation)
{
    size_t count = object->branch_count;
    if (!add_branch(object, operation, 1))
        return false;
    memmove(object->branches + 1, object->branches, count * sizeof *object->branches);
    object->branches[0] = (struct branch){ operation, count + 1, false };
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
    return object->branch_count == 0 || object->branches[0].size == object->branch_count
           || add_root(object, meet ? TREE_AND : TREE_OR);
}

static size_t count_leaves(const struct branch *branches, size_t count)
{
    size_t leaves = 0;
    for (size_t i = 0; i < count; i++)
        leaves += branches[i].operation == TREE_LEAF;
    return leaves;
}

static bool is_open_mesh(const struct scene_part *part)
{
    return part->primitive.kind == PRIMITIVE_MESH && !part->primitive.shape.mesh.solid
           && part->primitive.shape.mesh.body.count == 0;
}

static bool has_open_mesh(const struct scene_object *object)
{
    for (size_t i = 0; i < object->part_count; i++)
        if (is_open_mesh(&object->parts[i]))
            return true;
    return false;
}

static bool is_clipped(const struct scene_object *object)
{
    for (size_t i = 0; i < object->branch_count; i++)
        if (object->branches[i].clips)
            return true;
    return false;
}

/* The state while a tree with clipped solids is inverted: the part of the next leaf,
 * and the branches made so far. */
struct inverting {
    struct scene_object *object;
    size_t part;
    struct scene_object made;
};

static void invert_parts(struct inverting *inverting, size_t count)
{
    for (size_t i = 0; i < count; i++)
        inverting->object->parts[inverting->part++].primitive.inverted ^= true;
}

static bool invert_branch(struct inverting *inverting, size_t at);

/* Inverts the children of an intersection or a merge. An intersection becomes a merge,
 * and a merge an intersection. In a clipped solid only the first child is inverted; the
 * clipping objects are copied. */
static bool invert_children(struct inverting *inverting, size_t at)
{
    const struct branch *from = inverting->object->branches;
    struct branch root = from[at];
    size_t end = at + root.size, place = inverting->made.branch_count;
    if (!root.clips)
        root.operation = root.operation == TREE_AND ? TREE_OR : TREE_AND;
    if (!add_branches(&inverting->made, &root, 1) || !invert_branch(inverting, at + 1))
        return false;
    for (at += 1 + from[at + 1].size; at < end; at += from[at].size) {
        size_t leaves = count_leaves(&from[at], from[at].size);
        if (root.clips ? !add_branches(&inverting->made, &from[at], from[at].size)
                       : !invert_branch(inverting, at))
            return false;
        inverting->part += root.clips ? leaves : 0;
    }
    inverting->made.branches[place].size = inverting->made.branch_count - place;
    return true;
}

/* Inverts a branch by De Morgan's laws. As in POV-Ray, the clipping objects of a
 * clipped solid are not inverted, and a mesh without an inside does not change. */
static bool invert_branch(struct inverting *inverting, size_t at)
{
    const struct branch *from = &inverting->object->branches[at];
    struct scene_object *made = &inverting->made;
    switch (from->operation) {
    case TREE_LEAF:
        if (is_open_mesh(&inverting->object->parts[inverting->part]))
            return inverting->part++, add_branch(made, TREE_LEAF, 1);
        invert_parts(inverting, 1);
        return add_branch(made, TREE_NOT, 2) && add_branch(made, TREE_LEAF, 1);
    case TREE_NOT: /* the subtree of a complement has no clipping and no mesh without an
                      inside */
        invert_parts(inverting, count_leaves(from + 1, from->size - 1));
        return add_branches(made, from + 1, from->size - 1);
    case TREE_AND:
    case TREE_OR: break;
    }
    return invert_children(inverting, at);
}

static bool invert_clipped(struct scene_object *object)
{
    struct inverting inverting = { .object = object };
    bool done = invert_branch(&inverting, 0);
    free(done ? object->branches : inverting.made.branches);
    if (done) {
        object->branches = inverting.made.branches;
        object->branch_count = inverting.made.branch_count;
    }
    return done;
}

bool object_invert(struct scene_object *object)
{
    if (!object_join(object))
        return false;
    if (is_clipped(object) || has_open_mesh(object))
        return invert_clipped(object);
    for (size_t i = 0; i < object->part_count; i++)
        object->parts[i].primitive.inverted ^= true;
    if (object->branch_count == 0)
        return true;
    if (object->branches[0].operation != TREE_NOT)
        return add_root(object, TREE_NOT);
    remove_root(object);
    return true;
}

/* Appends a solid, which consists of branches and parts, and its clipping objects. */
static bool add_clipped(struct scene_object *object, const struct branch *branches,
                        size_t branch_count, const struct scene_part *parts,
                        size_t part_count, const struct scene_object *clip)
{
    if (!add_branch(object, TREE_AND, 1 + branch_count + clip->branch_count))
        return false;
    object->branches[object->branch_count - 1].clips = true;
    return add_branches(object, branches, branch_count)
           && add_parts(object, parts, part_count)
           && add_branches(object, clip->branches, clip->branch_count)
           && add_parts(object, clip->parts, clip->part_count);
}

bool object_clip(struct scene_object *object, const struct scene_object *clip)
{
    struct scene_object made = *object;
    const struct branch *branch = object->branches;
    const struct scene_part *part = object->parts;
    size_t left = object->branch_count;
    bool done = true;
    made.branches = NULL;
    made.parts = NULL;
    made.branch_count = made.part_count = 0;
    for (; done && left > 0; left -= branch->size, branch += branch->size) {
        size_t leaves = count_leaves(branch, branch->size);
        done = add_clipped(&made, branch, branch->size, part, leaves, clip);
        part += leaves;
    }
    free(done ? object->branches : made.branches);
    free(done ? object->parts : made.parts);
    if (done)
        *object = made;
    return done;
}

/* The content of a branch after its empty parts have been removed. */
enum content { CONTENT_NOTHING, CONTENT_ALL, CONTENT_SOME };

/* The state while a tree is pruned in place: the next branch and part to read, and the
 * numbers of branches and parts that have been kept. */
struct pruning {
    struct scene_object *object;
    size_t branch, part;
    size_t kept_branches, kept_parts;
};

static enum content prune_leaf(struct pruning *pruning)
{
    struct scene_part *parts = pruning->object->parts;
    const struct scene_part *part = &parts[pruning->part++];
    if (part->primitive.empty)
        return CONTENT_NOTHING;
    parts[pruning->kept_parts++] = *part;
    pruning->object->branches[pruning->kept_branches++] = (struct branch){ TREE_LEAF, 1,
                                                                           false };
    return CONTENT_SOME;
}

static enum content prune_branch(struct pruning *pruning);

static enum content opposite(enum content content)
{
    return content == CONTENT_NOTHING ? CONTENT_ALL : CONTENT_NOTHING;
}

/* Stores the root of a branch at its position, or removes it if it has only one
 * child. */
static void keep_root(struct pruning *pruning, struct branch root, size_t place,
                      size_t children)
{
    struct branch *branches = pruning->object->branches;
    root.size = pruning->kept_branches - place;
    branches[place] = root;
    if (root.operation == TREE_NOT || children > 1)
        return;
    pruning->kept_branches--;
    memmove(branches + place, branches + place + 1, (root.size - 1) * sizeof *branches);
}

/* Prunes a branch. One child can decide the result: an empty child makes an
 * intersection empty, and a child that contains all space makes a merge contain all
 * space. */
static enum content prune_branch(struct pruning *pruning)
{
    struct branch root = pruning->object->branches[pruning->branch++];
    size_t end = pruning->branch - 1 + root.size;
    size_t place = pruning->kept_branches, part = pruning->kept_parts;
    size_t children = 0;
    enum content decides = root.operation == TREE_AND ? CONTENT_NOTHING : CONTENT_ALL;
    enum content content = opposite(decides);
    if (root.operation == TREE_LEAF)
        return prune_leaf(pruning);
    pruning->kept_branches++;
    while (pruning->branch < end) {
        enum content child = prune_branch(pruning);
        children += child == CONTENT_SOME;
        if (child == decides)
            content = decides;
    }
    if (content == opposite(decides) && children > 0) {
        keep_root(pruning, root, place, children);
        return CONTENT_SOME;
    }
    pruning->kept_branches = place;
    pruning->kept_parts = part;
    return root.operation == TREE_NOT ? opposite(content) : content;
}

void object_prune(struct scene_object *object)
{
    struct pruning pruning = { .object = object };
    while (pruning.branch < object->branch_count)
        prune_branch(&pruning);
    object->branch_count = pruning.kept_branches;
    object->part_count = pruning.kept_parts;
}

unsigned object_hidden_from(const struct scene_object *object)
{
    unsigned hidden_from = object->hidden_from;
    for (size_t i = 0; i < object->part_count; i++)
        if (!object->parts[i].primitive.invisible)
            hidden_from |= object->parts[i].primitive.hidden_from;
    return hidden_from;
}

void object_show(struct scene_object *object)
{
    object->hidden_from = 0;
    for (size_t i = 0; i < object->part_count; i++)
        if (!object->parts[i].primitive.invisible)
            object->parts[i].primitive.hidden_from = 0;
}

/* Makes parts of a solid cast shadows: as in POV-Ray, no_shadow applies only to whole
 * solids. */
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
    if (object->joining != JOIN_APART) {
        forget_no_shadow(child);
        object_show(child);
    }
    return object_add(object, child);
}

bool object_copy(struct scene_object *copy, const struct scene_object *object)
{
    struct scene_object bare = *object;
    bare.textured = bare.filled = false;
    bare.hidden_from = 0;
    copy->textured = object->textured;
    copy->texture = object->texture;
    copy->filled = object->filled;
    copy->ior = object->ior;
    copy->interior = object->interior;
    copy->hidden_from = object->hidden_from;
    copy->is_light = object->is_light;
    copy->name = object->name;
    copy->named = object->named;
    return object_add(copy, &bare);
}

bool object_renumber(struct scene_object *object, size_t *last)
{
    struct rank_index old;
    if (!rank_index_begin(&old, object->part_count + 1))
        return false;
    for (size_t i = 0; i < object->part_count; i++)
        if (object->parts[i].filled)
            rank_index_add(&old, object->parts[i].primitive.interior);
    if (object->filled)
        rank_index_add(&old, object->interior);
    rank_index_sort(&old);
    for (size_t i = 0; i < object->part_count; i++) {
        size_t *interior = &object->parts[i].primitive.interior;
        if (object->parts[i].filled)
            *interior = *last + rank_index_place(&old, *interior);
    }
    if (object->filled)
        object->interior = *last + rank_index_place(&old, object->interior);
    *last += old.count;
    rank_index_free(&old);
    return true;
}

static void part_move(struct scene_part *part, const struct placement *step)
{
    struct primitive *primitive = &part->primitive;
    primitive->to_world = transform_then(&primitive->to_world, &step->to_world);
    primitive->to_local = transform_then(&step->to_local, &primitive->to_local);
    if (!part->textured)
        return;
    pigment_move(&primitive->pigment, step);
    bumps_move(&primitive->bumps, step);
}

void object_move(void *subject, const struct placement *step)
{
    struct scene_object *object = subject;
    for (size_t i = 0; i < object->part_count; i++)
        part_move(&object->parts[i], step);
    for (size_t i = 0; i < object->light_count; i++) {
        transform_point(&step->to_world, object->lights[i].position);
        transform_point(&step->to_world, object->lights[i].point_at);
        transform_direction(&step->to_world, object->lights[i].area_axes[0]);
        transform_direction(&step->to_world, object->lights[i].area_axes[1]);
    }
    if (object->textured)
        texture_move(&object->texture, step);
}

void scene_object_free(struct scene_object *object)
{
    free(object->parts);
    free(object->branches);
    free(object->lights);
    memset(object, 0, sizeof *object);
}
