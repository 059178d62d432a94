/* cmd_heat.c - rt205 heat: shape factors between the surfaces of a scene. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/provenance.h"
#include "rt/command/rt205_command.h"
#include "rt/heat/factors.h"

static const struct table_column area_columns[] = {
    { "surface", "surface", TABLE_COUNT, 0 },
    { "kind", "kind", TABLE_TEXT, 0 },
    { "line", "line", TABLE_COUNT, 0 },
    { "area", "area", TABLE_NUMBER, 6 },
    { "area_error", "+-", TABLE_NUMBER, 6 },
    { "points", "points", TABLE_COUNT, 0 },
    { "rays", "rays", TABLE_COUNT, 0 },
};

static const struct table_column factor_columns[] = {
    { "from", "from", TABLE_COUNT, 0 },
    { "to", "to", TABLE_TEXT, 0 },
    { "factor", "factor", TABLE_NUMBER, 6 },
    { "factor_error", "+-", TABLE_NUMBER, 6 },
    { "rays", "rays", TABLE_COUNT, 0 },
    { "back", "A F - A' F', sigmas", TABLE_NUMBER, 2 },
};

/* All rows of a scene; one that has no emission has no counts. */
struct heat {
    const struct rt205_arguments *arguments;
    const struct scene *scene;
    struct factor_row *rows;
    struct accounts accounts;
};

/* ---- The work ------------------------------------------------------------- */

static struct factors_options
factors_options(const struct rt205_arguments *arguments)
{
    return (struct factors_options){
        .mode = arguments->trace.mode,
        .queue = arguments->trace.queue,
        .points = arguments->heat.rays,
        .repeats = arguments->heat.repeats,
        .lattice = arguments->heat.points == 0,
        .seed = arguments->heat.seed,
        .jobs = arguments->trace.jobs,
        .model = arguments->trace.model,
    };
}

static bool go_on(const struct heat *heat, size_t done)
{
    const struct trace_options *trace = &heat->arguments->trace;

    return !trace->progress
           || trace->progress(trace->context, done,
                              heat->scene->primitive_count);
}

static bool find_row(struct heat *heat, const struct factors *factors,
                     size_t i, c205_error *error)
{
    const struct primitive *primitive = &heat->scene->primitives[i];
    const char *refusal = emission_refusal(primitive);

    if (refusal) {
        fprintf(stderr, "%s:%zu: warning: the %s receives alone: %s\n",
                heat->arguments->scene, primitive->line,
                primitive_kind_name(primitive->kind), refusal);
        return true;
    }
    return factors_find(factors, i, &heat->rows[i], error)
           && accounts_add_all(&heat->accounts, &heat->rows[i].accounts);
}

static bool find_rows(struct heat *heat, c205_error *error)
{
    struct factors_options options = factors_options(heat->arguments);
    struct factors *factors = factors_new(heat->scene, &options, error);
    bool good = factors != NULL;

    for (size_t i = 0; good && i < heat->scene->primitive_count; i++) {
        good = find_row(heat, factors, i, error);
        if (good && !go_on(heat, i + 1)) {
            snprintf(error->message, sizeof error->message,
                     "stopped after %zu of %zu surfaces", i + 1,
                     heat->scene->primitive_count);
            good = false;
        }
    }
    factors_free(factors);
    return good;
}

/* ---- What is told ----------------------------------------------------------- */

static void add_area(struct table *table, const struct heat *heat, size_t i)
{
    const struct primitive *primitive = &heat->scene->primitives[i];
    const struct factor_row *row = &heat->rows[i];

    table_count(table, i + 1);
    table_text(table, primitive_kind_name(primitive->kind));
    table_count(table, primitive->line);
    table_number(table, row->area.value);
    table_number(table, row->area.error);
    table_count(table, row->tried);
    table_count(table, row->sent);
}

/* By how many standard errors A F from i to j differs from that back. */
static double reciprocity(const struct heat *heat, size_t i, size_t j)
{
    const struct factor_row *from = &heat->rows[i];
    const struct factor_row *to = &heat->rows[j];
    double there, back, error;

    if (i == j || j == heat->scene->primitive_count || to->receivers == 0)
        return NAN;
    there = from->area.value * from->factor[j].value;
    back = to->area.value * to->factor[i].value;
    error = hypot(from->area.value * from->factor[j].error,
                  to->area.value * to->factor[i].error);
    return error > 0 ? (there - back) / error : NAN;
}

