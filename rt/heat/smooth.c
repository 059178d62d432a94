/* smooth.c - adjusts shape factors for reciprocity and closure, on a machine. */
#include "rt/heat/smooth.h"

#include <math.h>
#include <stdlib.h>

#include "vm/error.h"
#include "rt/layout/single_run.h"
#include "rt/trace/form.h"

/* ---- The adjustment on a machine -------------------------------------------- */

static bool is_positive(double value)
{
    return value >= 0 && isfinite(value);
}

static bool check_factors(const struct smooth_given *given, c205_error *error)
{
    size_t n = given->count;
    if (n == 0 || n > MAX_SMOOTH)
        return error_set(error, "%zu surfaces: the number must be between 1 and %d", n,
                         MAX_SMOOTH);
    for (size_t i = 0; i < n; i++) {
        if (!(given->areas[i] > 0) || !isfinite(given->areas[i]))
            return error_set(error, "surface %s has no area", given->names[i]);
        for (size_t j = 0; j <= n; j++)
            if (!is_positive(given->flows[i * (n + 1) + j])
                || !is_positive(given->variances[i * (n + 1) + j]))
                return error_set(error,
                                 "a flow of surface %s or its variance is below 0",
                                 given->names[i]);
    }
    return true;
}

/* Converts a matrix from rows to the columns that the program for the machine reads. */
static void lay_columns(const double *rows, size_t n, c205_word *words)
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j <= n; j++)
            words[j * n + i] = c205_from_double(rows[i * (n + 1) + j]);
}

/* Returns the input of the program: the matrices of flows and of their variances, then
 * the plane of areas. */
static c205_word *lay_words(const struct smooth_given *given)
{
    size_t n = given->count, size = n * (n + 1);
    c205_word *words = calloc(2 * size + n, sizeof *words);
    if (!words)
        return NULL;
    lay_columns(given->flows, n, words);
    lay_columns(given->variances, n, words + size);
    for (size_t i = 0; i < n; i++)
        words[2 * size + i] = c205_from_double(given->areas[i]);
    return words;
}

/* Returns the number of words that the program writes: n + 1 columns of adjusted flows,
 * a plane, and a word. */
static size_t made_size(size_t n)
{
    return n * (n + 1) + n + 1;
}

static bool run_smoothing(const struct smooth_given *given, struct object *program,
                          const c205_word *words, c205_word *made,
                          struct accounts *accounts, c205_error *error)
{
    size_t n = given->count, size = n * (n + 1);
    struct single_run run;
    uint64_t at, clocks = 0;
    single_run_begin(&run, program, given->model, error);
    run.accounts = accounts;
    single_run_word(&run, "smooth_count", n);
    at = single_run_room(&run, "smooth_flows", words, 2 * size + n);
    layout_word(&run.layout, "smooth_variances", at + 64 * size);
    layout_word(&run.layout, "smooth_areas", at + 128 * size);
    single_run_room(&run, "smooth_matrix", NULL, (n + 3) * n);
    at = single_run_room(&run, "smooth_results", NULL, made_size(n));
    return single_run_end(&run, at, made, made_size(n), &clocks);
}

static bool take_flows(const struct smooth_given *given, const c205_word *made,
                       double *flows, c205_error *error)
{
    size_t n = given->count;
    int64_t singular = c205_to_integer(made[made_size(n) - 1]);
    if (singular > 0)
        return error_set(error,
                         "factors cannot be smoothed: surface %s belongs to a group "
                         "that sees only itself, and its areas allow no solution",
                         given->names[singular - 1]);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j <= n; j++)
            flows[i * (n + 1) + j] = c205_to_double(made[j * n + i]);
    return true;
}

bool smooth_flows(const struct smooth_given *given, double *flows,
                  struct accounts *accounts, c205_error *error)
{
    struct object *program;
    c205_word *words, *made;
    bool good;
    if (!check_factors(given, error))
        return false;
    program = form_assemble_beside("heat/smooth", given->mode, NULL, error);
    if (!program)
        return false;
    words = lay_words(given);
    made = calloc(made_size(given->count), sizeof *made);
    good = words && made ? run_smoothing(given, program, words, made, accounts, error)
                               && take_flows(given, made, flows, error)
                         : error_set(error, "out of memory");
    free(words);
    free(made);
    object_free(program);
    return good;
}

/* ---- Surfaces --------------------------------------------------------------- */

struct smoothing {
    struct surfaces *surfaces;
    size_t count;
    size_t *seen; /* index of each visible surface */
    const char **names;
    double *areas, *flows, *variances;
};

/* Returns a flow with its error. If no ray arrived, the contribution of one ray is the
 * error. */
static struct estimate flow_of(const struct surface *from, size_t to)
{
    double error = from->count[to] > 0 ? from->factor[to].error
                                       : 1 / (double)from->sent;
    return (struct estimate){ from->area.value * from->factor[to].value,
                              from->area.value * error };
}

