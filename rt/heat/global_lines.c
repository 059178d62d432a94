/* global_lines.c - computes shape factors from lines through the whole scene. */
#include "rt/heat/global_lines.h"

#include <math.h>
#include <stdlib.h>

#include "vm/error.h"
#include "base/fnv_hash.h"
#include "rt/heat/chords.h"
#include "rt/layout/bounds.h"
#include "rt/layout/single_run.h"
#include "rt/scene/elementary.h"
#include "rt/shapes/primitive.h"
#include "rt/trace/form.h"
#include "rt/trace/ray_query.h"

/* A shorter gap, in world units, is ignored, because the surfaces touch there. */
static const double least_gap = 1e-7;
/* The sphere around the scene's box is enlarged by this factor. */
static const double larger = 1.001;

enum { MAX_SURFACES = 1023, MAX_ENDS = 65535 };

struct global_work {
    const struct scene *scene;
    const struct sampling_options *options;
    struct global_lines *found;
    struct chords chords;
    struct ray_query *lines;
    struct object *gaps;
    size_t lines_of_packet, packets; /* number of lines in a packet, and of packets in a
                                      * repeat */
};

/* Returns the number of surfaces, including the environment. */
static size_t receiver_count(const struct global_work *work)
{
    return work->found->surfaces + 1;
}

static size_t cells_of(const struct global_work *work)
{
    return receiver_count(work) * receiver_count(work);
}

static size_t unit_count(const struct global_work *work)
{
    return work->options->repeats * work->packets;
}

/* ---- The sphere around the scene ------------------------------------------ */

static bool join_box(const struct bound *bound, const struct region *region,
                     double low[3], double high[3], c205_error *error)
{
    if (bound_is_none(bound))
        return error_set(error,
                         "the object of line %zu has unknown bounds: lines need a "
                         "sphere around the scene",
                         region->line);
    for (int i = 0; i < 3; i++) {
        low[i] = fmin(low[i], bound->low[i]);
        high[i] = fmax(high[i], bound->high[i]);
    }
    return true;
}

static bool find_sphere(struct global_work *work, c205_error *error)
{
    const struct scene *scene = work->scene;
    struct bound *bounds = calloc(scene->node_count + 1, sizeof *bounds);
    double low[3] = { INFINITY, INFINITY, INFINITY };
    double high[3] = { -INFINITY, -INFINITY, -INFINITY }, square = 0;
    bool good = (bounds && bound_nodes(scene, bounds))
                || error_set(error, "out of memory");
    for (size_t i = 0; good && i < scene->region_count; i++)
        good = join_box(&bounds[scene->regions[i].first_node], &scene->regions[i], low,
                        high, error);
    for (int i = 0; good && i < 3; i++) {
        work->chords.center[i] = (low[i] + high[i]) / 2;
        square += (high[i] - low[i]) * (high[i] - low[i]);
    }
    work->chords.radius = larger * sqrt(square) / 2;
    work->found->radius = work->chords.radius;
    free(bounds);
    return good;
}

/* ---- Setup ----------------------------------------------------------------- */

static size_t surface_count(const struct scene *scene,
                            const struct sampling_options *options)
{
    return options->surface_of ? options->surfaces : scene->primitive_count;
}

static bool check_options(const struct scene *scene,
                          const struct sampling_options *options, c205_error *error)
{
    if (scene->primitive_count == 0)
        return error_set(error, "the scene has no surfaces");
    if (surface_count(scene, options) > MAX_SURFACES)
        return error_set(error, "lines allow at most %d surfaces; the scene has %zu",
                         MAX_SURFACES, surface_count(scene, options));
    if (options->repeats < 2)
        return error_set(
            error,
            "at least 2 repeats are required: errors are computed from their spread");
    if (options->lines_log > MAX_GLOBAL_LINES_LOG)
        return error_set(error, "at most 2^%d lines are allowed in a repeat",
                         MAX_GLOBAL_LINES_LOG);
    return true;
}

