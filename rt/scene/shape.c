/* shape.c - primitives, unions and objects: their arguments and modifiers. */
#include "rt/scene/expression.h"
#include "rt/scene/statement.h"
#include "rt/scene/vector.h"

#include <string.h>

static bool count_primitives(struct reader *reader, size_t more,
                             const struct token *at)
{
    reader->primitives_made += more;
    return reader->primitives_made <= PRIMITIVES_MOST
        || reader_fault(reader, at,
                        "more than %d primitives, copies counted",
                        PRIMITIVES_MOST);
}

bool shape_copy(struct reader *reader, struct object *copy,
                const struct object *object)
{
    struct token at = reader->token;
    size_t more = object->part_count + object->light_count;

    if (!count_primitives(reader, more, &at))
        return false;
    return object_copy(copy, object) || reader_no_memory(reader);
}

static bool add_primitive(struct reader *reader, struct object *object,
                          struct primitive *primitive, const struct token *at)
{
    primitive->line = at->main_line;
    primitive->to_world = placement_none.to_world;
    primitive->to_local = placement_none.to_local;
    if (!count_primitives(reader, 1, at))
        return false;
    return object_add_primitive(object, primitive)
        || reader_no_memory(reader);
}

/* A radius counts by its size; without one there is nothing to see. */
static bool read_radius(struct reader *reader, double *radius)
{
    struct token at = reader->token;

    if (!read_number(reader, radius))
        return false;
    *radius = fabs(*radius);
    return *radius > 0 || reader_fault(reader, &at, "the radius is 0");
}

static bool read_sphere(struct reader *reader, struct primitive *primitive)
{
    primitive->kind = PRIMITIVE_SPHERE;
    if (!read_vector(reader, primitive->shape.sphere.center))
        return false;
    reader_comma(reader);
    return read_radius(reader, &primitive->shape.sphere.radius);
}

static bool read_box(struct reader *reader, struct primitive *primitive)
{
    double a[3], b[3];

    primitive->kind = PRIMITIVE_BOX;
    if (!read_vector(reader, a))
        return false;
    reader_comma(reader);
    if (!read_vector(reader, b))
        return false;
    for (int i = 0; i < 3; i++) {
        primitive->shape.box.corner[0][i] = fmin(a[i], b[i]);
        primitive->shape.box.corner[1][i] = fmax(a[i], b[i]);
    }
    return true;
}

static bool read_cylinder(struct reader *reader, struct primitive *primitive)
{
    const double *base = primitive->shape.cylinder.base;
    const double *cap = primitive->shape.cylinder.cap;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_CYLINDER;
    if (!read_vector(reader, primitive->shape.cylinder.base))
        return false;
    reader_comma(reader);
    if (!read_vector(reader, primitive->shape.cylinder.cap))
        return false;
    reader_comma(reader);
    if (!read_radius(reader, &primitive->shape.cylinder.radius))
        return false;
    primitive->shape.cylinder.open = reader_accept(reader, "open");
    return base[0] != cap[0] || base[1] != cap[1] || base[2] != cap[2]
        || reader_fault(reader, &at, "both ends of the axis are the same");
}

/* The distance is along the normal of length one. */
static bool read_plane(struct reader *reader, struct primitive *primitive)
{
    double *normal = primitive->shape.plane.normal, length;
    struct token at = reader->token;

    primitive->kind = PRIMITIVE_PLANE;
    if (!read_vector(reader, normal))
        return false;
    length = length3(normal);
    if (length == 0 || !isfinite(length))
        return reader_fault(reader, &at, "the normal has no direction");
    scale3(1 / length, normal);
    reader_comma(reader);
    return read_number(reader, &primitive->shape.plane.distance);
}

/* A texture laid over another hides it, being opaque. */
static bool read_texture(struct reader *reader, void *subject,
                         const struct item *item)
{
    struct object *object = subject;

    (void)item;
    object->texture = reader->default_texture;
    object->textured = true;
    return texture_read(reader, &object->texture);
}

/* pigment and finish change the texture that the object has. */
static struct texture *own_texture(struct reader *reader,
                                   struct object *object)
{
    if (!object->textured)
        object->texture = reader->default_texture;
    object->textured = true;
    return &object->texture;
}

static bool read_pigment(struct reader *reader, void *subject,
                         const struct item *item)
{
    (void)item;
    return pigment_read(reader, &own_texture(reader, subject)->pigment);
}

static bool read_finish(struct reader *reader, void *subject,
                        const struct item *item)
{
    (void)item;
    return finish_read(reader, &own_texture(reader, subject)->finish);
}

