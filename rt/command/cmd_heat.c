/* cmd_heat.c - rt205 heat: shape factors between the surfaces of a scene, and what these
 * exchange. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/error.h"
#include "base/provenance.h"
#include "rt/command/rt205_command.h"
#include "rt/heat/thermal.h"

/* All that is found of a scene. */
struct heat {
    const struct rt205_arguments *arguments;
    const struct scene *scene;
    struct named_parts parts;
    struct surfaces surfaces;
    struct given_values emissivities, temperatures;
    struct factor_row
        *rows; /* of the primitives; one that has no emission has no
                                counts */
    struct thermal thermal;
    struct accounts accounts;
    size_t units; /* of work, done here or elsewhere */
    c205_error error;
};

/* ---- The work ------------------------------------------------------------- */

/* Else what packets come to is elsewhere. */
static bool collects(const struct heat *heat)
{
    return farm_collects(&heat->arguments->units.farm);
}

static struct factors_options factors_options(const struct heat *heat)
{
    const struct rt205_arguments *arguments = heat->arguments;

    return (struct factors_options){
        .mode = arguments->trace.mode,
        .queue = arguments->trace.queue,
        .points = arguments->heat.rays,
        .repeats = arguments->heat.repeats,
        .lattice = arguments->heat.points == 0,
        .seed = arguments->heat.seed,
        .jobs = arguments->trace.jobs,
        .farm = arguments->trace.farm,
        .progress = arguments->trace.progress,
        .context = arguments->trace.context,
        .receiver_of = heat->surfaces.surface_of,
        .receivers = heat->surfaces.count,
        .model = arguments->trace.model,
    };
}

/* Those that emit, in order; of all others a warning. */
static size_t list_emitters(const struct heat *heat, size_t *emitters)
{
    size_t count = 0;

    for (size_t i = 0; i < heat->scene->primitive_count; i++) {
        const struct primitive *primitive = &heat->scene->primitives[i];
        const char *refusal = emission_refusal(primitive);

        if (!refusal)
            emitters[count++] = i;
        else
            fprintf(stderr, "%s:%zu: warning: the %s receives alone: %s\n",
                    heat->arguments->scene, primitive->line,
                    primitive_kind_name(primitive->kind), refusal);
    }
    return count;
}

static bool find_rows(struct heat *heat, const size_t *emitters, size_t count)
{
    struct factors_options options = factors_options(heat);
    struct factors *factors = factors_new(heat->scene, &options,
                                          &heat->error);
    bool good = factors
                && factors_find(factors, emitters, count, heat->rows,
                                &heat->error);

    if (good)
        heat->units = factors_units(factors, count);
    factors_free(factors);
    return good;
}

/* The rows of emitters become those of their primitives. */
static void place_rows(struct factor_row *rows, const size_t *emitters,
                       size_t count)
{
    for (size_t i = count; i-- > 0;) {
        struct factor_row row = rows[i];

        rows[i] = (struct factor_row){ .receivers = 0 };
        rows[emitters[i]] = row;
    }
}

static bool add_accounts(struct heat *heat, const struct accounts *accounts)
{
    return accounts_add_all(&heat->accounts, accounts)
           || error_say(&heat->error, "no memory");
}

static bool combine_rows(struct heat *heat)
{
    for (size_t i = 0; i < heat->scene->primitive_count; i++)
        if (!add_accounts(heat, &heat->rows[i].accounts))
            return false;
    surfaces_combine(&heat->surfaces, heat->rows);
    return true;
}

static bool find_by_rays(struct heat *heat)
{
    size_t primitives = heat->scene->primitive_count, count;
    size_t *emitters = calloc(primitives + 1, sizeof *emitters);
    bool good = false;

    heat->rows = calloc(primitives + 1, sizeof *heat->rows);
    if (emitters && heat->rows) {
        count = list_emitters(heat, emitters);
        good = find_rows(heat, emitters, count);
        if (good && collects(heat)) {
            place_rows(heat->rows, emitters, count);
            good = combine_rows(heat);
        }
    } else {
        error_say(&heat->error, "no memory");
    }
    free(emitters);
    return good;
}

/* ---- .. by lines ------------------------------------------------------------ */

/* Of each repeat; at least as many in all as are asked. */
static size_t log_of_lines(const struct cmd_heat *wishes)
{
    size_t log = 0;

    while (wishes->repeats << log < wishes->lines)
        log++;
    return log;
}