static bool begin_chords(struct global_work *work, c205_error *error)
{
    const struct sampling_options *options = work->options;
    const struct emission_options emits = { .mode = trace_mode_besides(options->mode),
                                            .queue = options->queue,
                                            .points = work->lines_of_packet,
                                            .lattice = options->lattice,
                                            .model = options->model };
    return chords_begin(&work->chords, &emits, error);
}

static bool begin_lines(struct global_work *work, c205_error *error)
{
    const struct sampling_options *options = work->options;
    const struct ray_query_options lines = {
        .mode = options->mode,
        .queue = options->queue,
        .packet = work->lines_of_packet,
        .behind = CHORDS_BEHIND * work->found->radius,
        .bodies = true,
        .model = options->model,
    };
    work->lines = ray_query_new(work->scene, &lines, error);
    return work->lines;
}

static bool begin_gaps(struct global_work *work, c205_error *error)
{
    work->gaps = form_assemble_beside("heat/gaps", work->options->mode, NULL, error);
    return work->gaps;
}

static bool begin_room(struct global_work *work)
{
    work->found->ends = calloc(work->options->repeats * cells_of(work),
                               sizeof *work->found->ends);
    return work->found->ends;
}

static bool lines_begin(struct global_work *work, c205_error *error)
{
    size_t lines = (size_t)1 << work->options->lines_log;
    work->lines_of_packet = lines < GLOBAL_LINES_PACKET ? lines : GLOBAL_LINES_PACKET;
    work->packets = lines / work->lines_of_packet;
    if (!begin_room(work))
        return error_set(error, "out of memory");
    return find_sphere(work, error) && begin_chords(work, error)
           && begin_lines(work, error) && begin_gaps(work, error);
}

static void lines_end(struct global_work *work)
{
    chords_end(&work->chords);
    ray_query_free(work->lines);
    object_free(work->gaps);
}

/* ---- A packet -------------------------------------------------------------- */

struct global_packet {
    const struct global_work *work;
    size_t unit;
    c205_word *planes; /* planes of the points where the lines end */
    struct scene_ray *lines;
    struct ray_hits seen;
    c205_word *counts; /* counts of gaps: a row for each surface */
    struct accounts accounts;
    uint64_t clocks[HEAT_STEPS]; /* clocks of these machines for each step */
    c205_error *error;
};

static bool make_lines(struct global_packet *packet)
{
    const struct global_work *work = packet->work;
    const struct sampling_options *options = work->options;
    size_t repeat = packet->unit / work->packets;
    size_t first = packet->unit % work->packets * work->lines_of_packet;
    struct emission_choice choice = {
        .seed = options->seed, .m = options->lines_log, .shift = repeat, .first = first
    };
    if (!options->lattice)
        choice.first += repeat << options->lines_log;
    if (!chords_run(&work->chords, &choice, packet->planes, packet->lines,
                    &packet->accounts, packet->error))
        return false;
    heat_charge(packet->clocks, &packet->accounts, STEP_EMISSION);
    return true;
}

/* The planes in which the ends of gaps are stored, in the order of gaps.s. */
enum { GAP_DISTANCE, GAP_SURFACE, GAP_SCENE_DEPTH, GAP_PLANES };

struct ends {
    size_t count;
    c205_word *planes[GAP_PLANES]; /* adjacent parts of one allocation */
};

static void add_end(struct ends *ends, c205_word distance, size_t surface, int within)
{
    size_t i = ends->count++;
    ends->planes[GAP_DISTANCE][i] = distance;
    ends->planes[GAP_SURFACE][i] = c205_from_integer((int64_t)surface);
    ends->planes[GAP_SCENE_DEPTH][i] = c205_from_integer(within);
}

static size_t surface_of(const struct global_packet *packet, size_t primitive)
{
    const size_t *surfaces = packet->work->options->surface_of;
    return surfaces ? surfaces[primitive] : primitive;
}

/* Lists the ends of gaps: for each line an end that belongs to the environment, then
 * its crossings. One more environment end follows the last line. An environment end has
 * a distance that no crossing has. */
