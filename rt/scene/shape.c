/* shape.c - unions, objects and their modifiers. */
#include "rt/scene/expression.h"
#include "rt/scene/statement.h"

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

/* POV-Ray's choice of a root solver; ours needs none. */
static bool read_sturm(struct reader *reader, void *subject,
                       const struct item *item)
{
    double ignored;

    (void)subject;
    (void)item;
    return !starts_expression(reader) || read_number(reader, &ignored);
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
    { "sturm", read_sturm, 0 },
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
    enum shape shape = (enum shape)item->keyword->detail;
    struct primitive primitive;

    if (shape == SHAPE_UNION)
        return true;
    if (shape == SHAPE_OBJECT)
        return read_base(reader, object);
    return primitive_read(reader, shape, &primitive)
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
