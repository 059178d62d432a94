/* clip.c - parses clipped_by and bounded_by.
 *
 *   clipped_by { OBJECT ... }    bounded_by { OBJECT ... }
 *
 * clipped_by removes the part of the object that is outside at least one of the listed
 * objects. These clipping objects are invisible. bounded_by lists objects, the bounds,
 * that POV-Ray tests before the object. A bound changes the picture if the object is a
 * compound and extends beyond the bound.
 */
#include "rt/scene/language/scene_statement.h"

#include "rt/scene/language/scene_mesh.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"

#include <string.h>

/* ---- Objects in the braces ----------------------------------------------- */

/* The objects in the braces of clipped_by or bounded_by. Each is one solid. */
struct clipping {
    struct scene_object solids; /* first member: the subject of transforms */
    bool is_clip;               /* bounded_by { clipped_by }, which has no effect */
};

/* Checks that an object has an inside, so that it can clip or bound another object. */
static bool check_inside(struct reader *reader, const struct scene_object *object,
                         const struct scene_token *at)
{
    if (object->light_count > 0)
        return reader_fault(reader, at,
                            "a light has no inside and cannot clip or bound");
    for (size_t i = 0; i < object->part_count; i++)
        if (shape_is_surface(&object->parts[i].primitive))
            return reader_fault(reader, at,
                                "a %s has no inside and cannot clip or bound",
                                primitive_kind_name(object->parts[i].primitive.kind));
    return object->part_count > 0
           || reader_fault(reader, at, "the clipping or bounding object is empty");
}

static bool read_solid(struct reader *reader, const struct item *item)
{
    struct clipping *clipping = item->subject;
    struct scene_object solid = { 0 };
    bool done = shape_read(reader, &solid, item)
                && fields_fill(reader, &solid, &item->at)
                && check_inside(reader, &solid, &item->at)
                && ((object_join(&solid) && object_add(&clipping->solids, &solid))
                    || reader_no_memory(reader));
    scene_object_free(&solid);
    return done;
}

static const struct keyword clipped_by_word[] = {
    { "clipped_by", item_flag, offsetof(struct clipping, is_clip) },
    { NULL, NULL, 0 },
};
static const struct keyword bounded_by_word[] = {
    { "bounded_by", item_unsupported, 0 },
    { NULL, NULL, 0 },
};

/* In clipped_by, a transform moves all objects that precede it. */
static const struct grammar of_clip = { "an object to clip by",
                                        { bounded_by_word },
                                        .object = read_solid,
                                        .move = object_move };
static const struct grammar of_bound = { "an object as a bound",
                                         { clipped_by_word },
                                         .object = read_solid,
                                         .move = object_move };

/* ---- clipped_by ---------------------------------------------------------- */

/* Makes clipping objects invisible, and gives them a texture that is not replaced
 * later. */
static void hide(const struct reader *reader, struct scene_object *clip)
{
    for (size_t i = 0; i < clip->part_count; i++) {
        struct scene_part *part = &clip->parts[i];
        struct primitive *primitive = &part->primitive;
        part->textured = part->filled = true;
        primitive->pigment = reader->default_texture.pigment;
        primitive->pigment.filter[0] = primitive->pigment.filter[1] = 0;
        primitive->pigment.transmit[0] = primitive->pigment.transmit[1] = 0;
        primitive->bumps.list = NULL;
        primitive->finish = reader->default_texture.finish;
        primitive->ior = 1;
        primitive->interior = 0;
        primitive->no_shadow = true;
        primitive->hidden_from = HIDDEN_FROM_IMAGE | HIDDEN_FROM_REFLECTIONS;
        primitive->invisible = true;
    }
}

static size_t count_solids(const struct scene_object *object)
{
    size_t count = 0;
    for (size_t i = 0; i < object->branch_count; i += object->branches[i].size)
        count++;
    return count;
}

/* Joins the solids of a compound into one solid. */
static bool make_whole(struct reader *reader, struct scene_object *object)
{
    return object->joining == JOIN_APART || object_join(object)
           || reader_no_memory(reader);
}

/* Clips each solid of the object by the objects in `by`. */
static bool clip(struct reader *reader, struct scene_object *object,
                 struct scene_object *by, const struct scene_token *at)
{
    size_t count = count_solids(object), copies = count * by->part_count;
    if (object->part_count + copies > count * MAX_SOLID)
        return reader_fault(reader, at,
                            "more than %d primitives in one solid, including "
                            "those that clip it",
                            MAX_SOLID);
    hide(reader, by);
    return reader_spend(reader, TOKEN_COST * (object->part_count + copies))
           && shape_count(reader, copies, at)
           && mesh_count(reader, count > 0 ? (count - 1) * mesh_triangles(by) : 0, at)
           && (object_clip(object, by) || reader_no_memory(reader));
}

bool clipped_by_read(struct reader *reader, const struct item *item)
{
    struct clipping clipping = { .is_clip = false };
    bool done = block_read(reader, &of_clip, &clipping)
                && make_whole(reader, item->subject);
    if (done && clipping.solids.part_count > 0)
        done = clip(reader, item->subject, &clipping.solids, &item->at);
    scene_object_free(&clipping.solids);
    return done;
}

/* ---- bounded_by ---------------------------------------------------------- */

