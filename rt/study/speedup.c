#include "rt/study/speedup.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/provenance.h"
#include "rt/scene/language/scene_read.h"

const char speedup_solver[] = "root_solver";
const char *const speedup_projections[SPEEDUP_PROJECTIONS] = {
    [SPEEDUP_720] = "cyber720", [SPEEDUP_6600] = "cdc6600"
};

/* No constant of the 6600 has been fitted. */
const char *speedup_projection_model(const c205_model *model,
                                     enum speedup_projection machine)
{
    static const char *const priors[SPEEDUP_PROJECTIONS] = {
        [SPEEDUP_720] = "cyber720-prior", [SPEEDUP_6600] = "cdc6600"
    };

    return provenance_is_fitted(model) ? speedup_projections[machine]
                                       : priors[machine];
}

/* Bent, so that many rays cross it twice; its surface is of degree four. */
#define PATCH \
    "steiner_patch { <-1.1, -.8, .5>, <1.2, -.8, .5>, <0, .9, .5>," \
    " <.1, -1.5, -1>, <1.3, .6, -.8>, <-1.4, .5, -.8> }"

/* Source of the times and of the share: Plunkett, Cychosz, Bailey 1984. */
const struct speedup_subject speedup_subjects[] = {
    { .name = "sphere",
      .shape = "sphere { 0, 1 }",
      .from = { 0, 0, -1 },
      .regions = { "call", "sphere" },
      .paper = { { .944, .0279 }, 33.81, { { 13.1, 469 } }, 0 } },
    { .name = "cylinder",
      .shape = "cylinder { <-1, -.6, .4>, <1, .6, -.4>, .75 }",
      .from = { 0, 0, -1 },
      .regions = { "call", "cylinder" },
      .paper = { { 2.729, .1614 }, 16.91, { { 51.48, 318 } }, 0 } },
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
      .shape =
          "torus { .8, .35 translate .8*z }", /* the tube in the middle */
      .from = { 0, .8, -.6 },
      .regions = { "call", "torus", speedup_solver } },
};
const size_t speedup_subject_count = sizeof speedup_subjects
                                     / sizeof *speedup_subjects;

static void print_scene(char *text, size_t size,
                        const struct speedup_subject *subject,
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
             view->distance * subject->from[0],
             view->distance * subject->from[1],
             view->distance * subject->from[2], view->aim[0], view->aim[1],
             view->aim[2], (double)options->width / (double)options->height,
             view->angle, subject->shape);
}

static struct scene *read_scene(const struct speedup_subject *subject,
                                const struct speedup_view *view,
                                const struct trace_options *options,
                                c205_error *error)
{
    static const struct scene_options how = { .strict = true };
    struct diagnostics reports = { 0 };
    struct scene *scene;
    char text[1024];

    print_scene(text, sizeof text, subject, view, options);
    scene = scene_read_text(subject->name, text, &how, &reports);
    if (!scene)
        snprintf(error->message, sizeof error->message, "%s: %s",
                 subject->name,
                 reports.count > 0 ? reports.items[0].message : "no memory");
    diagnostics_free(&reports);
    return scene;
}

const c205_account *speedup_account(const struct accounts *accounts,
                                    const char *region, c205_error *error)
{
    const c205_account *account = accounts_find(accounts, region);

    if (!account)
        snprintf(error->message, sizeof error->message,
                 "the program has no region %s", region);
    return account;
}

