/* ray_query.c - runs all-hits ray queries on machines, packet by packet. */
#include "rt/trace/ray_query.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/jobs/job_set.h"
#include "rt/layout/program.h"
#include "rt/layout/trees.h"
#include "rt/shapes/mesh.h"
#include "rt/trace/form.h"

struct ray_query {
    struct ray_query_options options;
    const struct scene *scene;
    size_t **orders; /* for each mesh: the original numbers of its triangles */
    struct object *program;
    struct query_layout *layout;
};

/* ---- Setup --------------------------------------------------------------- */

/* Copies the geometry of a scene. All surfaces get the same opaque colour. Camera, sky,
 * fogs, lights and images are omitted. */
static bool lay_bare(const struct scene *scene, struct scene *bare)
{
    *bare = *scene;
    bare->camera = (struct camera){ 0 };
    bare->sky = (struct pigment){ .kind = PIGMENT_COLOR };
    bare->fog_count = bare->light_count = bare->image_count = 0;
    bare->every_crossing = true;
    bare->primitives = calloc(scene->primitive_count + 1, sizeof *bare->primitives);
    for (size_t i = 0; bare->primitives && i < scene->primitive_count; i++) {
        struct primitive *primitive = &bare->primitives[i];
        *primitive = scene->primitives[i];
        primitive->pigment = (struct pigment){ .kind = PIGMENT_COLOR };
        primitive->bumps = (struct bumps){ .list = NULL };
        primitive->finish = (struct finish){ .roughness = 0 };
        primitive->ior = 1;
    }
    return bare->primitives;
}

static bool find_orders(struct ray_query *query)
{
    const struct scene *scene = query->scene;
    query->orders = calloc(scene->primitive_count + 1, sizeof *query->orders);
    for (size_t i = 0; query->orders && i < scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        if (!primitive_is_mesh(primitive))
            continue;
        query->orders[i] = mesh_order(primitive);
        if (!query->orders[i])
            return false;
    }
    return query->orders;
}

static bool lay_out_query(struct ray_query *query, c205_error *error)
{
    const struct ray_query_options *options = &query->options;
    enum bounding bounding = options->no_bounds ? BOUNDING_NONE
                             : options->flat    ? BOUNDING_FLAT
                                                : BOUNDING_HIERARCHY;
    struct scene bare;
    if (!find_orders(query) || !lay_bare(query->scene, &bare))
        return error_set(error, "out of memory");
    query->program = form_assemble_lines(options->mode, options->queue,
                                         options->normals, options->bodies, &bare,
                                         error);
    if (query->program)
        query->layout = query_layout_new(query->program, &bare, bounding, error);
    free(bare.primitives);
    return query->layout;
}

static bool check_options(const struct ray_query_options *options, c205_error *error)
{
    if (options->mode >= TRACE_MODES)
        return error_set(error, "unknown mode: expected scalar, vector or "
                                "kernels");
    if (options->mode != TRACE_SCALAR
        && (options->queue == 0 || options->queue > MAX_TRACE_QUEUE))
        return error_set(error, "the queue must be between 1 and 65535 rays");
    if (!(options->behind >= 0) || !isfinite(options->behind))
        return error_set(error, "the distance before the origins must be finite and "
                                "not below 0");
    return true;
}

struct ray_query *ray_query_new(const struct scene *scene,
                                const struct ray_query_options *options,
                                c205_error *error)
{
    struct ray_query *query;
    if (!check_options(options, error))
        return NULL;
    query = calloc(1, sizeof *query);
    if (!query) {
        error_set(error, "out of memory");
        return NULL;
    }
    query->options = *options;
    query->scene = scene;
    if (options->packet == 0)
        query->options.packet = QUERY_PACKET;
    if (lay_out_query(query, error))
        return query;
    ray_query_free(query);
    return NULL;
}

void ray_query_free(struct ray_query *query)
{
    if (!query)
        return;
    for (size_t i = 0; query->orders && i < query->scene->primitive_count; i++)
        free(query->orders[i]);
    free(query->orders);
    query_layout_free(query->layout);
    object_free(query->program);
    free(query);
}

const struct object *ray_query_program(const struct ray_query *query)
{
    return query->program;
}

/* ---- Results ------------------------------------------------------------- */

void ray_hits_free(struct ray_hits *found)
{
    free(found->first);
    free(found->list);
    accounts_free(&found->accounts);
    *found = (struct ray_hits){ 0 };
}

