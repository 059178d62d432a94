/* shape.c - parses objects, solids that consist of objects, and their modifiers. */
#include "rt/scene/language/scene_statement.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_mesh.h"
#include "rt/shapes/shape.h"

#include <string.h>

bool shape_count(struct reader *reader, size_t more, const struct scene_token *at)
{
    reader->primitives_made += more;
    return reader->primitives_made <= MAX_PRIMITIVES
           || reader_fault(reader, at,
                           "more than %d primitives and lights, including copies",
                           MAX_PRIMITIVES);
}

bool shape_copy(struct reader *reader, struct scene_object *copy,
                const struct scene_object *object)
{
    struct scene_token at = reader->token;
    size_t more = object->part_count + object->light_count;
    if (!shape_count(reader, more, &at)
        || !mesh_count(reader, mesh_triangles(object), &at))
        return false;
    return (object_copy(copy, object) && object_renumber(copy, &reader->interiors))
           || reader_no_memory(reader);
}

bool shape_add(struct reader *reader, struct scene_object *object,
               struct primitive *primitive, const struct scene_token *at)
{
    primitive->line = at->main_line;
    primitive->to_world = placement_none.to_world;
    primitive->to_local = placement_none.to_local;
    primitive->ior = 1;
    if (!shape_count(reader, 1, at))
        return false;
    return object_add_primitive(object, primitive) || reader_no_memory(reader);
}

bool shape_leave_out(struct reader *reader, struct scene_object *object,
                     const struct scene_token *at, const char *reason)
{
    struct primitive primitive;
    memset(&primitive, 0, sizeof primitive);
    primitive_leave_out(reader, &primitive, at, reason);
    return shape_add(reader, object, &primitive, at);
}

void shape_choose_texture(struct reader *reader, struct scene_object *object,
                          const struct scene_token *at, const char *pieces,
                          const char *own)
{
    struct scene_part *part = object->parts;
    if (!part->textured)
        return;
    reader_report(reader, at,
                  "separate textures of %s are not supported; %s is used instead",
                  pieces, object->textured ? own : "the first one");
    part->textured = !object->textured;
}

/* Takes the refractive index from the finish, where old scenes have it. */
static void take_ior(struct reader *reader, struct scene_object *object)
{
    if (object->texture.finish.ior > 0)
        object_fill(reader, object, object->texture.finish.ior);
}

/* Reads texture, pigment, normal or finish. A texture after the first is added as a
 * layer. The other keywords modify the texture of the object, which initially is the
 * default texture. */
static bool read_texture(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    enum texture_part part = (enum texture_part)item->keyword->detail;
    if (part == TEXTURE_WHOLE && object->textured)
        return texture_layer_read(reader, &item->at, &object->texture);
    if (!object->textured)
        object->texture = reader->default_texture;
    object->textured = true;
    if (!texture_part_read(reader, item, &object->texture))
        return false;
    if (part == TEXTURE_FINISH || part == TEXTURE_WHOLE)
        take_ior(reader, object);
    return true;
}

void object_fill(struct reader *reader, struct scene_object *object, double ior)
{
    object->filled = true;
    object->ior = ior;
    object->interior = ++reader->interiors;
}

static bool read_interior(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    if (!object->filled)
        object_fill(reader, object, 1);
    if (!interior_read(reader, &object->ior))
        return false;
    take_ior(reader, object);
    return true;
}

/* Checks the number of primitives in an object before it becomes one solid. */
static bool check_solid(struct reader *reader, const struct scene_object *object,
                        const struct scene_token *at)
{
    return object->part_count <= MAX_SOLID
           || reader_fault(reader, at, "more than %d primitives in one solid",
                           MAX_SOLID);
}

static bool read_inverse(struct reader *reader, const struct item *item)
{
    return check_solid(reader, item->subject, &item->at)
           && fields_fill(reader, item->subject, &item->at)
           && (object_invert(item->subject) || reader_no_memory(reader));
}

static bool read_no_shadow(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    (void)reader;
    for (size_t i = 0; i < object->part_count; i++)
        object->parts[i].primitive.no_shadow = true;
    return true;
}

/* Reads a keyword such as no_image, which makes the object invisible to some rays. A
 * number may follow the keyword; a number that is not positive switches the effect
 * off. */
static bool read_hidden(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    unsigned rays = (unsigned)item->keyword->detail;
    double on = 1;
    if (starts_expression(reader) && !read_number(reader, &on))
        return false;
    object->hidden_from &= ~rays;
    object->hidden_from |= on > 0 ? rays : 0;
    return true;
}

/* Ignores POV-Ray's choice of a root finder, because there is only one root finder
 * here. */
static bool read_sturm(struct reader *reader, const struct item *item)
{
    double ignored;
    (void)item;
    return !starts_expression(reader) || read_number(reader, &ignored);
}

