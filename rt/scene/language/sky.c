/* sky.c - parses sky_sphere { ... }, the background of rays that hit nothing. */
#include "rt/scene/language/scene_statement.h"

/* Reads a pigment. If there are several, the first is the lowest layer, as in
 * POV-Ray. */
static bool read_pigment(struct reader *reader, const struct item *item)
{
    struct pigment pigment = reader->default_texture.pigment;
    struct sky_setting *sky = item->subject;
    if (sky->pigments++ == 1)
        reader_report(reader, &item->at,
                      "layered pigments are not supported; the lowest one "
                      "is used instead");
    if (!pigment_read(reader, &pigment))
        return false;
    if (sky->pigments == 1)
        sky->pigment = pigment;
    return true;
}

static const struct keyword words[] = {
    { "pigment", read_pigment, 0 },
    { "emission", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of sky_sphere",
                                        { words },
                                        .move = pigment_move };

bool sky_read(struct reader *reader, struct sky_setting *sky)
{
    *sky = (struct sky_setting){ .pigment = reader->default_texture.pigment };
    return block_read_from(reader, &grammar, VALUE_SKY, sky, sizeof *sky);
}

/* Adds a sky to the scene. A sky of a single colour becomes the background. */
void sky_take(struct reader *reader, const struct sky_setting *sky,
              const struct scene_token *at)
{
    const struct pigment *pigment = &sky->pigment;
    struct scene *scene = reader->scene;
    if (sky->pigments == 0)
        return;
    scene->sky = *pigment;
    if (pigment->kind == PIGMENT_IMAGE && image_is_bounded(&pigment->image)) {
        reader_report(reader, at,
                      "'once' of a sky image is not supported; the image is repeated");
        scene->sky.image.once = false;
    }
    if (pigment_makes_sky(pigment))
        return;
    if (pigment->kind == PIGMENT_CHECKER)
        reader_report(reader, at,
                      "a checkered sky is not supported; its first colour "
                      "is used instead");
    if (pigment->filter[0] != 0 || pigment->transmit[0] != 0)
        reader_report(reader, at, "a transparent sky is drawn opaque");
    for (int i = 0; i < 3; i++)
        scene->background[i] = pigment->color[0][i];
}
