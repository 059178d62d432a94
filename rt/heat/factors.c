#include "rt/heat/factors.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "rt/layout/single_run.h"
#include "rt/layout/program.h"
#include "rt/shapes/primitive.h"
#include "rt/study/tasks.h"

/* Lines through points along their normals begin so far below them. */
static const double below = 1e-3;

struct factors {
    const struct scene *scene;
    struct factors_options options;
    struct lines *normals, *rays;
    struct object *faces, *received;
};

/* ---- To begin ------------------------------------------------------------- */

static struct lines *begin_lines(const struct factors *factors, double behind,
                                 bool bodies, c205_error *error)
{
    const struct lines_options options = { .mode = factors->options.mode,
                                           .queue = factors->options.queue,
                                           .behind = behind,
                                           .bodies = bodies,
                                           .model = factors->options.model };

    return lines_new(factors->scene, &options, error);
}

static struct object *assemble(const struct factors *factors,
                               const char *name, c205_error *error)
{
    static const struct asm_define none[] = { { NULL, 0 } };
    char path[64];

    snprintf(path, sizeof path, "heat/%s_%s.s", name,
             trace_mode_name(factors->options.mode));
    return program_assemble(path, none, error);
}

static bool prepare(struct factors *factors, c205_error *error)
{
    factors->normals = begin_lines(factors, below, false, error);
    if (!factors->normals)
        return false;
    factors->rays = begin_lines(factors, 0, true, error);
    if (!factors->rays)
        return false;
    factors->faces = assemble(factors, "faces", error);
    if (!factors->faces)
        return false;
    factors->received = assemble(factors, "received", error);
    return factors->received;
}

struct factors *factors_new(const struct scene *scene,
                            const struct factors_options *options,
                            c205_error *error)
{
    struct factors *factors;

    if (options->repeats < 2) {
        error_say(error, "errors come of two repeats or more");
        return NULL;
    }
    factors = calloc(1, sizeof *factors);
    if (!factors) {
        error_say(error, "no memory");
        return NULL;
    }
    factors->scene = scene;
    factors->options = *options;
    if (prepare(factors, error))
        return factors;
    factors_free(factors);
    return NULL;
}

void factors_free(struct factors *factors)
{
    if (!factors)
        return;
    lines_free(factors->normals);
    lines_free(factors->rays);
    object_free(factors->faces);
    object_free(factors->received);
    free(factors);
}

/* ---- A packet -------------------------------------------------------------- */

/* One repeat of an emitter: what its rays come to, and what that took. */
struct packet {
    uint64_t stay;   /* points on faces */
    c205_word *sums; /* of weights, by receiver, of what is covered, of all */
    c205_word *counts;
    struct accounts accounts;
};

struct packet_run {
    const struct factors *factors;
    const struct emission *emission;
    size_t primitive, repeat;
    struct packet *packet;
    c205_word *made;  /* planes of all points, */
    c205_word *stays; /* of those that stay, and their number */
    struct scene_line *lines;
    c205_error *error;
};

static size_t receiver_count(const struct factors *factors)
{
    const struct factors_options *options = &factors->options;

    return 1
           + (options->receiver_of ? options->receivers
                                   : factors->scene->primitive_count);
}

/* Each primitive has shifts, or rays, of its own. */
static bool emit(const struct packet_run *run)
{
    const struct factors_options *options = &run->factors->options;
    size_t place = run->primitive * options->repeats + run->repeat;
    struct emission_choice choice = emission_choose(options->lattice,
                                                    options->seed,
                                                    options->points, place);

    return emission_run(run->emission, &choice, run->made,
                        &run->packet->accounts, run->error);
}

