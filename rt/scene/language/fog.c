/* fog.c - parses fog { ... } and adds constant fogs to the scene. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"

#include <string.h>

static bool read_type(struct reader *reader, const struct item *item)
{
    struct fog_setting *reading = item->subject;
    double type;
    if (!read_number(reader, &type))
        return false;
    reading->grounded = type == 2;
    return type == 1 || type == 2
           || reader_fault(reader, &item->at, "fog_type must be 1 or 2");
}

static void set_color(struct fog *fog, const struct numbers *color)
{
    memcpy(fog->color, color->n, sizeof fog->color);
    fog->filter = color->n[3];
    fog->transmit = color->n[4];
}

static bool read_fog_color(struct reader *reader, const struct item *item)
{
    struct fog_setting *reading = item->subject;
    struct numbers color;
    if (!read_color_after(reader, &item->at, &color))
        return false;
    set_color(&reading->fog, &color);
    return true;
}

static const struct keyword words[] = {
    { "distance", item_number, offsetof(struct fog_setting, fog.distance) },
    { "fog_type", read_type, 0 },
    { COLOR_WORDS, read_fog_color, 0 },
    /* Keywords of ground fog and of turbulence. Only the keyword `turbulence` itself is
     * reported. */
    { "fog_alt fog_offset lambda octaves omega turb_depth up", item_ignored, 0 },
    { "turbulence", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of fog", .tables = { words } };

/* Reads the optional name of a colour at the start of a fog block. */
static bool read_first_color(struct reader *reader, struct fog *fog)
{
    struct numbers color;
    if (!starts_color(reader) || is_color_word(&reader->token))
        return true;
    if (!read_color(reader, &color))
        return false;
    set_color(fog, &color);
    return true;
}

bool fog_read(struct reader *reader, struct fog_setting *fog)
{
    struct block block;
    *fog = (struct fog_setting){ .fog = { .distance = 0 } };
    return block_open_from(reader, &block, VALUE_FOG, fog, sizeof *fog)
           && block_items(reader, &block, &grammar, fog,
                          read_first_color(reader, &fog->fog));
}

bool fog_take(struct reader *reader, const struct fog_setting *setting,
              const struct scene_token *at)
{
    struct scene *scene = reader->scene;
    if (setting->grounded) {
        reader_report(reader, at, "a fog of type 2 is not supported and is ignored");
        return true;
    }
    if (setting->fog.distance == 0)
        return true; /* no fog, as in POV-Ray */
    if (setting->fog.distance < 0) {
        reader_report(reader, at, "a fog with a distance below 0 is ignored");
        return true;
    }
    if (scene->fog_count == MAX_FOGS)
        return reader_fault(reader, at, "more than %d fogs", MAX_FOGS);
    if (scene->fog_count == 0)
        reader->fog = *at;
    scene->fogs[scene->fog_count++] = setting->fog;
    return true;
}
