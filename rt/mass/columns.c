/* columns.c - computes sums over columns through solids, packet by packet. */
#include "rt/mass/columns.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "base/fnv_hash.h"
#include "rt/jobs/job_set.h"
#include "rt/layout/bounds.h"
#include "rt/mass/overlaps.h"
#include "rt/trace/form.h"
#include "rt/trace/ray_query.h"

const char *columns_stage_name(enum columns_stage stage)
{
    static const char *const names[COLUMNS_STAGES] = {
        [STAGE_RAYS] = "rays",     [STAGE_CROSSINGS] = "crossings",
        [STAGE_SUMS] = "sums",     [STAGE_OVERLAPS] = "overlaps",
        [STAGE_TOTALS] = "totals",
    };
    return names[stage];
}

/* ---- The box around the bodies ------------------------------------------- */

static bool join_box(const struct bound *bound, const struct region *region,
                     double low[3], double high[3], c205_error *error)
{
    if (bound_is_none(bound))
        return error_set(error,
                         "the solid of line %zu has unknown bounds: its volume "
                         "cannot be computed",
                         region->line);
    for (int i = 0; i < 3; i++) {
        low[i] = fmin(low[i], bound->low[i]);
        high[i] = fmax(high[i], bound->high[i]);
    }
    return true;
}

static bool find_box(const struct scene *scene, struct columns_sums *sums,
                     c205_error *error)
{
    struct bound *bounds = calloc(scene->node_count + 1, sizeof *bounds);
    double low[3] = { INFINITY, INFINITY, INFINITY };
    double high[3] = { -INFINITY, -INFINITY, -INFINITY };
    bool good = (bounds && bound_nodes(scene, bounds))
                || error_set(error, "out of memory");
    for (size_t i = 0; good && i < scene->region_count; i++)
        good = join_box(&bounds[scene->regions[i].first_node], &scene->regions[i], low,
                        high, error);
    for (int i = 0; i < 3; i++) {
        sums->middle[i] = (low[i] + high[i]) / 2;
        sums->width[i] = high[i] - low[i];
    }
    free(bounds);
    return good;
}

/* Returns the number of words of a shift, or of a packet: the sums of parts, then of
 * pairs. */
static size_t words_of_shift(const struct columns_sums *sums)
{
    return sums->parts * MOMENTS + sums->pairs;
}

/* ---- Data that all packets share ----------------------------------------- */

/* Rays begin at this distance before the centre of the box, in units of half the width
 * of the box. */
static const double BEHIND = 1.25;

struct columns_work {
    const struct scene *scene;
    const struct columns_options *options;
    struct columns_sums *sums;
    struct object *rays, *columns, *overlaps, *totals;
    struct ray_query *lines[VIEWS];
    size_t rays_of_packet, packets; /* number of rays in a packet, and of packets of a
                                     * view for a shift */
    c205_word *words; /* [VIEWS][repeats][packets][sums]: the words of each packet */
    uint64_t (*clocks)[COLUMNS_STAGES]; /* for each packet */
    uint64_t *crossings;
};

static size_t unit_count(const struct columns_work *work)
{
    return VIEWS * work->options->repeats * work->packets;
}

static struct object *assemble_columns(const struct columns_work *work,
                                       const char *name, c205_error *error)
{
    const struct asm_define defines[] = {
        { "POINTS", work->options->points },
        { "RAYS", (int64_t)work->rays_of_packet },
        { NULL, 0 },
    };
    return form_assemble_beside(name, work->options->mode, defines, error);
}

static bool begin_view(struct columns_work *work, size_t view, c205_error *error)
{
    const struct columns_options *options = work->options;
    const struct ray_query_options lines = {
        .mode = options->mode,
        .queue = options->queue,
        .packet = work->rays_of_packet,
        .behind = BEHIND * work->sums->width[view] / 2,
        .normals = true,
        .bodies = true,
        .model = options->model,
    };
    work->lines[view] = ray_query_new(work->scene, &lines, error);
    return work->lines[view];
}

