/* fit.c - fits the constants of the timing model with Ceres. */
#include "rt/study/fit/fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/platform/threads.h"
#include "rt/study/fit/ceres_fit.h"

/* Derivatives are approximated by differences with this step, in prior widths. */
#define STEP 0.1

double fit_error(const struct observation *observation, double predicted)
{
    return predicted / observation->value - 1;
}

/* ---- Points: places of all constants, and the clocks there ------------- */

struct point {
    double places[MAX_FREE];
    size_t moved; /* the constant that differs from the first point; MAX_FREE: this is
                   * the first point */
    bool timed[MAX_FIT_TIMINGS];
    double clocks[MAX_FIT_TIMINGS][MAX_RUN_REGIONS];
};

/* The clocks to compute: those of each timing, with the constants of each point.
 * Threads share the work. */
struct work {
    const struct fit *fit;
    const bool *needed; /* for each timing: true if the timing is needed */
    struct point *points;
    size_t count, next; /* number of points x timings */
    struct lock *lock;
    bool failed;
    c205_error error;
};

static bool time_one(const struct work *work, size_t i, c205_error *error)
{
    const struct observations *all = work->fit->observations;
    struct point *point = &work->points[i / all->timing_count];
    size_t which = i % all->timing_count;
    const struct run_timing *timing = &all->timings[which];
    c205_setting settings[MAX_SETTINGS];
    size_t count;
    if (!work->needed[which] || point->timed[which]
        || (point->moved < MAX_FREE && work->fit->idle[which][point->moved]))
        return true;
    count = constants_settings(work->fit->constants, point->places, timing->model,
                               settings);
    point->timed[which] = run_time(timing->run, timing->model, settings, count,
                                   RUN_FINE, point->clocks[which], error);
    return point->timed[which];
}

static void do_work(void *context)
{
    struct work *work = context;
    c205_error error = { "" };
    lock_take(work->lock);
    while (work->next < work->count && !work->failed) {
        size_t i = work->next++;
        bool good;
        lock_give_back(work->lock);
        good = time_one(work, i, &error);
        lock_take(work->lock);
        if (!good) {
            work->failed = true;
            work->error = error;
        }
    }
    lock_give_back(work->lock);
}

/* Runs the work in threads. This thread is the first worker. */
static void share_out(struct work *work)
{
    struct thread *threads[MAX_FIT_JOBS];
    size_t begun = 1;
    while (begun < work->fit->jobs && begun < MAX_FIT_JOBS
           && (threads[begun] = thread_begin(do_work, work)))
        begun++;
    do_work(work);
    for (size_t i = 1; i < begun; i++)
        thread_end(threads[i]);
}

/* Copies clocks from the first point, for programs that the changed constant does not
 * affect. */
static void fill_in(const struct fit *fit, struct point *points, size_t count)
{
    for (size_t i = 1; i < count; i++)
        for (size_t k = 0; k < fit->observations->timing_count; k++)
            if (points[i].moved < MAX_FREE && fit->idle[k][points[i].moved])
                memcpy(points[i].clocks[k], points[0].clocks[k],
                       sizeof points[i].clocks[k]);
}

static bool time_points(const struct fit *fit, const bool *needed, struct point *points,
                        size_t count, c205_error *error)
{
    struct work work = { .fit = fit,
                         .needed = needed,
                         .points = points,
                         .count = count * fit->observations->timing_count,
                         .lock = lock_new() };
    if (!work.lock)
        return error_set(error, "out of memory");
    share_out(&work);
    lock_free(work.lock);
    fill_in(fit, points, count);
    if (work.failed)
        *error = work.error;
    return !work.failed;
}

/* Returns an array of points. The first has the given places. Each other point differs
 * from it in one constant, by STEP. Returns NULL if out of memory. */
static struct point *points_at(const struct fit *fit, const double *places,
                               size_t *count, c205_error *error)
{
    size_t constants = fit->constants->count;
    struct point *points = calloc(1 + constants, sizeof *points);
    if (!points)
        error_set(error, "out of memory");
    for (size_t i = 0; points && i < 1 + constants; i++) {
        memcpy(points[i].places, places, constants * sizeof *places);
        points[i].moved = i == 0 ? MAX_FREE : i - 1;
        if (i > 0)
            points[i].places[points[i].moved] += STEP;
    }
    *count = 1 + constants;
    return points;
}

/* ---- Residuals ---------------------------------------------------------- */

/* The state of one fit for the callbacks of Ceres. */
struct asked {
    const struct fit *fit;
    const struct fit_change *change;
    size_t used[MAX_FIT_OBSERVATIONS], use_count;
    bool needed[MAX_FIT_TIMINGS];
    struct point last; /* the point of the last evaluation */
    c205_error error;
};