static void add_factor(struct table *table, const struct heat *heat, size_t i,
                       size_t j)
{
    const struct factor_row *row = &heat->rows[i];
    char text[24];

    if (row->count[j] == 0)
        return;
    snprintf(text, sizeof text, "%zu", j + 1);
    table_count(table, i + 1);
    table_text(table,
               j == heat->scene->primitive_count ? "environment" : text);
    table_number(table, row->factor[j].value);
    table_number(table, row->factor[j].error);
    table_count(table, row->count[j]);
    table_number(table, reciprocity(heat, i, j));
}

static bool tell_tables(const struct heat *heat,
                        const struct results *results)
{
    struct table *areas = table_new(TABLE_COLUMNS(area_columns));
    struct table *factors = table_new(TABLE_COLUMNS(factor_columns));
    struct table *clocks = accounts_of_run(&heat->accounts);
    bool good = areas && factors && clocks;

    for (size_t i = 0; good && i < heat->scene->primitive_count; i++) {
        if (heat->rows[i].receivers > 0)
            add_area(areas, heat, i);
        for (size_t j = 0; j < heat->rows[i].receivers; j++)
            add_factor(factors, heat, i, j);
    }
    good = good
           && results_part(results, areas, "areas", "Areas that are seen")
           && results_part(results, factors, "factors", "Factors")
           && results_part(results, clocks, "clocks",
                           "Where the clocks went");
    table_free(areas);
    table_free(factors);
    table_free(clocks);
    return good;
}

static bool tell(const struct heat *heat, const struct results *results)
{
    const struct rt205_arguments *arguments = heat->arguments;
    struct json *json = results->json;

    results_say(results,
                "%s: %zu repeats of %zu points of each surface, %s\n",
                arguments->scene, arguments->heat.repeats,
                arguments->heat.rays,
                arguments->heat.points == 0 ? "of the lattice" : "random");
    results_model(results, arguments->trace.model);
    if (json) {
        json_text(json, "scene", arguments->scene);
        json_count(json, "points", arguments->heat.rays);
        json_count(json, "repeats", arguments->heat.repeats);
        json_count(json, "seed", arguments->heat.seed);
        provenance_json(arguments->trace.model, json);
    }
    return tell_tables(heat, results);
}

/* ---- The command -------------------------------------------------------------- */

static bool find_and_tell(struct heat *heat, const struct results *results,
                          c205_error *error)
{
    size_t count = heat->scene->primitive_count;
    bool good;

    heat->rows = calloc(count + 1, sizeof *heat->rows);
    good = heat->rows && find_rows(heat, error) && tell(heat, results);
    for (size_t i = 0; heat->rows && i < count; i++)
        factor_row_free(&heat->rows[i]);
    free(heat->rows);
    accounts_free(&heat->accounts);
    return good;
}

static int run(const struct rt205_arguments *arguments,
               const struct results *results)
{
    struct scene *scene = cmd_read_scene(arguments);
    struct heat heat = { .arguments = arguments, .scene = scene };
    c205_error error = { "no memory" };
    bool good;

    if (!scene)
        return CMD_FAILED;
    heat.accounts.model = arguments->trace.model;
    good = find_and_tell(&heat, results, &error);
    scene_free(scene);
    return good ? CMD_DONE
                : cmd_failed(arguments->command, "%s", error.message);
}

static int run_command_line(void *given)
{
    struct rt205_arguments *arguments = given;

    arguments->trace.width = arguments->trace.height = 1;
    return cmd_with_machine(arguments, run);
}

static const char *points_choice(size_t number)
{
    static const char *const names[] = { "lattice", "random" };

    return number < 2 ? names[number] : NULL;
}

static const struct command_option options[] = {
    { CMD_COUNT("rays", heat.rays, 1, EMISSION_MOST, 1024,
                "points of a surface in each repeat, and rays of those that "
                "are seen") },
    { CMD_COUNT("repeats", heat.repeats, 2, 1000, 16,
                "by whose spread errors are told") },
    { .name = "points",
      .value = "KIND",
      .kind = COMMAND_CHOICE,
      .offset = CMD_PLACE(heat.points),
      .choice = points_choice,
      .help = "what they are made of" },
    { CMD_COUNT("seed", heat.seed, 0, 1e9, 1,
                "another one makes other points") },
    CMD_MODE(cmd_form_choice, "in which form"),
    CMD_QUEUE("points and rays in the vector queue"),
    CMD_JOBS("repeats at a time"),
    CMD_MODEL,
    CMD_READ,
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE, COMMAND_END };

const struct command heat_command = {
    .name = "heat",
    .summary = "shape factors between the surfaces of a scene",
    .function = run_command_line,
    .options = options,
    .operands = operands,
    .details = "Surfaces are the scene's primitives, in its order. Each "
               "radiates on its outward side, where it is seen; what its "
               "rays meet first receives them. Errors are standard errors.",
};