static bool find_by_lines(struct heat *heat)
{
    const struct rt205_arguments *arguments = heat->arguments;
    const struct global_lines_options options = {
        .mode = arguments->trace.mode,
        .queue = arguments->trace.queue,
        .lines_log = log_of_lines(&arguments->heat),
        .repeats = arguments->heat.repeats,
        .lattice = arguments->heat.points == 0,
        .seed = arguments->heat.seed,
        .jobs = arguments->trace.jobs,
        .farm = arguments->trace.farm,
        .progress = arguments->trace.progress,
        .context = arguments->trace.context,
        .surface_of = heat->surfaces.surface_of,
        .surfaces = heat->surfaces.count,
        .model = arguments->trace.model,
    };
    struct global_lines found;
    bool good;

    if (!global_lines_find(heat->scene, &options, &found, &heat->error))
        return false;
    heat->units = found.units;
    good = !collects(heat) || add_accounts(heat, &found.accounts);
    if (good && collects(heat))
        surfaces_take_lines(&heat->surfaces, &found);
    global_lines_free(&found);
    return good;
}

/* ---- What is given ---------------------------------------------------------- */

static bool take_given(struct heat *heat, struct given_values *given,
                       const struct value_kind *kind,
                       const struct command_texts *texts, const char *besides)
{
    bool good = true;

    given_begin(given, kind);
    for (size_t i = 0; good && i < texts->count; i++)
        good = given_add(given, texts->items[i], &heat->error);
    return good && given_check(given, &heat->parts, besides, &heat->error)
           && given_add_scene(given, heat->scene, &heat->error);
}

static bool begin(struct heat *heat)
{
    const struct cmd_heat *wishes = &heat->arguments->heat;

    if (!named_parts_find(heat->scene, &heat->parts)
        || !surfaces_find(heat->scene, &heat->parts,
                          (enum surfaces_by)wishes->by, &heat->surfaces))
        return error_say(&heat->error, "no memory");
    if (heat->scene->primitive_count == 0)
        return error_say(&heat->error, "the scene has no surfaces");
    return take_given(heat, &heat->emissivities, &emissivity_kind,
                      &wishes->emissivities, NULL)
           && take_given(heat, &heat->temperatures, &temperature_kind,
                         &wishes->temperatures, thermal_environment);
}

static bool find_exchange(struct heat *heat)
{
    const struct trace_options *trace = &heat->arguments->trace;

    if (!heat->arguments->heat.exchange)
        return true;
    return thermal_find(&heat->surfaces, &heat->parts, &heat->emissivities,
                        &heat->temperatures, trace->mode, trace->model,
                        &heat->thermal, &heat->error)
           && add_accounts(heat, &heat->thermal.exchange.accounts);
}

/* ---- Tables ----------------------------------------------------------------- */

static const struct table_column area_columns[] = {
    { "surface", "surface", TABLE_TEXT, 0 },
    { "kind", "kind", TABLE_TEXT, 0 },
    { "line", "line", TABLE_COUNT, 0 },
    { "area", "area", TABLE_NUMBER, 6 },
    { "area_error", "+-", TABLE_NUMBER, 6 },
    { "points", "points", TABLE_COUNT, 0 },
    { "rays", "rays", TABLE_COUNT, 0 },
};
static const struct table_column factor_columns[] = {
    { "from", "from", TABLE_TEXT, 0 },
    { "to", "to", TABLE_TEXT, 0 },
    { "factor", "factor", TABLE_NUMBER, 6 },
    { "factor_error", "+-", TABLE_NUMBER, 6 },
    { "rays", "rays", TABLE_COUNT, 0 },
    { "back", "A F - A' F', sigmas", TABLE_NUMBER, 2 },
};
static const struct table_column flow_columns[] = {
    { "surface", "surface", TABLE_TEXT, 0 },
    { "emissivity", "emissivity", TABLE_NUMBER, 3 },
    { "temperature", "K", TABLE_NUMBER, 1 },
    { "radiosity", "J, W/m^2", TABLE_NUMBER, 3 },
    { "irradiation", "H, W/m^2", TABLE_NUMBER, 3 },
    { "flow", "loses, W", TABLE_NUMBER, 3 },
};

/* Of a part or a material the kind and the line are those of its first primitive. */
static struct table *table_of_areas(const struct heat *heat)
{
    struct table *table = table_new(TABLE_COLUMNS(area_columns));

    for (size_t i = 0; table && i < heat->surfaces.count; i++) {
        const struct surface *surface = &heat->surfaces.list[i];

        if (surface->tried == 0)
            continue;
        table_text(table, surface->name);
        table_text(table, primitive_kind_name(surface->first->kind));
        table_count(table, surface->first->line);
        table_number(table, surface->area.value);
        table_number(table, surface->area.error);
        table_count(table, surface->tried);
        table_count(table, surface->sent);
    }
    return table;
}

static const char *receiver_name(const struct surfaces *surfaces, size_t j)
{
    return j == surfaces->count ? thermal_environment
                                : surfaces->list[j].name;
}

static struct table *table_of_factors(const struct surfaces *surfaces)
{
    struct table *table = table_new(TABLE_COLUMNS(factor_columns));

