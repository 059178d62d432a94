/* cmd_heat_hits.c - rt205 heat --hits: finds which rays strike an obstacle, and
 * compares the costs of a scalar machine and of queues of rays. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "vm/error.h"
#include "base/plural.h"
#include "base/provenance.h"
#include "rt/command/cmd_heat.h"
#include "rt/heat/hits.h"
#include "rt/study/speedup.h"

/* The runs that are compared. WAY_PROJECTED is the scalar form, projected for another
 * machine model. */
enum way { WAY_PROJECTED, WAY_SCALAR, WAY_QUEUE, WAY_LONGEST, WAYS };

struct hits_ways {
    const struct heat_arguments *args;
    const struct scene *scene;
    struct named_parts parts;
    c205_model *other; /* the model of the projection */
    struct hits found[WAYS];
    c205_error error;
};

static size_t queue_of(const struct hits_ways *ways, enum way way)
{
    return way == WAY_QUEUE     ? ways->args->shared.trace.queue
           : way == WAY_LONGEST ? ways->args->rays
                                : 1;
}

static bool find_way(struct hits_ways *ways, enum way way)
{
    const struct heat_arguments *args = ways->args;
    const struct hits_options options = {
        .mode = way < WAY_QUEUE ? TRACE_SCALAR : TRACE_VECTOR,
        .queue = queue_of(ways, way),
        .points = args->rays,
        .repeats = args->repeats,
        .lattice = args->points == 0,
        .seed = args->seed,
        .from = args->from,
        .model = args->shared.trace.model,
        .projection = way == WAY_SCALAR ? ways->other : NULL,
    };
    return hits_find(ways->scene, &ways->parts, &options, &ways->found[way],
                     &ways->error);
}

/* Computes the results in all ways, and checks that they are equal bit for bit. */
static bool find_ways(struct hits_ways *ways)
{
    for (int way = WAY_SCALAR; way < WAYS; way++)
        if (!find_way(ways, (enum way)way))
            return false;
    for (int way = WAY_QUEUE; way < WAYS; way++)
        if (ways->found[way].struck != ways->found[WAY_SCALAR].struck
            || memcmp(&ways->found[way].factor, &ways->found[WAY_SCALAR].factor,
                      sizeof ways->found[way].factor)
                   != 0)
            return error_set(&ways->error, "the results of the forms differ");
    return true;
}

/* ---- Output ----------------------------------------------------------------- */

static const struct table_column columns[] = {
    { "form", "form", TABLE_TEXT, 0 },
    { "queue", "queue", TABLE_COUNT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "clocks_per_test", "clocks/test", TABLE_NUMBER, 2 },
    { "translation_misses", "in misses", TABLE_COUNT, 0 },
    { "page_faults", "in faults", TABLE_COUNT, 0 },
    { "seconds", "s", TABLE_NUMBER, 5 },
    { "speedup", "speedup", TABLE_NUMBER, 1 },
};

static double seconds_of(const struct hits_ways *ways, enum way way)
{
    if (way == WAY_PROJECTED)
        return accounts_seconds(ways->other, ways->found[WAY_SCALAR].projected);
    return accounts_seconds(ways->args->shared.trace.model,
                            ways->found[way].accounts.clocks);
}

static void add_causes(struct table *table, const struct hits *found)
{
    c205_account all = accounts_together(&found->accounts);
    table_count(table, all.clocks[C205_TRANSLATION_MISS]);
    table_count(table, all.clocks[C205_PAGE_FAULT]);
}

static void add_way(struct table *table, const struct hits_ways *ways, enum way way,
                    const char *name)
{
    const struct hits *found = &ways->found[way];
    uint64_t clocks = way == WAY_PROJECTED ? ways->found[WAY_SCALAR].projected
                                           : found->accounts.clocks;
    double tests = (double)ways->found[WAY_SCALAR].rays
                   * (double)ways->found[WAY_SCALAR].cylinders;
    table_text(table, name);
    table_count(table, queue_of(ways, way));
    table_count(table, clocks);
    table_number(table, (double)clocks / tests);
    add_causes(table, found);
    table_number(table, seconds_of(ways, way));
    table_number(table, seconds_of(ways, WAY_PROJECTED) / seconds_of(ways, way));
}

static struct table *table_of_ways(const struct hits_ways *ways)
{
    struct table *table = table_new(TABLE_COLUMNS(columns));
    if (table) {
        add_way(table, ways, WAY_PROJECTED, "CDC 6600, projected");
        add_way(table, ways, WAY_SCALAR, "scalar");
        add_way(table, ways, WAY_QUEUE, "vector");
        add_way(table, ways, WAY_LONGEST, "vector");
    }
    return table;
}

static bool print_result(const struct hits_ways *ways,
                         const struct command_output *results)
{
    const struct heat_arguments *args = ways->args;
    const struct hits *found = &ways->found[WAY_LONGEST];
    bool good;
    output_printf(results,
                  "%s: %llu of %llu ray%s from %s strike one of %zu cylinder%s: "
                  "the factor is %.6f +- %.6f\n",
                  args->scene.path, (unsigned long long)found->struck,
                  (unsigned long long)found->rays, plural(found->rays), args->from,
                  found->cylinders, plural(found->cylinders), found->factor.value,
                  found->factor.error);
    output_model(results, args->shared.trace.model);
    if (results->json) {
        json_text(results->json, "scene", args->scene.path);
        json_count(results->json, "rays", found->rays);
        json_count(results->json, "struck", found->struck);
        json_number(results->json, "factor", found->factor.value);
        json_number(results->json, "error", found->factor.error);
        provenance_json(args->shared.trace.model, results->json);
    }
    good = output_part(results, table_of_ways(ways), "hits", "Rays that hit");
    output_printf(results, "The paper reports 600 s on a CDC 6600 and 3 s, a speedup "
                           "of 200; its geometry is unknown.\n");
    return good;
}

/* ---- Running the command ------------------------------------------------------ */

static bool begin(struct hits_ways *ways)
{
    const char *other = speedup_projection_model(ways->args->shared.trace.model,
                                                 SPEEDUP_6600);
    if (!ways->args->from)
        return error_set(&ways->error, "--hits requires --from NAME, the emitting "
                                       "part");
    if (!named_parts_find(ways->scene, &ways->parts))
        return error_set(&ways->error, "out of memory");
    ways->other = c205_model_find(other, &ways->error);
    return ways->other;
}

int cmd_heat_hits(struct trace_session *session, const struct heat_arguments *args)
{
    const struct scene *scene = session_scene(session, &args->scene);
    struct hits_ways ways = { .args = args, .scene = scene };
    bool good;
    if (!scene)
        return CMD_FAILED;
    good = begin(&ways) && find_ways(&ways)
           && (print_result(&ways, &session->results)
               || error_set(&ways.error, "out of memory"));
    for (int way = 0; way < WAYS; way++)
        hits_free(&ways.found[way]);
    named_parts_free(&ways.parts);
    c205_model_free(ways.other);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", ways.error.message);
}
