/* run.c - the runs of a sweep, and where two programs change places. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "asm/sweep/swept.h"
#include "base/accounts.h"
#include "base/array.h"

/* ---- One run --------------------------------------------------------------- */

/* How far the sweep is, where each run takes as long as its value is large. */
struct swept_progress {
    size_t done, all;
};

static bool goes_on(const struct program_sweep *sweep,
                    const struct swept_progress *progress)
{
    return !sweep->goes_on
           || sweep->goes_on(sweep->context, progress->done, progress->all);
}

/* Warnings are the same for all values: those of the first run are told. */
static struct object *assemble_at(const struct program_sweep *sweep,
                                  const struct swept_program *program,
                                  uint64_t value)
{
    struct asm_define defines[SWEPT_DEFINES_MOST + 2] = {
        { sweep->constant, (int64_t)value }
    };
    struct asm_options options = *sweep->options;
    struct diagnostics said = { 0 };
    struct object *object;

    for (size_t i = 0;
         i < SWEPT_DEFINES_MOST && options.defines && options.defines[i].name;
         i++)
        defines[i + 1] = options.defines[i];
    options.defines = defines;
    object = assemble_bytes(program->path, program->text, program->length,
                            &options, &said);
    if (!object || value == sweep->range.from)
        diagnostics_put(&said, &sweep->report);
    diagnostics_free(&said);
    return object;
}

/* In slices, between which it is asked whether to go on. */
static c205_stop run_slices(const struct program_sweep *sweep,
                            const struct swept_progress *progress,
                            c205 *machine)
{
    static const uint64_t slice = 5000000; /* clocks */
    uint64_t limit = 0;
    c205_stop stop;

    do {
        limit = sweep->clocks_most - limit > slice ? limit + slice
                                                   : sweep->clocks_most;
        stop = c205_run(machine, limit);
    } while (stop.trap == C205_TRAP_CLOCK_LIMIT && limit < sweep->clocks_most
             && goes_on(sweep, progress));
    return stop;
}

/* Of all regions together. */
static bool take_account(const struct program_sweep *sweep,
                         const c205 *machine, c205_account *account,
                         c205_error *error)
{
    struct accounts accounts = { .model = sweep->model };
    bool good = accounts_add(&accounts, machine);

    *account = accounts_together(&accounts);
    accounts_free(&accounts);
    snprintf(error->message, sizeof error->message, "no memory");
    return good;
}

static bool run_object(const struct program_sweep *sweep,
                       const struct swept_progress *progress,
                       const struct object *object, c205_account *account,
                       c205_error *error)
{
    c205 *machine = c205_new(sweep->model, error);
    bool good = machine && c205_load(machine, &object->program, error);
    c205_stop stop = { 0 };

    if (good) {
        if (sweep->warm)
            c205_warm(machine);
        stop = run_slices(sweep, progress, machine);
        good = stop.trap == C205_TRAP_NONE && stop.status == 0;
        if (good)
            good = take_account(sweep, machine, account, error);
        else if (stop.trap != C205_TRAP_NONE)
            c205_describe_stop(machine, &stop, error);
        else
            snprintf(error->message, sizeof error->message,
                     "it ended with status %" PRId64, stop.status);
    }
    c205_free(machine);
    return good;
}

static bool run_at(const struct program_sweep *sweep,
                   struct swept_progress *progress, int which, uint64_t value,
                   c205_account *account, c205_error *error)
{
    const struct swept_program *program = &sweep->programs[which];
    c205_error reason = { "it cannot be assembled" };
    struct object *object = assemble_at(sweep, program, value);
    bool good = object
                && run_object(sweep, progress, object, account, &reason);

    object_free(object);
    progress->done += value;
    if (!goes_on(sweep, progress)) {
        snprintf(reason.message, sizeof reason.message, "interrupted");
        good = false;
    }
    if (!good)
        snprintf(error->message, sizeof error->message,
                 "%.80s with %.40s = %" PRIu64 ": %.100s", program->path,
                 sweep->constant, value, reason.message);
    return good;
}

static bool run_point(const struct program_sweep *sweep,
                      struct swept_progress *progress, uint64_t value,
                      struct swept_point *point, c205_error *error)
{
    bool good = true;

    *point = (struct swept_point){ .value = value };
    for (size_t i = 0; good && i < sweep->program_count; i++)
        good = run_at(sweep, progress, (int)i, value, &point->runs[i], error);
    return good;
}

/* ---- Crossings ------------------------------------------------------------- */

static bool second_is_faster(const struct swept_point *point)
{
    return accounts_clocks(&point->runs[SWEPT_SECOND])
           < accounts_clocks(&point->runs[SWEPT_FIRST]);
}

/* The range is halved as long as there is something in it; of several crossings between two
 * points one is found. */
static bool find_crossing(const struct program_sweep *sweep,
                          struct swept_progress *progress,
                          const struct swept_point *before,
                          const struct swept_point *behind,
                          struct swept_point *found, c205_error *error)
{
    bool all = sweep->range.step == 0 && sweep->range.factor == 0;
    uint64_t low = before->value;
    struct swept_point middle;

    *found = *behind;
    while (all && found->value - low > 1) {
        uint64_t value = low + (found->value - low) / 2;

        progress->all += 2 * value;
        if (!run_point(sweep, progress, value, &middle, error))
            return false;
        if (second_is_faster(&middle) == second_is_faster(behind))
            *found = middle;
        else
            low = value;
    }
    return true;
}

static bool find_crossings(struct program_sweep *sweep,
                           struct swept_progress *progress, c205_error *error)
{
    for (size_t i = 1; i < sweep->count; i++) {
        const struct swept_point *points = &sweep->points[i - 1];
        struct swept_crossing *crossings;
        bool faster = second_is_faster(&points[1]);

        if (second_is_faster(&points[0]) == faster)
            continue;
        crossings = array_grow(sweep->crossings, sweep->crossing_count,
                               sizeof *crossings);
        if (!crossings) {
            snprintf(error->message, sizeof error->message, "no memory");
            return false;
        }
        sweep->crossings = crossings;
        crossings += sweep->crossing_count++;
        crossings->faster = faster;
        if (!find_crossing(sweep, progress, &points[0], &points[1],
                           &crossings->at, error))
            return false;
    }
    return true;
}

/* ---- All of it ------------------------------------------------------------- */

bool swept_run(struct program_sweep *sweep, c205_error *error)
{
    uint64_t values[SWEPT_POINTS_MOST];
    size_t count = swept_values(&sweep->range, sweep->asked, values);
    struct swept_progress progress = { 0, 0 };
    bool good = true;

    sweep->points = calloc(count, sizeof *sweep->points);
    if (!sweep->points) {
        snprintf(error->message, sizeof error->message, "no memory");
        return false;
    }
    for (size_t i = 0; i < count; i++)
        progress.all += sweep->program_count * values[i];
    for (; good && sweep->count < count; sweep->count++)
        good = run_point(sweep, &progress, values[sweep->count],
                         &sweep->points[sweep->count], error);
    return good
           && (sweep->program_count < SWEPT_PROGRAMS
               || find_crossings(sweep, &progress, error));
}

void swept_free(struct program_sweep *sweep)
{
    free(sweep->points);
    free(sweep->crossings);
}