/* Returns the mean of the flows that were estimated in the two directions. Each has the
 * reciprocal of its variance as its weight. */
static struct estimate flow_between(const struct smoothing *smoothing, size_t i,
                                    size_t j)
{
    size_t there = smoothing->seen[i], back = smoothing->seen[j];
    const struct surface *one = &smoothing->surfaces->list[there];
    const struct surface *other = &smoothing->surfaces->list[back];
    struct estimate a = flow_of(one, back), b = flow_of(other, there);
    double v = a.error * a.error, w = b.error * b.error;
    if (one->count[back] + other->count[there] == 0)
        return (struct estimate){ 0, 0 };
    if (i == j)
        return a;
    if (v + w == 0)
        return (struct estimate){ a.value / 2 + b.value / 2, 0 };
    return (struct estimate){ (a.value * w + b.value * v) / (v + w),
                              a.error * b.error / sqrt(v + w) };
}

static void put_flow(const struct smoothing *smoothing, size_t i, size_t j,
                     struct estimate flow)
{
    size_t at = i * (smoothing->count + 1) + j;
    smoothing->flows[at] = flow.value;
    smoothing->variances[at] = flow.error * flow.error;
}

static void put_factor_row(const struct smoothing *smoothing, size_t i)
{
    const struct surfaces *surfaces = smoothing->surfaces;
    const struct surface *surface = &surfaces->list[smoothing->seen[i]];
    struct estimate none = { 0, 0 };
    smoothing->areas[i] = surface->area.value;
    for (size_t j = 0; j < smoothing->count; j++)
        put_flow(smoothing, i, j, flow_between(smoothing, i, j));
    put_flow(smoothing, i, smoothing->count,
             surface->count[surfaces->count] > 0 ? flow_of(surface, surfaces->count)
                                                 : none);
}

static bool take_row(const struct smoothing *smoothing, size_t i, c205_error *error)
{
    struct surface *surface = &smoothing->surfaces->list[smoothing->seen[i]];
    const double *flows = smoothing->flows + i * (smoothing->count + 1);
    surface->smooth = calloc(smoothing->surfaces->count + 1, sizeof *surface->smooth);
    if (!surface->smooth)
        return error_set(error, "out of memory");

    for (size_t j = 0; j < smoothing->count; j++)
        surface->smooth[smoothing->seen[j]] = flows[j] / smoothing->areas[i];
    surface->smooth[smoothing->surfaces->count] = flows[smoothing->count]
                                                  / smoothing->areas[i];
    return true;
}

static bool list_seen(struct smoothing *smoothing, c205_error *error)
{
    const struct surfaces *surfaces = smoothing->surfaces;
    for (size_t i = 0; i < surfaces->count; i++) {
        const struct surface *surface = &surfaces->list[i];
        if (surface->receives_alone)
            return error_set(error,
                             "factors cannot be smoothed: surface %s, the %s of line "
                             "%zu, receives radiation but emits none",
                             surface->name, primitive_kind_name(surface->first->kind),
                             surface->first->line);
        if (surface->sent == 0)
            continue;
        smoothing->names[smoothing->count] = surface->name;
        smoothing->seen[smoothing->count++] = i;
    }
    return smoothing->count > 0 || error_set(error, "no surface is visible");
}

static bool smooth(const struct smoothing *smoothing, enum trace_mode mode,
                   const c205_model *model, struct accounts *accounts,
                   c205_error *error)
{
    const struct smooth_given given = { .mode = mode,
                                        .count = smoothing->count,
                                        .flows = smoothing->flows,
                                        .variances = smoothing->variances,
                                        .areas = smoothing->areas,
                                        .names = smoothing->names,
                                        .model = model };
    for (size_t i = 0; i < smoothing->count; i++)
        put_factor_row(smoothing, i);
    if (!smooth_flows(&given, smoothing->flows, accounts, error))
        return false;
    for (size_t i = 0; i < smoothing->count; i++)
        if (!take_row(smoothing, i, error))
            return false;
    return true;
}

bool smooth_surfaces(struct surfaces *surfaces, enum trace_mode mode,
                     const c205_model *model, struct accounts *accounts,
                     c205_error *error)
{
    size_t count = surfaces->count + 1;
    struct smoothing smoothing = {
        .surfaces = surfaces,
        .seen = calloc(count, sizeof *smoothing.seen),
        .names = calloc(count, sizeof *smoothing.names),
        .areas = calloc(count, sizeof *smoothing.areas),
        .flows = calloc(count * count, sizeof *smoothing.flows),
        .variances = calloc(count * count, sizeof *smoothing.variances),
    };
    bool good = (smoothing.seen && smoothing.names && smoothing.areas && smoothing.flows
                 && smoothing.variances)
                || error_set(error, "out of memory");
    good = good && list_seen(&smoothing, error)
           && smooth(&smoothing, mode, model, accounts, error);
    free(smoothing.seen);
    free(smoothing.names);
    free(smoothing.areas);
    free(smoothing.flows);
    free(smoothing.variances);
    return good;
}
