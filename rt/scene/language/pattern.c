/* pattern.c - parses the patterns of pigments, their waves and their lists. */
#include "rt/scene/language/pattern.h"

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/vector3.h"

enum { EXPONENT_LEAST = -100 }; /* keeps the powers of the kernels in range */

/* POV-Ray's defaults: mortar and brick, two cubes, three hexagons. */
static const double brick_size[3] = { 8, 3, 4.5 };
static const struct numbers bricks[MAX_LISTED] = { { .n = { .5, .5, .5 } },
                                                   { .n = { .6, .15, .15 } } };
static const struct numbers checkers[MAX_LISTED] = { { .n = { 0, 0, 1 } },
                                                     { .n = { 0, 1, 0 } } };
static const struct numbers hexagons[MAX_LISTED] = { { .n = { 0, 0, 1 } },
                                                     { .n = { 0, 1, 0 } },
                                                     { .n = { 1, 0, 0 } } };

static bool read_listed(struct reader *reader, struct pigment *pigment,
                        const struct numbers *unless, size_t count)
{
    struct numbers colors[MAX_LISTED];
    for (size_t i = 0; i < count; i++)
        colors[i] = unless[i];
    pigment->pattern.frequency = 0;
    return pigment_colors(reader, colors, count)
           && color_map_listed(reader, colors, count, &pigment->map);
}

void pattern_begin(struct pigment *pigment, enum pattern_function function)
{
    struct pattern *pattern = &pigment->pattern;
    pigment->kind = PIGMENT_PATTERN;
    pattern->function = function;
    if (function == PATTERN_BRICK) {
        copy3(brick_size, pattern->brick_size);
        pattern->mortar = .5;
    }
}

/* Reads a pattern. As in POV-Ray it keeps the wave and frequency of the pattern that it
 * replaces. A list sets the frequency to 0, which leaves its values unchanged. */
bool pattern_read(struct reader *reader, const struct item *item)
{
    struct pigment *pigment = item->subject;
    pattern_begin(pigment, (enum pattern_function)item->keyword->detail);
    switch (pigment->pattern.function) {
    case PATTERN_BRICK: return read_listed(reader, pigment, bricks, 2);
    case PATTERN_HEXAGON: return read_listed(reader, pigment, hexagons, 3);
    default: return true;
    }
}

bool checker_read(struct reader *reader, const struct item *item)
{
    struct pigment *pigment = item->subject;
    pigment->kind = PIGMENT_CHECKER;
    return read_listed(reader, pigment, checkers, 2);
}

static bool read_wave(struct reader *reader, const struct item *item)
{
    struct pattern *pattern = &((struct pigment *)item->subject)->pattern;
    pattern->wave = (enum pattern_wave)item->keyword->detail;
    if (pattern->wave != WAVE_POLY || !starts_expression(reader))
        return true;
    if (!read_number(reader, &pattern->exponent))
        return false;
    return pattern->exponent >= EXPONENT_LEAST
           || reader_fault(reader, &item->at, "the exponent must be at least %d",
                           EXPONENT_LEAST);
}

static bool read_brick_size(struct reader *reader, const struct item *item)
{
    double *size = ((struct pigment *)item->subject)->pattern.brick_size;
    if (!read_vector(reader, size))
        return false;
    for (int i = 0; i < 3; i++)
        if (size[i] == 0)
            return reader_fault(reader, &item->at, "the size of a brick must not be 0");
    return true;
}

const struct keyword pattern_words[] = {
    { "frequency", item_number, offsetof(struct pigment, pattern.frequency) },
    { "phase", item_number, offsetof(struct pigment, pattern.phase) },
    { "mortar", item_number, offsetof(struct pigment, pattern.mortar) },
    { "brick_size", read_brick_size, 0 },
    { "ramp_wave", read_wave, WAVE_RAMP },
    { "triangle_wave", read_wave, WAVE_TRIANGLE },
    { "sine_wave", read_wave, WAVE_SINE },
    { "scallop_wave", read_wave, WAVE_SCALLOP },
    { "cubic_wave", read_wave, WAVE_CUBIC },
    { "poly_wave", read_wave, WAVE_POLY },
    { NULL, NULL, 0 },
};

static bool is_changed(const struct pattern *pattern)
{
    return pattern->wave != WAVE_RAMP
           || (pattern->frequency != 0
               && (pattern->frequency != 1 || pattern->phase != 0));
}

static void finish_checker(struct pigment *pigment)
{
    for (int i = 0; i < 2; i++) {
        struct color_stop listed = pigment_listed(pigment, (size_t)i);
        copy3(listed.color, pigment->color[i]);
        pigment->filter[i] = listed.filter;
        pigment->transmit[i] = listed.transmit;
    }
}

/* Filter and transmit of a map are ignored. */
bool pattern_finish(struct reader *reader, struct pigment *pigment,
                    const struct scene_token *at)
{
    struct color_map *map = &pigment->map;
    struct pattern *pattern = &pigment->pattern;
    bool round = pigment->kind == PIGMENT_PATTERN
                 && pattern->function == PATTERN_RADIAL;
    if (pigment->kind == PIGMENT_CHECKER)
        finish_checker(pigment);
    if (!pigment_has_map(pigment))
        return true;

    if (map->count == 0)
        *map = round ? color_map_round : color_map_gray;
    if (pigment->kind == PIGMENT_GRADIENT && is_changed(pattern)) {
        pigment->kind = PIGMENT_PATTERN;
        pattern->function = PATTERN_SLANTED;
    }
    copy3(map->stops[0].color, pigment->color[0]);
    if (map->clear > 0)
        reader_report(reader, at, "a transparent %s is drawn opaque",
                      pigment->kind == PIGMENT_GRADIENT ? "gradient" : "pattern");
    pigment->filter[0] = pigment->transmit[0] = 0;
    return true;
}