    for (size_t i = 0; table && i < surfaces->count; i++)
        for (size_t j = 0; j <= surfaces->count; j++) {
            const struct surface *surface = &surfaces->list[i];

            if (surface->count[j] == 0)
                continue;
            table_text(table, surface->name);
            table_text(table, receiver_name(surfaces, j));
            table_number(table, surface->factor[j].value);
            table_number(table, surface->factor[j].error);
            table_count(table, surface->count[j]);
            table_number(table, surfaces_reciprocity(surfaces, i, j));
        }
    return table;
}

static void add_flow(struct table *table, const char *name, double emissivity,
                     double temperature, double flow)
{
    table_text(table, name);
    table_number(table, emissivity);
    table_number(table, temperature);
    table_number(table, NAN);
    table_number(table, NAN);
    table_number(table, flow);
}

/* Then that of the environment, and of all together. */
static struct table *table_of_flows(const struct heat *heat)
{
    const struct thermal *thermal = &heat->thermal;
    const struct exchange *exchange = &thermal->exchange;
    struct table *table = table_new(TABLE_COLUMNS(flow_columns));

    for (size_t i = 0; table && i < thermal->count; i++) {
        table_text(table, heat->surfaces.list[thermal->surface[i]].name);
        table_number(table, thermal->emissivity[i]);
        table_number(table, thermal->temperature[i]);
        table_number(table, exchange->radiosity[i]);
        table_number(table, exchange->irradiation[i]);
        table_number(table, exchange->flow[i]);
    }
    if (table) {
        add_flow(table, thermal_environment, 1, thermal->outside,
                 exchange->outside);
        add_flow(table, "all", NAN, NAN, exchange->sum);
    }
    return table;
}

/* ---- What is told ----------------------------------------------------------- */

/* A table that nobody needs after that. */
static bool tell_part(const struct results *results, struct table *table,
                      const char *key, const char *heading)
{
    bool good = table && results_part(results, table, key, heading);

    table_free(table);
    return good;
}

static bool tell_tables(const struct heat *heat,
                        const struct results *results)
{
    return tell_part(results, table_of_areas(heat), "areas",
                     "Areas that are seen")
           && tell_part(results, table_of_factors(&heat->surfaces), "factors",
                        "Factors")
           && (!heat->arguments->heat.exchange
               || tell_part(results, table_of_flows(heat), "flows", "Flows"))
           && tell_part(results, accounts_of_run(&heat->accounts), "clocks",
                        "Where the clocks went");
}

/* In each repeat. */
static size_t drawn_of(const struct cmd_heat *wishes)
{
    return wishes->lines > 0 ? (size_t)1 << log_of_lines(wishes)
                             : wishes->rays;
}

static bool tell(const struct heat *heat, const struct results *results)
{
    const struct rt205_arguments *arguments = heat->arguments;
    struct json *json = results->json;

    results_say(results, "%s: %zu repeats of %zu %s, %s\n", arguments->scene,
                arguments->heat.repeats, drawn_of(&arguments->heat),
                arguments->heat.lines > 0 ? "lines through all of it"
                                          : "points of each primitive",
                arguments->heat.points == 0 ? "of the lattice" : "random");
    results_model(results, arguments->trace.model);
    if (json) {
        json_text(json, "scene", arguments->scene);
        json_count(json, arguments->heat.lines > 0 ? "lines" : "points",
                   drawn_of(&arguments->heat));
        json_count(json, "repeats", arguments->heat.repeats);
        json_count(json, "seed", arguments->heat.seed);
        provenance_json(arguments->trace.model, json);
    }
    return tell_tables(heat, results);
}

/* What differs both ways by more is no chance; closure is exact. */
static const double strict_sigmas = 4.5;

static bool check_strictly(struct heat *heat)
{
    const struct surfaces *surfaces = &heat->surfaces;

    for (size_t i = 0; i < surfaces->count; i++)
        for (size_t j = i + 1; j < surfaces->count; j++) {
            double sigmas = fabs(surfaces_reciprocity(surfaces, i, j));

            if (sigmas > strict_sigmas)
                return error_say(&heat->error,
                                 "A F from %s to %s is not that back: %.1f "
                                 "standard errors lie between, and --strict "
                                 "allows %g",
                                 surfaces->list[i].name,
                                 surfaces->list[j].name, sigmas,
                                 strict_sigmas);
        }
    return true;
}

/* ---- The command -------------------------------------------------------------- */

static bool find_all(struct heat *heat)
{
    return begin(heat)
           && (heat->arguments->heat.lines > 0 ? find_by_lines(heat)
                                               : find_by_rays(heat))
           && (!collects(heat) || find_exchange(heat));
}

