/* cmd_heat.c - rt205 heat: computes shape factors between the surfaces of a scene, and
 * their radiative exchange. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "vm/error.h"
#include "base/plural.h"
#include "base/provenance.h"
#include "rt/command/cmd_heat.h"
#include "rt/heat/heat_picture.h"
#include "rt/heat/heat_tables.h"
#include "rt/study/stages.h"

/* ---- The request ------------------------------------------------------------ */

/* Returns the number of lines in each repeat: the smallest power of two with which all
 * repeats together have at least the requested number. */
static size_t lines_of_repeat(const struct heat_arguments *args)
{
    size_t lines = 1;
    while (args->repeats * lines < args->lines)
        lines *= 2;
    return lines;
}

static struct heat_request request_of(const struct heat_arguments *args)
{
    const struct trace_options *trace = &args->shared.trace;
    bool by_lines = args->lines > 0;
    size_t most = by_lines ? (size_t)1 << MAX_GLOBAL_LINES_LOG : MAX_FACTORS_POINTS;
    return (struct heat_request){
        .mode = trace->mode,
        .queue = trace->queue,
        .jobs = trace->jobs,
        .by = (enum surfaces_by)args->by,
        .by_lines = by_lines,
        .drawn = by_lines ? lines_of_repeat(args) : args->rays,
        .repeats = args->repeats,
        .lattice = args->points == 0,
        .seed = args->seed,
        .tolerance = args->tolerance,
        .limit = args->limit < most ? args->limit : most,
        .smooth = args->smooth,
        .exchange = args->exchange,
        .emissivities = args->emissivities.items,
        .emissivity_count = args->emissivities.count,
        .temperatures = args->temperatures.items,
        .temperature_count = args->temperatures.count,
        .job_set = trace->job_set,
        .model = trace->model,
        .progress = trace->progress,
        .context = trace->context,
    };
}

/* Warns about primitives that receive radiation but cannot emit it. All primitives can
 * emit if the factors are computed with lines through the scene. */
static void warn_of_receivers(const struct heat_arguments *args,
                              const struct heat *heat)
{
    const struct scene *scene = heat->scene;
    for (size_t i = 0; i < scene->primitive_count; i++)
        if (heat->refusals[i])
            cmd_print_line(stderr,
                           "%s:%zu: warning: the %s receives radiation but "
                           "emits none: %s",
                           args->scene.path, scene->primitives[i].line,
                           primitive_kind_name(scene->primitives[i].kind),
                           heat->refusals[i]);
}

/* ---- Three stages ------------------------------------------------------------ */

static bool find_stage(const void *found, enum trace_mode mode,
                       uint64_t clocks[MAX_STAGES_STEPS], bool *same, c205_error *error)
{
    const struct heat *heat = found;
    struct heat_request request = *heat->request;
    struct heat other;
    bool good;
    request.mode = mode;
    request.drawn = heat->drawn;
    request.tolerance = 0;
    request.job_set = NULL;
    good = heat_begin(heat->scene, &request, &other, error) && heat_find(&other, error);
    if (good) {
        *same = heat_is_same(heat, &other);
        memcpy(clocks, other.clocks, sizeof other.clocks);
    }
    heat_free(&other);
    return good;
}

static bool find_stages(const struct heat *heat, struct stages *stages,
                        c205_error *error)
{
    *stages = (struct stages){ .step_count = HEAT_STEPS };
    for (int i = 0; i < HEAT_STEPS; i++)
        stages->steps[i] = heat_step_name((enum heat_step)i);
    memcpy(stages->clocks[heat->request->mode], heat->clocks, sizeof heat->clocks);
    return stages_find(stages, heat->request->mode, find_stage, heat, error);
}

/* ---- Output ----------------------------------------------------------------- */

/* Prints the visible areas, without invisible surfaces unless details is true. JSON
 * always contains all surfaces. */
