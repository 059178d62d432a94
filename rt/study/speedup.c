/* speedup.c - measures the paper's Table 1 on the emulated machine. */
#include "rt/study/speedup.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "vm/error.h"
#include "base/provenance.h"
#include "rt/scene/language/scene_read.h"
#include "rt/platform/thread_pool.h"

const char speedup_solver[] = "root_solver";
const char *const speedup_projections[SPEEDUP_PROJECTIONS] = {
    [SPEEDUP_720] = "cyber720", [SPEEDUP_6600] = "cdc6600"
};

/* Selects the fitted model of the machine if `model` is fitted, and otherwise the model
 * with its priors. The model of the 6600 has no fitted constants. */
const char *speedup_projection_model(const c205_model *model,
                                     enum speedup_projection machine)
{
    static const char *const priors[SPEEDUP_PROJECTIONS] = {
        [SPEEDUP_720] = "cyber720-prior", [SPEEDUP_6600] = "cdc6600"
    };
    return provenance_is_fitted(model) ? speedup_projections[machine] : priors[machine];
}

/* A curved patch that many rays cross twice. Its surface has degree four. */
#define PATCH \
    "steiner_patch { <-1.1, -.8, .5>, <1.2, -.8, .5>, <0, .9, .5>," \
    " <.1, -1.5, -1>, <1.3, .6, -.8>, <-1.4, .5, -.8> }"

#define CYLINDER "cylinder { <-1, -.6, .4>, <1, .6, -.4>, .75 }"
#define CYLINDER_ROW \
    .shape = CYLINDER, .from = { 0, 0, -1 }, .regions = { "call", "cylinder" }

/* The times and the fraction of the root solver are from Plunkett, Cychosz, Bailey
 * 1984. */
const struct speedup_subject speedup_subjects[] = {
    { .name = "sphere",
      .shape = "sphere { 0, 1 }",
      .from = { 0, 0, -1 },
      .regions = { "call", "sphere" },
      .paper = { { .944, .0279 }, 33.81, { { 13.1, 469 } }, 0 } },
    { .name = "cylinder",
      CYLINDER_ROW,
      .historical = true,
      .paper = { { 2.729, .1614 }, 16.91, { { 51.48, 318 } }, 0 } },
    { .name = "cylinder, ours", CYLINDER_ROW },
    { .name = "Steiner",
      .shape = PATCH,
      .from = { .48, .6, -.64 },
      .historical = true,
      .regions = { "call", "steiner", speedup_solver },
      .paper = { { 11.157, 1.047 }, 10.67, { { 216.0, 206 } }, 65 } },
    { .name = "Steiner, ours",
      .shape = PATCH,
      .from = { .48, .6, -.64 },
      .regions = { "call", "steiner", speedup_solver } },
    { .name = "torus, ours",
      .shape = "torus { .8, .35 translate .8*z }", /* the tube is in the centre of the
                                                    * frame */
      .from = { 0, .8, -.6 },
      .regions = { "call", "torus", speedup_solver } },
};
const size_t speedup_subject_count = sizeof speedup_subjects / sizeof *speedup_subjects;

bool speedup_is_named(const struct speedup_subject *subject, const char *name)
{
    size_t stem = strcspn(subject->name, ",");
    return strcasecmp(subject->name, name) == 0
           || (strlen(name) == stem && strncasecmp(subject->name, name, stem) == 0);
}

const struct speedup_subject *speedup_subject_named(const char *name)
{
    for (size_t i = 0; i < speedup_subject_count; i++)
        if (speedup_is_named(&speedup_subjects[i], name))
            return &speedup_subjects[i];
    return NULL;
}

const struct speedup_subject speedup_formulations[] = {
    { .name = "Cychosz and Waggenspack, surfaces noted",
      CYLINDER_ROW,
      .historical = true },
    { .name = "the same without surfaces",
      CYLINDER_ROW,
      .historical = true,
      .variant = "CYLINDER_UNRECORDED" },
    { .name = "the first, one reciprocal for three divisions",
      CYLINDER_ROW,
      .historical = true,
      .variant = "CYLINDER_RECIPROCALS" },
    { .name = "own frame, both ends as planes",
      CYLINDER_ROW,
      .variant = "CYLINDER_IN_FRAME" },
    { .name = "side and two half spaces, merged",
      CYLINDER_ROW,
      .variant = "CYLINDER_HALF_SPACES" },
    { .name = "ours", CYLINDER_ROW },
};
const size_t speedup_formulation_count = sizeof speedup_formulations
                                         / sizeof *speedup_formulations;

