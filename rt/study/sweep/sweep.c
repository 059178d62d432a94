/* sweep.c - measures the points of a sweep. */
#include "rt/study/sweep/sweep.h"
#include "vm/error.h"

#include <stdlib.h>
#include <string.h>

#include "base/accounts.h"
#include "base/array.h"
#include "rt/platform/thread_pool.h"

/* ---- A frame ------------------------------------------------------------- */

/* Returns the trace of a point. The caller frees it, then *scene. *scene is NULL if the
 * trace uses the scene of the sweep. */
static struct trace *open_trace(const struct sweep *sweep,
                                const struct sweep_point *point, struct scene **scene,
                                c205_error *error)
{
    *scene = NULL;
    if (sweep->subject)
        return speedup_trace(sweep->subject, &point->view, &point->trace, scene, error);
    return trace_new(sweep->scene, &point->trace, error);
}

static void add_account(struct sweep_form *form, const c205_account *account)
{
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        form->clocks[cause] += account->clocks[cause];
        form->total += account->clocks[cause];
    }
}

static void add_all(const struct accounts *accounts, struct sweep_form *form)
{
    for (size_t i = 0; i < accounts->count; i++)
        add_account(form, &accounts->items[i]);
}

static bool add_subject(const struct accounts *accounts,
                        const struct speedup_subject *subject, struct sweep_form *form,
                        c205_error *error)
{
    for (size_t i = 0; i < MAX_SPEEDUP_REGIONS && subject->regions[i]; i++) {
        const c205_account *account = speedup_account(accounts, subject->regions[i],
                                                      error);
        if (!account)
            return false;
        add_account(form, account);
    }
    return true;
}

static void leave_out(struct sweep_form *form, c205_cause cause)
{
    form->total -= form->clocks[cause];
    form->clocks[cause] = 0;
}

/* A frame of a point in one form, and its results. */
struct form_run {
    size_t point; /* index of the point's measure */
    int form;
    struct sweep_form found;
    size_t hits;
    uint64_t checksum;
};

static bool read_form(const struct sweep *sweep, const struct trace *trace,
                      struct form_run *run, c205_error *error)
{
    const struct accounts *accounts = trace_accounts(trace);
    struct sweep_form *into = &run->found;
    if (!sweep->subject)
        add_all(accounts, into);
    else if (!add_subject(accounts, sweep->subject, into, error))
        return false;
    if (sweep->pages_in_place) {
        leave_out(into, C205_TRANSLATION_MISS);
        leave_out(into, C205_PAGE_FAULT);
    }
    run->hits = trace_hits(trace);
    run->checksum = trace_checksum(trace);
    return true;
}

/* Estimates the host's time for a frame; the unit is the time for a ray. Each queue
 * adds the time for a hundred rays, because a vector instruction takes time even if it
 * is short. */
static size_t weight_of(const struct sweep_point *point, int form)
{
    size_t rays = point->trace.width * point->trace.height;
    return form == SWEEP_SCALAR ? rays : rays + 100 * (rays / point->trace.queue);
}

/* The frames that are traced to measure the points of a sweep. */
struct plan {
    struct sweep *sweep;
    struct form_run *runs;
    size_t count;
};

static const struct sweep_point *point_of(const struct plan *plan,
                                          const struct form_run *run)
{
    return &plan->sweep->measures[run->point].point;
}

static double run_weight(const void *context, size_t number)
{
    const struct plan *plan = context;
    const struct form_run *run = &plan->runs[number];
    return (double)weight_of(point_of(plan, run), run->form);
}

/* Adds the name of the failing point to the error. */
static void name_point(const struct sweep_point *point, c205_error *error)
{
    const char *model = c205_model_name(point->trace.model);
    c205_error why = *error;
    if (point->trace.mode == TRACE_SCALAR)
        error_set(error, "in scalar form on %.60s: %s", model, why.message);
    else
        error_set(error, "with a queue of %zu on %.60s: %s", point->trace.queue, model,
                  why.message);
}

