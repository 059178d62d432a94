/* sky.c - sky_sphere { ... }: what is seen where nothing is hit. */
#include "rt/scene/language/statement.h"

struct sky_reading {
    struct pigment pigment;
    size_t pigments;
};

/* Of several the first lies lowest, as in POV-Ray. */
static bool read_pigment(struct reader *reader, void *subject,
                         const struct item *item)
{
    struct pigment pigment = reader->default_texture.pigment;
    struct sky_reading *sky = subject;

    if (sky->pigments++ == 1)
        reader_report(reader, &item->at,
                      "pigments in layers are not supported: only the lowest "
                      "is used");
    if (!pigment_read(reader, &pigment))
        return false;
    if (sky->pigments == 1)
        sky->pigment = pigment;
    return true;
}

static bool read_step(struct reader *reader, void *subject,
                      const struct item *item)
{
    struct sky_reading *sky = subject;
    struct placement step;

    if (!step_read(reader, item, &step))
        return false;
    pigment_move(&sky->pigment, &step);
    return true;
}

static const struct keyword words[] = {
    { "pigment", read_pigment, 0 },
    { "emission", item_left_out, 0 },
    STEP_WORDS(read_step),
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a word of sky_sphere",
                                        { words },
                                        NULL };

/* A sky of one colour is a background. */
static void take_sky(struct reader *reader, const struct pigment *sky,
                     const struct scene_token *at)
{
    struct scene *scene = reader->scene;

    scene->sky = *sky;
    if (pigment_has_map(sky))
        return;
    if (sky->kind == PIGMENT_CHECKER)
        reader_report(reader, at,
                      "a checkered sky is replaced by its first colour");
    if (sky->filter[0] != 0 || sky->transmit[0] != 0)
        reader_report(reader, at,
                      "a sky that lets light pass is drawn opaque");
    for (int i = 0; i < 3; i++)
        scene->background[i] = sky->color[0][i];
}

/* One with a name is a look, which is not drawn. */
bool sky_read(struct reader *reader, const struct scene_token *at)
{
    struct sky_reading sky = { .pigment = reader->default_texture.pigment };
    struct block block;

    if (!block_open(reader, &block, '{'))
        return false;
    if (reader_use(reader, VALUE_LOOK)) {
        reader_report(reader, at,
                      "'sky_sphere' is not supported and left out");
        return block_finish(reader, &block);
    }
    if (!block_items(reader, &block, &grammar, &sky, true))
        return false;
    if (sky.pigments > 0)
        take_sky(reader, &sky.pigment, at);
    return true;
}
