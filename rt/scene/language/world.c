/* world.c - parses the statements of a scene file and builds the scene. */
#include "rt/scene/language/scene_read.h"

#include "rt/scene/language/condition.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"
#include "rt/scene/language/scene_unit.h"
#include "rt/shapes/coincident.h"
#include "rt/shapes/shape_words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The defaults of POV-Ray 3.7 for a scene with #version 3.7. */
static const struct texture texture_default = {
    .pigment = { .kind = PIGMENT_COLOR,
                 .to_local = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } },
                 .pattern = { .frequency = 1, .exponent = 1 } },
    .bumps = { .to_local = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } } },
    .finish = { .ambient = { .1, .1, .1 },
                .reflection_falloff = 1,
                .diffuse = .6,
                .brilliance = 1,
                .phong_size = 40,
                .roughness = .05 },
};
enum { TRACE_LEVEL_DEFAULT = 5 };
#define LANGUAGE_VERSION 3.7

/* Returns true if the space of the bumps has an inverse. Normals are mapped to the
 * space and back. */
static bool has_space(const struct bumps *bumps)
{
    struct placement placement = { .to_local = bumps->to_local };
    return !bumps_show(bumps)
           || (transform_invert(&placement.to_local, &placement.to_world)
               && placement_is_finite(&placement));
}

static bool same_name(const char *one, const char *other)
{
    return one && other ? strcmp(one, other) == 0 : one == other;
}

static bool check_part(struct reader *reader, const struct scene_part *part,
                       const struct scene_token *at)
{
    const struct primitive *primitive = &part->primitive;
    struct placement own = { primitive->to_world, primitive->to_local };
    struct placement pattern = { placement_none.to_world, primitive->pigment.to_local };
    if (!placement_is_finite(&own) || !placement_is_finite(&pattern)
        || !has_space(&primitive->bumps))
        return reader_fault(reader, at, "a transform is out of range");
    return true;
}

/* Determines the material of an object from its parts. Inverted parts are ignored,
 * because only their texture is visible. */
static void find_material(const struct scene_part *parts, size_t count,
                          struct world_object *object)
{
    bool found = false;
    for (size_t i = 0; i < count; i++) {
        if (parts[i].primitive.inverted)
            continue;
        if (!found)
            object->material = parts[i].material;
        else if (!same_name(object->material, parts[i].material))
            object->mixed = true;
        found = true;
    }
}

/* Adds the name and the material of an object to the scene's list of objects. */
static bool add_world_object(struct reader *reader, size_t first,
                             const struct scene_object *object,
                             const struct scene_token *at)
{
    struct scene *scene = reader->scene;
    const struct scene_part *parts = reader->world.parts;
    struct world_object entry = { .name = object->name, .line = at->main_line };
    find_material(parts + first, reader->world.part_count - first, &entry);
    return arena_add(&scene->kept, &scene->objects, &scene->object_count,
                     &reader->objects_room, &entry, sizeof entry)
           || reader_no_memory(reader);
}

/* Removes a primitive whose numbers exceed the machine's range. */
static void leave_out_extremes(struct reader *reader, struct primitive *primitive,
                               const struct scene_token *at)
{
    struct placement own = { primitive->to_world, primitive->to_local };
    char reason[80];
    primitive->transformed = !placement_is_none(&own);
    if (primitive->empty || !placement_is_finite(&own) || shape_is_finite(primitive))
        return;
    snprintf(reason, sizeof reason, "the %s is too large or too small to be traced",
             primitive_kind_name(primitive->kind));
    primitive_leave_out(reader, primitive, at, reason);
}

/* Removes empty parts, and parts whose numbers exceed the machine's range. Patches are
 * tessellated first, to find out whether they are empty. */
static bool prune(struct reader *reader, struct scene_object *object,
                  const struct scene_token *at)
{
    for (size_t i = 0; i < object->part_count; i++)
        if (object->parts[i].patch && !bicubic_patch_cut(reader, &object->parts[i], at))
            return false;
    for (size_t i = 0; i < object->part_count; i++)
        leave_out_extremes(reader, &object->parts[i].primitive, at);
    object_prune(object);
    return true;
}

static bool add_to_world(struct reader *reader, struct scene_object *object,
                         const struct scene_token *at)
{
    size_t first = reader->world.part_count;
    if (!object->textured)
        object->texture = reader->default_texture;
    object->textured = true;
    if (!object->filled)
        object_fill(reader, object, 1);
    if (!prune(reader, object, at))
        return false;
    if (!object_add(&reader->world, object))
        return reader_no_memory(reader);
    for (size_t i = first; i < reader->world.part_count; i++) {
        struct scene_part *part = &reader->world.parts[i];
        part->primitive.object = reader->scene->object_count;
        if (part->smooth_field && !height_field_place(reader, part))
            return false;
        if (!check_part(reader, part, at))
            return false;
    }
    return reader->world.part_count == first
           || add_world_object(reader, first, object, at);
}

