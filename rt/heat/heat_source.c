/* heat_source.c - generates points on any bounded primitive. */
#include "rt/heat/heat_source.h"

#include <math.h>
#include <stdlib.h>

#include "vm/error.h"
#include "rt/heat/chords.h"
#include "rt/layout/bounds.h"
#include "rt/layout/single_run.h"
#include "rt/trace/form.h"

/* The factor by which the radius of the sphere around the primitive exceeds its
 * bound. */
static const double larger = 1.001;

struct heat_source {
    struct emission_options options;
    struct emission *emission; /* NULL: points come from lines */
    struct chords chords;
    /* A scene that contains only the primitive. The ray query of the lines uses it. */
    struct scene alone;
    struct tree_node node;
    struct region region;
    struct primitive primitive;
    struct ray_query *lines;
    struct object *spots;
};

/* ---- Refusals ----------------------------------------------------------------- */

/* Sets the bounds of a region's primitives from the bounds of its nodes. A primitive
 * gets the smallest bound of the leaves that contain it, or the bound of the region if
 * these leaves are unbounded. */
static void bound_in(const struct scene *scene, const struct region *region,
                     const struct bound *nodes, struct bound *bounds)
{
    size_t first = region->first_node, end = first + region->node_count;
    for (size_t i = 0; i < region->primitive_count; i++)
        bounds[region->first_primitive + i] = nodes[first];
    for (size_t i = first; i < end; i++) {
        struct bound *bound = &bounds[scene->nodes[i].primitive];
        if (scene->nodes[i].operation == TREE_LEAF && !bound_is_none(&nodes[i])
            && (bound_is_none(bound) || nodes[i].radius < bound->radius))
            *bound = nodes[i];
    }
}

/* Returns the smallest known bound of each of the scene's primitives. */
static struct bound *bound_primitives(const struct scene *scene)
{
    struct bound *nodes = calloc(scene->node_count + 1, sizeof *nodes);
    struct bound *bounds = calloc(scene->primitive_count + 1, sizeof *bounds);
    bool good = nodes && bounds && bound_nodes(scene, nodes);
    for (size_t i = 0; good && i < scene->region_count; i++)
        bound_in(scene, &scene->regions[i], nodes, bounds);
    free(nodes);
    if (good)
        return bounds;
    free(bounds);
    return NULL;
}

static const char *refusal_of(const struct scene *scene, const struct bound *bounds,
                              size_t primitive)
{
    const char *refusal = emission_refusal(&scene->primitives[primitive]);
    if (refusal && bound_is_none(&bounds[primitive]))
        return scene->primitives[primitive].kind == PRIMITIVE_PLANE
                   ? refusal
                   : "its bounds are unknown, so it cannot emit";
    return NULL;
}

const char **source_refusals(const struct scene *scene)
{
    const char **refusals = calloc(scene->primitive_count + 1, sizeof *refusals);
    struct bound *bounds = bound_primitives(scene);
    for (size_t i = 0; refusals && bounds && i < scene->primitive_count; i++)
        refusals[i] = refusal_of(scene, bounds, i);
    if (!bounds) {
        free(refusals);
        refusals = NULL;
    }
    free(bounds);
    return refusals;
}

/* ---- Setup -------------------------------------------------------------------- */

static bool find_sphere(struct heat_source *source, const struct scene *scene,
                        size_t primitive, c205_error *error)
{
    struct bound *bounds = bound_primitives(scene), bound;
    const char *refusal;
    if (!bounds)
        return error_set(error, "out of memory");
    bound = bounds[primitive];
    refusal = refusal_of(scene, bounds, primitive);
    free(bounds);
    if (refusal)
        return error_set(error, "the %s of line %zu: %s",
                         primitive_kind_name(scene->primitives[primitive].kind),
                         scene->primitives[primitive].line, refusal);
    for (int i = 0; i < 3; i++)
        source->chords.center[i] = bound.center[i];
    source->chords.radius = larger * bound.radius;
    return true;
}

static void put_alone(struct heat_source *source, const struct scene *scene,
                      size_t primitive)
{
    source->primitive = scene->primitives[primitive];
    source->node = (struct tree_node){ .operation = TREE_LEAF, .next = 1 };
    source->region = (struct region){ .primitive_count = 1,
                                      .node_count = 1,
                                      .line = source->primitive.line };
    source->alone = *scene;
    source->alone.primitives = &source->primitive;
    source->alone.nodes = &source->node;
    source->alone.regions = &source->region;
    source->alone.primitive_count = source->alone.node_count = source->alone
                                                                   .region_count = 1;
}

static bool begin_lines(struct heat_source *source, c205_error *error)
{
    const struct ray_query_options options = {
        .mode = source->options.mode,
        .queue = source->options.queue,
        .behind = CHORDS_BEHIND * source->chords.radius,
        .normals = true,
        .model = source->options.model,
    };
    struct emission_options emits = source->options;
    emits.mode = trace_mode_besides(emits.mode);
    source->lines = ray_query_new(&source->alone, &options, error);
    if (!source->lines)
        return false;
    source->spots = form_assemble_beside("heat/spots", emits.mode, NULL, error);
    return source->spots && chords_begin(&source->chords, &emits, error);
}

static bool source_begin(struct heat_source *source, const struct scene *scene,
                         size_t primitive, c205_error *error)
{
    const struct primitive *emitter = &scene->primitives[primitive];
    struct emission_options emits = source->options;
    emits.mode = trace_mode_besides(emits.mode);
    if (!emission_refusal(emitter)) {
        source->emission = emission_new(emitter, &emits, error);
        return source->emission;
    }
    if (!find_sphere(source, scene, primitive, error))
        return false;
    put_alone(source, scene, primitive);
    return begin_lines(source, error);
}