static bool lay_ends(const struct global_packet *packet, struct ends *ends)
{
    const struct ray_hits *seen = &packet->seen;
    size_t environment = packet->work->found->surfaces;
    size_t count = seen->first[seen->line_count] + seen->line_count + 1;
    c205_word away = c205_from_double(packet->work->found->radius);
    c205_word *words = calloc(GAP_PLANES * count, sizeof *words);
    for (size_t k = 0; k < GAP_PLANES; k++)
        ends->planes[k] = words ? words + k * count : NULL;
    for (size_t line = 0; words && line < seen->line_count; line++) {
        add_end(ends, away, environment, 0);
        for (size_t i = seen->first[line]; i < seen->first[line + 1]; i++)
            add_end(ends, seen->list[i].distance,
                    surface_of(packet, seen->list[i].primitive),
                    seen->list[i].scene_depth);
    }
    if (words)
        add_end(ends, away, environment, 0);
    return words != NULL;
}

/* Counts the gaps among the `count` intervals between successive ends, from the end
 * `first` on. Adds them to the counts of the packet. */
static bool count_gaps(struct global_packet *packet, const struct ends *ends,
                       size_t first, size_t count)
{
    const struct global_work *work = packet->work;
    size_t cells = cells_of(work), i;
    c205_word *part = calloc(GAP_PLANES * (count + 1), sizeof *part);
    c205_word *made = calloc(cells, sizeof *made);
    struct single_run run;
    uint64_t counts, clocks = 0;
    bool good = false;
    for (size_t k = 0; part && k < GAP_PLANES; k++)
        for (i = 0; i <= count; i++)
            part[k * (count + 1) + i] = ends->planes[k][first + i];
    if (part && made) {
        single_run_begin(&run, work->gaps, work->options->model, packet->error);
        run.accounts = &packet->accounts;
        single_run_word(&run, "gaps_count", count);
        single_run_word(&run, "gaps_surfaces", receiver_count(work));
        single_run_room(&run, "gaps_ends", part, GAP_PLANES * (count + 1));
        counts = single_run_room(&run, "gaps_counts", NULL, cells);
        single_run_room(&run, "gaps_buffer", NULL, 3 * count);
        single_run_number(&run, "gaps_least", 0, least_gap);
        good = single_run_end(&run, counts, made, cells, &clocks);
        for (i = 0; good && i < cells; i++)
            packet->counts[i] = c205_from_integer(c205_to_integer(packet->counts[i])
                                                  + c205_to_integer(made[i]));
    } else {
        error_set(packet->error, "out of memory");
    }
    free(part);
    free(made);
    return good;
}

static bool count_all(struct global_packet *packet)
{
    struct ends ends = { .count = 0 };
    size_t most = MAX_ENDS - 1, gaps;
    bool good = lay_ends(packet, &ends) || error_set(packet->error, "out of memory");
    gaps = good ? ends.count - 1 : 0;
    for (size_t i = 0; good && i < gaps; i += most)
        good = count_gaps(packet, &ends, i, gaps - i < most ? gaps - i : most);
    free(ends.planes[0]);
    return good;
}

static bool run_packet(struct global_packet *packet)
{
    const struct global_work *work = packet->work;
    bool good = make_lines(packet)
                && ray_query_find(work->lines, packet->lines, work->lines_of_packet,
                                  &packet->seen, packet->error);
    if (good)
        good = accounts_add_all(&packet->accounts, &packet->seen.accounts)
               || error_set(packet->error, "out of memory");
    heat_charge(packet->clocks, &packet->accounts, STEP_CROSSINGS);
    good = good && count_all(packet);
    heat_charge(packet->clocks, &packet->accounts, STEP_COUNTS);
    ray_hits_free(&packet->seen);
    return good;
}

static bool begin_packet(struct global_packet *packet)
{
    const struct global_work *work = packet->work;
    size_t count = work->lines_of_packet;
    packet->planes = malloc(EMITTED_PLANES * count * sizeof *packet->planes);
    packet->lines = malloc(count * sizeof *packet->lines);
    packet->counts = calloc(cells_of(work), sizeof *packet->counts);
    packet->accounts.model = work->options->model;
    return packet->planes && packet->lines && packet->counts;
}