static bool print_areas(const struct heat *heat, bool details,
                        const struct command_output *results)
{
    struct command_output printed = *results, kept = *results;
    size_t invisible = details ? 0 : heat_invisible(heat);
    printed.json = NULL;
    kept.file = NULL;
    if (!output_part(&printed, heat_table_of_areas(heat, details), "areas",
                     "Visible areas")
        || !output_part(&kept, heat_table_of_areas(heat, true), "areas", NULL))
        return false;
    if (invisible > 0)
        output_printf(results, "\n%zu surface%s no visible area; --details lists %s\n",
                      invisible, invisible == 1 ? " has" : "s have",
                      invisible == 1 ? "it" : "them");
    return true;
}

static bool print_tables(const struct heat *heat, const struct stages *stages,
                         bool details, const struct command_output *results)
{
    return print_areas(heat, details, results)
           && output_part(results, heat_table_of_factors(heat), "factors", "Factors")
           && (!heat->request->smooth
               || output_part(results, heat_table_of_smoothed(heat), "smoothed",
                              "Smoothed factors"))
           && (!heat->request->exchange
               || output_part(results, heat_table_of_flows(heat), "flows", "Flows"))
           && output_part(results, accounts_of_run(&heat->accounts), "clocks",
                          "Where the clocks went")
           && (!stages
               || output_part(results, stages_table(stages), "stages", "Three stages"));
}

static bool print_result(const struct heat_arguments *args, const struct heat *heat,
                         const struct stages *stages,
                         const struct command_output *results)
{
    const struct heat_request *request = heat->request;
    struct json *json = results->json;
    output_printf(results, "%s: %zu repeats of %zu %s%s %s, %s\n", args->scene.path,
                  request->repeats, heat->drawn, request->by_lines ? "line" : "point",
                  plural(heat->drawn),
                  request->by_lines ? "through the scene" : "of each primitive",
                  request->lattice ? "of the lattice" : "random");
    output_model(results, request->model);
    if (json) {
        json_text(json, "scene", args->scene.path);
        json_count(json, request->by_lines ? "lines" : "points", heat->drawn);
        json_count(json, "repeats", request->repeats);
        json_count(json, "seed", (size_t)request->seed);
        provenance_json(request->model, json);
    }
    return print_tables(heat, stages, args->details, results);
}

/* Reciprocity fails if the two directions of a pair of surfaces differ by more standard
 * errors than this. Closure must be exact. */
static const double strict_sigmas = 4.5;

static bool check_strictly(const struct heat *heat, c205_error *error)
{
    const struct surfaces *surfaces = &heat->surfaces;
    for (size_t i = 0; i < surfaces->count; i++)
        for (size_t j = i + 1; j < surfaces->count; j++) {
            double sigmas = fabs(surfaces_reciprocity(surfaces, i, j));
            if (sigmas > strict_sigmas)
                return error_set(error,
                                 "A F from %s to %s differs from the reverse "
                                 "direction by %.1f standard errors; --strict allows "
                                 "%g",
                                 surfaces->list[i].name, surfaces->list[j].name, sigmas,
                                 strict_sigmas);
        }
    return true;
}

static bool check_precision(const struct heat *heat, c205_error *error)
{
    return heat_is_precise(heat)
           || error_set(error,
                        "the tolerance %g is not reached: the error of the factor "
                        "from %s to %s is %.2g at --limit %zu",
                        heat->request->tolerance,
                        heat->surfaces.list[heat->worst_from].name,
                        heat_receiver(heat, heat->worst_to), heat->worst,
                        heat->request->limit);
}

/* ---- The command -------------------------------------------------------------- */

static bool draw(const struct heat_arguments *args, const struct heat *heat,
                 const struct command_output *results, c205_error *error)
{
    struct heat_look look = { .shown = (enum heat_shown)args->shown,
                              .from = args->from,
                              .trace = args->shared.trace,
                              .path = args->shared.output };
    struct heat_drawn drawn;
    if (!args->shared.output)
        return true;
    look.trace.job_set = NULL;
    if (!heat_draw(heat, &look, &drawn, error))
        return false;
    output_printf(results, "\npicture %s: %s from %g to %g%s; %llu clocks\n",
                  args->shared.output, heat_shown_name(look.shown), drawn.least,
                  drawn.most, heat_shown_unit(look.shown),
                  (unsigned long long)drawn.clocks);
    if (results->json)
        json_text(results->json, "picture", args->shared.output);
    return true;
}

