/* heat.c - computes shape factors and the radiative exchange of a scene. */
#include "rt/heat/heat.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/jobs/job_set.h"
#include "rt/heat/smooth.h"
#include "rt/heat/heat_source.h"
#include "rt/scene/named_values.h"

/* The data that is needed only while the factors and the exchange are computed. */
struct heat_work {
    struct heat *heat;
    size_t emitter_count, *emitters; /* indices of primitives, in increasing order */
    struct factor_row *rows;         /* one row for each primitive */
    c205_error *error;
};

static bool collects(const struct heat *heat)
{
    return !heat->request->job_set || job_set_collects(heat->request->job_set);
}

static bool add_accounts(const struct heat_work *work, const struct accounts *accounts,
                         const uint64_t clocks[HEAT_STEPS])
{
    for (int i = 0; i < HEAT_STEPS; i++)
        work->heat->clocks[i] += clocks[i];
    return accounts_add_all(&work->heat->accounts, accounts)
           || error_set(work->error, "out of memory");
}

static size_t log_of(size_t count)
{
    size_t log = 0;
    while ((size_t)1 << log < count)
        log++;
    return log;
}

/* Returns the options of a round. heat->drawn is the number of points or lines of each
 * repeat. */
static struct sampling_options sampling_of(const struct heat *heat)
{
    const struct heat_request *request = heat->request;
    return (struct sampling_options){
        .mode = request->mode,
        .queue = request->queue,
        .points = heat->drawn,
        .lines_log = request->by_lines ? log_of(heat->drawn) : 0,
        .repeats = request->repeats,
        .lattice = request->lattice,
        .seed = request->seed,
        .jobs = request->jobs,
        .job_set = request->job_set,
        .progress = request->progress,
        .context = request->context,
        .surface_of = heat->surfaces.surface_of,
        .surfaces = heat->surfaces.count,
        .model = request->model,
    };
}

/* ---- By rays --------------------------------------------------------------- */

static void list_emitters(struct heat_work *work)
{
    const struct heat *heat = work->heat;
    for (size_t i = 0; i < heat->scene->primitive_count; i++)
        if (!heat->refusals[i])
            work->emitters[work->emitter_count++] = i;
}

static bool find_rows(struct heat_work *work)
{
    struct heat *heat = work->heat;
    struct sampling_options options = sampling_of(heat);
    struct factors *factors = factors_new(heat->scene, &options, work->error);
    bool good = factors
                && factors_find(factors, work->emitters, work->emitter_count,
                                work->rows, work->error);
    if (good)
        heat->units = factors_units(factors, work->emitter_count);
    factors_free(factors);
    return good;
}

/* Moves each row to the index of its emitter. The loop runs backwards, because this
 * index is not less than the row's old index. */
static void place_rows(const struct heat_work *work)
{
    for (size_t i = work->emitter_count; i-- > 0;) {
        struct factor_row row = work->rows[i];
        work->rows[i] = (struct factor_row){ .receivers = 0 };
        work->rows[work->emitters[i]] = row;
    }
}

static bool combine_rows(const struct heat_work *work)
{
    for (size_t i = 0; i < work->heat->scene->primitive_count; i++)
        if (!add_accounts(work, &work->rows[i].accounts, work->rows[i].clocks))
            return false;
    surfaces_combine(&work->heat->surfaces, work->rows);
    return true;
}

static bool find_by_rays(struct heat_work *work)
{
    size_t primitives = work->heat->scene->primitive_count;
    bool good;
    work->emitter_count = 0;
    work->emitters = calloc(primitives + 1, sizeof *work->emitters);
    work->rows = calloc(primitives + 1, sizeof *work->rows);
    good = (work->emitters && work->rows) || error_set(work->error, "out of memory");
    if (good)
        list_emitters(work);
    good = good && find_rows(work);
    if (good && collects(work->heat)) {
        place_rows(work);
        good = combine_rows(work);
    }
    for (size_t i = 0; work->rows && i < primitives; i++)
        factor_row_free(&work->rows[i]);
    free(work->emitters);
    free(work->rows);
    return good;
}

/* ---- By lines -------------------------------------------------------------- */

