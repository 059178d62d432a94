/* thermal.c - assigns emissivities and temperatures, and computes the exchange. */
#include "rt/heat/thermal.h"

#include <math.h>
#include <stdlib.h>

#include "vm/error.h"

static bool is_emissivity(double value)
{
    return value >= 0 && value <= 1;
}

static bool is_temperature(double value)
{
    return value >= 0 && isfinite(value);
}

/* The value that represents the word "adiabatic" among temperatures, which are never
 * negative. */
enum { ADIABATIC = -1 };

const struct value_kind emissivity_kind = { .name = "emissivity",
                                            .ending = "_Emissivity",
                                            .range = "between 0 and 1",
                                            .allows = is_emissivity };
const struct value_kind temperature_kind = { .name = "temperature",
                                             .ending = "_Temperature",
                                             .range = "at least 0",
                                             .allows = is_temperature,
                                             .word = "adiabatic",
                                             .word_value = ADIABATIC };
const char thermal_environment[] = "environment";

/* ---- Input ------------------------------------------------------------------ */

struct thermal_work {
    const struct surfaces *surfaces;
    const struct named_parts *parts;
    const struct named_values *emissivities, *temperatures;
    struct thermal *thermal;
    c205_error *error;
};

/* Returns the i-th surface that has a visible part. */
static const struct surface *surface_of(const struct thermal_work *work, size_t i)
{
    return &work->surfaces->list[work->thermal->surface[i]];
}

static void take_values(const struct thermal_work *work, size_t i)
{
    struct thermal *thermal = work->thermal;
    const struct surface *surface = surface_of(work, i);
    const struct named_part *part = &work->parts->list[surface->part];
    double emissivity = named_of_part(work->emissivities, part);
    double temperature = named_of_part(work->temperatures, part);
    thermal->emissivity[i] = isnan(emissivity) ? 1 : emissivity;
    thermal->temperature[i] = temperature;
}

/* Lists the surfaces that have a visible part. */
static bool list_surfaces(const struct thermal_work *work)
{
    struct thermal *thermal = work->thermal;
    for (size_t i = 0; i < work->surfaces->count; i++) {
        const struct surface *surface = &work->surfaces->list[i];
        if (surface->receives_alone)
            return error_set(work->error,
                             "surface %s, the %s of line %zu, receives radiation but "
                             "emits none: its flow is unknown",
                             surface->name, primitive_kind_name(surface->first->kind),
                             surface->first->line);
        if (surface->sent > 0)
            thermal->surface[thermal->count++] = i;
    }
    return thermal->count > 0 || error_set(work->error, "no surface is visible");
}

static bool find_values(const struct thermal_work *work)
{
    struct thermal *thermal = work->thermal;
    const char *separator = ": ";
    bool good = true;
    error_set(work->error, "no temperature is set for");
    for (size_t i = 0; i < thermal->count; i++) {
        take_values(work, i);
        if (!isnan(thermal->temperature[i]))
            continue;
        good = false;
        named_parts_add_name(work->error, separator,
                             work->surfaces->list[thermal->surface[i]].name);
        separator = ", ";
    }
    if (!good)
        named_parts_add_name(work->error, "; ",
                             "use --temperature NAME=KELVINS, or default=300");
    return good;
}

/* Returns true for equal numbers and for two NaNs. */
static bool alike(double one, double other)
{
    return one == other || (isnan(one) && isnan(other));
}

/* Checks that all parts of each surface have the same temperature and the same
 * emissivity. */
static bool check_parts(const struct thermal_work *work)
{
    const struct surfaces *surfaces = work->surfaces;
    for (size_t i = 0; i < surfaces->primitive_count; i++) {
        const struct surface *surface = &surfaces->list[surfaces->surface_of[i]];
        const struct named_part *first = &work->parts->list[surface->part];
        const struct named_part *part = &work->parts->list[surfaces->part_of[i]];
        if (!alike(named_of_part(work->temperatures, part),
                   named_of_part(work->temperatures, first))
            || !alike(named_of_part(work->emissivities, part),
                      named_of_part(work->emissivities, first)))
            return error_set(work->error,
                             "surface %s has parts with different temperatures or "
                             "emissivities, %s and %s",
                             surface->name, first->name, part->name);
    }
    return true;
}

