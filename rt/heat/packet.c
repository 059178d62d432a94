/* packet.c - runs packets of rays and counts their receivers. */
#include "rt/heat/packet.h"

#include <stdlib.h>

#include "vm/error.h"
#include "rt/layout/single_run.h"
#include "rt/trace/form.h"

/* A line along the normal at a point begins at this distance before the point. */
static const double below = 1e-3;

/* ---- Setup ---------------------------------------------------------------- */

static struct ray_query *begin_lines(const struct packet_programs *programs,
                                     double behind, bool bodies, c205_error *error)
{
    const struct ray_query_options options = { .mode = programs->options.mode,
                                               .queue = programs->options.queue,
                                               .behind = behind,
                                               .bodies = bodies,
                                               .model = programs->options.model };
    return ray_query_new(programs->scene, &options, error);
}

bool packet_programs_begin(struct packet_programs *programs, c205_error *error)
{
    enum trace_mode mode = programs->options.mode;
    programs->normals = begin_lines(programs, below, false, error);
    if (!programs->normals)
        return false;
    programs->rays = begin_lines(programs, 0, true, error);
    if (!programs->rays)
        return false;
    programs->faces = form_assemble_beside("heat/faces", mode, NULL, error);
    if (!programs->faces)
        return false;
    programs->received = form_assemble_beside("heat/received", mode, NULL, error);
    return programs->received;
}

void packet_programs_end(struct packet_programs *programs)
{
    ray_query_free(programs->normals);
    ray_query_free(programs->rays);
    object_free(programs->faces);
    object_free(programs->received);
}

/* ---- Words ---------------------------------------------------------------- */

size_t packet_receivers(const struct packet_programs *programs)
{
    const struct sampling_options *options = &programs->options;
    return 1
           + (options->surface_of ? options->surfaces
                                  : programs->scene->primitive_count);
}

bool packet_begin(struct packet *packet, const struct packet_programs *programs)
{
    size_t receivers = packet_receivers(programs);
    *packet = (struct packet){ .width = 2 * receivers + 3,
                               .accounts.model = programs->options.model };
    packet->sums = calloc(packet->width, sizeof *packet->sums);
    packet->counts = packet->sums ? packet->sums + receivers + 2 : NULL;
    return packet->sums;
}

void packet_free(struct packet *packet)
{
    free(packet->sums);
    accounts_free(&packet->accounts);
    *packet = (struct packet){ .width = 0 };
}

void packet_put(const struct packet *packet, struct serialized_result *words)
{
    result_put(words, packet->made);
    result_put(words, packet->stay);
    result_put_all(words, packet->sums, packet->width);
    result_put_all(words, packet->clocks, HEAT_STEPS);
    result_put_accounts(words, &packet->accounts);
}

bool packet_take(struct packet *packet, struct serialized_result *words)
{
    packet->made = result_take(words);
    packet->stay = result_take(words);
    result_take_all(words, packet->sums, packet->width);
    result_take_all(words, packet->clocks, HEAT_STEPS);
    if (!words->failed && result_take_accounts(words, &packet->accounts))
        return true;
    accounts_free(&packet->accounts);
    return false;
}

/* ---- A packet ------------------------------------------------------------- */

struct packet_work {
    const struct packet_programs *programs;
    const struct heat_source *source;
    struct packet_choice choice;
    struct packet *packet;
    struct sourced made; /* all points of the source */
    c205_word *stays;    /* planes of the points on visible faces, then their number */
    struct scene_ray *lines;
    c205_error *error;
};

/* Attributes to `step` the clocks that have passed since the previous call. */
static void charge(const struct packet_work *work, enum heat_step step)
{
    heat_charge(work->packet->clocks, &work->packet->accounts, step);
}

/* Generates the points. Each primitive and repeat has its own shift of the lattice, or
 * its own random numbers. */