static void forget(struct heat *heat)
{
    for (size_t i = 0; heat->rows && i < heat->scene->primitive_count; i++)
        factor_row_free(&heat->rows[i]);
    free(heat->rows);
    thermal_free(&heat->thermal);
    given_free(&heat->emissivities);
    given_free(&heat->temperatures);
    surfaces_free(&heat->surfaces);
    named_parts_free(&heat->parts);
    accounts_free(&heat->accounts);
}

/* What is told leaves no need of the files. */
static bool tell_all(struct heat *heat, const struct results *results)
{
    const struct rt205_arguments *arguments = heat->arguments;

    if (!collects(heat)) {
        cmd_tell_share(arguments, heat->units);
        return true;
    }
    if (!tell(heat, results))
        return error_say(&heat->error, "no memory");
    farm_end(arguments->trace.farm, true);
    return !arguments->strict || check_strictly(heat);
}

static int run(const struct rt205_arguments *arguments,
               const struct results *results)
{
    struct scene *scene = cmd_read_scene(arguments);
    struct heat heat = { .arguments = arguments,
                         .scene = scene,
                         .accounts = { .model = arguments->trace.model } };
    bool good;

    if (!scene)
        return CMD_FAILED;
    good = arguments->heat.hits
               ? cmd_heat_hits(arguments, scene, results, &heat.error)
               : find_all(&heat) && tell_all(&heat, results);
    forget(&heat);
    scene_free(scene);
    return good ? CMD_DONE
                : cmd_failed(arguments->command, "%s", heat.error.message);
}

static int run_command_line(void *given)
{
    struct rt205_arguments *arguments = given;
    const struct cmd_units *units = &arguments->units;

    if (arguments->heat.hits
        && (units->ranks > 0 || units->farm.parts > 0
            || units->resume.count > 0))
        return cmd_usage(arguments->command,
                         "--hits is one run: it has no units for --ranks, "
                         "--part or --resume");
    arguments->trace.width = arguments->trace.height = 1;
    return cmd_with_farm(arguments, run);
}

static const char *points_choice(size_t number)
{
    static const char *const names[] = { "lattice", "random" };

    return number < 2 ? names[number] : NULL;
}

static const char *by_choice(size_t number)
{
    static const char *const names[SURFACES_BY] = {
        [BY_PRIMITIVE] = "primitive",
        [BY_PART] = "part",
        [BY_MATERIAL] = "material",
    };

    return number < SURFACES_BY ? names[number] : NULL;
}

static const struct command_option options[] = {
    { .name = "by",
      .value = "WHAT",
      .kind = COMMAND_CHOICE,
      .offset = CMD_PLACE(heat.by),
      .choice = by_choice,
      .help = "what the surfaces are" },
    CMD_FLAG(
        "exchange", heat.exchange,
        "also what they lose, of grey diffuse surfaces; lengths are metres"),
    { .name = "temperature",
      .value = "NAME=KELVINS",
      .kind = COMMAND_TEXT,
      .many = true,
      .offset = CMD_PLACE(heat.temperatures),
      .help =
          "of a part or a material, or adiabatic; of the environment (0); "
          "default: of all that have none" },
    { .name = "emissivity",
      .value = "NAME=SHARE",
      .kind = COMMAND_TEXT,
      .many = true,
      .offset = CMD_PLACE(heat.emissivities),
      .help = "of a part or a material; of all others 1" },
    { .name = "from",
      .value = "NAME",
      .kind = COMMAND_TEXT,
      .offset = CMD_PLACE(heat.from),
      .help = "the part or material that emits, under --hits" },
    CMD_FLAG(
        "hits", heat.hits,
        "whether rays strike cylinders, and no more, on a scalar machine "
        "and in queues, the longest ones too"),
    { CMD_COUNT("lines", heat.lines, 0, 1 << 30, 0,
                "through all of the scene, in all repeats at least, in place "
                "of rays") },
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
    CMD_MODE(cmd_mode_choice, "in which form; kernels is that of 1984"),
    CMD_QUEUE("points and rays in the vector queue"),
    CMD_JOBS("packets of rays at a time"),
    CMD_RESUME("packets"),
    CMD_PART("packets"),
    CMD_RANKS,
    CMD_MODEL,
    CMD_READ,
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE, COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 heat SCENE --by part --rays 4096", "factors between its parts" },
    { "rt205 heat SCENE --by part --exchange "
      "--temperature default=300",
      "and what they exchange" },
    { NULL, NULL }
};

const struct command heat_command = {
    .name = "heat",
    .summary = "shape factors between the surfaces of a scene",
    .function = run_command_line,
    .options = options,
    .operands = operands,
    .examples = examples,
    .details =
        "Each primitive radiates on its outward side, where it is seen; what "
        "its rays meet first receives them. Errors are standard errors. "
        "Floats NAME_Temperature and NAME_Emissivity of the scene are "
        "those of NAME; options come first. Under --strict reciprocity "
        "counts, too.",
};