/* Those crossings that lines find from the points on in directions of these planes. */
static bool follow(const struct packet_run *run, const struct lines *lines,
                   const c205_word *planes, enum emitted direction,
                   size_t count, struct seen_crossings *found)
{
    size_t points = run->factors->options.points;

    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < 3; k++) {
            run->lines[i].origin[k] = c205_to_double(
                planes[(EMITTED_SPOT + k) * points + i]);
            run->lines[i].direction[k] = c205_to_double(
                planes[(direction + k) * points + i]);
        }
    if (!lines_find(lines, run->lines, count, found, run->error))
        return false;
    if (accounts_add_all(&run->packet->accounts, &found->accounts))
        return true;
    seen_crossings_free(found);
    return error_say(run->error, "no memory");
}

static void begin_run(const struct packet_run *packet,
                      const struct object *program, struct single_run *run)
{
    single_run_begin(run, program, packet->factors->options.model,
                     packet->error);
    run->accounts = &packet->packet->accounts;
}

/* The planes of a crossing, as in faces.s. */
enum { FACE_DISTANCE, FACE_PRIMITIVE, FACE_POINT, FACE_SENSE, FACE_PLANES };

static c205_word *lay_crossings(const struct seen_crossings *found)
{
    size_t count = found->first[found->line_count];
    c205_word *planes = calloc(FACE_PLANES * count + 1, sizeof *planes);

    for (size_t line = 0; planes && line < found->line_count; line++)
        for (size_t i = found->first[line]; i < found->first[line + 1]; i++) {
            const struct seen_crossing *seen = &found->list[i];

            planes[FACE_DISTANCE * count + i] = seen->distance;
            planes[FACE_PRIMITIVE * count + i] = c205_from_integer(
                (int64_t)seen->primitive);
            planes[FACE_POINT * count + i] = c205_from_integer((int64_t)line);
            planes[FACE_SENSE * count + i] = c205_from_integer(seen->sense
                                                               + 2);
        }
    return planes;
}

static bool run_faces(const struct packet_run *packet, const c205_word *list,
                      size_t crossings)
{
    size_t points = packet->factors->options.points;
    size_t words = EMITTED_PLANES * points;
    struct single_run run;
    uint64_t made, clocks = 0;

    begin_run(packet, packet->factors->faces, &run);
    single_run_word(&run, "faces_points", points);
    single_run_word(&run, "faces_planes", EMITTED_PLANES);
    single_run_room(&run, "faces_from", packet->made, words);
    made = single_run_room(&run, "faces_made", NULL, words + 1);
    single_run_word(&run, "faces_crossings", crossings);
    single_run_room(&run, "faces_list", list, FACE_PLANES * crossings);
    single_run_word(&run, "faces_primitive", packet->primitive);
    single_run_room(&run, "faces_kept", NULL, points);
    if (!single_run_end(&run, made, packet->stays, words + 1, &clocks))
        return false;
    packet->packet->stay = (uint64_t)c205_to_integer(packet->stays[words]);
    return true;
}

/* Points that are not on a face go. */
static bool keep_faces(const struct packet_run *packet)
{
    const struct factors *factors = packet->factors;
    struct seen_crossings found = { 0 };
    c205_word *list;
    bool good;

    if (!follow(packet, factors->normals, packet->made, EMITTED_FACE,
                factors->options.points, &found))
        return false;
    list = lay_crossings(&found);
    good = list ? run_faces(packet, list, found.first[found.line_count])
                : error_say(packet->error, "no memory");
    free(list);
    seen_crossings_free(&found);
    return good;
}

/* A line that leaves more bodies than it comes into began within one. */
static bool begins_within(const struct seen_crossings *found, size_t line)
{
    for (size_t k = found->first[line]; k < found->first[line + 1]; k++)
        if (found->list[k].within < 0)
            return true;
    return false;
}

static size_t receiver_of(const struct factors *factors, size_t primitive)
{
    const size_t *receivers = factors->options.receiver_of;

    return receivers ? receivers[primitive] : primitive;
}

/* Of each ray, what it meets first; of one that meets nothing, the environment; of one from
 * a point that another body covers, nothing: the place behind the environment. */
