/* cmd_mass.c - rt205 mass: computes volume, area, mass, centroid, inertia and principal
 * axes of solids, with their errors. The machine computes them as sums over parallel
 * rays. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "vm/error.h"
#include "base/plural.h"
#include "base/provenance.h"
#include "rt/command/session.h"
#include "rt/mass/mass_tables.h"
#include "rt/study/stages.h"

struct mass_arguments {
    struct trace_arguments shared;
    struct scene_arguments scene;
    struct job_arguments jobs;
    size_t rays, repeats, limit, seed; /* rays and limit are numbers of rays of a view,
                                        * for all shifts */
    double tolerance;                  /* 0: no tolerance */
    int points, by;
    bool overlaps, stages;
    struct command_texts parts;   /* names of parts; none: all parts */
    struct command_texts density; /* texts NAME=VALUE */
    const char *densities;        /* a file of densities, or NULL */
    double about[3];
    struct mass_units units;
};

static struct mass_request request_of(const struct mass_arguments *args)
{
    const struct trace_options *trace = &args->shared.trace;
    return (struct mass_request){
        .mode = trace->mode,
        .queue = trace->queue,
        .jobs = trace->jobs,
        .parts = args->parts.items,
        .part_count = args->parts.count,
        .densities = args->density.items,
        .density_count = args->density.count,
        .density_file = args->densities,
        .units = args->units,
        .about = { args->about[0], args->about[1], args->about[2] },
        .by = (enum mass_by)args->by,
        .overlaps = args->overlaps,
        .points = (enum columns_points)args->points,
        .rays = args->rays,
        .repeats = args->repeats,
        .seed = args->seed,
        .tolerance = args->tolerance,
        .limit = args->limit,
        .job_set = trace->job_set,
        .model = trace->model,
        .progress = trace->progress,
        .context = trace->context,
    };
}

/* ---- Three stages --------------------------------------------------------- */

static void take_clocks(const struct mass *mass, uint64_t *clocks)
{
    for (int i = 0; i < COLUMNS_STAGES; i++)
        clocks[i] = mass->sums.clocks[i];
}

static bool find_stage(const void *found, enum trace_mode mode,
                       uint64_t clocks[MAX_STAGES_STEPS], bool *same, c205_error *error)
{
    const struct mass *mass = found;
    struct mass_request request = *mass->request;
    struct diagnostics reports = { 0 };
    struct mass other;
    bool good;
    request.mode = mode;
    request.rays = request.repeats << mass->rays_log;
    request.tolerance = 0;
    request.job_set = NULL;
    good = mass_begin(mass->scene, &request, &other, &reports, error)
           && mass_find(&other, error);
    if (good) {
        *same = columns_checksum(&other.sums) == columns_checksum(&mass->sums);
        take_clocks(&other, clocks);
    }
    mass_free(&other);
    diagnostics_free(&reports);
    return good;
}

static bool find_stages(const struct mass *mass, struct stages *stages,
                        c205_error *error)
{
    *stages = (struct stages){ .step_count = COLUMNS_STAGES };
    for (int i = 0; i < COLUMNS_STAGES; i++)
        stages->steps[i] = columns_stage_name((enum columns_stage)i);
    take_clocks(mass, stages->clocks[mass->request->mode]);
    return stages_find(stages, mass->request->mode, find_stage, mass, error);
}

/* ---- Output --------------------------------------------------------------- */

static void print_run(const struct mass_arguments *args, const struct mass *mass,
                      const struct command_output *results)
{
    const double *about = mass->request->about;
    const char *mode = trace_mode_name(mass->request->mode);
    size_t rays = (size_t)1 << mass->sums.rays_log;
    char sum[24];
    snprintf(sum, sizeof sum, "%016llX",
             (unsigned long long)columns_checksum(&mass->sums));
    output_printf(results,
                  "%s: 3 views of %zu shift%s of %zu ray%s, %llu crossing%s, %s; "
                  "checksum %s\n"
                  "errors are half the interval of 95 %%; inertia I about "
                  "<%g, %g, %g>, J about the centroid; Ixy = - integral of x y "
                  "dm\n",
                  args->scene.path, mass->sums.repeats, plural(mass->sums.repeats),
                  rays, plural(rays), (unsigned long long)mass->sums.crossings,
                  plural(mass->sums.crossings), mode, sum, about[0], about[1],
                  about[2]);
    if (results->json) {
        json_text(results->json, "scene", args->scene.path);
        json_text(results->json, "mode", mode);
        json_count(results->json, "rays", mass_rays(mass));
        json_count(results->json, "repeats", mass->sums.repeats);
        json_count(results->json, "crossings", mass->sums.crossings);
        json_text(results->json, "checksum", sum);
        provenance_json(mass->request->model, results->json);
    }
}

