/* factors.c - computes shape factors from packets of rays. */
#include "rt/heat/factors.h"

#include <stdlib.h>

#include "vm/error.h"
#include "base/fnv_hash.h"
#include "rt/heat/packet.h"

/* ---- Setup ---------------------------------------------------------------- */

struct factors {
    struct packet_programs programs;
};

struct factors *factors_new(const struct scene *scene,
                            const struct sampling_options *options, c205_error *error)
{
    struct factors *factors;
    if (options->points < 1 || options->points > MAX_FACTORS_POINTS) {
        error_set(error, "%zu points: the number must be between 1 and %d",
                  options->points, MAX_FACTORS_POINTS);
        return NULL;
    }
    if (options->repeats < 2) {
        error_set(
            error,
            "at least 2 repeats are required: errors are computed from their spread");
        return NULL;
    }
    factors = calloc(1, sizeof *factors);
    if (!factors) {
        error_set(error, "out of memory");
        return NULL;
    }
    factors->programs.scene = scene;
    factors->programs.options = *options;
    if (packet_programs_begin(&factors->programs, error))
        return factors;
    factors_free(factors);
    return NULL;
}

void factors_free(struct factors *factors)
{
    if (!factors)
        return;
    packet_programs_end(&factors->programs);
    free(factors);
}

/* ---- Rows ----------------------------------------------------------------- */

static bool row_begin(struct factor_row *row, const struct packet_programs *programs)
{
    size_t receivers = packet_receivers(programs);
    *row = (struct factor_row){ .receivers = receivers };
    row->accounts.model = programs->options.model;
    row->count = calloc(receivers, sizeof *row->count);
    row->factor = calloc(receivers, sizeof *row->factor);
    return row->count && row->factor;
}

void factor_row_free(struct factor_row *row)
{
    free(row->count);
    free(row->factor);
    accounts_free(&row->accounts);
    *row = (struct factor_row){ .receivers = 0 };
}

/* ---- Pieces --------------------------------------------------------------- */

/* The number of points of a piece. If the points are crossings of lines, this is the
 * number of lines. A piece may then have up to MAX_EMISSION crossings, almost four for
 * each line. */
enum { PIECE = 1 << 14 };

static size_t piece_count(const struct sampling_options *options)
{
    return options->points > MAX_EMISSION ? (options->points - 1) / PIECE + 1 : 1;
}

static size_t packet_count(const struct sampling_options *options)
{
    return options->repeats * piece_count(options);
}

/* Returns the number of points in a piece. Sets *first to the number of its first
 * point. */
static size_t find_piece(const struct sampling_options *options, size_t piece,
                         size_t *first)
{
    *first = PIECE * piece;
    return piece_count(options) == 1          ? options->points
           : options->points - *first > PIECE ? PIECE
                                              : options->points - *first;
}

/* All packets of an emitter, from which a row of factors is computed. */
struct repeats {
    size_t count, pieces, points, receivers;
    const struct packet *packets;
    double *areas, *shares; /* for each repeat */
};

/* Returns the mean weight of a receiver over the points of repeat k. */
static double share_of(const struct repeats *repeats, size_t k, size_t receiver)
{
    const struct packet *packet = &repeats->packets[k * repeats->pieces];
    double sum = 0;
    for (size_t i = 0; i < repeats->pieces; i++)
        sum += c205_to_double(packet[i].sums[receiver]);
    return sum / (double)repeats->points;
}

/* Computes the visible area of each repeat: the total area minus the covered area. */
static void find_areas(const struct repeats *repeats)
{
    for (size_t k = 0; k < repeats->count; k++)
        repeats->areas[k] = share_of(repeats, k, repeats->receivers + 1)
                            - share_of(repeats, k, repeats->receivers);
}

static struct estimate factor_of(const struct repeats *repeats, size_t receiver)
{
    for (size_t k = 0; k < repeats->count; k++)
        repeats->shares[k] = share_of(repeats, k, receiver);
    return estimate_ratio(repeats->shares, repeats->areas, repeats->count);
}