static bool read_object(struct reader *reader, const struct item *item)
{
    struct scene_object object = { 0 };
    bool done = shape_read(reader, &object, item)
                && add_to_world(reader, &object, &item->at);
    scene_object_free(&object);
    return done;
}

static bool read_camera(struct reader *reader, const struct item *item)
{
    struct camera_setting setting = camera_default;
    if (reader->camera_given)
        reader_report(reader, &item->at, "more than one camera: the last is used");
    reader->camera_given = true;
    if (!camera_read(reader, &item->at, &setting))
        return false;
    reader->scene->camera = setting.camera;
    return true;
}

static bool read_sky(struct reader *reader, const struct item *item)
{
    struct sky_setting sky;
    if (!sky_read(reader, &sky))
        return false;
    sky_take(reader, &sky, &item->at);
    return true;
}

static bool read_fog(struct reader *reader, const struct item *item)
{
    struct fog_setting fog;
    return fog_read(reader, &fog) && fog_take(reader, &fog, &item->at);
}

static bool read_background(struct reader *reader, const struct item *item)
{
    struct block block;
    bool good;
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_rgb(reader, reader->scene->background);
    return block_items(reader, &block, &no_words, item->subject, good);
}

static const struct keyword statements[] = {
    { "", read_object, SHAPE_NAMED },
    { "declare include version", item_unmarked, 0 },
    { "camera", read_camera, 0 },
    { "background", read_background, 0 },
    { "default", default_read, 0 },
    { "global_settings", settings_read, 0 },
    { "sky_sphere", read_sky, 0 },
    { "fog", read_fog, 0 },
    { "atmosphere media rainbow", item_left_out, 0 },
    { NULL, NULL, 0 },
};

const struct grammar file_grammar = { "a statement",
                                      { statements },
                                      .object = read_object };

static bool take_primitives(struct reader *reader)
{
    const struct scene_object *world = &reader->world;
    struct scene *scene = reader->scene;
    scene->primitives = calloc(world->part_count ? world->part_count : 1,
                               sizeof *scene->primitives);
    if (!scene->primitives)
        return reader_no_memory(reader);
    for (size_t i = 0; i < world->part_count; i++)
        scene->primitives[i] = world->parts[i].primitive;
    scene->primitive_count = world->part_count;
    return true;
}

/* Copies the Boolean trees of the world to the nodes of the scene. The leaves refer to
 * the primitives in order. */
static void fill_nodes(struct scene *scene, const struct scene_object *world)
{
    size_t leaf = 0;
    for (size_t i = 0; i < world->branch_count; i++) {
        struct tree_node *node = &scene->nodes[i];
        node->operation = world->branches[i].operation;
        node->next = i + world->branches[i].size;
        if (node->operation == TREE_LEAF)
            node->primitive = leaf++;
    }
    scene->node_count = world->branch_count;
}

/* Makes a region of each solid of the world. */
static void fill_regions(struct scene *scene)
{
    size_t leaf = 0;
    for (size_t i = 0; i < scene->node_count;) {
        struct region *region = &scene->regions[scene->region_count++];
        region->first_primitive = leaf;
        region->first_node = i;
        region->node_count = scene->nodes[i].next - i;
        region->line = scene->primitives[leaf].line;
        for (; i < region->first_node + region->node_count; i++)
            leaf += scene->nodes[i].operation == TREE_LEAF;
        region->primitive_count = leaf - region->first_primitive;
    }
}

static bool take_regions(struct reader *reader)
{
    struct scene *scene = reader->scene;
    scene->nodes = calloc(reader->world.branch_count + 1, sizeof *scene->nodes);
    scene->regions = calloc(scene->primitive_count + 1, sizeof *scene->regions);
    if (!scene->nodes || !scene->regions)
        return reader_no_memory(reader);
    fill_nodes(scene, &reader->world);
    fill_regions(scene);
    return true;
}

/* ---- Named floats -------------------------------------------------------- */

static void keep_float(void *context, const char *name, size_t length,
                       const struct scene_value *value)
{
    if (value->kind == VALUE_NUMBERS && value->is.numbers.count == 1)
        reader_keep_float(context, name, length, value->is.numbers.n[0]);
}

static bool take_floats(struct reader *reader)
{
    symbols_walk(&reader->symbols, keep_float, reader);
    return !reader->scene->kept.failed || reader_no_memory(reader);
}

/* Reports all transparent bodies in a scene with fog, because it is unknown during
 * parsing which rays are inside a body. */
