/* light.c - light_source: point lights. */
#include "rt/scene/language/expression.h"
#include "rt/scene/language/statement.h"

#include <string.h>

static bool read_shadowless(struct reader *reader, void *subject,
                            const struct item *item)
{
    struct scene_object *object = subject;

    (void)reader;
    (void)item;
    for (size_t i = 0; i < object->light_count; i++)
        object->lights[i].shadowless = true;
    return true;
}

static bool read_step(struct reader *reader, void *subject,
                      const struct item *item)
{
    struct placement step;

    if (!step_read(reader, item, &step))
        return false;
    object_move(subject, &step);
    return true;
}

/* It does not stand in the way of its light. */
static bool read_looks_like(struct reader *reader, void *subject,
                            const struct item *item)
{
    struct scene_object *object = subject, look;
    bool done;

    (void)item;
    if (!object->light_count)
        return false;
    memset(&look, 0, sizeof look);
    done = looks_like_read(reader, &look, object->lights[0].position);
    for (size_t i = 0; i < look.part_count; i++)
        look.parts[i].primitive.no_shadow = true;
    if (done && !object_add(object, &look))
        done = reader_no_memory(reader);
    scene_object_free(&look);
    return done;
}

static const struct keyword words[] = {
    { "shadowless", read_shadowless, 0 },
    { "looks_like", read_looks_like, 0 },
    STEP_WORDS(read_step),
    { NULL, NULL, 0 },
};

/* Words of lights that are not supported, which are reported. */
static const struct keyword passed_over[] = {
    { "adaptive", item_passed_over, 0 },
    { "area_illumination", item_passed_over, 0 },
    { "circular", item_passed_over, 0 },
    { "falloff", item_passed_over, 0 },
    { "jitter", item_passed_over, 0 },
    { "media_attenuation", item_passed_over, 0 },
    { "media_interaction", item_passed_over, 0 },
    { "orient", item_passed_over, 0 },
    { "photons", item_passed_over, 0 },
    { "point_at", item_passed_over, 0 },
    { "radius", item_passed_over, 0 },
    { "tightness", item_passed_over, 0 },
    { NULL, NULL, 0 },
};

static const struct keyword left_out[] = {
    { "area_light", item_left_out, 0 },
    { "cylinder", item_left_out, 0 },
    { "fade_distance", item_left_out, 0 },
    { "fade_power", item_left_out, 0 },
    { "parallel", item_left_out, 0 },
    { "projected_through", item_left_out, 0 },
    { "spotlight", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a word of light_source",
                                        { words, passed_over, left_out },
                                        NULL };

static bool read_point(struct reader *reader, struct scene_object *object)
{
    struct light light;

    memset(&light, 0, sizeof light);
    if (!read_vector(reader, light.position))
        return false;
    reader_comma(reader);
    if (!read_rgb(reader, light.color))
        return false;
    return object_add_light(object, &light) || reader_no_memory(reader);
}

bool light_read(struct reader *reader, struct scene_object *object)
{
    const struct scene_value *value;
    struct block block;
    bool good;

    if (!block_open(reader, &block, '{'))
        return false;
    value = reader_value_of(reader, VALUE_OBJECT);
    if (value && value->is.object.is_light) {
        notes_use(&reader->notebook, value->notes);
        good = shape_copy(reader, object, &value->is.object);
        reader_next(reader);
    } else {
        good = read_point(reader, object);
    }
    object->is_light = true;
    return block_items(reader, &block, &grammar, object, good);
}