struct heat_source *source_new(const struct scene *scene, size_t primitive,
                               const struct emission_options *options,
                               c205_error *error)
{
    struct heat_source *source = calloc(1, sizeof *source);
    if (!source) {
        error_set(error, "out of memory");
        return NULL;
    }
    source->options = *options;
    if (source_begin(source, scene, primitive, error))
        return source;
    source_free(source);
    return NULL;
}

void source_free(struct heat_source *source)
{
    if (!source)
        return;
    emission_free(source->emission);
    chords_end(&source->chords);
    ray_query_free(source->lines);
    object_free(source->spots);
    free(source);
}

/* ---- By lines ----------------------------------------------------------------- */

/* The planes in which the crossings of the lines are stored, in the order of
 * spots.s. */
enum {
    CROSSED_DISTANCE,
    CROSSED_LINE,
    CROSSED_NORMAL,
    CROSSED_PLANES = CROSSED_NORMAL + 3
};

static c205_word *lay_crossings(const struct ray_hits *found)
{
    size_t count = found->first[found->line_count];
    c205_word *planes = calloc(CROSSED_PLANES * count + 1, sizeof *planes);
    for (size_t line = 0; planes && line < found->line_count; line++)
        for (size_t i = found->first[line]; i < found->first[line + 1]; i++) {
            const struct ray_hit *seen = &found->list[i];
            planes[CROSSED_DISTANCE * count + i] = seen->distance;
            planes[CROSSED_LINE * count + i] = c205_from_integer((int64_t)line);
            for (size_t k = 0; k < 3; k++)
                planes[(CROSSED_NORMAL + k) * count + i] = seen->normal[k];
        }
    return planes;
}

static bool run_spots(const struct heat_source *source, const c205_word *lines,
                      const c205_word *crossings, struct sourced *made,
                      struct accounts *accounts, c205_error *error)
{
    size_t words = EMITTED_PLANES * made->count;
    struct single_run run;
    uint64_t at, clocks = 0;
    single_run_begin(&run, source->spots, source->options.model, error);
    run.accounts = accounts;
    single_run_word(&run, "spots_lines", source->chords.count);
    single_run_word(&run, "spots_crossings", made->count);
    single_run_room(&run, "spots_from", lines, EMITTED_PLANES * source->chords.count);
    single_run_room(&run, "spots_list", crossings, CROSSED_PLANES * made->count);
    at = single_run_room(&run, "spots_results", NULL, words);
    single_run_number(&run, "spots_weight", 0, chords_weight(&source->chords));
    return single_run_end(&run, at, made->planes, words, &clocks);
}

static bool make_spots(const struct heat_source *source, const c205_word *lines,
                       const struct ray_hits *found, struct sourced *made,
                       struct accounts *accounts, c205_error *error)
{
    c205_word *crossings;
    bool good;
    made->count = found->first[found->line_count];
    if (made->count > MAX_EMISSION)
        return error_set(error,
                         "the %s of line %zu has %zu crossings; at most %d are "
                         "allowed: use fewer rays",
                         primitive_kind_name(source->primitive.kind),
                         source->primitive.line, made->count, MAX_EMISSION);
    crossings = lay_crossings(found);
    made->planes = malloc((EMITTED_PLANES * made->count + 1) * sizeof *made->planes);
    good = (crossings && made->planes) || error_set(error, "out of memory");
    if (good && made->count > 0)
        good = run_spots(source, lines, crossings, made, accounts, error);
    free(crossings);
    return good;
}

static bool run_lines(const struct heat_source *source,
                      const struct emission_choice *choice, struct scene_ray *lines,
                      c205_word *planes, struct sourced *made,
                      struct accounts *accounts, c205_error *error)
{
    struct ray_hits found = { 0 };
    bool good = chords_run(&source->chords, choice, planes, lines, accounts, error)
                && ray_query_find(source->lines, lines, source->chords.count, &found,
                                  error);
    if (good && !accounts_add_all(accounts, &found.accounts))
        good = error_set(error, "out of memory");
    good = good && make_spots(source, planes, &found, made, accounts, error);
    ray_hits_free(&found);
    return good;
}

static bool run_by_lines(const struct heat_source *source,
                         const struct emission_choice *choice, struct sourced *made,
                         struct accounts *accounts, c205_error *error)
{
    size_t count = source->chords.count;
    struct scene_ray *lines = malloc(count * sizeof *lines);
    c205_word *planes = malloc(EMITTED_PLANES * count * sizeof *planes);
    bool good = lines && planes
                    ? run_lines(source, choice, lines, planes, made, accounts, error)
                    : error_set(error, "out of memory");
    free(lines);
    free(planes);
    return good;
}

/* ---- Runs --------------------------------------------------------------------- */

static bool run_emission(const struct heat_source *source,
                         const struct emission_choice *choice, struct sourced *made,
                         struct accounts *accounts, c205_error *error)
{
    made->count = source->options.points;
    made->planes = malloc(EMITTED_PLANES * made->count * sizeof *made->planes);
    return made->planes
               ? emission_run(source->emission, choice, made->planes, accounts, error)
               : error_set(error, "out of memory");
}

bool source_run(const struct heat_source *source, const struct emission_choice *choice,
                struct sourced *made, struct accounts *accounts, c205_error *error)
{
    bool good;
    *made = (struct sourced){ .count = 0 };
    good = source->emission ? run_emission(source, choice, made, accounts, error)
                            : run_by_lines(source, choice, made, accounts, error);
    if (!good) {
        free(made->planes);
        *made = (struct sourced){ .count = 0 };
    }
    return good;
}