static double prior_width(const struct asked *asked, size_t constant)
{
    double wider = asked->change->wider[constant];
    return wider > 0 ? wider : 1;
}

static const struct observation *used_at(const struct asked *asked, size_t i)
{
    return &asked->fit->observations->items[asked->used[i]];
}

static double error_at(const struct asked *asked, size_t i, struct point *point)
{
    const struct observation *item = used_at(asked, i);
    return fit_error(item, observation_predict(asked->fit->observations, item,
                                               point->clocks));
}

/* Returns the part that weigh_errors subtracts from an error of a row: the factor b
 * times the mean error of the rows of its group. */
static double shared_error(const struct asked *asked, size_t i, const double *errors,
                           size_t columns)
{
    const struct observation *item = used_at(asked, i);
    double own = item->uncertainty, sum = 0, rows = 0;
    for (size_t k = 0; k < asked->use_count; k++)
        if (observation_same_group(item, used_at(asked, k))) {
            sum += errors[k * columns];
            rows++;
        }
    return sum / rows
           * (1 - own / sqrt(own * own + rows * item->shared * item->shared));
}

/* Converts relative errors to residuals, column by column. The errors of a group of k
 * rows have the covariance u^2 I + s^2 1 1^T, where u is the uncertainty of each row
 * and s the shared uncertainty. The inverse square root of this matrix maps an error e
 * to
 *
 *     (e - b mean e) / u,   b = 1 - u / sqrt (u^2 + k s^2).
 */
static void weigh_errors(const struct asked *asked, double *errors, size_t columns)
{
    for (size_t k = 0; k < columns; k++) {
        double shared[MAX_FIT_OBSERVATIONS];
        for (size_t i = 0; i < asked->use_count; i++)
            shared[i] = shared_error(asked, i, errors + k, columns);
        for (size_t i = 0; i < asked->use_count; i++) {
            double *error = &errors[i * columns + k];
            *error = (*error - shared[i]) / used_at(asked, i)->uncertainty;
        }
    }
}

static void find_residuals(const struct asked *asked, struct point *points,
                           double *residuals)
{
    const struct fit_change *change = asked->change;
    for (size_t i = 0; i < asked->use_count; i++)
        residuals[i] = error_at(asked, i, &points[0]);
    weigh_errors(asked, residuals, 1);
    for (size_t i = 0; i < asked->fit->constants->count; i++)
        residuals[asked->use_count + i] = (points[0].places[i] - change->center[i])
                                          / prior_width(asked, i);
}

static void find_derivatives(const struct asked *asked, struct point *points,
                             double *derivatives)
{
    size_t constants = asked->fit->constants->count;
    double *prior = derivatives + asked->use_count * constants;
    for (size_t i = 0; i < asked->use_count; i++)
        for (size_t k = 0; k < constants; k++)
            derivatives[i * constants + k] = (error_at(asked, i, &points[k + 1])
                                              - error_at(asked, i, &points[0]))
                                             / STEP;
    weigh_errors(asked, derivatives, constants);
    memset(prior, 0, constants * constants * sizeof *prior);
    for (size_t i = 0; i < constants; i++)
        prior[i * constants + i] = 1 / prior_width(asked, i);
}

/* The callback for Ceres. It reuses the clocks of the last point if `places` has not
 * changed, because Ceres often requests the derivatives of a point after its
 * residuals. */
static bool evaluate(void *context, const double *places, double *residuals,
                     double *derivatives)
{
    struct asked *asked = context;
    size_t count;
    struct point *points = points_at(asked->fit, places, &count, &asked->error);
    bool good;
    if (points
        && memcmp(asked->last.places, points[0].places, sizeof points[0].places) == 0)
        points[0] = asked->last;
    good = points != NULL
           && time_points(asked->fit, asked->needed, points, derivatives ? count : 1,
                          &asked->error);
    if (good)
        asked->last = points[0];
    if (good)
        find_residuals(asked, points, residuals);
    if (good && derivatives)
        find_derivatives(asked, points, derivatives);
    free(points);
    return good;
}

/* ---- Fits --------------------------------------------------------------- */

bool fit_predict(const struct fit *fit, const double *places,
                 double predicted[MAX_FIT_OBSERVATIONS], c205_error *error)
{
    const struct observations *all = fit->observations;
    size_t count;
    struct point *points = points_at(fit, places, &count, error);
    bool needed[MAX_FIT_TIMINGS];
    bool good;
    memset(needed, true, sizeof needed);
    good = points && time_points(fit, needed, points, 1, error);
    for (size_t i = 0; good && i < all->count; i++)
        predicted[i] = observation_predict(all, &all->items[i], points[0].clocks);
    free(points);
    return good;
}

/* Marks constant k as idle in each timing whose clocks do not change when the constant
 * changes by one width of its prior. */