static void end_packet(struct global_packet *packet)
{
    free(packet->planes);
    free(packet->lines);
    free(packet->counts);
    accounts_free(&packet->accounts);
}

/* ---- Packets as units of a job set --------------------------------------------- */

/* Writes only the counts that are not 0: their number, then index and count of each.
 * Most pairs of surfaces cannot see each other. */
static void put_counts(const struct global_packet *packet,
                       struct serialized_result *words)
{
    size_t cells = cells_of(packet->work), some = 0;
    for (size_t i = 0; i < cells; i++)
        some += c205_to_integer(packet->counts[i]) != 0;
    result_put(words, some);
    for (size_t i = 0; i < cells; i++) {
        int64_t count = c205_to_integer(packet->counts[i]);
        if (count != 0) {
            result_put(words, i);
            result_put(words, (uint64_t)count);
        }
    }
}

static bool run_unit(void *context, size_t job, size_t unit,
                     struct serialized_result *words, c205_error *error)
{
    struct global_packet packet = { .work = context, .unit = unit, .error = error };
    bool good = begin_packet(&packet) ? run_packet(&packet)
                                      : error_set(error, "out of memory");
    (void)job;
    if (good) {
        result_put_accounts(words, &packet.accounts);
        result_put_all(words, packet.clocks, HEAT_STEPS);
        put_counts(&packet, words);
    }
    end_packet(&packet);
    return good;
}

/* Adds `count` gaps between the surfaces i and j, which `cell` encodes. A gap from i to
 * j is also a gap from j to i. */
static void add_gaps(const struct global_work *work, size_t unit, uint64_t cell,
                     uint64_t count)
{
    size_t width = receiver_count(work), i = (size_t)cell / width,
           j = (size_t)cell % width;
    uint64_t *ends = work->found->ends + unit / work->packets * cells_of(work);
    ends[i * width + j] += count;
    ends[j * width + i] += count;
}

/* Returns true if the next words have the format of put_counts. */
static bool are_counts(const struct global_work *work,
                       const struct serialized_result *words)
{
    struct serialized_result look = *words;
    uint64_t some = result_take(&look), last = 0;
    bool good = some <= cells_of(work);
    for (uint64_t i = 0; good && i < some; i++) {
        uint64_t cell = result_take(&look);
        good = cell < cells_of(work) && (i == 0 || cell > last);
        last = cell;
        result_take(&look);
    }
    return good && !look.failed;
}

/* Adds the serialized result of a packet to the sums. After an error, adds nothing. */
static bool take_unit(void *context, size_t unit, struct serialized_result *words,
                      c205_error *error)
{
    const struct global_work *work = context;
    struct accounts accounts = { .model = work->options->model };
    uint64_t clocks[HEAT_STEPS] = { 0 };
    bool good = result_take_accounts(words, &accounts);
    result_take_all(words, clocks, HEAT_STEPS);
    good = good && are_counts(work, words)
           && accounts_add_all(&work->found->accounts, &accounts);
    for (int i = 0; good && i < HEAT_STEPS; i++)
        work->found->clocks[i] += clocks[i];
    for (uint64_t i = good ? result_take(words) : 0; i > 0; i--) {
        uint64_t cell = result_take(words);
        add_gaps(work, unit, cell, result_take(words));
    }
    accounts_free(&accounts);
    return good || error_set(error, "the result of a packet is incomplete");
}

/* Opens the checkpoint files. Their key identifies all inputs of the packets, in
 * addition to the scene. */
static bool open_files(const struct global_work *work, struct job_set *job_set,
                       c205_error *error)
{
    const struct sampling_options *options = work->options;
    const uint64_t choices[] = {
        options->mode,
        options->queue,
        options->lines_log,
        options->repeats,
        options->lattice,
        options->seed,
        work->found->surfaces,
        hash_sizes(HASH_START, options->surface_of,
                   options->surface_of ? work->scene->primitive_count : 0),
    };
    return ray_query_keep(work->lines, job_set, "heat by lines", choices,
                          sizeof choices / sizeof *choices, error);
}

