/* mass.c - computes the mass properties of a scene. */
#include "rt/mass/mass.h"

#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/jobs/job_set.h"
#include "rt/mass/bodies.h"
#include "rt/mass/densities.h"
#include "rt/scene/vector3.h"

/* ---- Densities and rows -------------------------------------------------- */

static bool take_densities(const struct mass *mass, struct named_values *densities,
                           struct diagnostics *reports, c205_error *error)
{
    const struct mass_request *request = mass->request;
    bool good = true;
    for (size_t i = 0; good && i < request->density_count; i++)
        good = named_add(densities, request->densities[i], error);
    good = good && named_check(densities, &mass->parts, NULL, error);
    if (good && request->density_file
        && !named_read(densities, request->density_file, reports))
        return error_set(error, "the densities of %.180s cannot be used",
                         request->density_file);
    return good && named_add_scene(densities, mass->scene, error);
}

/* Reads the given densities, and sets the density of each part. */
static bool weigh_parts(struct mass *mass, struct diagnostics *reports,
                        c205_error *error)
{
    struct named_values densities;
    bool good;
    named_begin(&densities, &density_kind);
    mass->weights = calloc(mass->parts.count + 1, sizeof *mass->weights);
    good = mass->weights && take_densities(mass, &densities, reports, error)
           && densities_find(&densities, &mass->parts, mass->weights, error);
    named_free(&densities);
    return good;
}

static const char *row_name(const struct mass *mass, const struct named_part *part)
{
    if (mass->request->by == MASS_BY_PART)
        return part->name;
    return part->material ? part->material : "none";
}

static struct mass_row *find_row(struct mass *mass, const char *name)
{
    struct mass_row *row = mass->rows;
    while (row < mass->rows + mass->row_count && strcmp(row->name, name) != 0)
        row++;
    if (row == mass->rows + mass->row_count) {
        row->density = mass->densities + mass->row_count++ * mass->parts.count;
        row->name = name;
    }
    return row;
}

/* Makes a row for each name of a part or material. If there are several names, also
 * makes a row for all parts together. */
static bool make_rows(struct mass *mass)
{
    size_t count = mass->parts.count;
    mass->rows = calloc(count + 1, sizeof *mass->rows);
    mass->densities = calloc((count + 1) * count + 1, sizeof *mass->densities);
    if (!mass->rows || !mass->densities)
        return false;
    for (size_t i = 0; i < count; i++) {
        const struct named_part *part = &mass->parts.list[i];
        if (part->left_out)
            continue;
        find_row(mass, row_name(mass, part))
            ->density[i] = mass_units_density(&mass->request->units, mass->weights[i]);
    }
    if (mass->row_count > 1) {
        struct mass_row *all = &mass->rows[mass->row_count];
        all->name = "all";
        all->density = mass->densities + mass->row_count * count;
        for (size_t i = 0; i < mass->row_count * count; i++)
            all->density[i % count] += mass->densities[i];
        mass->row_count++;
    }
    return true;
}

/* ---- Rounds -------------------------------------------------------------- */

static bool sum_columns(struct mass *mass, c205_error *error)
{
    const struct mass_request *request = mass->request;
    const struct columns_options options = {
        .mode = request->mode,
        .queue = request->queue,
        .points = request->points,
        .rays_log = mass->rays_log,
        .repeats = request->repeats,
        .seed = (size_t)request->seed,
        .jobs = request->jobs,
        .overlaps = &mass->overlaps,
        .part_count = mass->parts.count,
        .part_of = mass->parts.part_of,
        .model = request->model,
        .progress = request->progress,
        .context = request->context,
        .job_set = request->job_set,
    };
    return columns_sum(&mass->bodies, &options, &mass->sums, error);
}

static bool find_figures(struct mass *mass, c205_error *error)
{
    int log = mass->scene->unit_log;
    double about[3];
    copy3(mass->request->about, about);
    scale3(ldexp(1, -log), about);
    mass->worst = -1;
    for (size_t i = 0; i < mass->row_count; i++) {
        struct mass_row *row = &mass->rows[i];
        const struct mass_body body = { .sums = &mass->sums,
                                        .density = row->density,
                                        .about = about };
        size_t figure = 0;
        double worst;
        if (!mass_figures_find(&body, &row->figures))
            return error_set(error, "out of memory");
        worst = mass_worst(&row->figures, &mass->sums, &figure);
        if (worst > mass->worst) {
            mass->worst = worst;
            mass->worst_row = i;
            mass->worst_figure = figure;
        }
        mass_figures_enlarge(&row->figures, log);
    }
    return true;
}

/* Returns the binary logarithm of the number of rays that a view needs for each shift.
 * `rays` is the number of rays for all shifts. */
static size_t log_of_rays(size_t rays, size_t repeats)
{
    size_t log = 0;
    while (log < MAX_COLUMNS_LOG && (repeats << log) < rays)
        log++;
    return log;
}

bool mass_is_precise(const struct mass *mass)
{
    double tolerance = mass->request->tolerance;
    return tolerance == 0 || mass->worst <= tolerance;
}

/* Sets the logarithm of the number of rays in the next round. If the errors exceed the
 * tolerance, there are four times as many rays. 0: no further round. */
static bool find_next(struct mass *mass, uint64_t *next, c205_error *error)
{
    const struct mass_request *request = mass->request;
    size_t last = log_of_rays(request->limit, request->repeats);
    *next = 0;
    if (request->job_set && !job_set_collects(request->job_set))
        return true;
    if (!find_figures(mass, error))
        return false;
    if (!mass_is_precise(mass) && mass->rays_log < last)
        *next = mass->rays_log + 2 < last ? mass->rays_log + 2 : last;
    return true;
}

bool mass_find(struct mass *mass, c205_error *error)
{
    const struct mass_request *request = mass->request;
    uint64_t next = log_of_rays(request->rays, request->repeats);
    do {
        columns_sums_free(&mass->sums);
        mass->rays_log = (size_t)next;
        if (!sum_columns(mass, error) || !find_next(mass, &next, error))
            return false;
        if (request->job_set && !job_set_agree(request->job_set, &next))
            return error_set(error,
                             "rank 0 has ended the run; its message gives the reason");
    } while (next > 0);
    return true;
}

/* ---- Setup and cleanup --------------------------------------------------- */

static bool choose_parts(struct mass *mass, c205_error *error)
{
    const struct mass_request *request = mass->request;
    return named_parts_find(mass->scene, &mass->parts)
           && bodies_find_endless(mass->scene, &mass->parts)
           && named_parts_choose(&mass->parts, request->parts, request->part_count,
                                 error)
           && bodies_take(mass->scene, &mass->parts, &mass->bodies)
           && (!request->overlaps
               || overlaps_find(&mass->bodies, mass->parts.part_of, mass->parts.count,
                                &mass->overlaps));
}

bool mass_begin(const struct scene *scene, const struct mass_request *request,
                struct mass *mass, struct diagnostics *reports, c205_error *error)
{
    *mass = (struct mass){ .request = request, .scene = scene };
    error_set(error, "out of memory");
    return choose_parts(mass, error) && weigh_parts(mass, reports, error)
           && make_rows(mass);
}

void mass_free(struct mass *mass)
{
    columns_sums_free(&mass->sums);
    overlaps_free(&mass->overlaps);
    bodies_free(&mass->bodies);
    named_parts_free(&mass->parts);
    free(mass->rows);
    free(mass->weights);
    free(mass->densities);
    *mass = (struct mass){ .request = NULL };
}

size_t mass_rays(const struct mass *mass)
{
    return VIEWS * mass->sums.repeats << mass->sums.rays_log;
}
