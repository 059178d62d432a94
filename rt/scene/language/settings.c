/* settings.c - parses global_settings { ... }. */
#include "rt/scene/language/scene_statement.h"

#include "rt/scene/language/scene_expression.h"

static bool read_gamma(struct reader *reader, const struct item *item)
{
    struct scene *scene = item->subject;
    if (reader_accept(reader, "srgb")) {
        reader_report(reader, &item->at,
                      "assumed_gamma srgb is not supported; 2.2 is used instead");
        scene->assumed_gamma = 2.2;
        return true;
    }
    return item_above_0(reader, item);
}

static bool read_trace_level(struct reader *reader, const struct item *item)
{
    enum { MIN_LEVEL = 1, MAX_LEVEL = 256 };
    struct scene *scene = item->subject;
    double level;
    if (!read_number(reader, &level))
        return false;
    if (level < MIN_LEVEL || level > MAX_LEVEL)
        return reader_fault(reader, &item->at,
                            "max_trace_level must be between %d and %d", MIN_LEVEL,
                            MAX_LEVEL);
    scene->max_trace_level = (int)level;
    return true;
}

static bool read_charset(struct reader *reader, const struct item *item)
{
    reader_report(reader, &item->at, "'charset' is not supported and is ignored");
    if (reader->token.kind != TOKEN_WORD)
        return reader_expected(reader, "ascii, utf8 or sys");
    reader_next(reader);
    return true;
}

static const struct keyword words[] = {
    { "assumed_gamma", read_gamma, offsetof(struct scene, assumed_gamma) },
    { "ambient_light", item_rgb, offsetof(struct scene, ambient_light) },
    { "max_trace_level", read_trace_level, 0 },
    { "adc_bailout", item_number, offsetof(struct scene, adc_bailout) },
    { "charset", read_charset, 0 },
    /* Keywords for noise, iridescence and the internals of POV-Ray, which have no
     * effect here. */
    { "hf_gray_16 irid_wavelength max_intersections mm_per_unit noise_generator "
      "number_of_waves",
      item_ignored, 0 },
    { "photons radiosity subsurface", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of global_settings",
                                        .tables = { words } };

bool settings_read(struct reader *reader, const struct item *item)
{
    (void)item;
    return block_read(reader, &grammar, reader->scene);
}