static void list_receivers(const struct packet_run *packet,
                           const struct seen_crossings *found,
                           c205_word *list)
{
    size_t environment = receiver_count(packet->factors) - 1;

    for (size_t i = 0; i < found->line_count; i++) {
        size_t first = found->first[i], receiver = environment;

        if (begins_within(found, i))
            receiver = environment + 1;
        else if (first < found->first[i + 1])
            receiver = receiver_of(packet->factors,
                                   found->list[first].primitive);
        list[i] = c205_from_integer((int64_t)receiver);
    }
}

static bool run_received(const struct packet_run *packet,
                         const c205_word *list)
{
    const struct packet *made = packet->packet;
    size_t rays = (size_t)made->stay,
           points = packet->factors->options.points;
    size_t receivers = receiver_count(packet->factors) + 1;
    struct single_run run;
    uint64_t sums, clocks = 0;

    begin_run(packet, packet->factors->received, &run);
    single_run_word(&run, "received_rays", rays);
    single_run_word(&run, "received_receivers", receivers);
    single_run_room(&run, "received_weights",
                    packet->stays + EMITTED_WEIGHT * points, rays);
    single_run_room(&run, "received_list", list, rays);
    sums = single_run_room(&run, "received_sums", NULL, 2 * receivers + 1);
    layout_word(&run.layout, "received_counts",
                sums + 64 * (receivers + UINT64_C(1)));
    single_run_room(&run, "received_room", NULL, rays);
    single_run_room(&run, "received_places", NULL, receivers);
    return single_run_end(&run, sums, made->sums, 2 * receivers + 1, &clocks);
}

/* The weights of rays go to what these meet first. */
static bool receive(const struct packet_run *packet)
{
    size_t rays = (size_t)packet->packet->stay;
    struct seen_crossings found = { 0 };
    c205_word *list;
    bool good;

    if (rays == 0)
        return true;
    if (!follow(packet, packet->factors->rays, packet->stays, EMITTED_RAY,
                rays, &found))
        return false;
    list = calloc(rays, sizeof *list);
    if (list)
        list_receivers(packet, &found, list);
    good = list ? run_received(packet, list)
                : error_say(packet->error, "no memory");
    free(list);
    seen_crossings_free(&found);
    return good;
}

static bool run_packet(struct packet_run *run)
{
    size_t points = run->factors->options.points;
    size_t words = EMITTED_PLANES * points;
    bool good;

    run->made = malloc(words * sizeof *run->made);
    run->stays = malloc((words + 1) * sizeof *run->stays);
    run->lines = malloc(points * sizeof *run->lines);
    good = run->made && run->stays && run->lines
               ? emit(run) && keep_faces(run) && receive(run)
               : error_say(run->error, "no memory");
    free(run->made);
    free(run->stays);
    free(run->lines);
    return good;
}

/* ---- The packets of a row ---------------------------------------------------- */

struct packets {
    const struct factors *factors;
    const struct emission *emission;
    size_t primitive, receivers;
    struct packet *list;
    c205_word *words;       /* of all */
    double *areas, *shares; /* of each repeat */
};

static bool packets_begin(struct packets *packets)
{
    const struct factors_options *options = &packets->factors->options;
    size_t width = 2 * packets->receivers + 3;

    packets->list = calloc(options->repeats, sizeof *packets->list);
    packets->words = calloc(options->repeats * width, sizeof *packets->words);
    packets->areas = calloc(options->repeats, sizeof *packets->areas);
    packets->shares = calloc(options->repeats, sizeof *packets->shares);
    if (!packets->list || !packets->words || !packets->areas
        || !packets->shares)
        return false;
    for (size_t i = 0; i < options->repeats; i++)
        packets->list[i] = (struct packet){
            .sums = packets->words + i * width,
            .counts = packets->words + i * width + packets->receivers + 2,
            .accounts = { .model = options->model },
        };
    return true;
}

static void packets_end(struct packets *packets)
{
    for (size_t i = 0; packets->list && i < packets->factors->options.repeats;
         i++)
        accounts_free(&packets->list[i].accounts);
    free(packets->list);
    free(packets->words);
    free(packets->areas);
    free(packets->shares);
}