/* The clocks of the subject's regions, by cause and by region. */
static bool sum_accounts(const struct accounts *accounts,
                         const struct speedup_subject *subject,
                         struct speedup_measure *measure, c205_error *error)
{
    for (size_t i = 0; i < SPEEDUP_REGIONS_MOST; i++) {
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

/* Seconds of the subject's regions on another machine. */
static double projected_seconds(const struct trace *trace,
                                const struct speedup_subject *subject,
                                const c205_projection *projection,
                                const c205_model *model)
{
    const struct accounts *accounts = trace_accounts(trace);
    uint64_t clocks = 0;

    for (size_t i = 0; i < SPEEDUP_REGIONS_MOST && subject->regions[i]; i++) {
        const c205_account *account = accounts_find(accounts,
                                                    subject->regions[i]);

        clocks += c205_projected_clocks(projection,
                                        (size_t)(account - accounts->items));
    }
    return accounts_seconds(model, clocks);
}

static bool watch(struct trace *trace, struct iterations *iterations,
                  c205_error *error)
{
    if (trace_watch(trace, iterations))
        return true;
    snprintf(error->message, sizeof error->message,
             "the root solver cannot be watched");
    return false;
}

static bool run(struct trace *trace, const struct speedup_subject *subject,
                struct speedup_measure *measure, c205_error *error)
{
    measure->falsi = trace_falsi(trace);
    if (!watch(trace, &measure->iterations, error) || !trace_run(trace, error)
        || !sum_accounts(trace_accounts(trace), subject, measure, error))
        return false;
    measure->hits = trace_hits(trace);
    measure->checksum = trace_checksum(trace);
    return true;
}

/* The models and what is charged with them; NULLs in the vector form. */
struct projecting {
    c205_model *models[SPEEDUP_PROJECTIONS];
    c205_projection *projections[SPEEDUP_PROJECTIONS + 1];
};

static bool begin_projecting(struct projecting *projecting,
                             const c205_model *on, c205_error *error)
{
    memset(projecting, 0, sizeof *projecting);
    for (int i = 0; i < SPEEDUP_PROJECTIONS; i++) {
        const char *name = speedup_projection_model(on,
                                                    (enum speedup_projection)
                                                        i);
        c205_model *model = c205_model_find(name, error);

        projecting->models[i] = model;
        if (model)
            projecting->projections[i] = c205_projection_new(model, error);
        if (!projecting->projections[i])
            return false;
    }
    return true;
}

static void end_projecting(struct projecting *projecting)
{
    for (size_t i = 0; i < SPEEDUP_PROJECTIONS; i++) {
        c205_projection_free(projecting->projections[i]);
        c205_model_free(projecting->models[i]);
    }
}

/* Run on a model, and read what the projections have been charged. */
static bool run_projected(struct trace *trace, const c205_model *model,
                          const struct speedup_subject *subject,
                          struct speedup_measure *measure, c205_error *error)
{
    struct projecting projecting;
    bool good = begin_projecting(&projecting, model, error);

    trace_project(trace, projecting.projections);
    good = good && run(trace, subject, measure, error);
    for (size_t i = 0; good && i < SPEEDUP_PROJECTIONS; i++)
        measure->projected[i] = projected_seconds(trace, subject,
                                                  projecting.projections[i],
                                                  projecting.models[i]);
    trace_project(trace, NULL);
    end_projecting(&projecting);
    return good;
}

struct trace *speedup_trace(const struct speedup_subject *subject,
                            const struct speedup_view *view,
                            const struct trace_options *options,
                            struct scene **scene, c205_error *error)
{
    struct trace_options how = *options;

    how.historical = subject->historical;
    how.no_bounds = true;
    how.band = options->width * options->height;
    *scene = read_scene(subject, view, options, error);
    return !*scene ? NULL : trace_new(*scene, &how, error);
}

bool speedup_measure(const struct speedup_subject *subject,
                     const struct speedup_view *view,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error)
{
    struct scene *scene;
    struct trace *trace = speedup_trace(subject, view, options, &scene,
                                        error);
    bool good;

    memset(measure, 0, sizeof *measure);
    measure->rays = options->width * options->height;
    good = trace != NULL
           && (options->mode == TRACE_SCALAR
                   ? run_projected(trace, options->model, subject, measure,
                                   error)
                   : run(trace, subject, measure, error));
    trace_free(trace);
    scene_free(scene);
    return good;
}
