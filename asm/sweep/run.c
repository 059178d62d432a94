/* run.c - runs the programs of a sweep, and searches for the values where the faster
 * program changes. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "asm/object/object_file.h"
#include "asm/sweep/swept.h"
#include "base/accounts.h"
#include "base/array.h"
#include "vm/error.h"

/* ---- One run --------------------------------------------------------------- */

static bool goes_on(const struct program_sweep *sweep)
{
    return !sweep->goes_on || sweep->goes_on(sweep->context, sweep->done, sweep->all);
}

static void note_used(struct program_sweep *sweep, const struct asm_define *defines,
                      struct object *object)
{
    for (size_t i = 0; defines[i].name; i++) {
        const struct asm_define one[] = { defines[i], { NULL, 0 } };
        sweep->used[i] |= !asm_unused_define(one, &object, 1);
    }
}

static bool uses_all(const struct program_sweep *sweep, c205_error *error)
{
    const struct asm_define *defines = sweep->options->defines;
    const char *name = sweep->used[0] ? NULL : sweep->constant;
    for (size_t i = 0; !name && i < MAX_SWEPT_DEFINES && defines && defines[i].name;
         i++)
        if (!sweep->used[i + 1])
            name = defines[i].name;
    error_set(error, "'%.100s' is defined, but the program does not use it",
              name ? name : "");
    return !name;
}

/* Assembles a program for a value. Only warnings of the first run are reported, because
 * all runs have the same warnings. */
static struct object *assemble_at(struct program_sweep *sweep,
                                  const struct swept_program *program, uint64_t value)
{
    struct asm_define defines[MAX_SWEPT_DEFINES + 2] = { { sweep->constant,
                                                           (int64_t)value } };
    struct asm_options options = *sweep->options;
    struct diagnostics said = { 0 };
    struct object *object;
    for (size_t i = 0;
         i < MAX_SWEPT_DEFINES && options.defines && options.defines[i].name; i++)
        defines[i + 1] = options.defines[i];
    options.defines = defines;
    object = assemble_bytes(program->path, program->text, program->length, &options,
                            &said);
    if (!object || value == sweep->range.from)
        diagnostics_put(&said, &sweep->report);
    if (object && value == sweep->range.from)
        note_used(sweep, defines, object);
    diagnostics_free(&said);
    return object;
}

/* Runs in slices. The progress function of the caller may end the run between two
 * slices. */
static c205_stop run_slices(const struct program_sweep *sweep, c205 *machine)
{
    static const uint64_t slice = 5000000; /* clocks per slice */
    uint64_t limit = 0;
    c205_stop stop;
    do {
        limit = sweep->clocks_most - limit > slice ? limit + slice : sweep->clocks_most;
        stop = c205_run(machine, limit);
    } while (stop.trap == C205_TRAP_CLOCK_LIMIT && limit < sweep->clocks_most
             && goes_on(sweep));
    return stop;
}

static bool run_object(const struct program_sweep *sweep, const struct object *object,
                       c205_account *account, c205_error *error)
{
    c205 *machine = c205_new(sweep->model, error);
    c205_program program = object->program;
    c205_stop stop = { 0 };
    bool good;
    program.warm = sweep->warm || (program.warm && !sweep->cold);
    good = machine && object_check(object, error)
           && c205_load(machine, &program, error);
    if (good) {
        stop = run_slices(sweep, machine);
        good = stop.trap == C205_TRAP_NONE && stop.status == 0;
        if (good)
            good = accounts_whole(machine, account)
                   || error_set(error, "out of memory");
        else if (stop.trap != C205_TRAP_NONE)
            c205_describe_stop(machine, &stop, error);
        else
            error_set(error, "the program ended with status %" PRId64, stop.status);
    }
    c205_free(machine);
    return good;
}

static bool run_at(struct program_sweep *sweep, int which, uint64_t value,
                   c205_account *account, c205_error *error)
{
    const struct swept_program *program = &sweep->programs[which];
    c205_error reason = { "the program cannot be assembled" };
    struct object *object = assemble_at(sweep, program, value);
    bool good = object && run_object(sweep, object, account, &reason);
    object_free(object);
    sweep->done += value;
    if (!goes_on(sweep)) {
        error_set(&reason, "interrupted");
        good = false;
    }
    if (!good)
        error_set(error, "%.60s with %.40s = %" PRIu64 ": %.120s", program->path,
                  sweep->constant, value, reason.message);
    return good;
}