static bool print_table(const struct command_output *results, struct table *table,
                        const char *key, const char *heading)
{
    bool good = output_show(results, table, key, heading) == CMD_DONE;
    output_gap(results);
    return good;
}

static bool print_tables(const struct mass *mass, const struct stages *stages,
                         const struct command_output *results)
{
    bool good = print_table(results, mass_table_of_figures(mass), "figures", "Figures")
                && (!mass->request->overlaps
                    || print_table(results, mass_table_of_overlaps(mass), "overlaps",
                                   "Overlaps"))
                && print_table(results, mass_table_of_axes(mass), "axes",
                               "Principal axes")
                && print_table(results, mass_table_of_clocks(mass), "clocks", "Clocks")
                && (!stages
                    || print_table(results, stages_table(stages), "stages",
                                   "Three stages"));
    output_model(results, mass->request->model);
    return good;
}

static bool check_precision(const struct mass *mass, c205_error *error)
{
    return mass_is_precise(mass)
           || error_set(error,
                        "the tolerance %g is not reached: the error of %s of %s is "
                        "%.2g of its value at --limit %zu",
                        mass->request->tolerance, figure_name(mass->worst_figure),
                        mass->rows[mass->worst_row].name, mass->worst,
                        mass->request->limit);
}

/* ---- The command --------------------------------------------------------- */

static bool print_all(const struct mass_arguments *args, const struct mass *mass,
                      const struct command_output *results, c205_error *error)
{
    struct stages stages;
    if (!job_set_collects(&args->jobs.job_set)) {
        cmd_print_share(args->shared.command, &args->jobs.job_set, mass->sums.units);
        return true;
    }
    if (args->stages && !find_stages(mass, &stages, error))
        return false;
    print_run(args, mass, results);
    if (!print_tables(mass, args->stages ? &stages : NULL, results))
        return error_set(error, "out of memory");
    if (!check_precision(mass, error))
        return false;
    job_set_close(args->shared.trace.job_set, true);
    return true;
}

static void warn_of_endless(const struct mass_arguments *args, const struct mass *mass)
{
    for (size_t i = 0; i < mass->parts.count; i++) {
        const struct named_part *part = &mass->parts.list[i];
        if (part->endless && part->left_out && mass->request->part_count == 0)
            cmd_print_line(stderr, "%s: warning: %s is unbounded and is ignored",
                           args->scene.path, part->name);
    }
}

static int find_and_print(struct trace_session *session,
                          const struct mass_arguments *args)
{
    const struct scene *scene = session_scene(session, &args->scene);
    struct mass_request request = request_of(args);
    struct diagnostics reports = { 0 };
    c205_error error = { "" };
    struct mass mass;
    bool good;
    if (!scene)
        return CMD_FAILED;
    good = mass_begin(scene, &request, &mass, &reports, &error);
    diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    warn_of_endless(args, &mass);
    good = good && mass_find(&mass, &error)
           && print_all(args, &mass, &session->results, &error);
    mass_free(&mass);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", error.message);
}

/* Moves a share such as 1/4 from the list of parts to args->jobs.job_set. The name of a
 * part contains no slash. */
static void take_share(struct mass_arguments *args)
{
    struct command_texts *parts = &args->parts;
    struct job_set share = { .parts = 0 };
    size_t kept = 0;
    for (size_t i = 0; i < parts->count; i++)
        if (cmd_is_part(parts->items[i], &share))
            args->jobs.job_set = share;
        else
            parts->items[kept++] = parts->items[i];
    parts->items[kept] = NULL;
    parts->count = kept;
}

static int cmd_mass(void *given)
{
    struct mass_arguments *args = given;
    struct trace_session session;
    int code;
    take_share(args);
    if (args->stages && (args->jobs.ranks > 0 || args->jobs.job_set.parts > 0))
        return cmd_usage(args->shared.command,
                         "--stages cannot be combined with --ranks or --part K/N");
    if (args->jobs.job_set.parts > 0 && args->tolerance > 0)
        return cmd_usage(args->shared.command,
                         "--part cannot be combined with --tolerance: each round "
                         "depends on all units");
    args->shared.trace.width = args->shared.trace.height = 1;
    code = session_open(&session, &args->shared, &args->jobs);
    if (code == CMD_DONE)
        code = find_and_print(&session, args);
    return session_close(&session, code);
}