static bool begin_work(struct columns_work *work, c205_error *error)
{
    size_t rays = (size_t)1 << work->options->rays_log, units;
    bool good;
    work->rays_of_packet = rays < COLUMNS_PACKET ? rays : COLUMNS_PACKET;
    work->packets = rays / work->rays_of_packet;
    units = unit_count(work);
    work->words = calloc(units * words_of_shift(work->sums), sizeof *work->words);
    work->clocks = calloc(units, sizeof *work->clocks);
    work->crossings = calloc(units, sizeof *work->crossings);
    if (!work->words || !work->clocks || !work->crossings)
        return error_set(error, "out of memory");
    work->rays = assemble_columns(work, "mass/rays", error);
    work->columns = assemble_columns(work, "mass/columns", error);
    work->overlaps = assemble_columns(work, "mass/overlaps", error);
    work->totals = assemble_columns(work, "mass/totals", error);
    good = work->rays && work->columns && work->overlaps && work->totals;
    for (size_t view = 0; good && view < VIEWS; view++)
        good = begin_view(work, view, error);
    return good;
}

static void end_work(struct columns_work *work)
{
    for (size_t view = 0; view < VIEWS; view++)
        ray_query_free(work->lines[view]);
    object_free(work->rays);
    object_free(work->columns);
    object_free(work->overlaps);
    object_free(work->totals);
    free(work->words);
    free(work->clocks);
    free(work->crossings);
}

/* ---- A packet ------------------------------------------------------------ */

/* The planes that the program mass/rays writes. */
enum { PLACE_P, PLACE_Q, ORIGIN_P, ORIGIN_Q, RAY_PLANES };

struct columns_packet {
    const struct columns_work *work;
    size_t unit, view, shift, first; /* `first` is the index of the packet's first
                                      * ray */
    c205_word *rays;                 /* [RAY_PLANES][rays] */
    struct scene_ray *lines;
    struct ray_hits seen;
    c205_error *error;
};

/* Returns the axis s, p or q of a view if `which` is 0, 1 or 2. The axes are in cyclic
 * order. */
static size_t axis_of(size_t view, size_t which)
{
    return (view + which) % 3;
}

static bool make_rays(struct columns_packet *packet)
{
    const struct columns_work *work = packet->work;
    const struct columns_options *options = work->options;
    const struct columns_sums *sums = work->sums;
    size_t count = work->rays_of_packet;
    size_t shift = packet->view * options->repeats + packet->shift;
    struct single_run run;
    uint64_t made;
    single_run_begin(&run, work->rays, options->model, packet->error);
    single_run_word(&run, "rays_seed", options->seed);
    single_run_word(&run, "rays_first", packet->first);
    single_run_word(&run, "rays_m", options->rays_log);
    single_run_word(&run, "rays_shift", shift);
    single_run_word(&run, "rays_number", shift << options->rays_log);
    single_run_word(&run, "rays_count", count);
    for (size_t i = 0; i < 2; i++) {
        size_t axis = axis_of(packet->view, i + 1);
        single_run_number(&run, "rays_width", i, sums->width[axis]);
        single_run_number(&run, "rays_middle", i, sums->middle[axis]);
    }
    made = single_run_room(&run, "rays_results", NULL, RAY_PLANES * count);
    return single_run_end(&run, made, packet->rays, RAY_PLANES * count,
                          &work->clocks[packet->unit][STAGE_RAYS]);
}

static void lay_lines(const struct columns_packet *packet)
{
    const struct columns_sums *sums = packet->work->sums;
    size_t count = packet->work->rays_of_packet, view = packet->view;
    for (size_t i = 0; i < count; i++) {
        struct scene_ray *line = &packet->lines[i];
        *line = (struct scene_ray){ { 0 }, { 0 } };
        line->direction[view] = 1;
        line->origin[view] = sums->middle[view];
        for (size_t k = 0; k < 2; k++)
            line->origin[axis_of(view, k + 1)] = c205_to_double(
                packet->rays[(ORIGIN_P + k) * count + i]);
    }
}

static bool find_crossings(struct columns_packet *packet)
{
    const struct columns_work *work = packet->work;
    lay_lines(packet);
    if (!ray_query_find(work->lines[packet->view], packet->lines, work->rays_of_packet,
                        &packet->seen, packet->error))
        return false;
    work->clocks[packet->unit][STAGE_CROSSINGS] += packet->seen.accounts.clocks;
    work->crossings[packet->unit] = packet->seen.first[work->rays_of_packet];
    return true;
}

