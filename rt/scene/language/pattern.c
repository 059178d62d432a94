/* pattern.c - parses the patterns of pigments, and their waves and lists. */
#include "rt/scene/language/pattern.h"

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/vector3.h"

enum { MIN_EXPONENT = -100 }; /* keeps the powers of the kernels in range */

/* Sets the pattern. As in POV-Ray, a pigment keeps the wave and the frequency of the
 * pattern that is replaced. */
void pattern_begin(struct pigment *pigment, enum pattern_function function)
{
    pigment->kind = PIGMENT_PATTERN;
    pigment->pattern.function = function;
    pigment->pattern.own = pattern_rules[function].own;
}

bool map_pattern_read(struct reader *reader, const struct item *item)
{
    (void)reader;
    pattern_begin(item->subject, (enum pattern_function)item->keyword->detail);
    return true;
}

/* Reads the list of colours of a pattern such as checker or brick, and makes its colour
 * map of them. The frequency 0 leaves the values of the pattern unchanged. */
static bool read_listed(struct reader *reader, const struct item *item)
{
    const struct pattern_rule *rule = &pattern_rules[item->keyword->detail];
    struct pigment *pigment = item->subject;
    struct numbers colors[MAX_LISTED] = { 0 };
    for (size_t i = 0; i < rule->listed; i++)
        copy3(rule->colors[i], colors[i].n);
    pigment->pattern.frequency = 0;
    return pigment_colors(reader, colors, rule->listed)
           && color_map_listed(reader, colors, rule->listed, &pigment->map);
}

bool list_pattern_read(struct reader *reader, const struct item *item)
{
    return map_pattern_read(reader, item) && read_listed(reader, item);
}

bool checker_pattern_read(struct reader *reader, const struct item *item)
{
    struct pigment *pigment = item->subject;
    pigment->kind = PIGMENT_CHECKER;
    return read_listed(reader, item);
}

static bool read_wave(struct reader *reader, const struct item *item)
{
    struct pattern *pattern = &((struct pigment *)item->subject)->pattern;
    pattern->wave = (enum pattern_wave)item->keyword->detail;
    if (pattern->wave != WAVE_POLY || !starts_expression(reader))
        return true;
    if (!read_number(reader, &pattern->exponent))
        return false;
    return pattern->exponent >= MIN_EXPONENT
           || reader_fault(reader, &item->at, "the exponent must be at least %d",
                           MIN_EXPONENT);
}

static bool read_brick_size(struct reader *reader, const struct item *item)
{
    double *size = ((struct pigment *)item->subject)->pattern.own.brick_size;
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
    { "mortar", item_number, offsetof(struct pigment, pattern.own.mortar) },
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

/* Completes a pigment. Filter and transmit of a map are ignored. */
bool pattern_finish(struct reader *reader, struct pigment *pigment,
                    const struct scene_token *at)
{
    struct color_map *map = &pigment->map;
    struct pattern *pattern = &pigment->pattern;
    bool round = pigment->kind == PIGMENT_PATTERN
                 && pattern_rules[pattern->function].round;
    if (pigment->kind == PIGMENT_CHECKER)
        finish_checker(pigment);
    if (!pigment_has_map(pigment))
        return true;

    if (map->count == 0)
        *map = round ? color_map_round : color_map_gray;
    if (pigment->kind == PIGMENT_GRADIENT && is_changed(pattern)) {
        pigment->kind = PIGMENT_PATTERN;
        pattern->function = PATTERN_GRADIENT;
    }
    copy3(map->stops[0].color, pigment->color[0]);
    if (map->clear > 0)
        reader_report(reader, at, "a transparent %s is drawn opaque",
                      pigment->kind == PIGMENT_GRADIENT ? "gradient" : "pattern");
    pigment->filter[0] = pigment->transmit[0] = 0;
    return true;
}