/* The k-th crossings of all lines are a column, which has a plane for each word of a
 * crossing. A field's offset is the number of planes before it in the column. */
struct ray_hit_fields {
    size_t size, distance, primitive, crossing, point;
    size_t normal, object_depth, scene_depth; /* present on request */
};

static size_t field(const struct ray_query *query, const char *name)
{
    const struct asm_symbol *symbol = object_symbol(query->program, name);
    return symbol ? (size_t)symbol->value : 0;
}

static struct ray_hit_fields find_fields(const struct ray_query *query)
{
    return (struct ray_hit_fields){
        .size = field(query, "RAY_HIT_SIZE"),
        .distance = field(query, "RAY_HIT_DISTANCE"),
        .primitive = field(query, "RAY_HIT_PRIMITIVE"),
        .crossing = field(query, "RAY_HIT_CROSSING"),
        .point = field(query, "RAY_HIT_POINT"),
        .normal = field(query, "RAY_HIT_NORMAL"),
        .object_depth = field(query, "RAY_HIT_OBJECT_DEPTH"),
        .scene_depth = field(query, "RAY_HIT_SCENE_DEPTH"),
    };
}

/* The k-th crossings of all lines. Word i of each plane belongs to line i. */
struct column {
    const struct ray_query *query;
    struct ray_hit_fields fields;
    size_t count; /* number of lines */
    c205_word *words;
};

static c205_word word_of(const struct column *column, size_t field, size_t line)
{
    return column->words[field * column->count + line];
}

static int integer_of(const struct column *column, size_t field, size_t line)
{
    return (int)c205_to_integer(word_of(column, field, line));
}

/* Returns the index of the triangle that was hit. For a mesh, the field `point` of a
 * crossing has the offset of the triangle's row in the mesh's table. */
static size_t triangle_of(const struct column *column, size_t line, size_t primitive)
{
    const struct ray_query *query = column->query;
    const size_t *order = query->orders[primitive];
    return order
               ? order[mesh_row(&query->scene->primitives[primitive],
                                (size_t)integer_of(column, column->fields.point, line))]
               : 0;
}

static struct ray_hit crossing_of(const struct column *column, size_t line)
{
    const struct ray_query *query = column->query;
    const struct ray_hit_fields *fields = &column->fields;
    size_t id = (size_t)integer_of(column, fields->primitive, line) - 1;
    struct ray_hit seen = {
        .distance = word_of(column, fields->distance, line),
        .primitive = id,
        .object = query->scene->primitives[id].object,
        .triangle = triangle_of(column, line, id),
        .crossing = integer_of(column, fields->crossing, line),
    };
    for (size_t i = 0; query->options.normals && i < 3; i++)
        seen.normal[i] = word_of(column, fields->normal + i, line);
    if (query->options.bodies) {
        seen.object_depth = integer_of(column, fields->object_depth, line);
        seen.scene_depth = integer_of(column, fields->scene_depth, line);
    }
    return seen;
}

/* Computes the index of each line's first crossing; first[0] is given. Returns the
 * largest number of crossings of a line. */
static size_t sum_counts(const c205_word *counts, size_t count, size_t *first)
{
    size_t most = 0;
    for (size_t i = 0; i < count; i++) {
        size_t crossings = (size_t)c205_to_integer(counts[i]);
        first[i + 1] = first[i] + crossings;
        most = crossings > most ? crossings : most;
    }
    return most;
}

static bool read_counts(const c205 *machine, const struct packet_layout *packet,
                        size_t *first, size_t *most)
{
    c205_word *counts = calloc(packet->count, sizeof *counts);
    bool good = counts && c205_read(machine, packet->counts, counts, packet->count);
    if (good)
        *most = sum_counts(counts, packet->count, first);
    free(counts);
    return good;
}

static bool read_column(struct column *column, const c205 *machine, uint64_t found,
                        size_t k, const size_t *first, struct ray_hit *list)
{
    size_t words = column->fields.size * column->count;
    if (!c205_read(machine, found + UINT64_C(64) * k * words, column->words, words))
        return false;
    for (size_t i = 0; i < column->count; i++)
        if (first[i] + k < first[i + 1])
            list[first[i] + k] = crossing_of(column, i);
    return true;
}