/* Transforms the texture that has been read so far in a material block. */
static void material_move(void *subject, const struct placement *step)
{
    struct scene_object *object = subject;
    texture_move(&object->texture, step);
}

static const struct keyword material_words[] = {
    { "texture", read_texture, TEXTURE_WHOLE },
    { "interior", read_interior, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar material_grammar = { "a keyword of material",
                                                 { material_words },
                                                 .move = material_move };

static void take_material(struct reader *reader, struct scene_object *object,
                          const struct scene_object *material)
{
    if (material->textured)
        object->texture = material->texture;
    object->textured |= material->textured;
    if (material->filled)
        object_fill(reader, object, material->ior);
    take_ior(reader, object);
}

bool material_read(struct reader *reader, struct scene_object *object)
{
    const struct scene_value *value;
    struct block block;
    if (!block_open(reader, &block, '{'))
        return false;
    value = reader_use(reader, VALUE_MATERIAL);
    if (value) {
        take_material(reader, object, &value->is.material);
        reader_next(reader);
    }
    return block_items(reader, &block, &material_grammar, object, true);
}

static const struct keyword modifiers[] = {
    { "texture", read_texture, TEXTURE_WHOLE },
    { "pigment", read_texture, TEXTURE_PIGMENT },
    { "finish", read_texture, TEXTURE_FINISH },
    { "normal", read_texture, TEXTURE_NORMAL },
    { "interior", read_interior, 0 },
    { "material", item_statement, VALUE_MATERIAL },
    { "inverse", read_inverse, 0 },
    { "no_image", read_hidden, HIDDEN_FROM_IMAGE },
    { "no_reflection", read_hidden, HIDDEN_FROM_REFLECTIONS },
    { "no_shadow", read_no_shadow, 0 },
    { "sturm", read_sturm, 0 },
    { "part", part_read, 0 },
    { "clipped_by", clipped_by_read, 0 },
    { "bounded_by", bounded_by_read, 0 },
    /* Keywords for media, photons, radiosity and light groups, which are reported at
     * other statements, and for the internals of POV-Ray. */
    { "global_lights hierarchy hollow no_radiosity photons split_union", item_ignored,
      0 },
    { "color colour cutaway_textures double_illuminate interior_texture radiosity "
      "uv_mapping",
      item_left_out, 0 },
    { NULL, NULL, 0 },
};

const struct grammar modifier_grammar = { "an object modifier",
                                          { modifiers },
                                          .move = object_move };

/* Reports a surface without an inside in an intersection or difference, as POV-Ray
 * does. */
static void report_patches(struct reader *reader, const struct scene_object *child,
                           const struct scene_token *at)
{
    for (size_t i = 0; i < child->part_count; i++)
        if (shape_is_surface(&child->parts[i].primitive)) {
            reader_report(reader, at,
                          "a patch in an intersection or difference has no inside");
            return;
        }
}

/* Reports a child of a solid that is invisible to some rays, which is not supported:
 * the child stays visible here. In POV-Ray the children of a merge can be invisible to
 * all kinds of rays, those of a union within a solid only to reflections. */
static void report_hidden(struct reader *reader, enum joining joining,
                          const struct scene_object *child,
                          const struct scene_token *at)
{
    bool several = child->branch_count > 0
                   && child->branches[0].size < child->branch_count;
    unsigned hidden_from = object_hidden_from(child);
    if (joining == JOIN_APART || (joining != JOIN_MERGE && !several))
        return;
    if (joining != JOIN_MERGE)
        hidden_from &= HIDDEN_FROM_REFLECTIONS;
    if (hidden_from != 0)
        reader_report(reader, at,
                      "'%s' on a part of a solid is not supported and is ignored",
                      hidden_from & HIDDEN_FROM_IMAGE ? "no_image" : "no_reflection");
}

static bool read_child(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    struct scene_object child = { 0 };
    bool done = shape_read(reader, &child, item)
                && (object->joining == JOIN_APART
                    || fields_fill(reader, &child, &item->at));
    if (done && object->joining >= JOIN_INTERSECTION)
        report_patches(reader, &child, &item->at);
    if (done)
        report_hidden(reader, object->joining, &child, &item->at);
    if (done && !object_add_child(object, &child))
        done = reader_no_memory(reader);
    scene_object_free(&child);
    return done;
}

const struct keyword unsupported_shapes[] = {
    { "isosurface", item_unsupported, 0 },
    { "julia_fractal", item_unsupported, 0 },
    { "lemon", item_unsupported, 0 },
    { "ovus", item_unsupported, 0 },
    { "parametric", item_unsupported, 0 },
    { "polynomial", item_unsupported, 0 },
    { "sor", item_unsupported, 0 },
    { "sphere_sweep", item_unsupported, 0 },
    { "superellipsoid", item_unsupported, 0 },
    { NULL, NULL, 0 },
};

static const struct keyword children[] = {
    { "", read_child, SHAPE_NAMED },
    { NULL, NULL, 0 },
};

/* Children must precede modifiers, because a transform applies only to the children
 * before it. */
static const struct grammar solid_grammar = { "an object or an object modifier",
                                              { children },
                                              .object = read_child,
                                              .then = &modifier_grammar };

/* Reads the first word of object { ... }: the name of an object, or a shape. */
static bool read_base(struct reader *reader, struct scene_object *object)
{
    const struct scene_value *value = reader_use(reader, VALUE_OBJECT);
    struct item item = item_find(reader, &solid_grammar, object);
    if (value) {
        bool done = shape_copy(reader, object, &value->is.object);
        if (!object->named)
            object->name = reader_keep_name(reader);
        reader_next(reader);
        return done;
    }
    if (!item.keyword)
        return reader_expected(reader, "the name of an object, or an object");
    reader_next(reader);
    return item.keyword->read == item_object ? shape_read(reader, object, &item)
                                             : item.keyword->read(reader, &item);
}

static bool read_named(struct reader *reader, struct scene_object *object,
                       const struct item *item)
{
    reader_warn(reader, &item->at,
                "the name of an object is read as 'object { NAME }'");
    return read_base(reader, object);
}

bool looks_like_read(struct reader *reader, struct scene_object *object,
                     const double position[3])
{
    struct placement step = placement_translation(position);
    struct block block;
    bool good;
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_base(reader, object);
    object_move(object, &step);
    return block_items(reader, &block, &modifier_grammar, object, good);
}

/* Returns true if the shape is a mesh, or if its triangles become a mesh. */
static bool is_mesh(enum shape_word shape)
{
    return shape == (enum shape_word)PRIMITIVE_MESH || shape >= SHAPE_TRIANGLE;
}

static bool is_joined(enum shape_word shape)
{
    return (shape >= SHAPE_UNION && shape <= SHAPE_DIFFERENCE)
           || shape == SHAPE_LIGHT_GROUP;
}

static void set_joining(struct reader *reader, struct scene_object *object,
                        const struct item *item)
{
    enum shape_word shape = (enum shape_word)item->keyword->detail;
    if (shape != SHAPE_LIGHT_GROUP) {
        object->joining = (enum joining)(shape - SHAPE_UNION);
        return;
    }
    object->joining = JOIN_APART;
    reader_report(reader, &item->at,
                  "'light_group' is not supported; its lights shine on all objects");
}

static bool read_solid(struct reader *reader, enum shape_word shape,
                       struct primitive *primitive)
{
    return shape == SHAPE_CUBIC || shape == SHAPE_POLY
               ? polynomial_read(reader, shape, primitive)
               : primitive_read(reader, (enum primitive_kind)shape, primitive);
}

static bool read_first(struct reader *reader, struct scene_object *object,
                       const struct item *item)
{
    enum shape_word shape = (enum shape_word)item->keyword->detail;
    static shape_reader *const readers[] = { text_read, bicubic_patch_read,
                                             polygon_read, height_field_read };
    struct primitive primitive;
    if (is_joined(shape)) {
        set_joining(reader, object, item);
        return true;
    }
    if (shape == SHAPE_OBJECT)
        return read_base(reader, object);
    if (shape >= SHAPE_TEXT && shape <= SHAPE_HEIGHT_FIELD)
        return readers[shape - SHAPE_TEXT](reader, object, &item->at);
    return read_solid(reader, shape, &primitive)
           && shape_add(reader, object, &primitive, &item->at);
}

/* Completes a union, merge, intersection or difference after its block. */
static bool finish_joined(struct reader *reader, struct scene_object *object,
                          const struct item *item)
{
    if (object->child_count < 2 && item->keyword->detail != SHAPE_LIGHT_GROUP)
        reader_report(reader, &item->at, "fewer than two objects in this '%s'",
                      item->keyword->words);
    if (object->joining == JOIN_APART)
        return true;
    return check_solid(reader, object, &item->at)
           && (object_join(object) || reader_no_memory(reader));
}

bool shape_read(struct reader *reader, struct scene_object *object,
                const struct item *item)
{
    enum shape_word shape = (enum shape_word)item->keyword->detail;
    struct block block;
    bool good;
    if (shape == SHAPE_NAMED)
        return read_named(reader, object, item);
    if (shape == SHAPE_LIGHT)
        return light_read(reader, object);
    if (shape == (enum shape_word)PRIMITIVE_BLOB)
        return blob_read(reader, object, item);
    if (is_mesh(shape))
        return mesh_read(reader, object, item);
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_first(reader, object, item);
    good = block_items(reader, &block,
                       is_joined(shape) ? &solid_grammar : &modifier_grammar, object,
                       good);
    return good && (!is_joined(shape) || finish_joined(reader, object, item));
}
