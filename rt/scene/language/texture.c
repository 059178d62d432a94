/* texture.c - parses finishes, and textures that consist of a pigment, a normal and a
 * finish. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"

#include <string.h>

/* A finish while `reflection` modifies it. As in POV-Ray, a parameter that is not
 * specified keeps its value from an earlier `reflection`. */
struct mirror_reading {
    struct finish finish;
    bool fresnel; /* `fresnel` is set in this block */
};

static bool read_fresnel(struct reader *reader, const struct item *item)
{
    struct mirror_reading *mirror = item->subject;
    double number = 1;
    if (starts_expression(reader) && !read_number(reader, &number))
        return false;
    mirror->fresnel = mirror->finish.fresnel = number != 0;
    return true;
}

static const struct keyword reflection_words[] = {
    { "falloff", item_number,
      offsetof(struct mirror_reading, finish.reflection_falloff) },
    { "fresnel", read_fresnel, 0 },
    { "metallic", item_number_or_1,
      offsetof(struct mirror_reading, finish.reflection_metallic) },
    { "exponent", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar reflection_grammar = { "a keyword of reflection",
                                                   .tables = { reflection_words } };

/* Reads a reflectivity that is the same for all angles. */
static bool read_mirror(struct reader *reader, struct finish *finish)
{
    bool good = read_rgb(reader, finish->reflection);
    memcpy(finish->reflection_most, finish->reflection, sizeof finish->reflection);
    return good;
}

/* Reads one reflectivity, or two: the perpendicular and the grazing reflectivity. */
static bool read_mirrors(struct reader *reader, struct finish *finish, bool *two)
{
    if (!read_mirror(reader, finish))
        return false;
    reader_comma(reader);
    *two = starts_color(reader) || starts_expression(reader);
    return !*two || read_rgb(reader, finish->reflection_most);
}

static bool read_reflection(struct reader *reader, const struct item *item)
{
    struct finish *finish = item->subject;
    struct mirror_reading mirror = { *finish, false };
    struct block block;
    bool two = false;
    if (!reader_at_sign(reader, '{'))
        return read_mirror(reader, finish);
    if (!block_open(reader, &block, '{')
        || !block_items(reader, &block, &reflection_grammar, &mirror,
                        read_mirrors(reader, &mirror.finish, &two)))
        return false;
    *finish = mirror.finish;
    if (mirror.fresnel && !two) /* the perpendicular reflectivity is 0 */
        memset(finish->reflection, 0, sizeof finish->reflection);
    return true;
}

static bool read_amount(struct reader *reader, const struct item *item)
{
    struct scene_token more = reader->token;
    double inside;
    if (reader_accept(reader, "albedo"))
        reader_report(reader, &more, "'albedo' is not supported and is ignored");
    if (!item_number(reader, item))
        return false;
    more = reader->token;
    if (!reader_accept_sign(reader, ','))
        return true;
    reader_report(reader, &more,
                  "the value for the inside is not supported and is ignored");
    return read_number(reader, &inside);
}

static bool read_old_ior(struct reader *reader, const struct item *item)
{
    reader_warn(reader, &item->at,
                "'ior' of a finish is read as 'ior' of the interior");
    return item_above_0(reader, item);
}

static const struct keyword finish_words[] = {
    { "ambient", item_rgb, offsetof(struct finish, ambient) },
    { "brilliance", read_amount, offsetof(struct finish, brilliance) },
    { "diffuse", read_amount, offsetof(struct finish, diffuse) },
    { "emission", item_rgb, offsetof(struct finish, emission) },
    { "ior", read_old_ior, offsetof(struct finish, ior) },
    { "metallic", item_number_or_1, offsetof(struct finish, metallic) },
    { "phong", read_amount, offsetof(struct finish, phong) },
    { "phong_size", read_amount, offsetof(struct finish, phong_size) },
    { "specular", read_amount, offsetof(struct finish, specular) },
    { "roughness", item_above_0, offsetof(struct finish, roughness) },
    { "reflection", read_reflection, 0 },
    { "conserve_energy crand caustics fresnel irid reflection_exponent refraction "
      "subsurface use_alpha",
      item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar finish_grammar = { "a keyword of finish",
                                               .tables = { finish_words } };

bool finish_read(struct reader *reader, struct finish *finish)
{
    return block_read_from(reader, &finish_grammar, VALUE_FINISH, finish,
                           sizeof *finish);
}

bool texture_part_read(struct reader *reader, const struct item *item,
                       struct texture *texture)
{
    switch ((enum texture_part)item->keyword->detail) {
    case TEXTURE_PIGMENT: return pigment_read(reader, &texture->pigment);
    case TEXTURE_NORMAL: return normal_read(reader, &texture->bumps);
    case TEXTURE_FINISH: return finish_read(reader, &texture->finish);
    case TEXTURE_WHOLE: break;
    }
    return texture_read(reader, texture);
}

bool item_texture_part(struct reader *reader, const struct item *item)
{
    return texture_part_read(reader, item, item->subject);
}

/* Reads a texture_map, and uses only the texture of its first entry. */
bool texture_map_read(struct reader *reader, struct texture *texture)
{
    return map_first(reader, VALUE_TEXTURE_MAP, texture_body, texture, sizeof *texture);
}

static bool read_pattern(struct reader *reader, const struct item *item)
{
    struct texture texture = reader->default_texture;
    reader_report(reader, &item->at,
                  "textures in the pattern '%.*s' are not supported; "
                  "the first one is used instead",
                  ITEM_WORD(item));
    skip_arguments(reader);
    for (bool first = true; reader_accept(reader, "texture"); first = false) {
        if (!texture_read(reader, first ? item->subject : &texture))
            return false;
        reader_comma(reader);
    }
    return true;
}

/* Reads tiles { texture tile2 texture }. */
static bool read_tiles(struct reader *reader, const struct item *item)
{
    struct block block;
    bool good;
    reader_report(reader, &item->at,
                  "'tiles' is not supported; the first texture is used instead");
    if (!block_open(reader, &block, '{'))
        return false;
    good = reader_accept(reader, "texture") ? texture_read(reader, item->subject)
                                            : reader_expected(reader, "a texture");
    return block_finish(reader, &block) && good;
}

static const struct keyword texture_words[] = {
    { "pigment", item_texture_part, TEXTURE_PIGMENT },
    { "finish", item_texture_part, TEXTURE_FINISH },
    { "normal", item_texture_part, TEXTURE_NORMAL },
    { "no_bump_scale", item_flag, offsetof(struct texture, bumps.unscaled) },
#define PATTERN(KIND, name, ...) { #name, read_pattern, 0 },
#include "rt/scene/patterns.def"
    { "image_map " UNSUPPORTED_PATTERNS, read_pattern, 0 },
    { "texture_map", item_statement, VALUE_TEXTURE_MAP },
    { "tiles", read_tiles, 0 },
    { "material_map", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar texture_grammar = { "a keyword of texture",
                                                { texture_words,
                                                  pattern_words_left_out },
                                                .move = texture_move };

bool texture_body(struct reader *reader, const struct block *block, void *subject)
{
    const struct scene_value *value = reader_use(reader, VALUE_TEXTURE);
    if (value) {
        struct texture *texture = subject;
        *texture = value->is.texture;
        texture->name = reader_keep_name(reader);
        reader_next(reader);
    }
    return block_items(reader, block, &texture_grammar, subject, true);
}

bool texture_read(struct reader *reader, struct texture *texture)
{
    struct block block;
    return block_open(reader, &block, '{') && texture_body(reader, &block, texture);
}

/* Reads a texture as a further layer. An opaque layer hides all layers below it. */
bool texture_layer_read(struct reader *reader, const struct scene_token *at,
                        struct texture *texture)
{
    struct texture layer = reader->default_texture;
    if (!texture_read(reader, &layer))
        return false;
    if (pigment_is_clear(&layer.pigment))
        reader_report(reader, at,
                      "layered textures are not supported; the lowest one "
                      "is used instead");
    else
        *texture = layer;
    return true;
}