static const char *points_choice(size_t number)
{
    static const char *const names[] = {
        [POINTS_RANDOM] = "random", [POINTS_LATTICE] = "lattice", [POINTS_GRID] = "grid"
    };
    return number < POINTS_KINDS ? names[number] : NULL;
}

static const char *by_choice(size_t number)
{
    return number == MASS_BY_PART       ? "part"
           : number == MASS_BY_MATERIAL ? "material"
                                        : NULL;
}

static bool take_about(char *text, void *value)
{
    double *about = value;
    for (int i = 0; i < 3; i++) {
        char *end;
        about[i] = strtod(text, &end);
        if (end == text || !isfinite(about[i]) || *end != (i < 2 ? ',' : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

static bool take_units(char *text, void *value)
{
    return mass_units_take(text, value);
}

enum { MAX_RAYS = 1 << 24, MAX_REPEATS = 256 };

#define PLACE(member) offsetof(struct mass_arguments, member)

static const struct command_option options[] = {
    { OPTION_ROW(
          "part", "NAME|K/N", COMMAND_TEXT, PLACE(parts),
          "only this part or material (default: all bounded ones); K/N: only the "
          "K-th of N shares of the packets, stored by --resume"),
      .many = true },
    { OPTION_ROW("density", "NAME=VALUE", COMMAND_TEXT, PLACE(density),
                 "density of a part, a material, or default for all others"),
      .many = true },
    { OPTION_ROW("densities", "FILE", COMMAND_INPUT, PLACE(densities),
                 "file of densities; a line has a number, a density and a name") },
    { OPTION_ROW("units", "LENGTH,MASS", COMMAND_CUSTOM, PLACE(units),
                 "units of the scene and of the tables; densities are then in g/cm^3"),
      .take = take_units,
      .wants = "a length (mm cm dm m in ft) and a mass (mg g kg t oz lb), separated "
               "by a comma" },
    { OPTION_ROW("about", "X,Y,Z", COMMAND_CUSTOM, PLACE(about),
                 "the reference point of the inertia I"),
      .take = take_about, .wants = "three numbers separated by commas",
      .preset_text = "0,0,0" },
    { OPTION_ROW("by", "WHAT", COMMAND_CHOICE, PLACE(by),
                 "the group of solids whose results are added"),
      .choice = by_choice, .preset = MASS_BY_PART },
    OPTION_FLAG("overlaps", PLACE(overlaps),
                "also the volumes in which two objects overlap, pair by pair"),
    { OPTION_COUNT(
        "rays", PLACE(rays), 1, MAX_RAYS, 65536,
        "rays of a view, over all shifts; rounded to a power of two in each") },
    { OPTION_COUNT("repeats", PLACE(repeats), 4, MAX_REPEATS, 16,
                   "shifts of the points; errors are computed from their spread") },
    { OPTION_ROW("tolerance", "SHARE", COMMAND_NUMBER, PLACE(tolerance),
                 "multiply the rays by 4 until no error is larger"),
      .most = 1, .preset_text = "none" },
    { OPTION_COUNT("limit", PLACE(limit), 1, MAX_RAYS, 1 << 19,
                   "at most N rays of a view, with --tolerance") },
    { OPTION_ROW("points", "KIND", COMMAND_CHOICE, PLACE(points),
                 "positions of the rays"),
      .choice = points_choice, .preset = POINTS_LATTICE },
    { OPTION_COUNT("seed", PLACE(seed), 0, 1000000, 1, "seed of shifts and points") },
    CMD_MODE(cmd_mode_choice, "form of the programs; kernels is that of 1984"),
    OPTION_FLAG("stages", PLACE(stages),
                "also run the other two modes, whose results must be equal: clocks of "
                "all, step by step"),
    CMD_QUEUE("rays in the vector queue"),
    CMD_MODEL,
    CMD_JOBS("packets of rays at a time"),
    CMD_RESUME(PLACE(jobs), "packets"),
    CMD_RANKS(PLACE(jobs)),
    CMD_READ(PLACE(scene)),
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE(PLACE(scene)),
                                                  COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 mass SCENE --density default=1", "all solids of one material" },
    { "rt205 mass SCENE --density Copper=8.96 --units mm,g --tolerance 1e-3",
      "until no error is above a thousandth" },
    { NULL, NULL }
};

const struct command mass_command = {
    COMMAND_ROW("mass", cmd_mass, struct mass_arguments,
                "volume, area, mass, centroid and inertia of solids"),
    .examples = examples,
    .details = "A part has the name of the #declare that defines it, a material that "
               "of its texture. A float NAME_Density in the scene sets the density "
               "of NAME.",
};