static void report_fogged_bodies(struct reader *reader)
{
    const struct scene *scene = reader->scene;
    for (size_t i = 0; scene->fog_count > 0 && i < scene->primitive_count; i++)
        if (pigment_is_clear(&scene->primitives[i].pigment)) {
            reader_report(reader, &reader->fog,
                          "fog also fills transparent objects; POV-Ray fills "
                          "only hollow ones");
            return;
        }
}

static bool take_world(struct reader *reader)
{
    struct scene *scene = reader->scene;
    bool done;
    if (!unit_choose(scene, &reader->world))
        reader_warn(reader, &reader->token,
                    "the objects are smaller than 1e-60 or larger than 1e60: "
                    "surfaces and shadows may be lost");
    scene->light_count = reader->world.light_count;
    scene->lights = reader->world.lights;
    reader->world.lights = NULL;
    done = take_primitives(reader) && take_regions(reader)
           && (coincident_find(scene) || reader_no_memory(reader));
    report_fogged_bodies(reader);
    return done;
}

static struct scene *new_scene(void)
{
    struct scene *scene = calloc(1, sizeof *scene);
    if (!scene)
        return NULL;
    scene->camera = camera_default.camera;
    scene->max_trace_level = TRACE_LEVEL_DEFAULT;
    scene->adc_bailout = 1.0 / 255;
    for (int i = 0; i < 3; i++)
        scene->ambient_light[i] = 1;
    return scene;
}

/* Switches gamma correction off for versions below 3.7 without assumed_gamma. As in
 * POV-Ray, the version at the end of the text counts. */
static void decide_gamma(struct reader *reader, const struct scene_source *source)
{
    struct scene_token at = reader->version_at;
    if (reader->fault_count > 0 || reader->scene->assumed_gamma > 0
        || !reader_is_before(reader, 3.7))
        return;
    if (!at.source) {
        at.source = source;
        at.place.line = 1;
    }
    reader->scene->gamma_off = true;
    reader_warn(reader, &at,
                "the version is below 3.7 and assumed_gamma is not given: "
                "colours are displayed without gamma correction");
}

static bool read_all(struct reader *reader, const struct scene_source *source)
{
    struct block file;
    lexer_open(&reader->lexer, source);
    reader_next(reader);
    file = block_file(reader);
    block_items(reader, &file, &file_grammar, NULL, true);
    conditions_close(reader);
    decide_gamma(reader, source);
    return take_world(reader) && take_floats(reader);
}

static bool report_notes(struct reader *reader)
{
    bool strict = reader->options && reader->options->strict;
    if (warnings_failed(&reader->warnings))
        return reader_no_memory(reader);
    warnings_report(&reader->warnings, strict ? SEVERITY_ERROR : SEVERITY_REPORT,
                    reader->reports);
    return true;
}

static struct scene *read_source(struct reader *reader,
                                 const struct scene_source *source)
{
    size_t before = reader->reports->errors;
    struct scene *scene = new_scene();
    bool done;
    reader->scene = scene;
    reader->default_texture = texture_default;
    reader->hold = (size_t)HOLD_NONE;
    reader->version = LANGUAGE_VERSION;
    done = scene && read_all(reader, source);
    if (!report_notes(reader) || !done || reader->reports->errors > before) {
        scene_free(scene);
        scene = NULL;
    }
    warnings_free(&reader->warnings);
    arena_free(&reader->arena);
    scene_object_free(&reader->world);
    symbols_free(&reader->symbols);
    queries_free(reader);
    sources_free(reader->sources);
    return scene;
}

static void cannot_read(struct diagnostics *reports, const char *path,
                        const char *reason)
{
    struct position position = { path, 0, 0, "", 0 };
    diagnostics_add(reports, SEVERITY_ERROR, &position, reason);
}

/* Reads a scene from a text, or from a file if `text` is NULL. The reader is on the
 * heap, because it is too large for the stack. */
static struct scene *read_from(const char *name, const char *text,
                               const struct scene_options *options,
                               struct diagnostics *reports)
{
    struct reader *reader = calloc(1, sizeof *reader);
    const struct scene_source *source = NULL;
    struct scene *scene = NULL;
    c205_error error = { "there is not enough memory" };
    size_t before = reports->errors;
    if (reader) {
        reader->options = options;
        reader->reports = reports;
        source = text ? source_add(&reader->sources, name, text, strlen(text), &error)
                      : source_load(&reader->sources, name, &error);
    }
    if (source)
        scene = read_source(reader, source);
    if (!scene && reports->errors == before)
        cannot_read(reports, name, error.message);
    free(reader);
    return scene;
}

struct scene *scene_read(const char *path, const struct scene_options *options,
                         struct diagnostics *reports)
{
    return read_from(path, NULL, options, reports);
}

struct scene *scene_read_text(const char *name, const char *text,
                              const struct scene_options *options,
                              struct diagnostics *reports)
{
    return read_from(name, text, options, reports);
}
