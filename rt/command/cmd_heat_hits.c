/* cmd_heat_hits.c - rt205 heat --hits: how a scalar machine, and queues of rays, tell whether
 * rays strike. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/provenance.h"
#include "rt/command/rt205_command.h"
#include "rt/heat/hits.h"
#include "rt/study/speedup.h"

/* The forms that are compared; the projection is of the scalar one. */
enum way { WAY_PROJECTED, WAY_SCALAR, WAY_QUEUE, WAY_LONGEST, WAYS };

struct hits_work {
    const struct rt205_arguments *arguments;
    const struct scene *scene;
    struct named_parts parts;
    c205_model *other; /* machine, which is projected */
    struct hits found[WAYS];
    c205_error error;
};

static size_t queue_of(const struct hits_work *work, enum way way)
{
    return way == WAY_QUEUE     ? work->arguments->trace.queue
           : way == WAY_LONGEST ? work->arguments->heat.rays
                                : 1;
}

static bool find_way(struct hits_work *work, enum way way)
{
    const struct rt205_arguments *arguments = work->arguments;
    const struct hits_options options = {
        .mode = way < WAY_QUEUE ? TRACE_SCALAR : TRACE_VECTOR,
        .queue = queue_of(work, way),
        .points = arguments->heat.rays,
        .repeats = arguments->heat.repeats,
        .lattice = arguments->heat.points == 0,
        .seed = arguments->heat.seed,
        .from = arguments->heat.from,
        .model = arguments->trace.model,
        .projection = way == WAY_SCALAR ? work->other : NULL,
    };

    return hits_find(work->scene, &work->parts, &options, &work->found[way],
                     &work->error);
}

/* What all of them find is the same, to the bit. */
static bool find_ways(struct hits_work *work)
{
    for (int way = WAY_SCALAR; way < WAYS; way++)
        if (!find_way(work, (enum way)way))
            return false;
    for (int way = WAY_QUEUE; way < WAYS; way++)
        if (work->found[way].struck != work->found[WAY_SCALAR].struck
            || memcmp(&work->found[way].factor,
                      &work->found[WAY_SCALAR].factor,
                      sizeof work->found[way].factor)
                   != 0)
            return error_say(&work->error, "the forms differ");
    return true;
}

/* ---- What is told ----------------------------------------------------------- */

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

static double seconds_of(const struct hits_work *work, enum way way)
{
    if (way == WAY_PROJECTED)
        return accounts_seconds(work->other,
                                work->found[WAY_SCALAR].projected);
    return accounts_seconds(work->arguments->trace.model,
                            work->found[way].accounts.clocks);
}

static void add_causes(struct table *table, const struct hits *found)
{
    c205_account all = accounts_together(&found->accounts);

    table_count(table, all.clocks[C205_TRANSLATION_MISS]);
    table_count(table, all.clocks[C205_PAGE_FAULT]);
}

static void add_way(struct table *table, const struct hits_work *work,
                    enum way way, const char *name)
{
    const struct hits *found = &work->found[way];
    uint64_t clocks = way == WAY_PROJECTED ? work->found[WAY_SCALAR].projected
                                           : found->accounts.clocks;
    double tests = (double)work->found[WAY_SCALAR].rays
                   * (double)work->found[WAY_SCALAR].cylinders;

    table_text(table, name);
    table_count(table, queue_of(work, way));
    table_count(table, clocks);
    table_number(table, (double)clocks / tests);
    add_causes(table, found);
    table_number(table, seconds_of(work, way));
    table_number(table,
                 seconds_of(work, WAY_PROJECTED) / seconds_of(work, way));
}

static struct table *table_of_ways(const struct hits_work *work)
{
    struct table *table = table_new(TABLE_COLUMNS(columns));

    if (table) {
        add_way(table, work, WAY_PROJECTED, "CDC 6600, projected");
        add_way(table, work, WAY_SCALAR, "scalar");
        add_way(table, work, WAY_QUEUE, "vector");
        add_way(table, work, WAY_LONGEST, "vector");
    }
    return table;
}

static bool tell(const struct hits_work *work, const struct results *results)
{
    const struct rt205_arguments *arguments = work->arguments;
    const struct hits *found = &work->found[WAY_LONGEST];
    struct table *table = table_of_ways(work);
    bool good;

    results_say(results,
                "%s: %llu of %llu rays from %s strike one of %zu cylinders: "
                "the factor is %.6f +- %.6f\n",
                arguments->scene, (unsigned long long)found->struck,
                (unsigned long long)found->rays, arguments->heat.from,
                found->cylinders, found->factor.value, found->factor.error);
    results_model(results, arguments->trace.model);
    if (results->json) {
        json_text(results->json, "scene", arguments->scene);
        json_count(results->json, "rays", found->rays);
        json_count(results->json, "struck", found->struck);
        json_number(results->json, "factor", found->factor.value);
        json_number(results->json, "error", found->factor.error);
        provenance_json(arguments->trace.model, results->json);
    }
    good = table
           && results_part(results, table, "hits", "Whether rays strike");
    table_free(table);
    results_say(results,
                "The paper's: 600 s on a CDC 6600 became 3 s, 200 times; "
                "its geometry is unknown.\n");
    return good;
}

/* ---- The work ----------------------------------------------------------------- */

static bool begin(struct hits_work *work)
{
    const char *other = speedup_projection_model(work->arguments->trace.model,
                                                 SPEEDUP_6600);

    if (!work->arguments->heat.from)
        return error_say(&work->error,
                         "--hits asks --from NAME: the part that emits");
    if (!named_parts_find(work->scene, &work->parts))
        return error_say(&work->error, "no memory");
    work->other = c205_model_find(other, &work->error);
    return work->other;
}

bool cmd_heat_hits(const struct rt205_arguments *arguments,
                   const struct scene *scene, const struct results *results,
                   c205_error *error)
{
    struct hits_work work = { .arguments = arguments, .scene = scene };
    bool good = begin(&work) && find_ways(&work)
                && (tell(&work, results)
                    || error_say(&work.error, "no memory"));

    *error = work.error;
    for (int way = 0; way < WAYS; way++)
        hits_free(&work.found[way]);
    named_parts_free(&work.parts);
    c205_model_free(work.other);
    return good;
}
