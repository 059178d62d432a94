#include "rt/study/sweep/sweep.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/accounts.h"
#include "base/array.h"

/* ---- What is measured ---------------------------------------------------- */

/* The trace of a point; the caller frees it, then *scene, which is NULL where
 * the sweep's own is traced. */
static struct trace *open_trace(const struct sweep *sweep,
                                const struct sweep_point *point,
                                struct scene **scene, c205_error *error)
{
    *scene = NULL;
    if (sweep->subject)
        return speedup_trace(sweep->subject, &point->view, &point->trace,
                             scene, error);
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
                        const struct speedup_subject *subject,
                        struct sweep_form *form, c205_error *error)
{
    for (size_t i = 0; i < SPEEDUP_REGIONS_MOST && subject->regions[i]; i++) {
        const c205_account *account = speedup_account(accounts,
                                                      subject->regions[i],
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

static bool read_form(const struct sweep *sweep, const struct trace *trace,
                      int form, struct sweep_measure *measure,
                      c205_error *error)
{
    const struct accounts *accounts = trace_accounts(trace);
    struct sweep_form *into = &measure->forms[form];

    *into = (struct sweep_form){ .total = 0 };
    if (!sweep->subject)
        add_all(accounts, into);
    else if (!add_subject(accounts, sweep->subject, into, error))
        return false;
    if (sweep->pages_in_place) {
        leave_out(into, C205_TRANSLATION_MISS);
        leave_out(into, C205_PAGE_FAULT);
    }
    measure->hits = trace_hits(trace);
    measure->checksum = trace_checksum(trace);
    return true;
}

/* Of the host's work, in rays: that of a vector instruction of no elements is
 * as much as that of some hundred more. */
static size_t weight_of(const struct sweep_point *point, int form)
{
    size_t rays = point->trace.width * point->trace.height;

    return form == SWEEP_SCALAR ? rays
                                : rays + 100 * (rays / point->trace.queue);
}

/* One progress for all frames of a run. */
static bool tell(void *context, size_t done, size_t pixels)
{
    const struct sweep *sweep = context;
    const struct trace_options *to = &sweep->base.trace;
    double share = (double)done / (double)pixels;
    size_t now = sweep->done + (size_t)((double)sweep->doing * share);

    return to->progress(to->context,
                        now < sweep->to_do ? now : sweep->to_do - 1,
                        sweep->to_do);
}

/* The same point for the trace of one form. */
static struct sweep_point
point_of_form(struct sweep *sweep, const struct sweep_point *point, int form)
{
    struct sweep_point how = *point;

    if (form == SWEEP_SCALAR) {
        how.trace.mode = TRACE_SCALAR;
        how.trace.band = 0;
    }
    if (sweep->base.trace.progress) {
        how.trace.progress = tell;
        how.trace.context = sweep;
    }
    return how;
}

static bool measure_form(struct sweep *sweep, int form,
                         struct sweep_measure *measure, c205_error *error)
{
    struct sweep_point how = point_of_form(sweep, &measure->point, form);
    struct scene *scene;
    struct trace *trace = open_trace(sweep, &how, &scene, error);
    bool good;

    sweep->doing = weight_of(&measure->point, form);
    good = trace && trace_run(trace, error)
           && read_form(sweep, trace, form, measure, error);
    sweep->done += sweep->doing;
    trace_free(trace);
    scene_free(scene);
    return good;
}

/* ---- Point after point --------------------------------------------------- */

/* The scalar form knows no queue. */
static bool are_one_in_scalar_form(const struct sweep_point *a,
                                   const struct sweep_point *b)
{
    return a->trace.model == b->trace.model
           && a->trace.width == b->trace.width
           && a->trace.height == b->trace.height
           && memcmp(&a->view, &b->view, sizeof a->view) == 0;
}

/* That point's scalar form serves for the next one, too. */
static const struct sweep_point *last_point(const struct sweep *sweep)
{
    return sweep->count > 0 ? &sweep->measures[sweep->count - 1].point : NULL;
}

static bool needs_scalar(const struct sweep_point *last,
                         const struct sweep_point *point)
{
    return !last || !are_one_in_scalar_form(last, point);
}

static bool measure_scalar(struct sweep *sweep, struct sweep_measure *measure,
                           c205_error *error)
{
    const struct sweep_measure *last;

    if (needs_scalar(last_point(sweep), &measure->point))
        return measure_form(sweep, SWEEP_SCALAR, measure, error);
    last = &sweep->measures[sweep->count - 1];
    measure->forms[SWEEP_SCALAR] = last->forms[SWEEP_SCALAR];
    measure->checksum = last->checksum;
    return true;
}

static bool measure_point(struct sweep *sweep,
                          const struct sweep_point *point,
                          struct sweep_measure *measure, c205_error *error)
{
    uint64_t checksum;

    *measure = (struct sweep_measure){
        .point = *point, .rays = point->trace.width * point->trace.height
    };
    if (!measure_scalar(sweep, measure, error))
        return false;
    checksum = measure->checksum;
    if (!measure_form(sweep, SWEEP_QUEUED, measure, error))
        return false;
    if (measure->checksum == checksum)
        return true;
    snprintf(error->message, sizeof error->message,
             "in a queue of %zu: the %s and the scalar frame do not agree",
             point->trace.queue, trace_mode_name(point->trace.mode));
    return false;
}

static bool make_room(struct sweep *sweep, size_t more, c205_error *error)
{
    struct sweep_measure *measures = realloc(sweep->measures,
                                             (sweep->count + more)
                                                 * sizeof *measures);

    snprintf(error->message, sizeof error->message, "no memory");
    if (measures)
        sweep->measures = measures;
    return measures != NULL;
}

static void plan_progress(struct sweep *sweep,
                          const struct sweep_point *points, size_t count)
{
    const struct sweep_point *last = last_point(sweep);

    sweep->done = sweep->to_do = 0;
    for (size_t i = 0; i < count; last = &points[i++]) {
        if (needs_scalar(last, &points[i]))
            sweep->to_do += weight_of(&points[i], SWEEP_SCALAR);
        sweep->to_do += weight_of(&points[i], SWEEP_QUEUED);
    }
}

bool sweep_run(struct sweep *sweep, const struct sweep_point *points,
               size_t count, c205_error *error)
{
    const struct trace_options *to = &sweep->base.trace;

    if (!make_room(sweep, count, error))
        return false;
    plan_progress(sweep, points, count);
    for (size_t i = 0; i < count; i++) {
        if (!measure_point(sweep, &points[i], &sweep->measures[sweep->count],
                           error))
            return false;
        sweep->count++;
    }
    if (to->progress)
        to->progress(to->context, sweep->to_do, sweep->to_do);
    return true;
}

const c205_model *sweep_model(struct sweep *sweep,
                              const c205_setting *settings, size_t count,
                              c205_error *error)
{
    c205_model **models = array_grow(sweep->models, sweep->model_count,
                                     sizeof *models);

    snprintf(error->message, sizeof error->message, "no memory");
    if (!models)
        return NULL;
    sweep->models = models;
    models[sweep->model_count] = c205_model_change(sweep->base.trace.model,
                                                   settings, count, error);
    if (!models[sweep->model_count])
        return NULL;
    return models[sweep->model_count++];
}

void sweep_free(struct sweep *sweep)
{
    for (size_t i = 0; i < sweep->model_count; i++)
        c205_model_free(sweep->models[i]);
    free(sweep->models);
    free(sweep->measures);
}

/* ---- The memory of a program --------------------------------------------- */

/* With memory for all, each page is brought in once, and here for one clock. */
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

/* ---- Of a measure -------------------------------------------------------- */

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

uint64_t sweep_group_clocks(const struct sweep_form *form,
                            enum sweep_group group)
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