static bool find_by_lines(struct heat_work *work)
{
    struct heat *heat = work->heat;
    struct sampling_options options = sampling_of(heat);
    struct global_lines found;
    bool good;
    if (!global_lines_find(heat->scene, &options, &found, work->error))
        return false;
    heat->units = found.units;
    good = !collects(heat) || add_accounts(work, &found.accounts, found.clocks);
    if (good && collects(heat))
        surfaces_take_lines(&heat->surfaces, &found);
    global_lines_free(&found);
    return good;
}

/* ---- Precision ------------------------------------------------------------- */

bool heat_is_precise(const struct heat *heat)
{
    double tolerance = heat->request->tolerance;
    return tolerance == 0 || heat->worst <= tolerance;
}

/* Returns the error of a factor, which is at least the contribution of one ray. Even if
 * all repeats agree, the factor is not known more accurately. */
static double error_of(const struct surface *surface, size_t to)
{
    return fmax(surface->factor[to].error, 1 / (double)surface->sent);
}

static void find_worst(struct heat *heat)
{
    const struct surfaces *surfaces = &heat->surfaces;
    heat->worst = -1;
    for (size_t i = 0; i < surfaces->count; i++)
        for (size_t j = 0; j <= surfaces->count; j++) {
            const struct surface *surface = &surfaces->list[i];
            if (surface->sent == 0 || error_of(surface, j) <= heat->worst)
                continue;
            heat->worst = error_of(surface, j);
            heat->worst_from = i;
            heat->worst_to = j;
        }
}

/* Returns the largest number of points or lines of a repeat. A number of lines is
 * rounded down to a power of two. */
static size_t limit_of(const struct heat_request *request)
{
    size_t limit = request->limit;
    return request->by_lines && limit > 0 ? (size_t)1 << (log_of(limit + 1) - 1)
                                          : limit;
}

/* Returns the number of points or lines in the next round. Returns 0 if there is no
 * further round. */
static uint64_t find_next(struct heat *heat)
{
    size_t limit = limit_of(heat->request);
    if (!collects(heat))
        return 0;
    find_worst(heat);
    if (heat_is_precise(heat) || heat->drawn >= limit)
        return 0;
    return heat->drawn < limit / 4 ? 4 * heat->drawn : limit;
}

static bool begin_round(const struct heat_work *work)
{
    struct heat *heat = work->heat;
    accounts_free(&heat->accounts);
    heat->accounts = (struct accounts){ .model = heat->request->model };
    memset(heat->clocks, 0, sizeof heat->clocks);
    surfaces_free(&heat->surfaces);
    return surfaces_find(heat->scene, &heat->parts, heat->request->by, &heat->surfaces)
           || error_set(work->error, "out of memory");
}

static bool find_factors(struct heat_work *work)
{
    const struct heat_request *request = work->heat->request;
    uint64_t next = request->drawn;
    do {
        work->heat->drawn = (size_t)next;
        if (!begin_round(work)
            || !(request->by_lines ? find_by_lines(work) : find_by_rays(work)))
            return false;
        next = find_next(work->heat);
        if (request->job_set && !job_set_agree(request->job_set, &next))
            return error_set(work->error,
                             "rank 0 has ended the run; its message gives the reason");
    } while (next > 0);
    return true;
}

/* ---- Input ----------------------------------------------------------------- */

static bool take_given(const struct heat *heat, struct named_values *given,
                       const char *const *texts, size_t count, const char *besides,
                       c205_error *error)
{
    bool good = true;
    for (size_t i = 0; good && i < count; i++)
        good = named_add(given, texts[i], error);
    return good && named_check(given, &heat->parts, besides, error)
           && named_add_scene(given, heat->scene, error);
}

bool heat_begin(const struct scene *scene, const struct heat_request *request,
                struct heat *heat, c205_error *error)
{
    *heat = (struct heat){ .request = request, .scene = scene };
    named_begin(&heat->emissivities, &emissivity_kind);
    named_begin(&heat->temperatures, &temperature_kind);
    if (scene->primitive_count == 0)
        return error_set(error, "the scene has no surfaces");
    heat->refusals = source_refusals(scene);
    if (!heat->refusals || !named_parts_find(scene, &heat->parts))
        return error_set(error, "out of memory");
    return take_given(heat, &heat->emissivities, request->emissivities,
                      request->emissivity_count, NULL, error)
           && take_given(heat, &heat->temperatures, request->temperatures,
                         request->temperature_count, thermal_environment, error);
}

