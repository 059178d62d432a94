/* cmd_mass.c - rt205 mass: volume, area and mass of solids, their centroids, inertia
 * and principal axes, each with its error, found along columns by the machine. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/diagnostic.h"
#include "base/provenance.h"
#include "rt/command/rt205_command.h"
#include "rt/mass/bodies.h"
#include "rt/mass/densities.h"
#include "rt/mass/figures.h"

enum { BY_PART, BY_MATERIAL };

/* A line of the tables: a part, a material, or all of them. */
struct mass_row {
    const char *name;
    double *density; /* of each part, 0: it is none of it */
    struct mass_figures figures;
};

struct mass_work {
    const struct rt205_arguments *arguments;
    const struct scene *scene;
    struct scene bodies; /* what is measured of it */
    struct named_parts parts;
    struct overlaps overlaps; /* of bodies, if they are asked */
    size_t row_count;
    struct mass_row *rows;
    double *weights;   /* densities of parts */
    double *densities; /* of all rows */
    size_t rays_log;   /* of a view under a shift */
    struct columns_sums sums;
    double worst; /* the largest error, beside what it is of, */
    size_t worst_row, worst_figure;
    c205_error error;
};

/* ---- Densities and rows -------------------------------------------------- */

static bool take_densities(struct mass_work *work,
                           struct given_values *densities)
{
    const struct cmd_mass *wishes = &work->arguments->mass;
    struct diagnostics reports = { 0 };
    bool good = true;

    for (size_t i = 0; good && i < wishes->density.count; i++)
        good = given_add(densities, wishes->density.items[i], &work->error);
    good = good && given_check(densities, &work->parts, NULL, &work->error);
    if (good && wishes->densities
        && !given_read(densities, wishes->densities, &reports)) {
        diagnostics_print(&reports, stderr);
        snprintf(work->error.message, sizeof work->error.message,
                 "the file of densities is not used");
        good = false;
    }
    diagnostics_free(&reports);
    return good && given_add_scene(densities, work->scene, &work->error);
}

/* Of each part. */
static bool weigh_parts(struct mass_work *work)
{
    struct given_values densities;
    bool good;

    given_begin(&densities, &density_kind);
    work->weights = calloc(work->parts.count + 1, sizeof *work->weights);
    good = work->weights && take_densities(work, &densities)
           && densities_find(&densities, &work->parts, work->weights,
                             &work->error);
    given_free(&densities);
    return good;
}

static const char *row_name(const struct mass_work *work,
                            const struct named_part *part)
{
    if (work->arguments->mass.by == BY_PART)
        return part->name;
    return part->material ? part->material : "none";
}

static struct mass_row *find_row(struct mass_work *work, const char *name)
{
    struct mass_row *row = work->rows;

    while (row < work->rows + work->row_count && strcmp(row->name, name) != 0)
        row++;
    if (row == work->rows + work->row_count) {
        row->density = work->densities
                       + work->row_count++ * work->parts.count;
        row->name = name;
    }
    return row;
}

/* One for each name, then one of all, if there are several. */
static bool make_rows(struct mass_work *work)
{
    size_t count = work->parts.count;

    work->rows = calloc(count + 1, sizeof *work->rows);
    work->densities = calloc((count + 1) * count + 1,
                             sizeof *work->densities);
    if (!work->rows || !work->densities)
        return false;
    for (size_t i = 0; i < count; i++) {
        const struct named_part *part = &work->parts.list[i];

        if (part->left_out)
            continue;
        find_row(work, row_name(work, part))
            ->density[i] = mass_units_density(&work->arguments->mass.units,
                                              work->weights[i]);
    }
    if (work->row_count > 1) {
        struct mass_row *all = &work->rows[work->row_count];

        all->name = "all";
        all->density = work->densities + work->row_count * count;
        for (size_t i = 0; i < work->row_count * count; i++)
            all->density[i % count] += work->densities[i];
        work->row_count++;
    }
    return true;
}

/* ---- The machine's work -------------------------------------------------- */

static bool sum_columns(struct mass_work *work)
{
    const struct rt205_arguments *arguments = work->arguments;
    const struct columns_options options = {
        .mode = arguments->trace.mode,
        .queue = arguments->trace.queue,
        .points = (enum columns_points)arguments->mass.points,
        .rays_log = work->rays_log,
        .repeats = arguments->mass.repeats,
        .seed = arguments->mass.seed,
        .jobs = arguments->trace.jobs,
        .overlaps = &work->overlaps,
        .part_count = work->parts.count,
        .part_of = work->parts.part_of,
        .model = arguments->trace.model,
        .progress = arguments->trace.progress,
        .context = arguments->trace.context,
        .farm = arguments->trace.farm,
    };

    return columns_sum(&work->bodies, &options, &work->sums, &work->error);
}