static bool trace_form(void *context, const struct task *task, c205_error *error)
{
    const struct plan *plan = context;
    struct form_run *run = &plan->runs[task->number];
    struct sweep_point how = *point_of(plan, run);
    struct scene *scene;
    struct trace *trace;
    bool good;
    if (run->form == SWEEP_SCALAR) {
        how.trace.mode = TRACE_SCALAR;
        how.trace.band = 0;
    }
    how.trace.jobs = 1;
    how.trace.progress = task->progress;
    how.trace.context = task->context;
    trace = open_trace(plan->sweep, &how, &scene, error);
    good = trace && trace_run(trace, error)
           && read_form(plan->sweep, trace, run, error);
    if (!good)
        name_point(&how, error);
    trace_free(trace);
    scene_free(scene);
    return good;
}

/* ---- Points -------------------------------------------------------------- */

/* Returns true if the scalar frames of two points are the same, because the points
 * differ at most in the queue. */
static bool are_one_in_scalar_form(const struct sweep_point *a,
                                   const struct sweep_point *b)
{
    return a->trace.model == b->trace.model && a->trace.width == b->trace.width
           && a->trace.height == b->trace.height
           && memcmp(&a->view, &b->view, sizeof a->view) == 0;
}

/* Returns the last measured point. Its scalar frame may also serve the next point. */
static const struct sweep_point *last_point(const struct sweep *sweep)
{
    return sweep->count > 0 ? &sweep->measures[sweep->count - 1].point : NULL;
}

static bool needs_scalar(const struct sweep_point *last,
                         const struct sweep_point *point)
{
    return !last || !are_one_in_scalar_form(last, point);
}

static void plan_run(struct plan *plan, size_t point, int form)
{
    plan->runs[plan->count++] = (struct form_run){ .point = point, .form = form };
}

/* Plans the frames. Each point has a frame in queues. It has a scalar frame only if
 * that differs from the scalar frame of the previous point. */
static void plan_runs(struct plan *plan, const struct sweep_point *points, size_t count)
{
    struct sweep *sweep = plan->sweep;
    const struct sweep_point *last = last_point(sweep);
    for (size_t i = 0; i < count; last = &points[i++]) {
        size_t number = sweep->count + i;
        sweep->measures[number] = (struct sweep_measure){
            .point = points[i], .rays = points[i].trace.width * points[i].trace.height
        };
        if (needs_scalar(last, &points[i]))
            plan_run(plan, number, SWEEP_SCALAR);
        plan_run(plan, number, SWEEP_QUEUED);
    }
}

static bool finish_queued(const struct form_run *run, struct sweep_measure *measure,
                          c205_error *error)
{
    const struct trace_options *trace = &measure->point.trace;
    measure->forms[SWEEP_QUEUED] = run->found;
    measure->hits = run->hits;
    if (measure->checksum == run->checksum)
        return true;
    return error_set(error,
                     "in a queue of %zu: the %s and the scalar frame do not agree",
                     trace->queue, trace_mode_name(trace->mode));
}

/* Copies the results of the frames to the measures. The result of a scalar frame is
 * also used for all following points up to the next scalar frame. */
static bool finish_row(const struct plan *plan, c205_error *error)
{
    struct sweep *sweep = plan->sweep;
    const struct sweep_measure *last = sweep->count > 0
                                           ? &sweep->measures[sweep->count - 1]
                                           : NULL;
    for (size_t i = 0; i < plan->count; i++) {
        const struct form_run *run = &plan->runs[i];
        struct sweep_measure *measure = &sweep->measures[run->point];
        if (run->form == SWEEP_SCALAR) {
            measure->forms[SWEEP_SCALAR] = run->found;
            measure->checksum = run->checksum;
            last = measure;
            continue;
        }
        measure->forms[SWEEP_SCALAR] = last->forms[SWEEP_SCALAR];
        measure->checksum = last->checksum;
        if (!finish_queued(run, measure, error))
            return false;
        sweep->count++;
    }
    return true;
}

static bool grow_measures(struct sweep *sweep, size_t more, c205_error *error)
{
    struct sweep_measure *measures = realloc(sweep->measures,
                                             (sweep->count + more) * sizeof *measures);
    error_set(error, "out of memory");
    if (measures)
        sweep->measures = measures;
    return measures != NULL;
}