static bool run_packets(struct global_work *work, c205_error *error)
{
    const struct sampling_options *options = work->options;
    const struct job_set_work packets = {
        .job_set = options->job_set,
        .count = unit_count(work),
        .jobs = options->jobs,
        .first = (uint64_t)options->lines_log << 32,
        .run = run_unit,
        .take = take_unit,
        .context = work,
        .progress = options->progress,
        .progress_context = options->context,
    };
    work->found->units = packets.count;
    return open_files(work, packets.job_set, error) && job_set_run(&packets, error);
}

bool global_lines_find(const struct scene *scene,
                       const struct sampling_options *options,
                       struct global_lines *found, c205_error *error)
{
    struct global_work work = { .scene = scene, .options = options, .found = found };
    bool good;
    *found = (struct global_lines){ .surfaces = surface_count(scene, options),
                                    .repeats = options->repeats,
                                    .lines_log = options->lines_log,
                                    .accounts = { .model = options->model } };
    if (!check_options(scene, options, error))
        return false;
    good = lines_begin(&work, error) && run_packets(&work, error);
    lines_end(&work);
    if (!good)
        global_lines_free(found);
    return good;
}

void global_lines_free(struct global_lines *found)
{
    free(found->ends);
    accounts_free(&found->accounts);
    *found = (struct global_lines){ 0 };
}

/* ---- Results ----------------------------------------------------------------- */

static uint64_t count_in(const struct global_lines *found, size_t repeat, size_t i,
                         size_t j)
{
    size_t width = found->surfaces + 1;
    return found->ends[(repeat * width + i) * width + j];
}

/* Returns the number of ends of gaps at surface i in a repeat. */
static uint64_t row_in(const struct global_lines *found, size_t repeat, size_t i)
{
    uint64_t sum = 0;
    for (size_t j = 0; j <= found->surfaces; j++)
        sum += count_in(found, repeat, i, j);
    return sum;
}

static uint64_t row_of(const struct global_lines *found, size_t i)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < found->repeats; k++)
        sum += row_in(found, k, i);
    return sum;
}

uint64_t global_lines_count(const struct global_lines *found, size_t i, size_t j)
{
    uint64_t sum = 0;
    for (size_t k = 0; k < found->repeats; k++)
        sum += count_in(found, k, i, j);
    return sum;
}

/* Returns the standard error of a sum over the repeats. `squares` is the sum of the
 * squared deviations of the repeats from their mean. Even if all repeats of a lattice
 * have the same counts, the error is at least the effect of one more line, with its two
 * ends, in one repeat. */
static double error_of(const struct global_lines *found, double squares)
{
    double n = (double)found->repeats;
    return sqrt(fmax(squares, 4) * n / (n - 1));
}

struct estimate global_lines_area(const struct global_lines *found, size_t i)
{
    double sum = (double)row_of(found, i), n = (double)found->repeats;
    double unit = 2 * elementary_acos(-1) * found->radius * found->radius
                  / (n * ldexp(1, (int)found->lines_log));
    double squares = 0;
    for (size_t k = 0; k < found->repeats; k++) {
        double beside = (double)row_in(found, k, i) - sum / n;
        squares += beside * beside;
    }
    return (struct estimate){ unit * sum, unit * error_of(found, squares) };
}

/* The factor is the ratio of two counts of gap ends: the ends at surface i that face
 * surface j (`count`), and all ends at surface i (`row`). Its error is the error of the
 * sum of count - factor * row over the repeats, divided by `row`. */
struct estimate global_lines_factor(const struct global_lines *found, size_t i,
                                    size_t j)
{
    double row = (double)row_of(found, i);
    double factor = (double)global_lines_count(found, i, j) / row;
    double squares = 0;
    for (size_t k = 0; k < found->repeats; k++) {
        double beside = (double)count_in(found, k, i, j)
                        - factor * (double)row_in(found, k, i);
        squares += beside * beside;
    }
    return (struct estimate){ factor, error_of(found, squares) / row };
}