static bool find_figures(struct mass_work *work)
{
    work->worst = -1;
    for (size_t i = 0; i < work->row_count; i++) {
        struct mass_row *row = &work->rows[i];
        const struct mass_body body = {
            .sums = &work->sums,
            .density = row->density,
            .about = work->arguments->mass.about
        };
        size_t figure = 0;
        double worst;

        if (!mass_figures_find(&body, &row->figures)) {
            snprintf(work->error.message, sizeof work->error.message,
                     "no memory");
            return false;
        }
        worst = mass_worst(&row->figures, &work->sums, &figure);
        if (worst > work->worst) {
            work->worst = worst;
            work->worst_row = i;
            work->worst_figure = figure;
        }
    }
    return true;
}

/* A view's rays, so many in all shifts, as a power of two under each. */
static size_t log_of_rays(size_t rays, size_t repeats)
{
    size_t log = 0;

    while (log < COLUMNS_LOG_MOST && (repeats << log) < rays)
        log++;
    return log;
}

static bool is_precise(const struct mass_work *work)
{
    double tolerance = work->arguments->mass.tolerance;

    return tolerance == 0 || work->worst <= tolerance;
}

/* With four times as many rays as long as errors are larger than the tolerance; the
 * logarithm of these, or 0: no more are needed. */
static bool find_next(struct mass_work *work, uint64_t *next)
{
    const struct cmd_mass *wishes = &work->arguments->mass;
    size_t last = log_of_rays(wishes->limit, wishes->repeats);

    *next = 0;
    if (!farm_collects(&work->arguments->units.farm))
        return true;
    if (!find_figures(work))
        return false;
    if (!is_precise(work) && work->rays_log < last)
        *next = work->rays_log + 2 < last ? work->rays_log + 2 : last;
    return true;
}

static bool find_mass(struct mass_work *work)
{
    const struct cmd_mass *wishes = &work->arguments->mass;
    uint64_t next = log_of_rays(wishes->rays, wishes->repeats);

    do {
        columns_sums_free(&work->sums);
        work->rays_log = (size_t)next;
        if (!sum_columns(work) || !find_next(work, &next)
            || !farm_agree(work->arguments->trace.farm, &next))
            return false;
    } while (next > 0);
    return true;
}

/* ---- What is told -------------------------------------------------------- */

