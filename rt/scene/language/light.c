/* light.c - parses light_source { ... }. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"

#include <string.h>

#include "rt/scene/vector3.h"

/* A negative tightness brightens a beam towards its edge. The limit keeps the powers of
 * the kernels in range. */
enum { MIN_TIGHTNESS = -100 };

/* Sets a member of all lights of the subject. The keyword's detail is the offset of the
 * member. */
static void set_member(const struct item *item, const void *value, size_t size)
{
    const struct scene_object *object = item->subject;
    for (size_t i = 0; i < object->light_count; i++)
        memcpy((char *)&object->lights[i] + item->keyword->detail, value, size);
}

/* Sets the kind of lights without shadows. As in POV-Ray, a light has only one kind:
 * the last that is named. The rays of a light that was a cylinder stay parallel. */
static bool read_shadowless(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    (void)reader;
    for (size_t i = 0; i < object->light_count; i++) {
        object->lights[i].shadowless = true;
        object->lights[i].beam = BEAM_NONE;
    }
    return true;
}

/* Reads the object of looks_like. It casts no shadow and, as in POV-Ray, is visible to
 * all rays. */
static bool read_looks_like(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject, look = { 0 };
    bool done;
    if (!object->light_count)
        return false;
    done = looks_like_read(reader, &look, object->lights[0].position);
    for (size_t i = 0; i < look.part_count; i++)
        look.parts[i].primitive.no_shadow = true;
    object_show(&look);
    if (done && !object_add(object, &look))
        done = reader_no_memory(reader);
    scene_object_free(&look);
    return done;
}

/* Makes lights cones or cylinders, with the default edges that were measured in
 * POV-Ray. */
static bool read_beam(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    bool cone = item->keyword->detail == BEAM_CONE;
    (void)reader;
    for (size_t i = 0; i < object->light_count; i++) {
        struct light *light = &object->lights[i];
        light->shadowless = false;
        light->beam = cone ? BEAM_CONE : BEAM_CYLINDER;
        light->parallel = light->parallel || !cone;
        light->radius = cone ? 30 : .75;
        light->falloff = cone ? 45 : 1;
        light->tightness = 0;
    }
    return true;
}

static bool read_flag(struct reader *reader, const struct item *item)
{
    bool on = true;
    (void)reader;
    set_member(item, &on, sizeof on);
    return true;
}

static bool read_point_at(struct reader *reader, const struct item *item)
{
    double point[3];
    if (!read_vector(reader, point))
        return false;
    set_member(item, point, sizeof point);
    return true;
}

static bool read_fading(struct reader *reader, const struct item *item)
{
    double number;
    if (!read_number(reader, &number))
        return false;
    set_member(item, &number, sizeof number);
    return true;
}

/* Reads a parameter of a beam. As in POV-Ray, the kind of the beam must precede its
 * parameters. */
static bool read_measure(struct reader *reader, const struct item *item)
{
    const struct scene_object *object = item->subject;
    for (size_t i = 0; i < object->light_count; i++)
        if (object->lights[i].beam == BEAM_NONE)
            return reader_fault(reader, &item->at,
                                "'%s' requires 'spotlight' or 'cylinder' before it",
                                item->keyword->words);
    return read_fading(reader, item);
}

/* Reads the number of points along a side of an area light. As in POV-Ray, it is
 * truncated. */
static bool read_side(struct reader *reader, const struct item *item, size_t *size)
{
    double number;
    reader_comma(reader);
    if (!read_number(reader, &number))
        return false;
    if (!(number >= 1 && number <= MAX_AREA_POINTS))
        return reader_fault(reader, &item->at,
                            "the points along a side of an area_light must be "
                            "between 1 and %d",
                            MAX_AREA_POINTS);
    *size = (size_t)number;
    return true;
}

static bool read_area(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    double axes[2][3];
    size_t size[2] = { 0, 0 };
    if (!read_vectors(reader, axes, 2) || !read_side(reader, item, &size[0])
        || !read_side(reader, item, &size[1]))
        return false;
    if (size[0] * size[1] > MAX_AREA_POINTS)
        return reader_fault(reader, &item->at,
                            "an area_light has %zu points, but at most %d are allowed",
                            size[0] * size[1], MAX_AREA_POINTS);
    for (size_t i = 0; i < object->light_count; i++) {
        memcpy(object->lights[i].area_axes, axes, sizeof axes);
        memcpy(object->lights[i].area_size, size, sizeof size);
    }
    return true;
}