bool sweep_run(struct sweep *sweep, const struct sweep_point *points, size_t count,
               c205_error *error)
{
    const struct trace_options *options = &sweep->base.trace;
    struct plan plan = { sweep, NULL, 0 };
    struct thread_pool pool = { .jobs = options->jobs,
                                .run = trace_form,
                                .weight = run_weight,
                                .context = &plan,
                                .progress = options->progress,
                                .progress_context = options->context };
    bool good;
    if (!grow_measures(sweep, count, error))
        return false;
    plan.runs = calloc(2 * count + 1, sizeof *plan.runs);
    if (!plan.runs)
        return false;
    plan_runs(&plan, points, count);
    pool.count = plan.count;
    good = thread_pool_run(&pool, error) && finish_row(&plan, error);
    free(plan.runs);
    return good;
}

const c205_model *sweep_model(struct sweep *sweep, const c205_setting *settings,
                              size_t count, c205_error *error)
{
    c205_model **added = array_add(&sweep->models, &sweep->model_count, NULL,
                                   sizeof *added);
    error_set(error, "out of memory");
    if (!added)
        return NULL;
    *added = c205_model_change(sweep->base.trace.model, settings, count, error);
    sweep->model_count -= !*added;
    return *added;
}

void sweep_free(struct sweep *sweep)
{
    for (size_t i = 0; i < sweep->model_count; i++)
        c205_model_free(sweep->models[i]);
    free(sweep->models);
    free(sweep->measures);
}

/* ---- Memory -------------------------------------------------------------- */

/* Counts pages by counting page faults. With memory for all pages, each page is loaded
 * only once. The model sets the time of a fault to one clock. */
bool sweep_touched(struct sweep *sweep, const struct sweep_point *point,
                   unsigned page_words, uint64_t *words, c205_error *error)
{
    const c205_setting settings[] = { { "page.words", page_words },
                                      { "memory.real_words", 1 << 28 },
                                      { "page_fault.clocks", 1 } };
    struct sweep_point how = *point;
    struct sweep_form form = { .total = 0 };
    struct scene *scene = NULL;
    struct trace *trace = NULL;
    bool good;
    how.trace.model = sweep_model(sweep, settings, 3, error);
    if (how.trace.model)
        trace = open_trace(sweep, &how, &scene, error);
    good = trace && trace_run(trace, error);
    if (good)
        add_all(trace_accounts(trace), &form);
    *words = form.clocks[C205_PAGE_FAULT] * page_words;
    trace_free(trace);
    scene_free(scene);
    return good;
}

/* ---- Derived values ------------------------------------------------------ */

static const char *const group_names[SWEEP_GROUPS] = {
    [SWEEP_SERIAL] = "scalar code",    [SWEEP_STARTUP] = "start-up",
    [SWEEP_STREAM] = "stream",         [SWEEP_CONFLICT] = "bank conflict",
    [SWEEP_MISS] = "translation miss", [SWEEP_FAULT] = "page fault",
};

const char *sweep_group_name(enum sweep_group group)
{
    return group_names[group];
}

static enum sweep_group group_of(c205_cause cause)
{
    switch (cause) {
    case C205_VECTOR_STARTUP: return SWEEP_STARTUP;
    case C205_VECTOR_STREAM: return SWEEP_STREAM;
    case C205_BANK_CONFLICT: return SWEEP_CONFLICT;
    case C205_TRANSLATION_MISS: return SWEEP_MISS;
    case C205_PAGE_FAULT: return SWEEP_FAULT;
    default: return SWEEP_SERIAL;
    }
}

uint64_t sweep_group_clocks(const struct sweep_form *form, enum sweep_group group)
{
    uint64_t clocks = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++)
        if (group_of((c205_cause)cause) == group)
            clocks += form->clocks[cause];
    return clocks;
}

double sweep_per_ray(const struct sweep_measure *measure, uint64_t clocks)
{
    return (double)clocks / (double)measure->rays;
}

double sweep_cost(const struct sweep_measure *measure, int form)
{
    return sweep_per_ray(measure, measure->forms[form].total);
}

double sweep_speedup(const struct sweep_measure *measure)
{
    return (double)measure->forms[SWEEP_SCALAR].total
           / (double)measure->forms[SWEEP_QUEUED].total;
}

double sweep_hit_percent(const struct sweep_measure *measure)
{
    return 100 * sweep_per_ray(measure, measure->hits);
}