static const struct table_column figure_columns[] = {
    { "part", "part", TABLE_TEXT, 0 },
    { "figure", "figure", TABLE_TEXT, 0 },
    { "value", "value", TABLE_NUMBER, 0 },
    { "error", "+-", TABLE_NUMBER, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
};
static const struct table_column overlap_columns[] = {
    { "part", "part", TABLE_TEXT, 0 },
    { "other", "other", TABLE_TEXT, 0 },
    { "volume", "volume", TABLE_NUMBER, 0 },
    { "error", "+-", TABLE_NUMBER, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
};
static const struct table_column axis_columns[] = {
    { "part", "part", TABLE_TEXT, 0 }, { "moment", "moment", TABLE_TEXT, 0 },
    { "x", "x", TABLE_NUMBER, 6 },     { "y", "y", TABLE_NUMBER, 6 },
    { "z", "z", TABLE_NUMBER, 6 },
};
static const struct table_column clock_columns[] = {
    { "stage", "stage", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "clocks_per_ray", "clocks/ray", TABLE_NUMBER, 1 },
};

/* Two digits of the error are shown; of what has none, nine of the value. */
static int decimals_of(double value, double error)
{
    double digits = error > 0    ? 1 - floor(log10(error))
                    : value != 0 ? 8 - floor(log10(fabs(value)))
                                 : 0;

    return !(digits > 0) ? 0 : digits > 15 ? 15 : (int)digits;
}

static int error_decimals(double error)
{
    return error > 0 ? decimals_of(0, error) : 0;
}

static void unit_of(const struct mass_units *units, size_t figure,
                    char text[MASS_UNIT])
{
    if (figure == FIGURE_AREA)
        mass_units_text(units, 0, 2, text);
    else if (figure == FIGURE_MASS)
        mass_units_text(units, 1, 0, text);
    else if (figure == FIGURE_VOLUME || figure >= FIGURE_VIEWS)
        mass_units_text(units, 0, 3, text);
    else if (figure < FIGURE_INERTIA)
        mass_units_text(units, 0, 1, text);
    else
        mass_units_text(units, 1, 2, text);
}

static void add_figure(struct table *table, const struct mass_units *units,
                       const char *part, const char *figure, double value,
                       double error, size_t unit)
{
    char text[MASS_UNIT];

    unit_of(units, unit, text);
    table_text(table, part);
    table_text(table, figure);
    table_rounded(table, value, decimals_of(value, error));
    table_rounded(table, error, error_decimals(error));
    table_text(table, text);
}

static struct table *table_of_figures(const struct mass_work *work)
{
    const struct mass_units *units = &work->arguments->mass.units;
    struct table *table = table_new(TABLE_COLUMNS(figure_columns));
    double volume, error;

    if (!table)
        return NULL;
    for (size_t i = 0; i < work->row_count; i++)
        for (size_t k = 0; k < FIGURES; k++)
            add_figure(table, units, work->rows[i].name, figure_name(k),
                       work->rows[i].figures.value[k],
                       work->rows[i].figures.error[k], k);
    if (work->arguments->mass.overlaps) {
        mass_overlap(&work->sums, &volume, &error);
        add_figure(table, units, "overlaps", figure_name(FIGURE_VOLUME),
                   volume, error, FIGURE_VOLUME);
    }
    return table;
}

/* Of pairs that claim something both. */
static struct table *table_of_overlaps(const struct mass_work *work)
{
    struct table *table = table_new(TABLE_COLUMNS(overlap_columns));
    char unit[MASS_UNIT];

    unit_of(&work->arguments->mass.units, FIGURE_VOLUME, unit);
    for (size_t i = 0; table && i < work->overlaps.count; i++) {
        double volume, error;

        if (!mass_overlap_of(&work->sums, i, &volume, &error))
            continue;
        for (size_t k = 0; k < 2; k++)
            table_text(table,
                       work->parts.list[work->overlaps.pairs[i].parts[k]]
                           .name);
        table_rounded(table, volume, decimals_of(volume, error));
        table_rounded(table, error, error_decimals(error));
        table_text(table, unit);
    }
    return table;
}

static struct table *table_of_axes(const struct mass_work *work)
{
    struct table *table = table_new(TABLE_COLUMNS(axis_columns));

    for (size_t i = 0; table && i < work->row_count; i++)
        for (size_t k = 0; k < 3; k++) {
            table_text(table, work->rows[i].name);
            table_text(table, figure_name(FIGURE_PRINCIPAL + k));
            for (size_t axis = 0; axis < 3; axis++)
                table_number(table, work->rows[i].figures.axes[k][axis]);
        }
    return table;
}

static size_t rays_of(const struct mass_work *work)
{
    return VIEWS * work->sums.repeats << work->sums.rays_log;
}

static struct table *table_of_clocks(const struct mass_work *work)
{
    struct table *table = table_new(TABLE_COLUMNS(clock_columns));

    for (int i = 0; table && i < COLUMNS_STAGES; i++) {
        if (i == STAGE_OVERLAPS && work->overlaps.count == 0)
            continue;
        table_text(table, columns_stage_name((enum columns_stage)i));
        table_count(table, work->sums.clocks[i]);
        table_number(table,
                     (double)work->sums.clocks[i] / (double)rays_of(work));
    }
    return table;
}

static void tell_run(const struct mass_work *work,
                     const struct results *results)
{
    const struct rt205_arguments *arguments = work->arguments;
    const struct cmd_mass *wishes = &arguments->mass;
    const double *about = wishes->about;
    char sum[24];

    snprintf(sum, sizeof sum, "%016llX",
             (unsigned long long)columns_checksum(&work->sums));
    results_say(results,
                "%s: 3 views of %zu shifts of %zu rays, %llu crossings, %s; "
                "checksum %s\n"
                "errors are half the interval of 95 %%; inertia I about "
                "<%g, %g, %g>, J about the centroid; Ixy = - integral of x y "
                "dm\n",
                arguments->scene, work->sums.repeats,
                (size_t)1 << work->sums.rays_log,
                (unsigned long long)work->sums.crossings,
                trace_mode_name(arguments->trace.mode), sum, about[0],
                about[1], about[2]);
    if (results->json) {
        json_text(results->json, "scene", arguments->scene);
        json_text(results->json, "mode",
                  trace_mode_name(arguments->trace.mode));
        json_count(results->json, "rays", rays_of(work));
        json_count(results->json, "repeats", work->sums.repeats);
        json_count(results->json, "crossings", work->sums.crossings);
        json_text(results->json, "checksum", sum);
        provenance_json(arguments->trace.model, results->json);
    }
}

static int tell_tables(const struct mass_work *work,
                       const struct results *results)
{
    int code = results_show(results, table_of_figures(work), "figures",
                            "Figures");

    if (code == CMD_DONE && work->arguments->mass.overlaps) {
        results_gap(results);
        code = results_show(results, table_of_overlaps(work), "overlaps",
                            "Overlaps");
    }
    results_gap(results);
    if (code == CMD_DONE)
        code = results_show(results, table_of_axes(work), "axes",
                            "Principal axes");
    results_gap(results);
    if (code == CMD_DONE)
        code = results_show(results, table_of_clocks(work), "clocks",
                            "Clocks");
    results_model(results, work->arguments->trace.model);
    return code;
}

static int tell(const struct mass_work *work, const struct results *results)
{
    const char *command = work->arguments->command;
    int code;

    if (!farm_collects(&work->arguments->units.farm))
        return cmd_tell_share(work->arguments, work->sums.units);
    tell_run(work, results);
    code = tell_tables(work, results);
    if (code == CMD_DONE && is_precise(work))
        farm_end(work->arguments->trace.farm, true);
    if (code != CMD_DONE || is_precise(work))
        return code;
    return cmd_failed(
        command,
        "the tolerance %g is not reached: the error of %s of %s "
        "is %.2g of it with the most rays, --limit %zu",
        work->arguments->mass.tolerance, figure_name(work->worst_figure),
        work->rows[work->worst_row].name, work->worst,
        work->arguments->mass.limit);
}

/* ---- The command --------------------------------------------------------- */

static void warn_of_endless(const struct mass_work *work)
{
    for (size_t i = 0; i < work->parts.count; i++) {
        const struct named_part *part = &work->parts.list[i];

        if (part->endless && part->left_out
            && work->arguments->mass.parts.count == 0)
            fprintf(stderr, "%s: warning: %s has no end: it is left out\n",
                    work->arguments->scene, part->name);
    }
}

static bool choose_parts(struct mass_work *work)
{
    const struct command_texts *names = &work->arguments->mass.parts;

    if (!named_parts_find(work->scene, &work->parts)
        || !bodies_find_endless(work->scene, &work->parts)
        || !named_parts_choose(&work->parts, names->items, names->count,
                               &work->error))
        return false;
    warn_of_endless(work);
    return bodies_take(work->scene, &work->parts, &work->bodies)
           && (!work->arguments->mass.overlaps
               || overlaps_find(&work->bodies, work->parts.part_of,
                                work->parts.count, &work->overlaps));
}

static bool begin(struct mass_work *work)
{
    snprintf(work->error.message, sizeof work->error.message, "no memory");
    return choose_parts(work) && weigh_parts(work) && make_rows(work);
}

static int work_on(const struct rt205_arguments *arguments,
                   const struct scene *scene, const struct results *results)
{
    struct mass_work work = { .arguments = arguments, .scene = scene };
    int code = begin(&work) && find_mass(&work)
                   ? tell(&work, results)
                   : cmd_failed(arguments->command, "%s", work.error.message);

    columns_sums_free(&work.sums);
    overlaps_free(&work.overlaps);
    bodies_free(&work.bodies);
    named_parts_free(&work.parts);
    free(work.rows);
    free(work.weights);
    free(work.densities);
    return code;
}

static int run(const struct rt205_arguments *arguments,
               const struct results *results)
{
    struct scene *scene = cmd_read_scene(arguments);
    int code = scene ? work_on(arguments, scene, results) : CMD_FAILED;

    scene_free(scene);
    return code;
}

/* What is called a part may be a share: no name has a / in it. */
static void take_share(struct rt205_arguments *arguments)
{
    struct command_texts *parts = &arguments->mass.parts;
    struct farm share = { .parts = 0 };
    size_t kept = 0;

    for (size_t i = 0; i < parts->count; i++)
        if (cmd_is_part(parts->items[i], &share))
            arguments->units.farm = share;
        else
            parts->items[kept++] = parts->items[i];
    parts->items[kept] = NULL;
    parts->count = kept;
}

static int run_command_line(void *given)
{
    struct rt205_arguments *arguments = given;

    take_share(arguments);
    if (arguments->units.farm.parts > 0 && arguments->mass.tolerance > 0)
        return cmd_usage(arguments->command,
                         "--part does not go with --tolerance: what comes "
                         "next hangs on all of them");
    arguments->trace.width = arguments->trace.height = 1;
    return cmd_with_farm(arguments, run);
}

static const char *points_choice(size_t number)
{
    static const char *const names[] = { [POINTS_RANDOM] = "random",
                                         [POINTS_LATTICE] = "lattice",
                                         [POINTS_GRID] = "grid" };

    return number < POINTS_KINDS ? names[number] : NULL;
}

static const char *by_choice(size_t number)
{
    return number == BY_PART       ? "part"
           : number == BY_MATERIAL ? "material"
                                   : NULL;
}

static bool take_about(char *text, void *value)
{
    double *about = value;

    for (int i = 0; i < 3; i++) {
        char *end;

        about[i] = strtod(text, &end);
        if (end == text || !isfinite(about[i])
            || *end != (i < 2 ? ',' : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

static bool take_units(char *text, void *value)
{
    return mass_units_take(text, value);
}

enum { RAYS_MOST = 1 << 24, REPEATS_MOST = 256 };

static const struct command_option options[] = {
    { .name = "part",
      .value = "NAME|K/N",
      .kind = COMMAND_TEXT,
      .many = true,
      .offset = CMD_PLACE(mass.parts),
      .help = "these parts or materials alone, else all that have an end; "
              "the K-th of N shares of the packets, kept by --resume" },
    { .name = "density",
      .value = "NAME=VALUE",
      .kind = COMMAND_TEXT,
      .many = true,
      .offset = CMD_PLACE(mass.density),
      .help = "of a part or a material; default: of all that have none" },
    { .name = "densities",
      .value = "FILE",
      .kind = COMMAND_INPUT,
      .offset = CMD_PLACE(mass.densities),
      .help = "a file of them: lines of a number, a density, a name" },
    { .name = "units",
      .value = "LENGTH,MASS",
      .kind = COMMAND_OWN,
      .offset = CMD_PLACE(mass.units),
      .take = take_units,
      .wants = "a length (mm cm dm m in ft) and a mass (mg g kg t oz lb), "
               "with a comma between",
      .help =
          "of the scene and of the tables; densities are in g/cm^3 then" },
    { .name = "about",
      .value = "X,Y,Z",
      .kind = COMMAND_OWN,
      .offset = CMD_PLACE(mass.about),
      .take = take_about,
      .wants = "three numbers with commas between",
      .preset_text = "0,0,0",
      .help = "the point of the inertia I" },
    { .name = "by",
      .value = "WHAT",
      .kind = COMMAND_CHOICE,
      .offset = CMD_PLACE(mass.by),
      .choice = by_choice,
      .preset = BY_PART,
      .help = "what is added up" },
    CMD_FLAG("overlaps", mass.overlaps,
             "also the volumes that several objects claim, pair by pair"),
    { CMD_COUNT("rays", mass.rays, 1, RAYS_MOST, 65536,
                "of a view, in all shifts; made a power of two in each") },
    { CMD_COUNT("repeats", mass.repeats, 4, REPEATS_MOST, 16,
                "shifts of the points, of which errors are found") },
    { .name = "tolerance",
      .value = "SHARE",
      .kind = COMMAND_NUMBER,
      .offset = CMD_PLACE(mass.tolerance),
      .most = 1,
      .preset_text = "none",
      .help = "four times the rays until no error is larger" },
    { CMD_COUNT("limit", mass.limit, 1, RAYS_MOST, 1 << 19,
                "rays of a view at the most, where there is a tolerance") },
    { .name = "points",
      .value = "KIND",
      .kind = COMMAND_CHOICE,
      .offset = CMD_PLACE(mass.points),
      .choice = points_choice,
      .preset = POINTS_LATTICE,
      .help = "where rays are" },
    { CMD_COUNT("seed", mass.seed, 0, 1000000, 1, "of shifts and points") },
    CMD_MODE(cmd_mode_choice, "in which form; kernels is that of 1984"),
    CMD_QUEUE("rays in the vector queue"),
    CMD_MODEL,
    CMD_JOBS("packets of rays at a time"),
    CMD_RESUME("packets"),
    CMD_RANKS,
    CMD_READ,
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE, COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 mass SCENE --density default=1", "as if all were of one stuff" },
    { "rt205 mass SCENE --density Copper=8.96 --units mm,g --tolerance 1e-3",
      "until no error is above a thousandth" },
    { NULL, NULL }
};

const struct command mass_command = {
    .name = "mass",
    .summary = "volume, area, mass, centroid and inertia of solids",
    .function = run_command_line,
    .options = options,
    .operands = operands,
    .examples = examples,
    .details =
        "Parts are called by the #declare that they come from, materials "
        "by their texture's; a float NAME_Density of the scene is the "
        "density of NAME.",
};
