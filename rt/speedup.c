#include "rt/speedup.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VIEW \
    "#version 3.7;\n" \
    "global_settings { assumed_gamma 1 }\n" \
    "camera { location <0, 0, -5> look_at 0 right 1.6*x up y angle 37 }\n"

/* Source of the times: Plunkett, Cychosz, Bailey 1984, Table 1. */
const struct speedup_subject speedup_subjects[] = {
    { "sphere", VIEW "sphere { 0, 1 pigment { color rgb 1 } }\n",
      { [TRACE_SCALAR] = 0.944, [TRACE_VECTOR] = 0.0279 },
      33.81 },
    { "cylinder",
      VIEW "cylinder { <-1, -.6, .4>, <1, .6, -.4>, .75\n"
           " pigment { color rgb 1 } }\n",
      { [TRACE_SCALAR] = 2.729, [TRACE_VECTOR] = 0.1614 },
      16.91 },
};
const size_t speedup_subject_count =
    sizeof speedup_subjects / sizeof *speedup_subjects;

static struct scene *read_subject(const struct speedup_subject *subject,
                                  c205_error *error)
{
    static const struct scene_options how = { .strict = true };
    struct reports reports = { 0, 0, NULL };
    struct scene *scene = scene_read_text(subject->primitive, subject->scene,
                                          &how, &reports);

    if (scene == NULL)
        snprintf(error->message, sizeof error->message, "%s: %s",
                 subject->primitive,
                 reports.count > 0 ? reports.items[0].message : "no memory");
    reports_free(&reports);
    return scene;
}

/* The clocks of the kernel and of calling it, by cause. */
static void sum_accounts(const c205 *machine,
                         const struct speedup_subject *subject,
                         struct speedup_measure *measure)
{
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);

        if (strcmp(account->name, subject->primitive) != 0
            && strcmp(account->name, "call") != 0)
            continue;
        for (int cause = 0; cause < C205_CAUSES; cause++) {
            measure->clocks[cause] += account->clocks[cause];
            measure->total += account->clocks[cause];
        }
    }
}

static bool count_hits(const struct trace *trace,
                       struct speedup_measure *measure, c205_error *error)
{
    c205_word *words = malloc(measure->rays * sizeof *words);

    if (words == NULL || !trace_read_words(trace, CHANNEL_ID, words)) {
        snprintf(error->message, sizeof error->message, "no memory");
        free(words);
        return false;
    }
    for (size_t i = 0; i < measure->rays; i++)
        measure->hits += c205_to_integer(words[i]) != 0;
    free(words);
    return true;
}

bool speedup_measure(const struct speedup_subject *subject,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error)
{
    struct scene *scene = read_subject(subject, error);
    struct trace *trace = scene == NULL ? NULL
                                        : trace_new(scene, options, error);
    bool good = trace != NULL && trace_run(trace, error);

    memset(measure, 0, sizeof *measure);
    measure->rays = options->width * options->height;
    if (good) {
        sum_accounts(trace_machine(trace), subject, measure);
        good = count_hits(trace, measure, error)
               && trace_checksum(trace, &measure->checksum, error);
    }
    trace_free(trace);
    scene_free(scene);
    return good;
}