/* Rejects a crossing of an open surface, because such a surface has no volume. */
static bool check_crossing(const struct columns_packet *packet,
                           const struct ray_hit *seen)
{
    const struct primitive *primitive = &packet->work->scene
                                             ->primitives[seen->primitive];
    if (seen->crossing != 0)
        return true;
    return error_set(packet->error,
                     "the %s of line %zu is an open surface: it has no volume",
                     primitive_kind_name(primitive->kind), primitive->line);
}

/* The fields of a crossing, in the order of crossed.s. */
enum {
    CROSSED_S,
    CROSSED_NORMAL,
    CROSSED_RAY,
    CROSSED_PART,
    CROSSED_SIGN,
    CROSSED_OBJECT_DEPTH,
    CROSSED_SCENE_DEPTH,
    CROSSED_SIZE
};

static void lay_crossing(const struct columns_packet *packet, size_t ray, size_t i,
                         size_t count, c205_word *planes)
{
    const struct ray_hit *seen = &packet->seen.list[i];
    const size_t *part_of = packet->work->options->part_of;
    planes[CROSSED_S * count + i] = seen->distance;
    planes[CROSSED_NORMAL * count + i] = seen->normal[packet->view];
    planes[CROSSED_RAY * count + i] = c205_from_integer((int64_t)ray);
    planes[CROSSED_PART * count + i] = c205_from_integer(
        (int64_t)part_of[seen->object]);
    planes[CROSSED_SIGN * count + i] = c205_from_integer(seen->crossing);
    planes[CROSSED_OBJECT_DEPTH * count + i] = c205_from_integer(seen->object_depth);
    planes[CROSSED_SCENE_DEPTH * count + i] = c205_from_integer(seen->scene_depth);
}

static bool lay_crossings(const struct columns_packet *packet, c205_word *planes)
{
    const struct ray_hits *seen = &packet->seen;
    size_t count = seen->first[seen->line_count];
    for (size_t ray = 0; ray < seen->line_count; ray++)
        for (size_t i = seen->first[ray]; i < seen->first[ray + 1]; i++) {
            if (!check_crossing(packet, &seen->list[i]))
                return false;
            lay_crossing(packet, ray, i, count, planes);
        }
    return true;
}

static c205_word *words_of(const struct columns_packet *packet)
{
    return packet->work->words + packet->unit * words_of_shift(packet->work->sums);
}

/* Writes the crossings, and reserves room for `totals` sums. Returns the address of the
 * sums. */
static uint64_t give_crossed(const struct columns_packet *packet,
                             const c205_word *planes, size_t totals,
                             struct single_run *run)
{
    size_t count = packet->seen.first[packet->seen.line_count];
    single_run_word(run, "crossed_count", count);
    single_run_room(run, "crossed_planes", planes, CROSSED_SIZE * count);
    single_run_word(run, "crossed_totals", totals);
    single_run_room(run, "crossed_lanes", NULL,
                    totals * (size_t)layout_symbol(&run->layout, "LANES"));
    return single_run_room(run, "crossed_sums", NULL, totals);
}

static bool run_columns(const struct columns_packet *packet, const c205_word *planes)
{
    const struct columns_work *work = packet->work;
    size_t rays = work->rays_of_packet;
    size_t width = work->sums->parts * MOMENTS;
    struct single_run run;
    uint64_t made;
    single_run_begin(&run, work->columns, work->options->model, packet->error);
    made = give_crossed(packet, planes, width, &run);
    single_run_word(&run, "column_parts", work->options->part_count);
    single_run_word(&run, "column_rays", rays);
    single_run_room(&run, "column_places", packet->rays, 2 * rays);
    return single_run_end(&run, made, words_of(packet), width,
                          &work->clocks[packet->unit][STAGE_SUMS]);
}