/* Appends the crossings of this packet to the crossings of earlier packets. */
static bool read_columns(struct column *column, const c205 *machine,
                         const struct packet_layout *packet, const size_t *first,
                         size_t most, struct ray_hits *found)
{
    size_t total = first[packet->count];
    struct ray_hit *list = realloc(found->list, (total + 1) * sizeof *list);
    if (!list)
        return false;
    found->list = list;
    if (!column->words)
        return false;
    for (size_t k = 0; k < most; k++)
        if (!read_column(column, machine, packet->found, k, first, list))
            return false;
    return true;
}

static bool collect(const struct ray_query *query, const c205 *machine,
                    const struct packet_layout *packet, struct ray_hits *found,
                    size_t line)
{
    struct column column = { .query = query,
                             .fields = find_fields(query),
                             .count = packet->count };
    size_t *first = found->first + line, most = 0;
    bool good;
    column.words = calloc(column.fields.size * column.count, sizeof *column.words);
    good = read_counts(machine, packet, first, &most)
           && read_columns(&column, machine, packet, first, most, found)
           && accounts_add(&found->accounts, machine);
    free(column.words);
    return good;
}

/* ---- Queries ------------------------------------------------------------- */

static bool is_line(const struct scene_ray *line)
{
    double size = 0;
    for (int i = 0; i < 3; i++) {
        if (!isfinite(line->origin[i]) || !isfinite(line->direction[i]))
            return false;
        size = fmax(size, fabs(line->direction[i]));
    }
    return size > 0;
}

static bool check_rays(const struct scene_ray *list, size_t count, c205_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (!is_line(&list[i]))
            return error_set(error, "ray %zu must have a direction and finite numbers",
                             i);
    return true;
}

static bool load_packet(const struct ray_query *query, c205 *machine,
                        struct packet_layout *packet, c205_error *error)
{
    packet->behind = query->options.behind;
    return c205_load(machine, &query->program->program, error)
           && query_layout_put(query->layout, machine, packet, error);
}

c205 *ray_query_machine(const struct ray_query *query, const struct scene_ray *list,
                        size_t count, c205_error *error)
{
    struct packet_layout packet = { .lines = list, .count = count };
    c205 *machine;
    if (!check_rays(list, count, error))
        return NULL;
    machine = c205_new(query->options.model, error);
    if (machine && load_packet(query, machine, &packet, error))
        return machine;
    c205_free(machine);
    return NULL;
}

static bool find_packet(const struct ray_query *query, c205 *machine,
                        struct packet_layout *packet, struct ray_hits *found,
                        size_t line, c205_error *error)
{
    bool stopped = false;
    if (!load_packet(query, machine, packet, error)
        || !program_run(machine, NULL, NULL, &stopped, error))
        return false;
    return collect(query, machine, packet, found, line)
           || error_set(error, "out of memory");
}

static bool find_packets(const struct ray_query *query, c205 *machine,
                         const struct scene_ray *list, struct ray_hits *found,
                         c205_error *error)
{
    size_t most = query->options.packet, count = found->line_count;
    for (size_t i = 0; i < count; i += most) {
        struct packet_layout packet = {
            .lines = list + i,
            .count = count - i < most ? count - i : most,
        };
        if (!find_packet(query, machine, &packet, found, i, error))
            return false;
    }
    return true;
}

bool ray_query_find(const struct ray_query *query, const struct scene_ray *list,
                    size_t count, struct ray_hits *found, c205_error *error)
{
    c205 *machine;
    bool good;
    *found = (struct ray_hits){ .line_count = count,
                                .accounts = { .model = query->options.model } };
    if (!check_rays(list, count, error))
        return false;
    found->first = calloc(count + 1, sizeof *found->first);
    if (!found->first)
        return error_set(error, "out of memory");
    machine = c205_new(query->options.model, error);
    good = machine && find_packets(query, machine, list, found, error);
    c205_free(machine);
    if (!good)
        ray_hits_free(found);
    return good;
}

/* ---- Checkpoints of queries ------------------------------------------------ */

bool ray_query_keep(const struct ray_query *query, struct job_set *job_set,
                    const char *kind, const uint64_t *choices, size_t count,
                    c205_error *error)
{
    const struct scene_ray line = { { 0 }, { 1, 0, 0 } };
    c205 *machine;
    bool good;
    if (!job_set || job_set->path_count == 0 || job_set->file)
        return true;
    machine = ray_query_machine(query, &line, 1, error);
    good = machine
           && job_set_open(job_set, job_set_key(kind, machine, choices, count), error);
    c205_free(machine);
    return good;
}