/* Prints all results, then removes the checkpoint file. */
static bool print_all(const struct heat_arguments *args, const struct heat *heat,
                      const struct command_output *results, c205_error *error)
{
    struct stages stages;
    if (!job_set_collects(&args->jobs.job_set)) {
        cmd_print_share(args->shared.command, &args->jobs.job_set, heat->units);
        return true;
    }
    if (args->stages && !find_stages(heat, &stages, error))
        return false;
    if (!print_result(args, heat, args->stages ? &stages : NULL, results))
        return error_set(error, "out of memory");
    if (!check_precision(heat, error)
        || (args->scene.strict && !check_strictly(heat, error))
        || !draw(args, heat, results, error))
        return false;
    job_set_close(args->shared.trace.job_set, true);
    return true;
}

static int find_and_print(struct trace_session *session,
                          const struct heat_arguments *args)
{
    const struct scene *scene = session_scene(session, &args->scene);
    struct heat_request request = request_of(args);
    c205_error error = { "" };
    struct heat heat;
    bool good;
    if (!scene)
        return CMD_FAILED;
    good = heat_begin(scene, &request, &heat, &error);
    if (good && !request.by_lines)
        warn_of_receivers(args, &heat);
    good = good && heat_find(&heat, &error)
           && print_all(args, &heat, &session->results, &error);
    heat_free(&heat);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", error.message);
}

/* Returns the reason why some of the options exclude each other, or NULL. */
static const char *contradiction(const struct heat_arguments *args)
{
    const struct job_arguments *jobs = &args->jobs;
    bool apart = jobs->ranks > 0 || jobs->job_set.parts > 0;
    if (args->hits && (apart || jobs->resume.count > 0))
        return "--hits cannot be combined with --ranks, --part or --resume";
    if (args->stages && apart)
        return "--stages cannot be combined with --ranks or --part";
    if (args->hits
        && (args->stages || args->smooth || args->exchange || args->tolerance > 0
            || args->shared.output))
        return "--hits cannot be combined with --stages, --smooth, --exchange, "
               "--tolerance or -o";
    if (args->shared.output && args->shown == SHOWN_FLOW && !args->exchange)
        return "-o requires --exchange, or --show factor --from NAME";
    if (args->shared.output && args->shown == SHOWN_FACTOR && !args->from)
        return "--show factor requires --from NAME";
    if (args->tolerance > 0 && jobs->job_set.parts > 0)
        return "--part cannot be combined with --tolerance: each round depends on "
               "all units";
    return NULL;
}