static void print_scene(char *text, size_t size, const struct speedup_subject *subject,
                        const struct speedup_view *view,
                        const struct trace_options *options)
{
    snprintf(text, size,
             "#version 3.7;\n"
             "global_settings { assumed_gamma 1 }\n"
             "camera { location <%.17g, %.17g, %.17g>"
             " look_at <%.17g, %.17g, %.17g>\n"
             " right %.17g*x up y angle %.17g }\n"
             "object { %s pigment { color rgb 1 } }\n",
             view->distance * subject->from[0], view->distance * subject->from[1],
             view->distance * subject->from[2], view->aim[0], view->aim[1],
             view->aim[2], (double)options->width / (double)options->height,
             view->angle, subject->shape);
}

static struct scene *read_scene(const struct speedup_subject *subject,
                                const struct speedup_view *view,
                                const struct trace_options *options, c205_error *error)
{
    static const struct scene_options how = { .strict = true };
    struct diagnostics reports = { 0 };
    struct scene *scene;
    char text[1024];
    print_scene(text, sizeof text, subject, view, options);
    scene = scene_read_text(subject->name, text, &how, &reports);
    if (!scene)
        error_set(error, "%s: %s", subject->name,
                  reports.count > 0 ? reports.items[0].message : "out of memory");
    diagnostics_free(&reports);
    return scene;
}

const c205_account *speedup_account(const struct accounts *accounts, const char *region,
                                    c205_error *error)
{
    const c205_account *account = accounts_find(accounts, region);
    if (!account)
        error_set(error, "the program has no region %s", region);
    return account;
}

/* Sums the clocks of the subject's regions, for each cause and for each region. */
static bool sum_accounts(const struct accounts *accounts,
                         const struct speedup_subject *subject,
                         struct speedup_measure *measure, c205_error *error)
{
    for (size_t i = 0; i < MAX_SPEEDUP_REGIONS; i++) {
        const char *region = subject->regions[i];
        const c205_account *account;
        if (!region)
            break;
        account = speedup_account(accounts, region, error);
        if (!account)
            return false;
        for (int cause = 0; cause < C205_CAUSES; cause++) {
            measure->clocks[cause] += account->clocks[cause];
            measure->regions[i] += account->clocks[cause];
        }
        measure->total += measure->regions[i];
    }
    return true;
}

/* ---- Projections to other machines --------------------------------------- */

/* The state of a projection of the scalar form to another machine. The clocks are those
 * of the subject's regions. */
struct projecting {
    c205_model *model;
    const struct speedup_subject *subject;
    uint64_t clocks;
    bool failed; /* its error message is the reason of the failure */
    c205_error error;
};

struct projected_band {
    c205_projection *projection;
    const c205 *machine; /* machine of the last event */
};

static void end_projection(void *state)
{
    struct projected_band *band = state;
    c205_projection_free(band->projection);
    free(band);
}

static void *begin_projection(void *context, const struct object *program,
                              c205_error *error)
{
    const struct projecting *projecting = context;
    struct projected_band *band = calloc(1, sizeof *band);
    (void)program;
    error_set(error, "out of memory");
    if (band)
        band->projection = c205_projection_new(projecting->model, error);
    if (band && band->projection)
        return band;
    free(band);
    return NULL;
}

static void record_projection(void *state, const c205 *machine, const c205_event *event)
{
    struct projected_band *band = state;
    band->machine = machine;
    c205_project(band->projection, machine, event);
}

static bool is_of(const struct speedup_subject *subject, const char *region)
{
    for (size_t i = 0; i < MAX_SPEEDUP_REGIONS && subject->regions[i]; i++)
        if (strcmp(subject->regions[i], region) == 0)
            return true;
    return false;
}

static void merge_projection(void *context, const void *state)
{
    const struct projected_band *band = state;
    struct projecting *projecting = context;
    if (!c205_projection_holds(band->projection, &projecting->error))
        projecting->failed = true;
    for (size_t i = 0; i < c205_account_count(band->machine); i++)
        if (is_of(projecting->subject, c205_account_at(band->machine, i)->name))
            projecting->clocks += c205_projected_clocks(band->projection, i);
}

static struct observer projection_observer(struct projecting *projecting)
{
    return (struct observer){ begin_projection, record_projection, merge_projection,
                              end_projection, projecting };
}

static bool find_projections(struct projecting projecting[SPEEDUP_PROJECTIONS],
                             const struct speedup_subject *subject,
                             const c205_model *on, c205_error *error)
{
    for (int i = 0; i < SPEEDUP_PROJECTIONS; i++) {
        enum speedup_projection machine = (enum speedup_projection)i;
        projecting[i].subject = subject;
        projecting[i].model = c205_model_find(speedup_projection_model(on, machine),
                                              error);
        if (!projecting[i].model)
            return false;
    }
    return true;
}

/* ---- A measurement -------------------------------------------------------- */

static bool run_form(const struct speedup_subject *subject,
                     const struct speedup_view *view,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error)
{
    struct scene *scene;
    struct trace *trace = speedup_trace(subject, view, options, &scene, error);
    bool good = trace && trace_run(trace, error)
                && sum_accounts(trace_accounts(trace), subject, measure, error);
    if (good) {
        measure->falsi = falsi_of(trace_program(trace));
        measure->hits = trace_hits(trace);
        measure->checksum = trace_checksum(trace);
    }
    trace_free(trace);
    scene_free(scene);
    return good;
}

