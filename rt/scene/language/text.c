/* text.c - parses text { ttf "font" "string" thickness, offset }. Each character
 * becomes a prism along z. */
#include "rt/scene/font.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"
#include "rt/scene/language/string_value.h"
#include "rt/shapes/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FONT_COST = 1 << 14 }; /* cost of opening a font, in bytes of reading */

struct text_reading {
    struct reader *reader;
    struct scene_object *object;
    const struct scene_token *at;
    const struct font *font;
    double thickness, offset[3]; /* offset: additional distance of two characters */
    double position[3];
};

/* Maps the axes of a prism to the axes of a character. A prism lies along y, and its
 * path is in x and z. A character lies along z, and its outline is in x and y. */
static struct placement to_character(const double position[3])
{
    struct placement placement = placement_none;
    double values[12] = { 1, 0, 0, 0, 0, 1, 0, 1, 0 };
    memcpy(values + 9, position, 3 * sizeof *position);
    placement_matrix(values, &placement);
    return placement;
}

/* Makes a prism with straight edges. Returns false if the glyph is invisible. */
static bool make_prism(struct text_reading *text, const struct glyph *glyph,
                       struct primitive *prism)
{
    prism->kind = PRIMITIVE_PRISM;
    prism->shape.prism.high = text->thickness;
    prism->shape.prism.path = (struct outline){ glyph->count, glyph->points };
    return shapes[PRIMITIVE_PRISM]->finish(prism) == NULL;
}

/* Makes a prism whose outline consists of parabolas. The points of the glyph are used
 * unchanged. Returns false if the glyph is invisible. */
static bool make_quadratic_prism(struct text_reading *text, const struct glyph *glyph,
                                 struct primitive *prism)
{
    prism->kind = PRIMITIVE_QUADRATIC_PRISM;
    prism->shape.quadratic_prism.low = fmin(0, text->thickness);
    prism->shape.quadratic_prism.high = fmax(0, text->thickness);
    prism->shape.quadratic_prism.path = (struct outline){ glyph->count, glyph->points };
    return glyph->count >= 3;
}

static bool add_glyph(struct text_reading *text, const struct glyph *glyph)
{
    struct reader *reader = text->reader;
    struct placement placement = to_character(text->position);
    struct primitive prism;
    struct scene_object one = { 0 };
    bool done;
    if (glyph->count > MAX_PATH)
        return reader_fault(reader, text->at, "more than %d points in one character",
                            MAX_PATH);
    memset(&prism, 0, sizeof prism);
    if (!(glyph->apart == 1 ? make_prism : make_quadratic_prism)(text, glyph, &prism))
        return true;
    done = shape_add(reader, &one, &prism, text->at);
    object_move(&one, &placement);
    done = done && (object_add(text->object, &one) || reader_no_memory(reader));
    scene_object_free(&one);
    return done;
}

/* Adds a character. As in POV-Ray, the ink of the first character begins at 0. */
static bool add_character(struct text_reading *text, bool first, uint32_t before,
                          uint32_t character)
{
    struct reader *reader = text->reader;
    struct glyph glyph;
    if (!font_glyph(text->font, character, &reader->scene->kept, &glyph))
        return reader_fault(reader, text->at,
                            "the font is invalid, or there is not enough memory");
    if (first)
        text->position[0] = -glyph.bearing;
    else
        text->position[0] += font_kerning(text->font, before, character);
    if (glyph.count && !add_glyph(text, &glyph))
        return false;
    text->position[0] += glyph.advance;
    for (int i = 0; i < 2; i++) /* POV-Ray ignores z */
        text->position[i] += text->offset[i];
    return reader_spend(reader, TOKEN_COST * (glyph.count + 1));
}

/* Decodes the next UTF-8 character. An invalid byte counts as Latin-1. */
static uint32_t next_character(const unsigned char **string)
{
    const unsigned char *s = *string;
    size_t more = s[0] >= 0xf0 ? 3 : s[0] >= 0xe0 ? 2 : s[0] >= 0xc0 ? 1 : 0;
    uint32_t character = more ? s[0] & (0x3fu >> more) : s[0];
    for (size_t i = 1; i <= more; i++) {
        if ((s[i] & 0xc0) != 0x80) {
            *string = s + 1;
            return s[0];
        }
        character = character << 6 | (s[i] & 0x3fu);
    }
    *string = s + more + 1;
    return character;
}

static bool add_characters(struct text_reading *text, const char *string)
{
    const unsigned char *next = (const unsigned char *)string;
    uint32_t before = 0;
    bool first = true;
    for (; *next; first = false) {
        uint32_t character = next_character(&next);
        if (!add_character(text, first, before, character))
            return false;
        before = character;
    }
    return text->object->part_count > 0
           || shape_leave_out(text->reader, text->object, text->at,
                              "the text has no visible characters");
}

static bool read_extent(struct text_reading *text)
{
    struct reader *reader = text->reader;
    reader_comma(reader);
    if (!read_number(reader, &text->thickness))
        return false;
    reader_comma(reader);
    return read_vector(reader, text->offset);
}

/* Reads thickness and offset, then adds the characters of the string in this font. */
static bool read_with(struct text_reading *text, const struct scene_source *source,
                      const char *string)
{
    const char *fault;
    struct font *font;
    bool done;
    if (!read_extent(text) || !reader_spend(text->reader, FONT_COST))
        return false;
    font = font_open(source->text, source->length, &fault);
    text->font = font;
    done = reader_check(text->reader, text->at, fault) && add_characters(text, string);
    font_close(font);
    return done;
}

static const struct scene_source *read_font(struct reader *reader)
{
    const struct scene_source *source;
    struct scene_token at;
    char *name;
    if (is_token(&reader->token, "internal")) {
        reader_fault(reader, &reader->token,
                     "the built-in fonts of POV-Ray are not supported");
        return NULL;
    }
    if (!reader_accept(reader, "ttf")) {
        reader_expected(reader, "ttf");
        return NULL;
    }
    at = reader->token;
    if (!file_name_read(reader, &name))
        return NULL;
    source = reader_find(reader, &at, name, false);
    free(name);
    return source;
}

bool text_read(struct reader *reader, struct scene_object *object,
               const struct scene_token *at)
{
    struct text_reading text = { .reader = reader, .object = object, .at = at };
    const struct scene_source *source = read_font(reader);
    char *string;
    bool done;
    if (!source)
        return false;
    reader_comma(reader);
    if (!string_read_within(reader, &string))
        return false;
    done = read_with(&text, source, string);
    free(string);
    return done;
}
