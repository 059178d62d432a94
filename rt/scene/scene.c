/* scene.c - a scene from a file: its statements, and what they add up to. */
#include "rt/scene/scene.h"

#include "rt/scene/condition.h"
#include "rt/scene/expression.h"
#include "rt/scene/statement.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

const char *primitive_kind_name(enum primitive_kind kind)
{
    static const char *const names[PRIMITIVE_KINDS] = {
        "sphere",  "box",     "cylinder",
        "plane",   "cone",    "torus",
        "elliptical_torus", "quadric", "quartic",
        "steiner_patch"
    };

    return names[kind];
}

/* POV-Ray 3.7's own, in a scene of #version 3.7. */
static const struct texture texture_default = {
    { PIGMENT_COLOR,
      { { 0, 0, 0 }, { 0, 0, 0 } },
      { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } } },
    { { .1, .1, .1 }, .6, 0, 40, 0, .05 },
};
enum { TRACE_LEVEL_DEFAULT = 5 };

static bool is_sound(const struct part *part)
{
    const struct primitive *primitive = &part->primitive;
    struct placement own = { primitive->to_world, primitive->to_local };
    struct placement pattern = { placement_none.to_world,
                                 primitive->pigment.to_local };

    return placement_is_finite(&own) && placement_is_finite(&pattern);
}

/* Until shadows are cast, the first light that would do so is noted. */
static void note_shadows(struct reader *reader, const struct object *object,
                         const struct token *at)
{
    for (size_t i = 0; i < object->light_count && !reader->shadows; i++)
        if (!object->lights[i].shadowless) {
            reader->shadows = true;
            reader->shadow_light = *at;
        }
}

static bool add_to_world(struct reader *reader, struct object *object,
                         const struct token *at)
{
    size_t first = reader->world.part_count;

    if (!object->textured)
        object->texture = reader->default_texture;
    object->textured = true;
    note_shadows(reader, object, at);
    if (!object_add(&reader->world, object))
        return reader_no_memory(reader);
    for (size_t i = first; i < reader->world.part_count; i++)
        if (!is_sound(&reader->world.parts[i]))
            return reader_fault(reader, at, "a transform is out of range");
    return true;
}

static bool read_object(struct reader *reader, void *subject,
                        const struct item *item)
{
    struct object object;
    bool done;

    (void)subject;
    memset(&object, 0, sizeof object);
    done = shape_read(reader, &object, item)
        && add_to_world(reader, &object, &item->at);
    scene_object_free(&object);
    return done;
}

static bool read_camera(struct reader *reader, void *subject,
                        const struct item *item)
{
    struct camera_setting setting = camera_default;

    (void)subject;
    if (reader->camera_given)
        reader_report(reader, &item->at,
                      "more than one camera: the last is used");
    reader->camera_given = true;
    if (!camera_read(reader, &item->at, &setting))
        return false;
    reader->scene->camera = setting.camera;
    return true;
}

static bool read_settings(struct reader *reader, void *subject,
                          const struct item *item)
{
    (void)subject;
    (void)item;
    return settings_read(reader, reader->scene);
}

static bool read_background(struct reader *reader, void *subject,
                            const struct item *item)
{
    static const struct grammar no_more = { "'}'", { NULL }, NULL };
    struct block block;
    bool good;

    (void)item;
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_rgb(reader, reader->scene->background);
    return block_items(reader, &block, &no_more, subject, good);
}

static const struct keyword statements[] = {
    SHAPE_WORDS(read_object),
    { "camera", read_camera, 0 },
    { "background", read_background, 0 },
    { "global_settings", read_settings, 0 },
    { NULL, NULL, 0 },
};

static const struct keyword left_out[] = {
    { "atmosphere", item_left_out, 0 },
    { "fog", item_left_out, 0 },
    { "media", item_left_out, 0 },
    { "rainbow", item_left_out, 0 },
    { "sky_sphere", item_left_out, 0 },
    { NULL, NULL, 0 },
};