static void find_idle(struct fit *fit, const struct point *points, size_t k)
{
    for (size_t i = 0; i < fit->observations->timing_count; i++)
        fit->idle[i][k] = memcmp(points[0].clocks[i], points[k + 1].clocks[i],
                                 sizeof points[0].clocks[i])
                          == 0;
}

/* Marks, for each timing, the constants of other machines, which cannot affect its
 * clocks. */
static void set_strangers_idle(struct fit *fit)
{
    const struct observations *all = fit->observations;
    for (size_t i = 0; i < all->timing_count; i++)
        for (size_t k = 0; k < fit->constants->count; k++)
            fit->idle[i][k] = !constant_is_of(&fit->constants->items[k],
                                              all->timings[i].model);
}

/* Marks the timings of the observations that the fit uses. */
static void find_needed(const struct fit *fit, const struct fit_change *change,
                        bool needed[MAX_FIT_TIMINGS])
{
    const struct observations *all = fit->observations;
    memset(needed, 0, MAX_FIT_TIMINGS * sizeof *needed);
    for (size_t i = 0; i < all->count; i++)
        for (size_t k = 0; k < all->items[i].term_count; k++)
            if (all->items[i].use == OBSERVATION_FIT && !change->held[i])
                needed[all->items[i].terms[k].timing] = true;
}

bool fit_begin(struct fit *fit, c205_error *error)
{
    static const double priors[MAX_FREE];
    static const struct fit_change none;
    bool needed[MAX_FIT_TIMINGS];
    struct point *points;
    size_t count;
    bool good;
    if (fit->observations->count > MAX_FIT_OBSERVATIONS
        || fit->observations->timing_count > MAX_FIT_TIMINGS)
        return error_set(error, "more than %d observations or %d programs",
                         MAX_FIT_OBSERVATIONS, MAX_FIT_TIMINGS);
    set_strangers_idle(fit);
    find_needed(fit, &none, needed);
    points = points_at(fit, priors, &count, error);
    for (size_t k = 0; points && k < fit->constants->count; k++)
        points[k + 1].places[k] = 1;
    good = points && time_points(fit, needed, points, count, error);
    for (size_t k = 0; good && k < fit->constants->count; k++)
        find_idle(fit, points, k);
    free(points);
    return good;
}

static void choose(struct asked *asked)
{
    const struct observations *all = asked->fit->observations;
    for (size_t i = 0; i < all->count; i++)
        if (all->items[i].use == OBSERVATION_FIT && !asked->change->held[i])
            asked->used[asked->use_count++] = i;
}

/* Computes the standard errors. The covariance assumes correct uncertainties. If the
 * cost indicates that they are too small, the variances are multiplied by 2 cost /
 * (residuals - constants). */
static void find_errors(const struct ceres_outcome *found, size_t constants,
                        struct fit_outcome *outcome)
{
    double scale = fmax(1, sqrt(2 * found->cost / (double)outcome->used));
    for (size_t i = 0; i < constants; i++) {
        double error = found->determined ? sqrt(found->covariance[i * constants + i])
                                         : NAN;
        outcome->raw_errors[i] = error;
        outcome->errors[i] = error * scale;
    }
}

bool fit_solve(const struct fit *fit, const struct fit_change *change,
               const double *places, struct fit_outcome *outcome, c205_error *error)
{
    struct asked asked = { .fit = fit,
                           .change = change,
                           .last = { .moved = MAX_FREE } };
    size_t constants = fit->constants->count;
    double least[MAX_FREE], most[MAX_FREE];
    double losses[MAX_FIT_OBSERVATIONS + MAX_FREE] = { 0 };
    double covariance[MAX_FREE * MAX_FREE];
    struct ceres_outcome found = { .covariance = covariance };
    struct ceres_problem problem = {
        constants, 0, least, most, losses, evaluate, &asked
    };
    choose(&asked);
    find_needed(fit, change, asked.needed);
    problem.residuals = asked.use_count + constants;
    for (size_t i = 0; i < constants; i++) {
        const struct free_constant *constant = &fit->constants->items[i];
        least[i] = constant_place(constant, constant->least);
        most[i] = constant_place(constant, constant->most);
        outcome->places[i] = places[i];
    }
    for (size_t i = 0; i < asked.use_count; i++)
        losses[i] = FIT_LOSS;
    if (!ceres_fit(&problem, outcome->places, &found))
        return error_set(error, "%.200s",
                         *asked.error.message != '\0' ? asked.error.message
                                                      : found.message);
    outcome->cost = found.cost;
    outcome->steps = found.steps;
    outcome->converged = found.converged;
    outcome->used = asked.use_count;
    find_errors(&found, constants, outcome);
    return fit_predict(fit, outcome->places, outcome->predicted, error);
}