static bool run_overlaps(const struct columns_packet *packet, const c205_word *planes)
{
    const struct columns_work *work = packet->work;
    const struct columns_sums *sums = work->sums;
    struct single_run run;
    uint64_t made;
    if (sums->pairs == 0)
        return true;
    single_run_begin(&run, work->overlaps, work->options->model, packet->error);
    made = give_crossed(packet, planes, sums->pairs, &run);
    overlaps_give(work->options->overlaps, &run);
    return single_run_end(&run, made, words_of(packet) + sums->parts * MOMENTS,
                          sums->pairs, &work->clocks[packet->unit][STAGE_OVERLAPS]);
}

static bool add_columns(const struct columns_packet *packet)
{
    size_t count = packet->seen.first[packet->seen.line_count];
    c205_word *planes = calloc(CROSSED_SIZE * count + 1, sizeof *planes);
    bool good = planes ? lay_crossings(packet, planes) && run_columns(packet, planes)
                             && run_overlaps(packet, planes)
                       : error_set(packet->error, "out of memory");
    free(planes);
    return good;
}

static bool do_packet(const struct columns_work *work, size_t unit, c205_error *error)
{
    size_t rays = work->rays_of_packet;
    size_t group = unit / work->packets;
    struct columns_packet packet = {
        .work = work,
        .unit = unit,
        .view = group / work->options->repeats,
        .shift = group % work->options->repeats,
        .first = unit % work->packets * rays,
        .rays = calloc(RAY_PLANES * rays, sizeof *packet.rays),
        .lines = calloc(rays, sizeof *packet.lines),
        .error = error,
    };
    bool good = packet.rays && packet.lines
                    ? make_rays(&packet) && find_crossings(&packet)
                          && add_columns(&packet)
                    : error_set(error, "out of memory");
    ray_hits_free(&packet.seen);
    free(packet.rays);
    free(packet.lines);
    return good;
}

/* Runs a packet and writes its results as words. */
static bool run_unit(void *context, size_t job, size_t unit,
                     struct serialized_result *words, c205_error *error)
{
    const struct columns_work *work = context;
    size_t width = words_of_shift(work->sums);
    (void)job;
    if (!do_packet(work, unit, error))
        return false;
    result_put_all(words, work->words + unit * width, width);
    result_put_all(words, work->clocks[unit], COLUMNS_STAGES);
    result_put(words, work->crossings[unit]);
    return true;
}

static bool take_unit(void *context, size_t unit, struct serialized_result *words,
                      c205_error *error)
{
    const struct columns_work *work = context;
    size_t width = words_of_shift(work->sums);
    result_take_all(words, work->words + unit * width, width);
    result_take_all(words, work->clocks[unit], COLUMNS_STAGES);
    work->crossings[unit] = result_take(words);
    return !words->failed || error_set(error, "the result of a packet is incomplete");
}

/* Opens the checkpoint files. Their key identifies all inputs of the packets. If a run
 * has several rounds, the files have the key of the first round, because it determines
 * the later rounds. */
static bool open_files(const struct columns_work *work, struct job_set *job_set,
                       c205_error *error)
{
    const struct columns_options *options = work->options;
    const uint64_t choices[] = {
        options->mode,
        options->queue,
        options->points,
        options->rays_log,
        options->repeats,
        options->seed,
        work->sums->parts,
        work->sums->pairs,
        hash_sizes(HASH_START, options->part_of, work->scene->object_count),
    };
    return ray_query_keep(work->lines[0], job_set, "mass", choices,
                          sizeof choices / sizeof *choices, error);
}

static bool do_packets(struct columns_work *work, c205_error *error)
{
    const struct columns_options *options = work->options;
    const struct job_set_work packets = {
        .job_set = options->job_set,
        .count = unit_count(work),
        .jobs = options->jobs,
        .first = (uint64_t)options->rays_log << 32,
        .run = run_unit,
        .take = take_unit,
        .context = work,
        .progress = options->progress,
        .progress_context = options->context,
    };
    work->sums->units = packets.count;
    return open_files(work, packets.job_set, error) && job_set_run(&packets, error);
}

static bool collects(const struct columns_work *work)
{
    return !work->options->job_set || job_set_collects(work->options->job_set);
}

/* ---- All packets --------------------------------------------------------- */