const struct grammar file_grammar = {
    "a statement", { statements, left_out, other_shapes }, NULL
};

static void report_shadows(struct reader *reader)
{
    bool cast = false;

    for (size_t i = 0; i < reader->world.part_count; i++)
        cast = cast || !reader->world.parts[i].primitive.no_shadow;
    if (reader->shadows && cast)
        reader_report(reader, &reader->shadow_light,
                      "shadows are not cast; 'shadowless' in the light or "
                      "'no_shadow' in the objects says so");
}

static bool take_primitives(struct reader *reader)
{
    const struct object *world = &reader->world;
    struct scene *scene = reader->scene;

    scene->primitives = calloc(world->part_count ? world->part_count : 1,
                               sizeof *scene->primitives);
    if (!scene->primitives)
        return reader_no_memory(reader);
    for (size_t i = 0; i < world->part_count; i++) {
        struct primitive *primitive = &scene->primitives[i];
        *primitive = world->parts[i].primitive;
        struct placement placement = { primitive->to_world,
                                       primitive->to_local };
        primitive->transformed = !placement_is_none(&placement);
    }
    scene->primitive_count = world->part_count;
    return true;
}

static bool take_world(struct reader *reader)
{
    struct scene *scene = reader->scene;

    scene->light_count = reader->world.light_count;
    scene->lights = reader->world.lights;
    reader->world.lights = NULL;
    return take_primitives(reader);
}

static struct scene *new_scene(void)
{
    struct scene *scene = calloc(1, sizeof *scene);

    if (!scene)
        return NULL;
    scene->camera = camera_default.camera;
    scene->max_trace_level = TRACE_LEVEL_DEFAULT;
    for (int i = 0; i < 3; i++)
        scene->ambient_light[i] = 1;
    return scene;
}

void scene_free(struct scene *scene)
{
    if (!scene)
        return;
    free(scene->lights);
    free(scene->primitives);
    free(scene);
}

static bool read_all(struct reader *reader, const struct source *source)
{
    struct block file;

    lexer_open(&reader->lexer, source);
    reader_next(reader);
    file = block_file(reader);
    block_items(reader, &file, &file_grammar, NULL, true);
    conditions_close(reader);
    report_shadows(reader);
    return take_world(reader);
}

static struct scene *read_source(struct reader *reader,
                                 const struct source *source)
{
    size_t before = reader->reports->errors;
    struct scene *scene = new_scene();

    reader->scene = scene;
    reader->default_texture = texture_default;
    if (scene
        && (!read_all(reader, source) || reader->reports->errors > before)) {
        scene_free(scene);
        scene = NULL;
    }
    scene_object_free(&reader->world);
    symbols_free(&reader->symbols);
    sources_free(reader->sources);
    return scene;
}

static void cannot_read(struct reports *reports, const char *path)
{
    struct position position = { path, 0, 0, "", 0 };

    reports_add(reports, true, &position, strerror(errno));
}

/* One reader is too large for a caller's stack to be sure of. */
static struct scene *read_from(const char *name, const char *text,
                               const struct scene_options *options,
                               struct reports *reports)
{
    struct reader *reader = calloc(1, sizeof *reader);
    const struct source *source = NULL;
    struct scene *scene = NULL;
    size_t before = reports->errors;

    if (reader) {
        reader->options = options;
        reader->reports = reports;
        source = text
            ? source_add(&reader->sources, name, text, strlen(text))
            : source_load(&reader->sources, name);
    }
    if (source)
        scene = read_source(reader, source);
    if (!scene && reports->errors == before)
        cannot_read(reports, name);
    free(reader);
    return scene;
}

struct scene *scene_read(const char *path, const struct scene_options *options,
                         struct reports *reports)
{
    return read_from(path, NULL, options, reports);
}

struct scene *scene_read_text(const char *name, const char *text,
                              const struct scene_options *options,
                              struct reports *reports)
{
    return read_from(name, text, options, reports);
}