static int cmd_heat(void *given)
{
    struct heat_arguments *args = given;
    const char *why = contradiction(args);
    struct trace_session session;
    int code;
    if (why)
        return cmd_usage(args->shared.command, "%s", why);
    code = cmd_check_picture(&args->shared);
    if (code != CMD_DONE)
        return code;
    code = session_open(&session, &args->shared, &args->jobs);
    if (code == CMD_DONE)
        code = args->hits ? cmd_heat_hits(&session, args)
                          : find_and_print(&session, args);
    return session_close(&session, code);
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

static const char *shown_choice(size_t number)
{
    return heat_shown_name((enum heat_shown)number);
}

#define PLACE(member) offsetof(struct heat_arguments, member)

static const struct command_option options[] = {
    CMD_OUTPUT("a picture of the scene in colours of flows or factors: .png "
               ".jpg, .exr .tif (with the values as a channel)"),
    { OPTION_ROW("show", "WHAT", COMMAND_CHOICE, PLACE(shown),
                 "quantity in the picture; factor requires --from"),
      .choice = shown_choice },
    CMD_SIZE(320, 240),
    { OPTION_ROW("by", "WHAT", COMMAND_CHOICE, PLACE(by),
                 "the group of primitives that forms one surface"),
      .choice = by_choice },
    OPTION_FLAG(
        "exchange", PLACE(exchange),
        "also the net flow of each surface, grey and diffuse; lengths are metres"),
    OPTION_FLAG(
        "smooth", PLACE(smooth),
        "also the nearest factors that have reciprocity and closure; --exchange "
        "uses these"),
    { OPTION_ROW("temperature", "NAME=KELVINS", COMMAND_TEXT, PLACE(temperatures),
                 "temperature of a part, a material, environment (0 K), or default for "
                 "all others; adiabatic instead of a number: no net flow"),
      .many = true },
    { OPTION_ROW("emissivity", "NAME=SHARE", COMMAND_TEXT, PLACE(emissivities),
                 "emissivity of a part or a material; all others have 1"),
      .many = true },
    { OPTION_ROW("from", "NAME", COMMAND_TEXT, PLACE(from),
                 "the emitting part or material, with --hits; else the surface whose "
                 "factors are shown") },
    OPTION_FLAG(
        "hits", PLACE(hits),
        "only test whether rays hit cylinders: in scalar form, and in queues up "
        "to the longest"),
    { OPTION_COUNT("lines", PLACE(lines), 0, 1 << 30, 0,
                   "at least N lines through the scene, over all repeats, instead of "
                   "rays") },
    { OPTION_COUNT(
        "rays", PLACE(rays), 1, MAX_FACTORS_POINTS, 1024,
        "points on a surface in each repeat; each visible point emits a ray") },
    { OPTION_COUNT("repeats", PLACE(repeats), 2, 1000, 16,
                   "repeats; errors are computed from their spread") },
    { OPTION_ROW(
          "tolerance", "ERROR", COMMAND_NUMBER, PLACE(tolerance),
          "multiply the rays or lines by 4 until no factor has a larger standard "
          "error"),
      .most = 1, .preset_text = "none" },
    { OPTION_COUNT("limit", PLACE(limit), 1, 1 << MAX_GLOBAL_LINES_LOG, 32768,
                   "at most N rays or lines in a repeat, with --tolerance") },
    { OPTION_ROW("points", "KIND", COMMAND_CHOICE, PLACE(points),
                 "source of the sample points"),
      .choice = points_choice },
    { OPTION_COUNT("seed", PLACE(seed), 0, 1e9, 1, "seed of the sample points") },
    CMD_MODE(cmd_mode_choice, "form of the programs; kernels is that of 1984"),
    OPTION_FLAG("stages", PLACE(stages),
                "also run the other two modes, whose results must be equal: clocks of "
                "all, step by step"),
    OPTION_FLAG("details", PLACE(details), "also list surfaces without visible area"),
    CMD_QUEUE("points and rays in the vector queue"),
    CMD_JOBS("packets of rays at a time"),
    CMD_RESUME(PLACE(jobs), "packets"),
    CMD_PART(PLACE(jobs), "packets"),
    CMD_RANKS(PLACE(jobs)),
    CMD_MODEL,
    CMD_READ(PLACE(scene)),
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE(PLACE(scene)),
                                                  COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 heat SCENE --by part --rays 4096", "factors between its parts" },
    { "rt205 heat SCENE --by part --tolerance 1e-3",
      "until no error is above a thousandth" },
    { "rt205 heat SCENE --by part --show factor --from NAME -o PICTURE",
      "the receivers of one part's radiation, as a picture" },
    { "rt205 heat SCENE --by part --exchange "
      "--temperature default=300",
      "also the heat that they exchange" },
    { NULL, NULL }
};

const struct command heat_command = {
    COMMAND_ROW("heat", cmd_heat, struct heat_arguments,
                "shape factors between the surfaces of a scene"),
    .examples = examples,
    .details = "Each primitive radiates from the visible part of its outward side; "
               "the first surface on a ray receives it. Errors are standard errors. "
               "A float NAME_Temperature or NAME_Emissivity in the scene sets the "
               "value of NAME; options override it. --strict also checks reciprocity.",
};
