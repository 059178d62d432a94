/* form.c - selects and assembles the kernels that a scene needs. */
#include "rt/trace/form.h"

#include <stdio.h>
#include <string.h>

#include "rt/layout/bumps.h"
#include "rt/layout/images.h"
#include "rt/layout/interiors.h"
#include "rt/layout/lights.h"
#include "rt/layout/pigment.h"
#include "rt/layout/program.h"
#include "rt/layout/regions.h"
#include "rt/layout/surface.h"
#include "rt/layout/trees.h"
#include "rt/shapes/blob.h"
#include "rt/shapes/shape.h"

static const struct form {
    const char *name, *program;
} forms[TRACE_MODES] = {
    [TRACE_SCALAR] = { "scalar", "frame/frame_scalar.s" },
    [TRACE_VECTOR] = { "vector", "frame/frame_vector.s" },
    [TRACE_KERNELS] = { "kernels", "frame/frame_1984.s" },
};

const char *trace_mode_name(enum trace_mode mode)
{
    return forms[mode].name;
}

const char *form_program(enum trace_mode mode)
{
    return forms[mode].program;
}

bool trace_mode_named(const char *name, enum trace_mode *mode)
{
    for (int i = 0; i < TRACE_MODES; i++)
        if (strcmp(name, forms[i].name) == 0) {
            *mode = (enum trace_mode)i;
            return true;
        }
    return false;
}

enum trace_mode trace_mode_besides(enum trace_mode mode)
{
    return mode == TRACE_VECTOR ? TRACE_VECTOR : TRACE_SCALAR;
}

const char *order_name(enum trace_order order)
{
    static const char *const orders[ORDERS] = {
        [ORDER_DEFAULT] = "default",
        [ORDER_ROWS] = "rows",
        [ORDER_TILES] = "tiles",
    };
    return orders[order];
}

const char *visible_name(enum visible method)
{
    static const char *const methods[CSG_METHODS] = {
        [VISIBLE_DEFAULT] = "default",
        [VISIBLE_STEPPING] = "stepping",
        [VISIBLE_EVERY] = "every",
    };
    return methods[method];
}

/* The value of MAX_CROSSINGS with which kernels are assembled if no shape needs more
 * crossings. */
enum { CROSSINGS_USUAL = 6 };

static bool is_orthographic(const struct scene *scene)
{
    return scene->camera.orthographic;
}

static bool has_fogs(const struct scene *scene)
{
    return scene->fog_count > 0;
}

/* Returns true if the kernels must order hits by keys instead of distances
 * (docs/solids.md): if a region yields, because its surfaces may coincide with those of
 * a later region, or if light passes through a body. A query of all crossings reports
 * the crossings of each region, so yields do not matter. */
static bool has_keys(const struct scene *scene)
{
    for (size_t i = 0; !scene->every_crossing && i < scene->region_count; i++)
        if (scene->regions[i].yield > 0)
            return true;
    return scene_has_interiors(scene);
}

static bool has_simple_yields(const struct scene *scene)
{
    for (size_t i = 0; i < scene->region_count; i++)
        if (scene->regions[i].yield > 0 && region_is_simple(scene, &scene->regions[i]))
            return true;
    return false;
}

/* Optional parts of the kernels, each with a function that returns whether a scene
 * needs it. */
static const struct feature {
    const char *symbol;
    bool (*is_in)(const struct scene *scene);
} features[] = {
    { "ORTHOGRAPHIC", is_orthographic },
    { "FOG", has_fogs },
    { "GLOSS", scene_is_glossy },
    { "BEAMS", scene_has_beams },
    { "AREAS", scene_has_areas },
    { "PATTERNS", scene_has_patterns },
    { "IMAGES", scene_has_images },
    { "BUMPS", scene_has_bumps },
    { "INTERIORS", scene_has_interiors },
    { "KEYS", has_keys },
    { "SIMPLE_YIELDS", has_simple_yields },
    { "MESH_CROSSINGS", scene_has_crossed_meshes },
};
enum { FEATURES = sizeof features / sizeof *features };

/* The constants for the assembly of the program. */
struct defines {
    struct asm_define list[FEATURES + PRIMITIVE_KINDS + 11]; /* the last entry is
                                                              * NULL */
    size_t count;
};

static void define(struct defines *defines, const char *symbol, size_t value)
{
    defines->list[defines->count++] = (struct asm_define){ symbol, (int64_t)value };
}

/* Enables the kernels of the shapes that are in the scene. */
static void define_shapes(struct defines *defines, const struct scene *scene)
{
    bool there[PRIMITIVE_KINDS] = { false };
    for (size_t i = 0; i < scene->primitive_count; i++)
        there[scene->primitives[i].kind] = true;
    for (size_t i = 0; i < PRIMITIVE_KINDS; i++)
        if (there[i] && shapes[i]->symbol)
            define(defines, shapes[i]->symbol, 1);
}

/* Defines the constants that depend on the scene. */
static void define_scene(struct defines *defines, const struct scene *scene)
{
    size_t crossings = most_crossings(scene);
    size_t pieces = blob_pieces_most(scene);
    for (size_t i = 0; i < FEATURES; i++)
        if (features[i].is_in(scene))
            define(defines, features[i].symbol, 1);
    define_shapes(defines, scene);
    if (pieces > 0)
        define(defines, "BLOB_PIECES", pieces);
    if (crossings > CROSSINGS_USUAL)
        define(defines, "MAX_CROSSINGS", crossings);
}

struct object *form_assemble(const struct trace_options *options,
                             const struct scene *scene, c205_error *error)
{
    struct defines defines = { .count = 0 };
    define(&defines, "QUEUE", options->queue);
    define_scene(&defines, scene);
    if (scene_hides(scene))
        define(&defines, "HIDDEN", 1);
    if (scene->camera.lens_radius > 0 && options->samples > 1)
        define(&defines, "LENS", 1);
    if (options->threshold > 0)
        define(&defines, "ADAPTIVE", TRACE_BLOCK);
    if (options->historical)
        define(&defines, "HISTORICAL", 1);
    if (options->variant)
        define(&defines, options->variant, 1);
    if (options->visible != VISIBLE_DEFAULT)
        define(&defines, "VISIBLE", options->visible);
    return program_assemble(forms[options->mode].program, defines.list, error);
}

struct object *form_assemble_lines(enum trace_mode mode, size_t queue, bool normals,
                                   bool bodies, const struct scene *scene,
                                   c205_error *error)
{
    static const char *const programs[TRACE_MODES] = {
        [TRACE_SCALAR] = "query/query_scalar.s",
        [TRACE_VECTOR] = "query/query_vector.s",
        [TRACE_KERNELS] = "query/query_1984.s",
    };
    struct defines defines = { .count = 0 };
    define(&defines, "QUEUE", queue);
    define_scene(&defines, scene);
    if (normals)
        define(&defines, "NORMALS", 1);
    if (bodies)
        define(&defines, "DEPTHS", 1);
    return program_assemble(programs[mode], defines.list, error);
}

struct object *form_assemble_beside(const char *name, enum trace_mode mode,
                                    const struct asm_define *defines, c205_error *error)
{
    struct defines all = { .count = 0 };
    char path[64];
    for (; defines && defines->name; defines++)
        define(&all, defines->name, (size_t)defines->value);
    if (trace_mode_besides(mode) == TRACE_SCALAR)
        define(&all, "SCALAR", 1);
    snprintf(path, sizeof path, "%s.s", name);
    return program_assemble(path, all.list, error);
}
