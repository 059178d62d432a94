/* pigment.c - parses pigments: colours, checkers, patterns with maps, and images. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/pattern.h"
#include "rt/scene/vector3.h"

#include <string.h>

static const double black[COLOR_TERMS];

/* Ignores quick_color, which POV-Ray uses only at low quality. */
static bool read_quick_color(struct reader *reader, const struct item *item)
{
    struct numbers ignored;
    (void)item;
    return read_color(reader, &ignored);
}

const struct keyword pattern_words_left_out[] = {
    { "agate_turb blend_gamma blend_mode brick_size control0 control1 cubic_wave "
      "exterior exponent form frequency interior interpolate lambda metric mortar "
      "octaves offset omega orientation phase poly_wave ramp_wave scallop_wave "
      "sine_wave solid triangle_wave turbulence uv_mapping warp",
      item_left_out, 0 },
    { "noise_generator", item_ignored, 0 },
    { "quick_color quick_colour", read_quick_color, 0 },
    { NULL, NULL, 0 },
};

static void set_color(struct pigment *pigment, int which,
                      const double terms[COLOR_TERMS])
{
    memcpy(pigment->color[which], terms, 3 * sizeof *terms);
    pigment->filter[which] = terms[3];
    pigment->transmit[which] = terms[4];
}

static bool read_term(struct reader *reader, struct pigment *pigment, int which)
{
    struct numbers color;
    if (!read_color(reader, &color))
        return false;
    set_color(pigment, which, color.n);
    return true;
}

static bool read_color_word(struct reader *reader, const struct item *item)
{
    struct pigment *pigment = item->subject;
    struct numbers color;
    if (!read_color_after(reader, &item->at, &color))
        return false;
    pigment->kind = PIGMENT_COLOR;
    set_color(pigment, 0, color.n);
    return true;
}

static bool read_nested(struct reader *reader, struct numbers *color)
{
    struct pigment pigment = reader->default_texture.pigment;
    struct scene_token at = reader->token;
    reader_next(reader);
    if (!pigment_read(reader, &pigment))
        return false;
    if (pigment.kind != PIGMENT_COLOR)
        reader_report(reader, &at,
                      "a pattern inside a pattern is not supported; its "
                      "first colour is used instead");
    copy3(pigment.color[0], color->n);
    color->n[3] = pigment.filter[0];
    color->n[4] = pigment.transmit[0];
    return true;
}

bool pigment_colors(struct reader *reader, struct numbers *colors, size_t count)
{
    bool done = true;
    for (size_t i = 0; i < count && done; i++) {
        if (is_token(&reader->token, "pigment"))
            done = read_nested(reader, &colors[i]);
        else if (starts_color(reader))
            done = read_color(reader, &colors[i]);
        if (i + 1 < count)
            reader_comma(reader);
    }
    return done;
}

bool gradient_pattern_read(struct reader *reader, const struct item *item)
{
    struct pigment *pigment = item->subject;
    double length;
    if (!read_vector(reader, pigment->axis))
        return false;
    length = length3(pigment->axis);
    if (!(length > 0) || !isfinite(length))
        return reader_fault(reader, &item->at,
                            "the vector of a gradient must have a finite length "
                            "above 0");
    scale3(1 / length, pigment->axis);
    pigment->kind = PIGMENT_GRADIENT;
    reader_comma(reader);
    return true;
}

/* Reads an unsupported pattern. Only its first colour is used. */
static bool unsupported_pattern_read(struct reader *reader, const struct item *item)
{
    struct pigment *pigment = item->subject;
    struct pigment other;
    bool first = true;
    reader_report(
        reader, &item->at,
        "the pattern '%.*s' is not supported; its first colour is used instead",
        ITEM_WORD(item));
    pigment->kind = PIGMENT_COLOR;
    set_color(pigment, 0, black);
    reader_accept(reader, "df3"); /* the file kind of density_file */
    if (!starts_color(reader))
        skip_arguments(reader);
    for (; starts_color(reader); first = false) {
        if (!read_term(reader, first ? pigment : &other, 0))
            return false;
        reader_comma(reader);
    }
    return true;
}

bool pigment_map_read(struct reader *reader, struct pigment *pigment)
{
    return map_first(reader, VALUE_PIGMENT_MAP, pigment_body, pigment, sizeof *pigment);
}

static bool read_pigment_map(struct reader *reader, const struct item *item)
{
    struct pigment *pigment = item->subject;
    if (pigment_has_map(pigment))
        reader_report(reader, &item->at,
                      "'pigment_map' is not supported; its first pigment "
                      "is used instead");
    return pigment_map_read(reader, pigment);
}

static const struct keyword words[] = {
#define PATTERN(KIND, name, pigment, ...) \
    { #name, pigment##_pattern_read, PATTERN_##KIND },
#include "rt/scene/patterns.def"
    { COLOR_WORDS " filter transmit", read_color_word, 0 },
    { "image_map", image_map_read, 0 },
    { "color_map colour_map", item_statement, VALUE_COLOR_MAP },
    { "pigment_map", read_pigment_map, 0 },
    { UNSUPPORTED_PATTERNS, unsupported_pattern_read, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of pigment",
                                        { words, pattern_words,
                                          pattern_words_left_out },
                                        .move = pigment_move };

/* Reads a pigment. It may begin with the name of a pigment or of a colour. */
bool pigment_body(struct reader *reader, const struct block *block, void *subject)
{
    const struct scene_value *value = reader_use(reader, VALUE_PIGMENT);
    struct pigment *pigment = subject;
    bool done = true;
    if (value) {
        *pigment = value->is.pigment;
        reader_next(reader);
    } else if (starts_color(reader) && !is_color_word(&reader->token)) {
        pigment->kind = PIGMENT_COLOR;
        done = read_term(reader, pigment, 0);
    }
    return block_items(reader, block, &grammar, pigment, done)
           && pattern_finish(reader, pigment, &block->open);
}

bool pigment_read(struct reader *reader, struct pigment *pigment)
{
    struct block block;
    return block_open(reader, &block, '{') && pigment_body(reader, &block, pigment);
}
