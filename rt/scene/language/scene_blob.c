/* scene_blob.c - parses blob { .. }: spheres and cylinders in one primitive. */
#include "rt/scene/language/scene_statement.h"

#include "base/array.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/blob.h"
#include "rt/shapes/shape.h"

#include <stdlib.h>
#include <string.h>

struct blob_reading {
    struct scene_object object; /* first member: the subject of the modifiers */
    struct scene_token at;      /* the keyword `blob` */
    struct blob_parts parts;    /* in an array of array_add, until the blob ends */
    struct scene_token look_at; /* place of the first texture of a component; it becomes
                                 * the texture of the object's part */
};

/* A component of a blob and its texture. */
struct part_reading {
    struct blob_part part;
    struct texture texture;
    bool textured;
    struct scene_token look_at;
};

/* ---- A component --------------------------------------------------------- */

static bool read_radius(struct reader *reader, double *radius)
{
    reader_comma(reader);
    if (!read_number(reader, radius))
        return false;
    *radius = fabs(*radius);
    return true;
}

static bool read_strength(struct reader *reader, double *strength)
{
    reader_comma(reader);
    reader_accept(reader, "strength");
    return read_number(reader, strength);
}

static bool read_ends(struct reader *reader, struct blob_part *part)
{
    struct scene_token at = reader->token;
    double axis[3];
    if (!read_vector(reader, part->base))
        return false;
    reader_comma(reader);
    if (!read_vector(reader, part->cap))
        return false;
    subtract3(part->cap, part->base, axis);
    return length3(axis) > 0 || reader_fault(reader, &at, "the cylinder has no length");
}

static bool read_part(struct reader *reader, struct blob_part *part)
{
    return (part->cylinder ? read_ends(reader, part) : read_vector(reader, part->base))
           && read_radius(reader, &part->radius)
           && read_strength(reader, &part->strength);
}

static void part_move(void *subject, const struct placement *step)
{
    struct part_reading *reading = subject;
    struct blob_part *part = &reading->part;
    part->to_blob = transform_then(&part->to_blob, &step->to_world);
    part->to_local = transform_then(&step->to_local, &part->to_local);
    pigment_move(&reading->texture.pigment, step);
}

static bool read_texture_part(struct reader *reader, const struct item *item)
{
    struct part_reading *reading = item->subject;
    if (!reading->textured)
        reading->look_at = item->at;
    reading->textured = true;
    return texture_part_read(reader, item, &reading->texture);
}

static const struct keyword part_words[] = {
    { "texture", read_texture_part, TEXTURE_WHOLE },
    { "pigment", read_texture_part, TEXTURE_PIGMENT },
    { "finish", read_texture_part, TEXTURE_FINISH },
    { "normal uv_mapping", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar part_grammar = { "a modifier of the component",
                                             { part_words },
                                             .move = part_move };

static bool add_part(struct reader *reader, struct blob_reading *blob,
                     const struct blob_part *part, const struct scene_token *at)
{
    if (blob->parts.count == MAX_BLOB_PARTS)
        return reader_fault(reader, at, "more than %d components in one blob",
                            MAX_BLOB_PARTS);
    return array_add(&blob->parts.list, &blob->parts.count, part, sizeof *part)
           || reader_no_memory(reader);
}

/* Records the texture of a component. POV-Ray blends the textures of components; here
 * the blob has only one. */
static void take_look(struct blob_reading *blob, const struct part_reading *reading)
{
    struct scene_part *part = blob->object.parts;
    if (!reading->textured || part->textured)
        return;
    blob->look_at = reading->look_at;
    part->textured = true;
    part->primitive.pigment = reading->texture.pigment;
    part->primitive.finish = reading->texture.finish;
}

/* Reads a component. The keyword's detail is true for a cylinder, false for a
 * sphere. */
static bool read_component(struct reader *reader, const struct item *item)
{
    struct part_reading reading = { .texture = reader->default_texture,
                                    .part.cylinder = item->keyword->detail };
    struct block block;
    bool good;
    reading.part.to_blob = reading.part.to_local = placement_none.to_world;
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_part(reader, &reading.part);
    if (!block_items(reader, &block, &part_grammar, &reading, good))
        return false;
    take_look(item->subject, &reading);
    return add_part(reader, item->subject, &reading.part, &item->at);
}

/* Reads a blob component in the old form: strength, radius, centre. */
static bool read_bare_component(struct reader *reader, const struct item *item)
{
    struct blob_part part = { .to_blob = placement_none.to_world,
                              .to_local = placement_none.to_world };
    if (!read_strength(reader, &part.strength) || !read_radius(reader, &part.radius))
        return false;
    reader_comma(reader);
    return read_vector(reader, part.base)
           && add_part(reader, item->subject, &part, &item->at);
}

/* ---- The blob ------------------------------------------------------------ */

static bool read_threshold(struct reader *reader, const struct item *item)
{
    struct blob_reading *blob = item->subject;
    struct primitive *primitive = &blob->object.parts->primitive;
    return read_number(reader, &primitive->shape.blob.threshold);
}

static const struct keyword blob_words[] = {
    { "threshold", read_threshold, 0 },
    { "sphere", read_component, false },
    { "cylinder", read_component, true },
    { "component", read_bare_component, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar blob_grammar = { "a component or an object modifier",
                                             { blob_words },
                                             .then = &modifier_grammar };

static bool begin(struct reader *reader, struct blob_reading *blob,
                  const struct item *item)
{
    struct primitive primitive;
    *blob = (struct blob_reading){ .at = item->at };
    memset(&primitive, 0, sizeof primitive);
    primitive.kind = PRIMITIVE_BLOB;
    primitive.shape.blob.threshold = 1;
    return shape_add(reader, &blob->object, &primitive, &item->at);
}

/* Copies the components of a blob to storage that the scene owns. */
static bool keep(struct reader *reader, struct blob_reading *blob)
{
    struct primitive *primitive = &blob->object.parts->primitive;
    size_t count = blob->parts.count;
    struct blob_part *list = reader_keep(reader, blob->parts.list,
                                         count * sizeof *list);
    if (!list)
        return false;
    primitive->shape.blob.parts = (struct blob_parts){ count, list };
    /* A blob of one component without a texture of its own needs no report, because the
     * texture of the component is then the texture of the blob, as in POV-Ray. */
    if (count != 1 || blob->object.textured)
        shape_choose_texture(reader, &blob->object, &blob->look_at, "blob components",
                             "the texture of the blob");
    return primitive_finish(reader, primitive, &blob->at);
}

bool blob_read(struct reader *reader, struct scene_object *object,
               const struct item *item)
{
    struct blob_reading blob;
    struct block block;
    bool good = begin(reader, &blob, item) && block_open(reader, &block, '{')
                && block_items(reader, &block, &blob_grammar, &blob, true)
                && keep(reader, &blob);
    free(blob.parts.list);
    *object = blob.object;
    return good;
}