static bool run_point(struct program_sweep *sweep, uint64_t value,
                      struct swept_point *point, c205_error *error)
{
    bool good = true;
    *point = (struct swept_point){ .value = value };
    for (size_t i = 0; good && i < sweep->program_count; i++)
        good = run_at(sweep, (int)i, value, &point->runs[i], error);
    return good;
}

/* ---- Crossings ------------------------------------------------------------- */

static bool second_is_faster(const struct swept_point *point)
{
    return accounts_clocks(&point->runs[SWEPT_SECOND])
           < accounts_clocks(&point->runs[SWEPT_FIRST]);
}

/* Finds the next two points between which the faster program changes. Returns false if
 * there are none, or with the error set if memory is exhausted. */
static bool find_crossing(struct program_sweep *sweep, c205_error *error)
{
    *error->message = '\0';
    while (++sweep->searched < sweep->count) {
        const struct swept_point *points = sweep->points + sweep->searched - 1;
        struct swept_crossing crossing = { points[1], second_is_faster(&points[1]) };
        if (second_is_faster(&points[0]) == second_is_faster(&points[1]))
            continue;
        if (!array_add(&sweep->crossings, &sweep->crossing_count, &crossing,
                       sizeof crossing))
            return error_set(error, "out of memory");
        sweep->low = points[0].value;
        return true;
    }
    return false;
}

/* Bisects the interval of a crossing. It finds one crossing if the interval has
 * several. Values between the points are tried only if the range has neither step nor
 * factor. */
static bool halve(struct program_sweep *sweep, c205_error *error)
{
    bool all = sweep->range.step == 0 && sweep->range.factor == 0;
    struct swept_crossing *crossing = sweep->crossings + sweep->crossing_count - 1;
    uint64_t value = sweep->low + (crossing->at.value - sweep->low) / 2;
    struct swept_point middle;
    if (!all || value == sweep->low) {
        sweep->inside = false;
        return true;
    }
    sweep->all += 2 * value;
    if (!run_point(sweep, value, &middle, error))
        return false;
    if (second_is_faster(&middle) == crossing->faster)
        crossing->at = middle;
    else
        sweep->low = value;
    return true;
}

/* Makes one step of the search for crossings. Sets *over to true if there are no
 * more. */
static bool search(struct program_sweep *sweep, bool *over, c205_error *error)
{
    if (sweep->inside)
        return halve(sweep, error);
    sweep->inside = find_crossing(sweep, error);
    *over = !sweep->inside;
    return sweep->inside || !*error->message;
}

/* ---- The sweep ------------------------------------------------------------- */

static bool sweep_begin(struct program_sweep *sweep, c205_error *error)
{
    uint64_t values[MAX_SWEPT_POINTS];
    sweep->point_count = swept_values(&sweep->range, sweep->asked, values);
    sweep->points = calloc(sweep->point_count, sizeof *sweep->points);
    if (!sweep->points)
        return error_set(error, "out of memory");
    for (size_t i = 0; i < sweep->point_count; i++) {
        sweep->points[i].value = values[i];
        sweep->all += sweep->program_count * values[i];
    }
    snprintf(sweep->per_element, sizeof sweep->per_element, "clk/%s", sweep->constant);
    return true;
}

bool swept_step(struct program_sweep *sweep, bool *over, c205_error *error)
{
    struct swept_point *point;
    *over = false;
    if (!sweep->points && !sweep_begin(sweep, error))
        return false;
    if (sweep->count < sweep->point_count) {
        point = &sweep->points[sweep->count];
        if (!run_point(sweep, point->value, point, error)
            || (sweep->count == 0 && !uses_all(sweep, error)))
            return false;
        sweep->count++;
        return true;
    }
    *over = sweep->program_count < SWEPT_PROGRAMS;
    return *over || search(sweep, over, error);
}

bool swept_run(struct program_sweep *sweep, c205_error *error)
{
    bool over = false, good = true;
    while (good && !over)
        good = swept_step(sweep, &over, error);
    return good;
}

void swept_free(struct program_sweep *sweep)
{
    free(sweep->points);
    free(sweep->crossings);
}