/* Runs a frame with observers. The scalar form is also projected to the other
 * machines. */
static bool run_observed(const struct speedup_subject *subject,
                         const struct speedup_view *view,
                         const struct trace_options *options,
                         struct projecting projecting[SPEEDUP_PROJECTIONS],
                         struct speedup_measure *measure, c205_error *error)
{
    bool scalar = options->mode == TRACE_SCALAR;
    struct trace_options how = *options;
    struct observer watching[1 + SPEEDUP_PROJECTIONS];
    const struct observer *observers[2 + SPEEDUP_PROJECTIONS] = { NULL };
    measure->iterations.vector = options->mode == TRACE_VECTOR;
    watching[0] = iterations_observer(&measure->iterations);
    observers[0] = &watching[0];
    for (int i = 0; scalar && i < SPEEDUP_PROJECTIONS; i++) {
        watching[1 + i] = projection_observer(&projecting[i]);
        observers[1 + i] = &watching[1 + i];
    }
    how.observers = observers;
    if (!run_form(subject, view, &how, measure, error))
        return false;
    for (int i = 0; scalar && i < SPEEDUP_PROJECTIONS; i++) {
        if (projecting[i].failed)
            return error_set(error, "%s", projecting[i].error.message);
        measure->projected[i] = accounts_seconds(projecting[i].model,
                                                 projecting[i].clocks);
    }
    return true;
}

struct trace *speedup_trace(const struct speedup_subject *subject,
                            const struct speedup_view *view,
                            const struct trace_options *options, struct scene **scene,
                            c205_error *error)
{
    struct trace_options how = *options;
    how.historical = subject->historical;
    how.variant = subject->variant;
    how.no_bounds = true;
    how.band = options->width * options->height;
    how.order = ORDER_ROWS;
    *scene = read_scene(subject, view, options, error);
    return !*scene ? NULL : trace_new(*scene, &how, error);
}

bool speedup_measure(const struct speedup_subject *subject,
                     const struct speedup_view *view,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error)
{
    struct projecting projecting[SPEEDUP_PROJECTIONS] = { { .model = NULL } };
    bool good;
    memset(measure, 0, sizeof *measure);
    measure->rays = options->width * options->height;
    good = find_projections(projecting, subject, options->model, error)
           && run_observed(subject, view, options, projecting, measure, error);
    for (int i = 0; i < SPEEDUP_PROJECTIONS; i++)
        c205_model_free(projecting[i].model);
    return good;
}

/* ---- A whole table ------------------------------------------------------- */

struct measuring {
    const struct speedup_subject *subjects;
    const struct speedup_view *view;
    const struct trace_options *options;
    struct speedup_measure (*measures)[TRACE_FORMS];
};

static bool measure_form(void *context, const struct task *task, c205_error *error)
{
    const struct measuring *measuring = context;
    struct trace_options options = *measuring->options;
    size_t subject = task->number / TRACE_FORMS;
    size_t mode = task->number % TRACE_FORMS;
    options.mode = (enum trace_mode)mode;
    options.jobs = 1;
    options.progress = task->progress;
    options.context = task->context;
    return speedup_measure(&measuring->subjects[subject], measuring->view, &options,
                           &measuring->measures[subject][mode], error);
}

/* Returns the measured relative cost on the host. The scalar form takes most of the
 * time, particularly with long kernels. */
static double form_weight(const void *context, size_t number)
{
    const struct measuring *measuring = context;
    const struct speedup_subject *subject = &measuring->subjects[number / TRACE_FORMS];
    if (number % TRACE_FORMS == TRACE_VECTOR)
        return 1;
    return subject->regions[2] ? 20 : 3;
}

bool speedup_measure_all(const struct speedup_subject *subjects, size_t count,
                         const struct speedup_view *view,
                         const struct trace_options *options,
                         struct speedup_measure (*measures)[TRACE_FORMS],
                         c205_error *error)
{
    struct measuring measuring = { subjects, view, options, measures };
    const struct thread_pool pool = { .count = TRACE_FORMS * count,
                                      .jobs = options->jobs,
                                      .run = measure_form,
                                      .weight = form_weight,
                                      .context = &measuring,
                                      .progress = options->progress,
                                      .progress_context = options->context };
    if (!thread_pool_run(&pool, error))
        return false;
    for (size_t i = 0; i < count; i++) {
        const struct speedup_measure *forms = measures[i];
        if (forms[TRACE_SCALAR].checksum == forms[TRACE_VECTOR].checksum)
            continue;
        return error_set(error, "%s: the scalar and the vector form do not agree",
                         subjects[i].name);
    }
    return true;
}