static bool count_rays(const struct repeats *repeats, struct factor_row *row)
{
    bool good = true;
    for (size_t k = 0; good && k < repeats->count * repeats->pieces; k++) {
        const struct packet *packet = &repeats->packets[k];
        row->tried += packet->made;
        row->sent += packet->stay
                     - (uint64_t)c205_to_integer(packet->counts[row->receivers]);
        for (size_t j = 0; j < row->receivers; j++)
            row->count[j] += (uint64_t)c205_to_integer(packet->counts[j]);
        for (int i = 0; i < HEAT_STEPS; i++)
            row->clocks[i] += packet->clocks[i];
        good = accounts_add_all(&row->accounts, &packet->accounts);
    }
    return good;
}

/* Computes the row of factors of an emitter from its packets. Returns false if out of
 * memory. */
static bool conclude(const struct packet_programs *programs,
                     const struct packet *packets, struct factor_row *row)
{
    const struct sampling_options *options = &programs->options;
    struct repeats repeats = { .count = options->repeats,
                               .pieces = piece_count(options),
                               .points = options->points,
                               .receivers = packet_receivers(programs),
                               .packets = packets };
    bool good;
    repeats.areas = calloc(repeats.count, sizeof *repeats.areas);
    repeats.shares = calloc(repeats.count, sizeof *repeats.shares);
    good = repeats.areas && repeats.shares && row_begin(row, programs)
           && count_rays(&repeats, row);
    if (good) {
        find_areas(&repeats);
        row->area = estimate_mean(repeats.areas, repeats.count);
        for (size_t j = 0; j < row->receivers && row->sent > 0; j++)
            row->factor[j] = factor_of(&repeats, j);
    }
    free(repeats.areas);
    free(repeats.shares);
    return good;
}

/* ---- Packets as units of a job set --------------------------------------------- */

/* The source of a thread's last packet. The next packet often has the same source. */
struct emitting {
    struct heat_source *source;
    size_t primitive, points;
};

/* The packets of an emitter that have been received. */
struct coming {
    struct packet *packets; /* packets of all repeats; NULL before the first is
                             * received */
    size_t count;
};

struct rows_work {
    const struct packet_programs *programs;
    const size_t *emitters; /* indices of primitives, in increasing order */
    size_t emitter_count, job_count;
    struct emitting *emitting; /* one element for each job */
    struct coming *coming;     /* one element for each emitter */
    struct factor_row *rows;   /* one row for each emitter */
};

static bool begin_source(const struct rows_work *work, struct emitting *emitting,
                         size_t primitive, size_t points, c205_error *error)
{
    const struct sampling_options *options = &work->programs->options;
    const struct emission_options emits = { .mode = options->mode,
                                            .queue = options->queue,
                                            .points = points,
                                            .lattice = options->lattice,
                                            .model = options->model };
    if (emitting->source && emitting->primitive == primitive
        && emitting->points == points)
        return true;
    source_free(emitting->source);
    emitting->primitive = primitive;
    emitting->points = points;
    emitting->source = source_new(work->programs->scene, primitive, &emits, error);
    return emitting->source;
}

static bool run_unit(void *context, size_t job, size_t unit,
                     struct serialized_result *words, c205_error *error)
{
    const struct rows_work *work = context;
    const struct sampling_options *options = &work->programs->options;
    size_t pieces = piece_count(options), packets = packet_count(options);
    struct packet_choice choice = {
        .primitive = work->emitters[unit / packets],
        .repeat = unit % packets / pieces,
    };
    size_t points = find_piece(options, unit % pieces, &choice.first);
    struct emitting *emitting = &work->emitting[job];
    struct packet packet = { .width = 0 };
    bool good;
    if (!begin_source(work, emitting, choice.primitive, points, error))
        return false;
    good = packet_begin(&packet, work->programs)
               ? packet_run(work->programs, emitting->source, &choice, &packet, error)
               : error_set(error, "out of memory");
    if (good)
        packet_put(&packet, words);
    packet_free(&packet);
    return good;
}

static void end_coming(struct coming *coming, size_t count)
{
    for (size_t k = 0; coming->packets && k < count; k++)
        packet_free(&coming->packets[k]);
    free(coming->packets);
    coming->packets = NULL;
}

