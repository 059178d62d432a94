/* hits.c - computes the fraction of a surface's radiation that strikes cylinders. */
#include "rt/heat/hits.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/layout/single_run.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/primitive.h"
#include "rt/trace/form.h"

/* ---- Cylinders ---------------------------------------------------------------- */

/* The number of words of a cylinder, as in hits.s. */
enum { CYLINDER_WORDS = 8 };

static void transform_point(const struct transform *map, const double point[3],
                            double to[3])
{
    for (size_t i = 0; i < 3; i++)
        to[i] = dot3(map->rows[i], point) + map->rows[i][3];
}

/* Returns the factor by which a map scales all lengths, or 0 if the scaling is not
 * uniform. */
static double scale_of(const struct transform *map)
{
    double columns[3][3], scale;
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++)
            columns[i][k] = map->rows[k][i];
    scale = sqrt(dot3(columns[0], columns[0]));
    for (size_t i = 0; i < 3; i++) {
        double length = sqrt(dot3(columns[i], columns[i]));
        double slant = dot3(columns[i], columns[(i + 1) % 3]);
        if (fabs(length - scale) > 1e-9 * scale || fabs(slant) > 1e-9 * scale * scale)
            return 0;
    }
    return scale;
}

static bool put_cylinder(const struct primitive *primitive, double *words)
{
    double base[3], cap[3], length, scale = scale_of(&primitive->to_world);
    double radius = primitive->shape.cylinder.radius * scale;
    transform_point(&primitive->to_world, primitive->shape.cylinder.base, base);
    transform_point(&primitive->to_world, primitive->shape.cylinder.cap, cap);
    for (size_t i = 0; i < 3; i++) {
        words[i] = base[i];
        words[3 + i] = cap[i] - base[i];
    }
    length = sqrt(dot3(words + 3, words + 3));
    for (size_t i = 3; i < 6; i++)
        words[i] /= length;
    words[6] = length;
    words[7] = radius * radius;
    return scale > 0;
}

struct hits_work {
    const struct scene *scene;
    const struct named_parts *parts;
    const struct hits_options *options;
    struct hits *hits;
    struct object *program, *received;
    double *cylinders;    /* [count][CYLINDER_WORDS] */
    c205_word *planes;    /* planes of a repeat's points */
    c205_word *reported;  /* for each point: 1 if its ray strikes a cylinder */
    double *share, *area; /* for each repeat: means over its points */
    c205_error *error;
};

static bool is_emitter(const struct hits_work *work, const struct primitive *primitive)
{
    const struct named_part
        *part = &work->parts->list[work->parts->part_of[primitive->object]];
    const char *from = work->options->from;
    return strcmp(part->name, from) == 0
           || (part->material && strcmp(part->material, from) == 0);
}

static bool list_cylinders(const struct hits_work *work)
{
    const struct scene *scene = work->scene;
    for (size_t i = 0; i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        const struct primitive *primitive = &scene->primitives[region->first_primitive];
        if (is_emitter(work, primitive))
            continue;
        if (region->primitive_count != 1 || primitive->inverted
            || primitive->kind != PRIMITIVE_CYLINDER || primitive->shape.cylinder.open
            || !put_cylinder(primitive,
                             work->cylinders + CYLINDER_WORDS * work->hits->cylinders))
            return error_set(work->error,
                             "the %s of line %zu is not a separate solid cylinder: "
                             "--hits supports no other objects",
                             primitive_kind_name(primitive->kind), primitive->line);
        work->hits->cylinders++;
    }
    return work->hits->cylinders > 0
           || error_set(work->error, "the scene has no cylinder to test");
}

/* ---- A repeat
 * ------------------------------------------------------------------- */

static bool run_hits(struct hits_work *work)
{
    const struct hits_options *options = work->options;
    size_t points = options->points, count = work->hits->cylinders;
    size_t numbers = CYLINDER_WORDS * count;
    c205_word *words = calloc(numbers, sizeof *words);
    struct single_run run;
    uint64_t at, made, clocks = 0;
    if (!words)
        return error_set(work->error, "out of memory");
    put_numbers(words, work->cylinders, numbers);
    single_run_begin(&run, work->program, options->model, work->error);
    run.accounts = &work->hits->accounts;
    run.projection = options->projection;
    run.projected = &work->hits->projected;
    single_run_word(&run, "hits_rays", points);
    at = single_run_room(&run, "hits_from", work->planes, EMITTED_PLANES * points);
    layout_word(&run.layout, "hits_towards", at + UINT64_C(64) * EMITTED_RAY * points);
    single_run_word(&run, "hits_cylinders", count);
    single_run_room(&run, "hits_list", words, numbers);
    made = single_run_room(&run, "hits_results", NULL, points);
    free(words);
    return single_run_end(&run, made, work->reported, points, &clocks);
}

/* Computes three sums of weights: of the rays that miss the cylinders, of the rays that
 * strike one, and of all rays. */