static bool add_packets(struct columns_work *work, c205_error *error)
{
    struct columns_sums *sums = work->sums;
    size_t groups = VIEWS * sums->repeats, width = words_of_shift(work->sums);
    struct single_run run;
    uint64_t made;
    single_run_begin(&run, work->totals, work->options->model, error);
    single_run_word(&run, "total_groups", groups);
    single_run_word(&run, "total_rows", work->packets);
    single_run_word(&run, "total_width", width);
    single_run_room(&run, "totals_from", work->words, groups * work->packets * width);
    made = single_run_room(&run, "totals_results", NULL, groups * width);
    return single_run_end(&run, made, sums->words, groups * width,
                          &sums->clocks[STAGE_TOTALS]);
}

static void add_accounts(const struct columns_work *work)
{
    struct columns_sums *sums = work->sums;
    for (size_t unit = 0; unit < unit_count(work); unit++) {
        sums->crossings += work->crossings[unit];
        for (int stage = 0; stage < COLUMNS_STAGES; stage++)
            sums->clocks[stage] += work->clocks[unit][stage];
    }
}

static bool check_options(const struct scene *scene,
                          const struct columns_options *options, c205_error *error)
{
    if (options->rays_log > MAX_COLUMNS_LOG)
        return error_set(error, "at most 2^20 rays of a view are allowed in a shift");
    if (options->repeats == 0)
        return error_set(error, "at least one shift is required");
    if (scene->region_count == 0)
        return error_set(error, "the scene has no objects");
    if (options->part_count > MAX_COLUMNS_PARTS)
        return error_set(error, "the scene has %zu parts; at most %d are allowed",
                         options->part_count, MAX_COLUMNS_PARTS);
    if (options->overlaps && options->overlaps->count > MAX_COLUMNS_PAIRS)
        return error_set(error,
                         "%zu pairs of parts may overlap; at most %d are allowed",
                         options->overlaps->count, MAX_COLUMNS_PAIRS);
    return true;
}

bool columns_sum(const struct scene *scene, const struct columns_options *options,
                 struct columns_sums *sums, c205_error *error)
{
    struct columns_work work = { .scene = scene, .options = options, .sums = sums };
    bool good;
    *sums = (struct columns_sums){ .parts = options->part_count + 1,
                                   .pairs = options->overlaps ? options->overlaps->count
                                                              : 0,
                                   .repeats = options->repeats,
                                   .rays_log = options->rays_log };
    if (!check_options(scene, options, error) || !find_box(scene, sums, error))
        return false;
    sums->words = calloc(VIEWS * sums->repeats * words_of_shift(sums),
                         sizeof *sums->words);
    good = sums->words ? begin_work(&work, error) && do_packets(&work, error)
                             && (!collects(&work) || add_packets(&work, error))
                       : error_set(error, "out of memory");
    if (good)
        add_accounts(&work);
    end_work(&work);
    if (!good)
        columns_sums_free(sums);
    return good;
}

void columns_sums_free(struct columns_sums *sums)
{
    free(sums->words);
    sums->words = NULL;
}

/* ---- Integrals ----------------------------------------------------------- */

/* Returns the integral over space for the sum at index `place` of a view and a
 * shift. */
static double integral_of(const struct columns_sums *sums, size_t view, size_t repeat,
                          size_t place)
{
    size_t shift = view * sums->repeats + repeat;
    c205_word sum = sums->words[shift * words_of_shift(sums) + place];
    double area = sums->width[axis_of(view, 1)] * sums->width[axis_of(view, 2)];
    return ldexp(c205_to_double(sum) * area, -(int)sums->rays_log);
}

double columns_integral(const struct columns_sums *sums, size_t view, size_t repeat,
                        size_t part, enum moment moment)
{
    return integral_of(sums, view, repeat, part * MOMENTS + moment);
}

double columns_overlap(const struct columns_sums *sums, size_t view, size_t repeat,
                       size_t pair)
{
    return integral_of(sums, view, repeat, sums->parts * MOMENTS + pair);
}

uint64_t columns_checksum(const struct columns_sums *sums)
{
    return hash_words(HASH_START, sums->words,
                      VIEWS * sums->repeats * words_of_shift(sums));
}