/* ---- Smoothing and exchange ------------------------------------------------- */

static bool smooth(const struct heat_work *work)
{
    struct heat *heat = work->heat;
    const struct heat_request *request = heat->request;
    if (!request->smooth || !collects(heat))
        return true;
    if (!smooth_surfaces(&heat->surfaces, request->mode, request->model,
                         &heat->accounts, work->error))
        return false;
    heat_charge(heat->clocks, &heat->accounts, STEP_SMOOTHING);
    return true;
}

static bool find_exchange(const struct heat_work *work)
{
    struct heat *heat = work->heat;
    const struct heat_request *request = heat->request;
    if (!request->exchange || !collects(heat))
        return true;
    if (!thermal_find(&heat->surfaces, &heat->parts, &heat->emissivities,
                      &heat->temperatures, request->mode, request->model,
                      &heat->thermal, work->error)
        || !accounts_add_all(&heat->accounts, &heat->thermal.exchange.accounts))
        return false;
    heat_charge(heat->clocks, &heat->accounts, STEP_EXCHANGE);
    return true;
}

/* Converts areas and flows from the unit of the scene to the unit of the scene file. */
static void enlarge(struct heat *heat)
{
    double unit = ldexp(1, 2 * heat->scene->unit_log);
    for (size_t i = 0; i < heat->surfaces.count; i++) {
        heat->surfaces.list[i].area.value *= unit;
        heat->surfaces.list[i].area.error *= unit;
    }
    for (size_t i = 0; i < heat->thermal.exchange.count; i++)
        heat->thermal.exchange.flow[i] *= unit;
    heat->thermal.exchange.outside *= unit;
    heat->thermal.exchange.sum *= unit;
}

bool heat_find(struct heat *heat, c205_error *error)
{
    struct heat_work work = { .heat = heat, .error = error };
    if (!find_factors(&work) || !smooth(&work) || !find_exchange(&work))
        return false;
    enlarge(heat);
    return true;
}

void heat_free(struct heat *heat)
{
    thermal_free(&heat->thermal);
    surfaces_free(&heat->surfaces);
    named_parts_free(&heat->parts);
    named_free(&heat->emissivities);
    named_free(&heat->temperatures);
    free(heat->refusals);
    accounts_free(&heat->accounts);
    *heat = (struct heat){ .request = NULL };
}

/* ---- Results --------------------------------------------------------------- */

const char *heat_receiver(const struct heat *heat, size_t to)
{
    return to == heat->surfaces.count ? thermal_environment
                                      : heat->surfaces.list[to].name;
}

static bool is_same_surface(const struct surface *one, const struct surface *other,
                            size_t receivers)
{
    return one->tried == other->tried && one->sent == other->sent
           && memcmp(&one->area, &other->area, sizeof one->area) == 0
           && memcmp(one->count, other->count, receivers * sizeof *one->count) == 0
           && memcmp(one->factor, other->factor, receivers * sizeof *one->factor) == 0
           && !one->smooth == !other->smooth
           && (!one->smooth
               || memcmp(one->smooth, other->smooth, receivers * sizeof *one->smooth)
                      == 0);
}

static bool is_same_exchange(const struct exchange *one, const struct exchange *other)
{
    size_t size = one->count * sizeof *one->flow;
    return one->count == other->count
           && (size == 0
               || (memcmp(one->radiosity, other->radiosity, size) == 0
                   && memcmp(one->irradiation, other->irradiation, size) == 0
                   && memcmp(one->flow, other->flow, size) == 0));
}

bool heat_is_same(const struct heat *one, const struct heat *other)
{
    size_t count = one->surfaces.count;
    bool same = one->drawn == other->drawn && count == other->surfaces.count;
    for (size_t i = 0; same && i < count; i++)
        same = is_same_surface(&one->surfaces.list[i], &other->surfaces.list[i],
                               count + 1);
    return same && is_same_exchange(&one->thermal.exchange, &other->thermal.exchange);
}