static bool begin_coming(const struct rows_work *work, struct coming *coming)
{
    size_t count = packet_count(&work->programs->options);
    bool good;
    coming->packets = calloc(count, sizeof *coming->packets);
    good = coming->packets != NULL;
    for (size_t k = 0; good && k < count; k++)
        good = packet_begin(&coming->packets[k], work->programs);
    return good;
}

/* Stores the packet that a unit has computed. The last packet of an emitter completes
 * its row; all packets of the row are then freed. */
static bool take_unit(void *context, size_t unit, struct serialized_result *words,
                      c205_error *error)
{
    const struct rows_work *work = context;
    size_t count = packet_count(&work->programs->options);
    size_t i = unit / count;
    struct coming *coming = &work->coming[i];
    if (!coming->packets && !begin_coming(work, coming))
        return error_set(error, "out of memory");
    if (!packet_take(&coming->packets[unit % count], words))
        return error_set(error, "the result of a packet is incomplete");
    if (++coming->count < count)
        return true;
    if (!conclude(work->programs, coming->packets, &work->rows[i]))
        return error_set(error, "out of memory");
    end_coming(coming, count);
    return true;
}

static size_t unit_count(const struct rows_work *work)
{
    return work->emitter_count * packet_count(&work->programs->options);
}

/* ---- All rows ---------------------------------------------------------------- */

/* Opens the checkpoint files. Their key identifies all inputs of the packets, in
 * addition to the scene. */
static bool open_files(const struct rows_work *work, struct job_set *job_set,
                       c205_error *error)
{
    const struct packet_programs *programs = work->programs;
    const struct sampling_options *options = &programs->options;
    const uint64_t choices[] = {
        options->mode,
        options->queue,
        options->points,
        options->repeats,
        options->lattice,
        options->seed,
        packet_receivers(programs),
        hash_sizes(HASH_START, options->surface_of,
                   options->surface_of ? programs->scene->primitive_count : 0),
        hash_sizes(HASH_START, work->emitters, work->emitter_count),
    };
    return ray_query_keep(programs->rays, job_set, "heat by rays", choices,
                          sizeof choices / sizeof *choices, error);
}

static bool run_job_set(struct rows_work *work, c205_error *error)
{
    const struct sampling_options *options = &work->programs->options;
    const struct job_set_work packets = {
        .job_set = options->job_set,
        .count = unit_count(work),
        .jobs = options->jobs,
        .first = (uint64_t)options->points << 32,
        .run = run_unit,
        .take = take_unit,
        .context = work,
        .progress = options->progress,
        .progress_context = options->context,
    };
    return open_files(work, packets.job_set, error) && job_set_run(&packets, error);
}

static bool rows_begin(struct rows_work *work)
{
    size_t jobs = work->programs->options.jobs;
    work->job_count = jobs > 0 ? jobs : 1;
    work->emitting = calloc(work->job_count, sizeof *work->emitting);
    work->coming = calloc(work->emitter_count + 1, sizeof *work->coming);
    return work->emitting && work->coming;
}

static void rows_end(struct rows_work *work)
{
    for (size_t i = 0; work->emitting && i < work->job_count; i++)
        source_free(work->emitting[i].source);
    for (size_t i = 0; work->coming && i < work->emitter_count; i++)
        end_coming(&work->coming[i], packet_count(&work->programs->options));
    free(work->emitting);
    free(work->coming);
}

size_t factors_units(const struct factors *factors, size_t count)
{
    return count * packet_count(&factors->programs.options);
}

bool factors_find(const struct factors *factors, const size_t *emitters, size_t count,
                  struct factor_row *rows, c205_error *error)
{
    struct rows_work work = { .programs = &factors->programs,
                              .emitters = emitters,
                              .emitter_count = count,
                              .rows = rows };
    bool good;
    for (size_t i = 0; i < count; i++)
        rows[i] = (struct factor_row){ .receivers = 0 };
    good = rows_begin(&work) ? run_job_set(&work, error)
                             : error_set(error, "out of memory");
    rows_end(&work);
    for (size_t i = 0; !good && i < count; i++)
        factor_row_free(&rows[i]);
    return good;
}
