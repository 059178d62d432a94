/* cmd_heat_lines.c - rt205 heat --lines: all factors between the primitives of a scene, from
 * lines through all of it. */
#include <stdio.h>

#include "base/error.h"
#include "base/provenance.h"
#include "rt/command/rt205_command.h"
#include "rt/heat/global_lines.h"
#include "rt/heat/surfaces.h"

static const struct table_column area_columns[] = {
    { "surface", "surface", TABLE_COUNT, 0 },
    { "kind", "kind", TABLE_TEXT, 0 },
    { "line", "line", TABLE_COUNT, 0 },
    { "area", "area", TABLE_NUMBER, 6 },
    { "area_error", "+-", TABLE_NUMBER, 6 },
};
static const struct table_column factor_columns[] = {
    { "from", "from", TABLE_COUNT, 0 },
    { "to", "to", TABLE_TEXT, 0 },
    { "factor", "factor", TABLE_NUMBER, 6 },
    { "factor_error", "+-", TABLE_NUMBER, 6 },
    { "ends", "ends", TABLE_COUNT, 0 },
};

static struct table *table_of_areas(const struct scene *scene,
                                    const struct global_lines *found)
{
    struct table *table = table_new(TABLE_COLUMNS(area_columns));

    for (size_t i = 0; table && i < found->surfaces; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        struct estimate area = global_lines_area(found, i);

        table_count(table, i + 1);
        table_text(table, primitive_kind_name(primitive->kind));
        table_count(table, primitive->line);
        table_number(table, area.value);
        table_number(table, area.error);
    }
    return table;
}

static void add_factor(struct table *table, const struct global_lines *found,
                       size_t i, size_t j)
{
    struct estimate factor = global_lines_factor(found, i, j);
    char name[24];

    snprintf(name, sizeof name, "%zu", j + 1);
    table_count(table, i + 1);
    table_text(table, j == found->surfaces ? "environment" : name);
    table_number(table, factor.value);
    table_number(table, factor.error);
    table_count(table, global_lines_count(found, i, j));
}

static struct table *table_of_factors(const struct global_lines *found)
{
    struct table *table = table_new(TABLE_COLUMNS(factor_columns));

    for (size_t i = 0; table && i < found->surfaces; i++)
        for (size_t j = 0; j <= found->surfaces; j++)
            if (global_lines_count(found, i, j) > 0)
                add_factor(table, found, i, j);
    return table;
}

/* A table that nobody needs after that. */
static bool tell_part(const struct results *results, struct table *table,
                      const char *key, const char *heading)
{
    bool good = table && results_part(results, table, key, heading);

    table_free(table);
    return good;
}

static bool tell(const struct rt205_arguments *arguments,
                 const struct scene *scene, const struct global_lines *found,
                 const struct results *results)
{
    size_t lines = (size_t)1 << found->lines_log;

    results_say(results,
                "%s: %zu repeats of %zu lines through a sphere of radius "
                "%.6g, %s\n",
                arguments->scene, found->repeats, lines, found->radius,
                arguments->heat.points == 0 ? "of the lattice" : "random");
    results_model(results, arguments->trace.model);
    if (results->json) {
        json_text(results->json, "scene", arguments->scene);
        json_count(results->json, "lines", lines);
        json_count(results->json, "repeats", found->repeats);
        json_count(results->json, "seed", arguments->heat.seed);
        provenance_json(arguments->trace.model, results->json);
    }
    return tell_part(results, table_of_areas(scene, found), "areas",
                     "Areas that are seen")
           && tell_part(results, table_of_factors(found), "factors",
                        "Factors")
           && tell_part(results, accounts_of_run(&found->accounts), "clocks",
                        "Where the clocks went");
}

/* At least as many in all repeats as are asked. */
static size_t log_of_lines(const struct rt205_arguments *arguments)
{
    size_t log = 0;

    while (arguments->heat.repeats << log < arguments->heat.lines)
        log++;
    return log;
}

bool cmd_heat_lines(const struct rt205_arguments *arguments,
                    const struct scene *scene, const struct results *results,
                    c205_error *error)
{
    const struct global_lines_options options = {
        .mode = arguments->trace.mode,
        .queue = arguments->trace.queue,
        .lines_log = log_of_lines(arguments),
        .repeats = arguments->heat.repeats,
        .lattice = arguments->heat.points == 0,
        .seed = arguments->heat.seed,
        .jobs = arguments->trace.jobs,
        .model = arguments->trace.model,
    };
    struct global_lines found;
    bool good;

    if (arguments->heat.by != BY_PRIMITIVE || arguments->heat.exchange)
        return error_say(error, "--lines has factors between primitives, "
                                "without --by and --exchange");
    if (!global_lines_find(scene, &options, &found, error))
        return false;
    good = tell(arguments, scene, &found, results)
           || error_say(error, "no memory");
    global_lines_free(&found);
    return good;
}
