/* pattern.c - patterns of pigments: which function, its waves, its bricks. */
#include "rt/scene/language/pattern.h"

#include "rt/scene/language/expression.h"
#include "rt/scene/vector.h"

enum { EXPONENT_LEAST = -100 }; /* the kernels' powers have their range */

const struct pattern pattern_plain = { .wave = WAVE_RAMP,
                                       .frequency = 1,
                                       .exponent = 1,
                                       .brick_size = { 8, 3, 4.5 },
                                       .mortar = .5 };

/* POV-Ray's, unless they are given: mortar and brick; three hexagons. */
static const struct numbers bricks[LISTED_MOST] = {
    { .n = { .5, .5, .5 } }, { .n = { .6, .15, .15 } }
};
static const struct numbers hexagons[LISTED_MOST] = { { .n = { 0, 0, 1 } },
                                                      { .n = { 0, 1, 0 } },
                                                      { .n = { 1, 0, 0 } } };

static bool read_listed(struct reader *reader, struct pigment *pigment,
                        const struct numbers *unless, size_t count)
{
    struct numbers colors[LISTED_MOST];

    for (size_t i = 0; i < count; i++)
        colors[i] = unless[i];
    return pigment_colors(reader, colors, count)
           && color_map_steps(reader, colors, count, &pigment->map);
}

bool pattern_read(struct reader *reader, void *subject,
                  const struct item *item)
{
    struct pigment *pigment = subject;

    pigment->kind = PIGMENT_PATTERN;
    pigment->pattern = pattern_plain;
    pigment->pattern.function = (enum pattern_function)item->keyword->detail;
    switch (pigment->pattern.function) {
    case PATTERN_BRICK: return read_listed(reader, pigment, bricks, 2);
    case PATTERN_HEXAGON: return read_listed(reader, pigment, hexagons, 3);
    default: return true;
    }
}

static bool read_wave(struct reader *reader, void *subject,
                      const struct item *item)
{
    struct pattern *pattern = &((struct pigment *)subject)->pattern;

    pattern->wave = (enum pattern_wave)item->keyword->detail;
    if (pattern->wave != WAVE_POLY || !starts_expression(reader))
        return true;
    if (!read_number(reader, &pattern->exponent))
        return false;
    return pattern->exponent >= EXPONENT_LEAST
           || reader_fault(reader, &item->at, "an exponent below %d",
                           EXPONENT_LEAST);
}

/* The keyword's detail is the member's offset. */
static bool read_amount(struct reader *reader, void *subject,
                        const struct item *item)
{
    struct pattern *pattern = &((struct pigment *)subject)->pattern;
    void *amount = (char *)pattern + item->keyword->detail;

    return read_number(reader, amount);
}

static bool read_brick_size(struct reader *reader, void *subject,
                            const struct item *item)
{
    double *size = ((struct pigment *)subject)->pattern.brick_size;

    if (!read_vector(reader, size))
        return false;
    for (int i = 0; i < 3; i++)
        if (size[i] == 0)
            return reader_fault(reader, &item->at, "a brick without size");
    return true;
}

const struct keyword pattern_words[] = {
    { "frequency", read_amount, offsetof(struct pattern, frequency) },
    { "phase", read_amount, offsetof(struct pattern, phase) },
    { "mortar", read_amount, offsetof(struct pattern, mortar) },
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
    return pattern->wave != WAVE_RAMP || pattern->frequency != 1
           || pattern->phase != 0;
}

/* What a map lets pass is not seen. */
bool pattern_settle(struct reader *reader, struct pigment *pigment,
                    const struct scene_token *at)
{
    struct color_map *map = &pigment->map;
    struct pattern *pattern = &pigment->pattern;
    bool round = pigment->kind == PIGMENT_PATTERN
                 && pattern->function == PATTERN_RADIAL;

    if (map->count == 0
        && !(round ? color_map_round(reader, map)
                   : color_map_gray(reader, map)))
        return false;
    if (pigment->kind == PIGMENT_GRADIENT && is_changed(pattern)) {
        pigment->kind = PIGMENT_PATTERN;
        pattern->function = PATTERN_SLANTED;
    }
    copy3(map->stops[0].color, pigment->color[0]);
    if (map->clear > 0)
        reader_report(reader, at, "a %s that lets light pass is drawn opaque",
                      pigment->kind == PIGMENT_GRADIENT ? "gradient"
                                                        : "pattern");
    pigment->filter[0] = pigment->transmit[0] = 0;
    return true;
}