static void find_outside(const struct thermal_work *work)
{
    double outside = named_of_name(work->temperatures, thermal_environment);
    work->thermal->outside = outside > 0 ? outside : 0;
}

/* ---- The exchange ------------------------------------------------------------- */

/* Copies the factors between visible surfaces to consecutive rows. */
static void fill_factors(const struct thermal_work *work, double *factors)
{
    const struct thermal *thermal = work->thermal;
    size_t n = thermal->count;
    for (size_t i = 0; i < n; i++) {
        const struct surface *surface = surface_of(work, i);
        for (size_t j = 0; j < n; j++)
            factors[i * (n + 1) + j] = surface_factor(surface, thermal->surface[j]);
        factors[i * (n + 1) + n] = surface_factor(surface, work->surfaces->count);
    }
}

/* Splits the values into emissivities and temperatures. An adiabatic surface has the
 * emissivity 0, because it returns everything that it receives. */
static void split_values(struct thermal *thermal, double *emissivity)
{
    for (size_t i = 0; i < thermal->count; i++) {
        bool adiabatic = thermal->temperature[i] < 0;
        emissivity[i] = adiabatic ? 0 : thermal->emissivity[i];
        if (adiabatic)
            thermal->temperature[i] = NAN;
    }
}

static bool find_exchange(const struct thermal_work *work, enum trace_mode mode,
                          const c205_model *model)
{
    struct thermal *thermal = work->thermal;
    size_t n = thermal->count;
    double *factors = calloc(n * (n + 1), sizeof *factors);
    double *area = calloc(2 * n, sizeof *area), *emissivity = area + n;
    const char **names = calloc(n, sizeof *names);
    const struct exchange_given given = {
        .mode = mode,
        .count = n,
        .names = names,
        .area = area,
        .emissivity = emissivity,
        .temperature = thermal->temperature,
        .factors = factors,
        .outside = thermal->outside,
        .model = model,
    };
    bool good = factors && area && names;
    if (good) {
        fill_factors(work, factors);
        split_values(thermal, emissivity);
        for (size_t i = 0; i < n; i++) {
            const struct surface *surface = surface_of(work, i);
            names[i] = surface->name;
            area[i] = surface->area.value;
        }
    }
    good = good ? exchange_find(&given, &thermal->exchange, work->error)
                : error_set(work->error, "out of memory");
    free(factors);
    free(area);
    free(names);
    return good;
}

static bool thermal_begin(const struct surfaces *surfaces, struct thermal *thermal)
{
    size_t count = surfaces->count + 1;
    *thermal = (struct thermal){ 0 };
    thermal->surface = calloc(count, sizeof *thermal->surface);
    thermal->emissivity = calloc(count, sizeof *thermal->emissivity);
    thermal->temperature = calloc(count, sizeof *thermal->temperature);
    return thermal->surface && thermal->emissivity && thermal->temperature;
}

void thermal_free(struct thermal *thermal)
{
    free(thermal->surface);
    free(thermal->emissivity);
    free(thermal->temperature);
    exchange_free(&thermal->exchange);
    *thermal = (struct thermal){ 0 };
}

bool thermal_find(const struct surfaces *surfaces, const struct named_parts *parts,
                  const struct named_values *emissivities,
                  const struct named_values *temperatures, enum trace_mode mode,
                  const c205_model *model, struct thermal *thermal, c205_error *error)
{
    const struct thermal_work work = { .surfaces = surfaces,
                                       .parts = parts,
                                       .emissivities = emissivities,
                                       .temperatures = temperatures,
                                       .thermal = thermal,
                                       .error = error };
    bool good = thermal_begin(surfaces, thermal) || error_set(error, "out of memory");
    if (good)
        find_outside(&work);
    good = good && list_surfaces(&work) && check_parts(&work) && find_values(&work)
           && find_exchange(&work, mode, model);
    if (!good)
        thermal_free(thermal);
    return good;
}