static bool do_packet(void *context, const struct task *task,
                      c205_error *error)
{
    const struct packets *packets = context;
    struct packet_run run = { .factors = packets->factors,
                              .emission = packets->emission,
                              .primitive = packets->primitive,
                              .repeat = task->number,
                              .packet = &packets->list[task->number],
                              .error = error };

    return run_packet(&run);
}

static bool run_packets(struct packets *packets, c205_error *error)
{
    const struct factors_options *options = &packets->factors->options;
    const struct tasks tasks = { .count = options->repeats,
                                 .jobs = options->jobs,
                                 .run = do_packet,
                                 .context = packets };

    return tasks_run(&tasks, error);
}

/* ---- What they say ----------------------------------------------------------- */

/* Of a repeat, the mean over its points of what a receiver gets. */
static double share_of(const struct packets *packets, size_t repeat,
                       size_t receiver)
{
    return c205_to_double(packets->list[repeat].sums[receiver])
           / (double)packets->factors->options.points;
}

/* Of each repeat, all but what is covered. */
static void find_areas(const struct packets *packets)
{
    for (size_t k = 0; k < packets->factors->options.repeats; k++)
        packets->areas[k] = share_of(packets, k, packets->receivers + 1)
                            - share_of(packets, k, packets->receivers);
}

static struct estimate factor_of(const struct packets *packets,
                                 size_t receiver)
{
    size_t count = packets->factors->options.repeats;

    for (size_t k = 0; k < count; k++)
        packets->shares[k] = share_of(packets, k, receiver);
    return estimate_ratio(packets->shares, packets->areas, count);
}

static bool conclude(const struct packets *packets, struct factor_row *row)
{
    const struct factors_options *options = &packets->factors->options;
    bool good = true;

    for (size_t k = 0; good && k < options->repeats; k++) {
        const struct packet *packet = &packets->list[k];

        row->tried += options->points;
        row->sent += packet->stay
                     - (uint64_t)c205_to_integer(
                         packet->counts[row->receivers]);
        for (size_t j = 0; j < row->receivers; j++)
            row->count[j] += (uint64_t)c205_to_integer(packet->counts[j]);
        good = accounts_add_all(&row->accounts, &packet->accounts);
    }
    find_areas(packets);
    row->area = estimate_mean(packets->areas, options->repeats);
    for (size_t j = 0; j < row->receivers && row->sent > 0; j++)
        row->factor[j] = factor_of(packets, j);
    return good;
}

static bool row_begin(const struct factors *factors, struct factor_row *row)
{
    size_t receivers = receiver_count(factors);

    *row = (struct factor_row){ .receivers = receivers };
    row->accounts.model = factors->options.model;
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

static bool find_row(struct packets *packets, struct factor_row *row,
                     c205_error *error)
{
    if (!packets_begin(packets) || !row_begin(packets->factors, row))
        return error_say(error, "no memory");
    return run_packets(packets, error)
           && (conclude(packets, row) || error_say(error, "no memory"));
}

bool factors_find(const struct factors *factors, size_t primitive,
                  struct factor_row *row, c205_error *error)
{
    const struct factors_options *options = &factors->options;
    const struct emission_options emits = { .mode = options->mode,
                                            .queue = options->queue,
                                            .points = options->points,
                                            .lattice = options->lattice,
                                            .model = options->model };
    struct emission *emission =
        emission_new(&factors->scene->primitives[primitive], &emits, error);
    struct packets packets = { .factors = factors,
                               .emission = emission,
                               .primitive = primitive,
                               .receivers = receiver_count(factors) };
    bool good;

    *row = (struct factor_row){ .receivers = 0 };
    if (!emission)
        return false;
    good = find_row(&packets, row, error);
    if (!good)
        factor_row_free(row);
    emission_free(emission);
    packets_end(&packets);
    return good;
}