static const struct keyword words[] = {
    { "area_light", read_area, 0 },
    { "circular", read_flag, offsetof(struct light, circular) },
    { "shadowless", read_shadowless, 0 },
    { "looks_like", read_looks_like, 0 },
    { "spotlight", read_beam, BEAM_CONE },
    { "cylinder", read_beam, BEAM_CYLINDER },
    { "parallel", read_flag, offsetof(struct light, parallel) },
    { "point_at", read_point_at, offsetof(struct light, point_at) },
    { "radius", read_measure, offsetof(struct light, radius) },
    { "falloff", read_measure, offsetof(struct light, falloff) },
    { "tightness", read_measure, offsetof(struct light, tightness) },
    { "fade_distance", read_fading, offsetof(struct light, fade_distance) },
    { "fade_power", read_fading, offsetof(struct light, fade_power) },
    /* item_ignored: features that are reported at other keywords, and adaptive
     * sampling, which is not needed because all points of an area are used. */
    { "adaptive media_attenuation media_interaction photons", item_ignored, 0 },
    { "area_illumination jitter orient projected_through", item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of light_source",
                                        { words },
                                        .move = object_move };

static bool read_point(struct reader *reader, struct scene_object *object)
{
    struct light light = { .point_at = { 0, 0, 1 } }; /* POV-Ray's default */
    if (!read_vector(reader, light.position))
        return false;
    reader_comma(reader);
    if (!read_rgb(reader, light.color))
        return false;
    return object_add_light(object, &light) || reader_no_memory(reader);
}

/* Checks the beams of lights. A light with an axis must not be at the point to which
 * the axis points. */
static bool check_beams(struct reader *reader, const struct scene_object *object,
                        const struct scene_token *at)
{
    for (size_t i = 0; i < object->light_count; i++) {
        const struct light *light = &object->lights[i];
        double way[3];
        subtract3(light->point_at, light->position, way);
        if ((light->beam != BEAM_NONE || light->parallel) && !(length3(way) > 0))
            return reader_fault(reader, at,
                                "the location and point_at of the light are the same");
        if (light->tightness < MIN_TIGHTNESS)
            return reader_fault(reader, at, "the tightness must be at least %d",
                                MIN_TIGHTNESS);
        if (light->beam == BEAM_CYLINDER && !(light->falloff > 0))
            return reader_fault(reader, at,
                                "the falloff of a cylinder light must be above 0");
    }
    return true;
}

/* Reports an error for an area light that POV-Ray rejects, too. */
static bool check_areas(struct reader *reader, const struct scene_object *object,
                        const struct scene_token *at)
{
    for (size_t i = 0; i < object->light_count; i++) {
        const struct light *light = &object->lights[i];
        const size_t *size = light->area_size;
        if (light->circular && (size[0] == 1 || size[1] == 1))
            return reader_fault(reader, at,
                                "a circular area_light must have at least 2 points "
                                "along each side");
    }
    return true;
}

/* Ignores the area of a light with parallel rays, because its effect in POV-Ray is not
 * understood. */
static void leave_out_areas(struct reader *reader, struct scene_object *object,
                            const struct scene_token *at)
{
    for (size_t i = 0; i < object->light_count; i++) {
        struct light *light = &object->lights[i];
        if (light->parallel && light->area_size[0] > 0) {
            light->area_size[0] = light->area_size[1] = 0;
            reader_report(reader, at,
                          "'area_light' is not supported for a parallel light "
                          "and is ignored");
        }
    }
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
        value_warnings_use(&reader->warnings, value->value_warnings);
        good = shape_copy(reader, object, &value->is.object);
        reader_next(reader);
    } else {
        good = shape_count(reader, 1, &block.open) && read_point(reader, object);
    }
    object->is_light = true;
    if (!block_items(reader, &block, &grammar, object, good)
        || !check_beams(reader, object, &block.open)
        || !check_areas(reader, object, &block.open))
        return false;
    leave_out_areas(reader, object, &block.open);
    return true;
}