static bool emit_points(struct packet_work *work)
{
    const struct sampling_options *options = &work->programs->options;
    size_t place = work->choice.primitive * options->repeats + work->choice.repeat;
    struct emission_choice choice = emission_choose(options->lattice, options->seed,
                                                    options->points, place);
    choice.first += work->choice.first;
    if (!source_run(work->source, &choice, &work->made, &work->packet->accounts,
                    work->error))
        return false;
    charge(work, STEP_EMISSION);
    return true;
}

/* Runs a query along lines through the first `count` points. The directions of the
 * lines are in three planes, from the plane `direction` on. */
static bool follow(const struct packet_work *work, const struct ray_query *lines,
                   const c205_word *planes, enum emitted direction, size_t count,
                   struct ray_hits *found)
{
    size_t points = work->made.count;
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < 3; k++) {
            work->lines[i].origin[k] = c205_to_double(
                planes[(EMITTED_POINT + k) * points + i]);
            work->lines[i].direction[k] = c205_to_double(
                planes[(direction + k) * points + i]);
        }
    if (!ray_query_find(lines, work->lines, count, found, work->error))
        return false;
    if (accounts_add_all(&work->packet->accounts, &found->accounts))
        return true;
    ray_hits_free(found);
    return error_set(work->error, "out of memory");
}

static void begin_run(const struct packet_work *work, const struct object *program,
                      struct single_run *run)
{
    single_run_begin(run, program, work->programs->options.model, work->error);
    run->accounts = &work->packet->accounts;
}

/* The planes in which the crossings of the lines are stored, in the order of
 * faces.s. */
enum { FACE_DISTANCE, FACE_PRIMITIVE, FACE_POINT, FACE_SIGN, FACE_PLANES };

static c205_word *lay_crossings(const struct ray_hits *found)
{
    size_t count = found->first[found->line_count];
    c205_word *planes = calloc(FACE_PLANES * count + 1, sizeof *planes);
    for (size_t line = 0; planes && line < found->line_count; line++)
        for (size_t i = found->first[line]; i < found->first[line + 1]; i++) {
            const struct ray_hit *seen = &found->list[i];
            planes[FACE_DISTANCE * count + i] = seen->distance;
            planes[FACE_PRIMITIVE * count + i] = c205_from_integer(
                (int64_t)seen->primitive);
            planes[FACE_POINT * count + i] = c205_from_integer((int64_t)line);
            planes[FACE_SIGN * count + i] = c205_from_integer(seen->crossing + 2);
        }
    return planes;
}

static bool run_faces(const struct packet_work *work, const c205_word *list,
                      size_t crossings)
{
    size_t points = work->made.count;
    size_t words = EMITTED_PLANES * points;
    struct single_run run;
    uint64_t made, clocks = 0;
    begin_run(work, work->programs->faces, &run);
    single_run_word(&run, "faces_points", points);
    single_run_word(&run, "faces_planes", EMITTED_PLANES);
    single_run_room(&run, "faces_from", work->made.planes, words);
    made = single_run_room(&run, "faces_results", NULL, words + 1);
    single_run_word(&run, "faces_crossings", crossings);
    single_run_room(&run, "faces_list", list, FACE_PLANES * crossings);
    single_run_word(&run, "faces_primitive", work->choice.primitive);
    single_run_word(&run, "faces_vectors",
                    UINT64_C(7) << EMITTED_FACE | UINT64_C(7) << EMITTED_RAY);
    single_run_room(&run, "faces_kept", NULL, points);
    if (!single_run_end(&run, made, work->stays, words + 1, &clocks))
        return false;
    work->packet->stay = (uint64_t)c205_to_integer(work->stays[words]);
    return true;
}

/* Removes the points that are not on a visible face. */
static bool keep_faces(const struct packet_work *work)
{
    const struct packet_programs *programs = work->programs;
    struct ray_hits found = { 0 };
    c205_word *list;
    bool good;
    if (!follow(work, programs->normals, work->made.planes, EMITTED_FACE,
                work->made.count, &found))
        return false;
    list = lay_crossings(&found);
    good = list ? run_faces(work, list, found.first[found.line_count])
                : error_set(work->error, "out of memory");
    charge(work, STEP_FACES);
    free(list);
    ray_hits_free(&found);
    return good;
}