static bool run_received(struct hits_work *work, size_t repeat)
{
    enum { RECEIVERS = 2, SUMS = 2 * RECEIVERS + 1 };
    size_t points = work->options->points;
    struct single_run run;
    c205_word made[SUMS];
    uint64_t sums, clocks = 0;
    single_run_begin(&run, work->received, work->options->model, work->error);
    single_run_word(&run, "received_rays", points);
    single_run_word(&run, "received_receivers", RECEIVERS);
    single_run_room(&run, "received_weights", work->planes + EMITTED_WEIGHT * points,
                    points);
    single_run_room(&run, "received_list", work->reported, points);
    sums = single_run_room(&run, "received_sums", NULL, SUMS);
    layout_word(&run.layout, "received_counts", sums + 64 * (RECEIVERS + 1));
    single_run_room(&run, "received_buffer", NULL, points);
    single_run_room(&run, "received_places", NULL, RECEIVERS);
    if (!single_run_end(&run, sums, made, SUMS, &clocks))
        return false;
    work->share[repeat] += c205_to_double(made[1]) / (double)points;
    work->area[repeat] += c205_to_double(made[RECEIVERS]) / (double)points;
    work->hits->struck += (uint64_t)c205_to_integer(made[SUMS - 1]);
    work->hits->rays += points;
    return true;
}

static bool run_repeat(struct hits_work *work, const struct emission *emission,
                       size_t primitive, size_t repeat)
{
    const struct hits_options *options = work->options;
    struct emission_choice choice = emission_choose(options->lattice, options->seed,
                                                    options->points,
                                                    primitive * options->repeats
                                                        + repeat);
    return emission_run(emission, &choice, work->planes, NULL, work->error)
           && run_hits(work) && run_received(work, repeat);
}

static bool run_emitter(struct hits_work *work, size_t primitive)
{
    const struct hits_options *options = work->options;
    const struct emission_options emits = {
        .mode = options->mode,
        .queue = options->queue,
        .points = options->points,
        .lattice = options->lattice,
        .model = options->model,
    };
    struct emission *emission = emission_new(&work->scene->primitives[primitive],
                                             &emits, work->error);
    bool good = emission;
    for (size_t k = 0; good && k < options->repeats; k++)
        good = run_repeat(work, emission, primitive, k);
    emission_free(emission);
    return good;
}

/* ---- All emitters
 * ----------------------------------------------------------------- */

static bool run_emitters(struct hits_work *work)
{
    for (size_t i = 0; i < work->scene->primitive_count; i++)
        if (is_emitter(work, &work->scene->primitives[i]) && !run_emitter(work, i))
            return false;
    return true;
}

static struct object *assemble_hits(const struct hits_work *work, const char *name)
{
    const struct hits_options *options = work->options;
    const struct asm_define defines[] = {
        { options->mode == TRACE_VECTOR ? "QUEUE" : NULL, (int64_t)options->queue },
        { NULL, 0 },
    };
    return form_assemble_beside(name, options->mode, defines, work->error);
}

static bool hits_begin(struct hits_work *work)
{
    const struct hits_options *options = work->options;
    size_t points = options->points, repeats = options->repeats;
    if (!named_parts_check(work->parts, options->from, work->error))
        return false;
    work->cylinders = calloc(CYLINDER_WORDS * work->scene->region_count + 1,
                             sizeof *work->cylinders);
    work->planes = calloc(EMITTED_PLANES * points, sizeof *work->planes);
    work->reported = calloc(points, sizeof *work->reported);
    work->share = calloc(repeats, sizeof *work->share);
    work->area = calloc(repeats, sizeof *work->area);
    if (!work->cylinders || !work->planes || !work->reported || !work->share
        || !work->area)
        return error_set(work->error, "out of memory");
    if (!list_cylinders(work))
        return false;
    work->program = assemble_hits(work, "heat/hits");
    work->received = work->program ? assemble_hits(work, "heat/received") : NULL;
    return work->received;
}

static void hits_end(struct hits_work *work)
{
    object_free(work->program);
    object_free(work->received);
    free(work->cylinders);
    free(work->planes);
    free(work->reported);
    free(work->share);
    free(work->area);
}

void hits_free(struct hits *hits)
{
    accounts_free(&hits->accounts);
}

bool hits_find(const struct scene *scene, const struct named_parts *parts,
               const struct hits_options *options, struct hits *hits, c205_error *error)
{
    struct hits_work work = {
        .scene = scene, .parts = parts, .options = options, .hits = hits, .error = error
    };
    bool good;
    *hits = (struct hits){ .accounts = { .model = options->model } };
    good = hits_begin(&work) && run_emitters(&work);
    if (good)
        hits->factor = estimate_ratio(work.share, work.area, options->repeats);
    hits_end(&work);
    if (!good)
        hits_free(hits);
    return good;
}