#define SLACK 1e-6 /* relative tolerance of a bound */

static bool box_holds(const struct primitive *box, const double point[3])
{
    for (int i = 0; i < 3; i++) {
        double one = box->shape.box.corner[0][i];
        double other = box->shape.box.corner[1][i];
        double middle = (one + other) / 2, half = fabs(other - one) / 2;
        if (!(fabs(point[i] - middle) <= half * (1 + SLACK)))
            return false;
    }
    return true;
}

static bool sphere_holds(const struct primitive *sphere, const double point[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = point[i] - sphere->shape.sphere.center[i];
    return length3(from) <= fabs(sphere->shape.sphere.radius) * (1 + SLACK);
}

/* Returns true if the bound contains a point of the world. */
static bool holds(const struct primitive *bound, const double point[3])
{
    double local[3];
    memcpy(local, point, sizeof local);
    transform_point(&bound->to_local, local);
    return bound->kind == PRIMITIVE_BOX ? box_holds(bound, local)
                                        : sphere_holds(bound, local);
}

/* Returns true if the bound contains a box. The bound is convex, so it contains the box
 * if it contains all its corners. */
static bool holds_box(const struct primitive *bound, const struct bound *about)
{
    for (int i = 0; i < 8; i++) {
        double corner[3];
        for (int axis = 0; axis < 3; axis++)
            corner[axis] = i >> axis & 1 ? about->high[axis] : about->low[axis];
        if (!holds(bound, corner))
            return false;
    }
    return true;
}

/* Returns the radius of a sphere in world space, or 0 if it is an ellipsoid there. */
static double radius_in_world(const struct primitive *sphere)
{
    const double(*rows)[4] = sphere->to_world.rows;
    double square = dot3(rows[0], rows[0]);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            if (!(fabs(dot3(rows[i], rows[k]) - (i == k ? square : 0))
                  <= SLACK * square))
                return 0;
    return fabs(sphere->shape.sphere.radius) * sqrt(square);
}

static bool holds_sphere(const struct primitive *bound, const struct bound *about)
{
    double from[3];
    if (bound->kind != PRIMITIVE_SPHERE)
        return false;
    memcpy(from, bound->shape.sphere.center, sizeof from);
    transform_point(&bound->to_world, from);
    for (int i = 0; i < 3; i++)
        from[i] -= about->center[i];
    return length3(from) + about->radius <= radius_in_world(bound) * (1 + SLACK);
}

/* Computes the bound of a primitive, without the margin that bound_primitive adds. */
static void bound_part(const struct primitive *primitive, struct bound *bound)
{
    const struct shape *shape = shape_of(primitive);
    (shape->endless ? bound_without : shape->bound)(primitive, bound);
}

/* Computes the bound of a branch. On entry *part is the index of the branch's first
 * leaf; on return it is the index after its last leaf. */
static void bound_branch(const struct scene_object *object, size_t at, size_t *part,
                         struct bound *whole)
{
    const struct branch *branches = object->branches;
    enum tree_operation operation = branches[at].operation;
    size_t end = at + branches[at].size;
    struct bound both[2];
    if (operation == TREE_LEAF) {
        bound_part(&object->parts[(*part)++].primitive, whole);
        return;
    }
    bound_branch(object, at + 1, part, &both[0]);
    for (at += 1 + branches[at + 1].size; at < end; at += branches[at].size) {
        bound_branch(object, at, part, &both[1]);
        (operation == TREE_AND ? bound_common : bound_enclose)(both, 2, whole);
        both[0] = *whole;
    }
    *whole = operation == TREE_NOT ? bound_none : both[0];
}

static bool holds_object(const struct scene_object *bound,
                         const struct scene_object *object)
{
    const struct primitive *primitive = &bound->parts[0].primitive;
    size_t part = 0;
    if (bound->branch_count != 1
        || (primitive->kind != PRIMITIVE_BOX && primitive->kind != PRIMITIVE_SPHERE))
        return false;
    for (size_t i = 0; i < object->branch_count; i += object->branches[i].size) {
        struct bound about;
        bound_branch(object, i, &part, &about);
        if (!holds_box(primitive, &about) && !holds_sphere(primitive, &about))
            return false;
    }
    return true;
}

/* Returns true if POV-Ray ignores bounds of the object, because it is a single bounded
 * primitive. */
static bool is_forgotten(const struct scene_object *object)
{
    enum primitive_kind kind;
    if (object->part_count != 1)
        return object->part_count == 0;
    kind = object->parts[0].primitive.kind;
    return kind != PRIMITIVE_QUADRIC && kind != PRIMITIVE_QUARTIC;
}

static bool changes_nothing(const struct clipping *clipping,
                            const struct scene_object *object)
{
    return clipping->is_clip || is_forgotten(object) || clipping->solids.part_count == 0
           || holds_object(&clipping->solids, object);
}

bool bounded_by_read(struct reader *reader, const struct item *item)
{
    struct clipping clipping = { .is_clip = false };
    bool done = block_read(reader, &of_bound, &clipping)
                && make_whole(reader, item->subject);
    if (done && !changes_nothing(&clipping, item->subject))
        reader_report(reader, &item->at,
                      "'bounded_by' is ignored: whether it cuts the "
                      "object cannot be determined");
    scene_object_free(&clipping.solids);
    return done;
}