/* Returns true if a line leaves more bodies than it enters, so that it began inside a
 * body. */
static bool begins_within(const struct ray_hits *found, size_t line)
{
    for (size_t k = found->first[line]; k < found->first[line + 1]; k++)
        if (found->list[k].scene_depth < 0)
            return true;
    return false;
}

static size_t receiver_of(const struct packet_programs *programs, size_t primitive)
{
    const size_t *receivers = programs->options.surface_of;
    return receivers ? receivers[primitive] : primitive;
}

/* Lists the receivers of the rays. The receiver is the first hit or the environment. If
 * another body covers the point of a ray, the receiver is the number after the
 * environment. */
static void list_receivers(const struct packet_work *work, const struct ray_hits *found,
                           c205_word *list)
{
    size_t environment = packet_receivers(work->programs) - 1;
    for (size_t i = 0; i < found->line_count; i++) {
        size_t first = found->first[i], receiver = environment;
        if (begins_within(found, i))
            receiver = environment + 1;
        else if (first < found->first[i + 1])
            receiver = receiver_of(work->programs, found->list[first].primitive);
        list[i] = c205_from_integer((int64_t)receiver);
    }
}

static bool run_received(const struct packet_work *work, const c205_word *list)
{
    const struct packet *made = work->packet;
    size_t rays = (size_t)made->stay, points = work->made.count;
    size_t receivers = packet_receivers(work->programs) + 1;
    struct single_run run;
    uint64_t sums, clocks = 0;
    begin_run(work, work->programs->received, &run);
    single_run_word(&run, "received_rays", rays);
    single_run_word(&run, "received_receivers", receivers);
    single_run_room(&run, "received_weights", work->stays + EMITTED_WEIGHT * points,
                    rays);
    single_run_room(&run, "received_list", list, rays);
    sums = single_run_room(&run, "received_sums", NULL, 2 * receivers + 1);
    layout_word(&run.layout, "received_counts", sums + 64 * (receivers + UINT64_C(1)));
    single_run_room(&run, "received_buffer", NULL, rays);
    single_run_room(&run, "received_places", NULL, receivers);
    return single_run_end(&run, sums, made->sums, 2 * receivers + 1, &clocks);
}

/* Adds the weights of the rays to their receivers. */
static bool receive(const struct packet_work *work)
{
    size_t rays = (size_t)work->packet->stay;
    struct ray_hits found = { 0 };
    c205_word *list;
    bool good;
    if (rays == 0)
        return true;
    if (!follow(work, work->programs->rays, work->stays, EMITTED_RAY, rays, &found))
        return false;
    charge(work, STEP_CROSSINGS);
    list = calloc(rays, sizeof *list);
    if (list)
        list_receivers(work, &found, list);
    good = list ? run_received(work, list) : error_set(work->error, "out of memory");
    charge(work, STEP_COUNTS);
    free(list);
    ray_hits_free(&found);
    return good;
}

static bool run_packet(struct packet_work *work)
{
    size_t points, words;
    bool good;
    if (!emit_points(work))
        return false;
    points = work->made.count;
    work->packet->made = points;
    words = EMITTED_PLANES * points;
    work->stays = malloc((words + 1) * sizeof *work->stays);
    work->lines = malloc((points + 1) * sizeof *work->lines);
    good = work->stays && work->lines
               ? points == 0 || (keep_faces(work) && receive(work))
               : error_set(work->error, "out of memory");
    free(work->made.planes);
    free(work->stays);
    free(work->lines);
    return good;
}

bool packet_run(const struct packet_programs *programs,
                const struct heat_source *source, const struct packet_choice *choice,
                struct packet *packet, c205_error *error)
{
    struct packet_work work = { .programs = programs,
                                .source = source,
                                .choice = *choice,
                                .packet = packet,
                                .error = error };
    return run_packet(&work);
}