static bool read_step(struct reader *reader, void *subject,
                      const struct item *item)
{
    struct placement step;

    if (!step_read(reader, item, &step))
        return false;
    object_move(subject, &step);
    return true;
}

static bool read_no_shadow(struct reader *reader, void *subject,
                           const struct item *item)
{
    struct object *object = subject;

    (void)reader;
    (void)item;
    for (size_t i = 0; i < object->part_count; i++)
        object->parts[i].primitive.no_shadow = true;
    return true;
}

static const struct keyword material_words[] = {
    { "texture", read_texture, 0 },
    { "interior", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar material_grammar = {
    "texture or interior", { material_words }, NULL
};

static bool read_material(struct reader *reader, void *subject,
                          const struct item *item)
{
    (void)item;
    return block_read(reader, &material_grammar, subject);
}

static const struct keyword modifiers[] = {
    STEP_WORDS(read_step),
    { "texture", read_texture, 0 },
    { "pigment", read_pigment, 0 },
    { "finish", read_finish, 0 },
    { "material", read_material, 0 },
    { "no_shadow", read_no_shadow, 0 },
    { NULL, NULL, 0 },
};

static const struct keyword modifiers_left_out[] = {
    { "bounded_by", item_left_out, 0 },
    { "color", item_left_out, 0 },
    { "colour", item_left_out, 0 },
    { "double_illuminate", item_left_out, 0 },
    { "hierarchy", item_left_out, 0 },
    { "hollow", item_left_out, 0 },
    { "interior", item_left_out, 0 },
    { "interior_texture", item_left_out, 0 },
    { "no_radiosity", item_left_out, 0 },
    { "no_reflection", item_left_out, 0 },
    { "normal", item_left_out, 0 },
    { "photons", item_left_out, 0 },
    { "radiosity", item_left_out, 0 },
    { "split_union", item_left_out, 0 },
    { "sturm", item_left_out, 0 },
    { "uv_mapping", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct keyword modifiers_unsupported[] = {
    { "clipped_by", item_unsupported, 0 },
    { "cutaway_textures", item_unsupported, 0 },
    { "inverse", item_unsupported, 0 },
    { "no_image", item_unsupported, 0 },
    { NULL, NULL, 0 },
};

const struct grammar modifier_grammar = {
    "a word that changes the object",
    { modifiers, modifiers_left_out, modifiers_unsupported },
    NULL
};

static bool read_child(struct reader *reader, void *subject,
                       const struct item *item)
{
    struct object child = { 0, 0, NULL, 0, 0, NULL, false,
                            reader->default_texture };
    bool done = shape_read(reader, &child, item);

    if (done && !object_add(subject, &child))
        done = reader_no_memory(reader);
    scene_object_free(&child);
    return done;
}

static const struct keyword children[] = {
    SHAPE_WORDS(read_child),
    { NULL, NULL, 0 },
};

/* The children come first: a transform moves those before it. */
static const struct grammar union_grammar = {
    "an object or a word that changes the union",
    { children, other_shapes },
    &modifier_grammar
};

/* The object that object { ... } begins with: a name, or a shape. */
static bool read_base(struct reader *reader, struct object *object)
{
    const struct value *value = reader_value_of(reader, VALUE_OBJECT);
    struct item item = { grammar_find(&union_grammar, &reader->token),
                         reader->token };

    if (value) {
        bool done = shape_copy(reader, object, &value->is.object);
        reader_next(reader);
        return done;
    }
    if (!item.keyword)
        return reader_expected(reader, "the name of an object, or an object");
    reader_next(reader);
    return item.keyword->read == read_child
        ? shape_read(reader, object, &item)
        : item.keyword->read(reader, object, &item);
}

static bool read_first(struct reader *reader, struct object *object,
                       const struct item *item)
{
    static bool (*const arguments[])(struct reader *, struct primitive *) = {
        read_sphere, read_box, read_cylinder, read_plane
    };
    size_t shape = item->keyword->detail;
    struct primitive primitive;

    if (shape == SHAPE_UNION)
        return true;
    if (shape == SHAPE_OBJECT)
        return read_base(reader, object);
    memset(&primitive, 0, sizeof primitive);
    return arguments[shape](reader, &primitive)
        && add_primitive(reader, object, &primitive, &item->at);
}

bool shape_read(struct reader *reader, struct object *object,
                const struct item *item)
{
    struct block block;
    bool good;

    if (item->keyword->detail == SHAPE_LIGHT)
        return light_read(reader, object);
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_first(reader, object, item);
    return block_items(reader, &block,
                       item->keyword->detail == SHAPE_UNION
                           ? &union_grammar
                           : &modifier_grammar,
                       object, good);
}
