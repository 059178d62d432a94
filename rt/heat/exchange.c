/* exchange.c - solves the equations of radiative exchange on a machine. */
#include "rt/heat/exchange.h"

#include <math.h>
#include <stdlib.h>

#include "vm/error.h"
#include "rt/layout/single_run.h"
#include "rt/trace/form.h"

static bool is_share(double value)
{
    return value >= 0 && value <= 1;
}

static bool check_surface(const struct exchange_given *given, size_t i,
                          c205_error *error)
{
    if (!(given->area[i] > 0) || !isfinite(given->area[i]))
        return error_set(error, "surface %s has no area", given->names[i]);
    if (!is_share(given->emissivity[i]))
        return error_set(error,
                         "the emissivity %g of surface %s must be between 0 "
                         "and 1",
                         given->emissivity[i], given->names[i]);
    if (given->emissivity[i] > 0 && !(given->temperature[i] >= 0))
        return error_set(error, "surface %s has no temperature", given->names[i]);
    return true;
}

static bool check_exchange(const struct exchange_given *given, c205_error *error)
{
    if (given->count == 0 || given->count > MAX_EXCHANGE)
        return error_set(error, "%zu surfaces: the number must be between 1 and %d",
                         given->count, MAX_EXCHANGE);
    if (!(given->outside >= 0))
        return error_set(error, "the environment has no temperature");
    for (size_t i = 0; i < given->count; i++)
        if (!check_surface(given, i, error))
            return false;
    return true;
}

/* Returns the input of the program: the columns of the matrix of factors, then the
 * planes of areas, emissivities and temperatures. */
static c205_word *lay_words(const struct exchange_given *given)
{
    size_t n = given->count;
    c205_word *words = calloc((n + 4) * n, sizeof *words), *planes;
    if (!words)
        return NULL;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j <= n; j++)
            words[j * n + i] = c205_from_double(given->factors[i * (n + 1) + j]);
    planes = words + (n + 1) * n;
    for (size_t i = 0; i < n; i++) {
        double kelvins = given->emissivity[i] > 0 ? given->temperature[i] : 0;
        planes[i] = c205_from_double(given->area[i]);
        planes[n + i] = c205_from_double(given->emissivity[i]);
        planes[2 * n + i] = c205_from_double(kelvins);
    }
    return words;
}

/* The output of the program: three planes, then three words. */
enum { MADE_PLANES = 3, MADE_OUTSIDE = 0, MADE_SUM, MADE_SINGULAR, MADE_WORDS };

static bool run_exchange(const struct exchange_given *given, struct object *program,
                         const c205_word *words, c205_word *made,
                         struct accounts *accounts, c205_error *error)
{
    size_t n = given->count, count = MADE_PLANES * n + MADE_WORDS;
    struct single_run run;
    uint64_t at, planes, clocks = 0;
    single_run_begin(&run, program, given->model, error);
    run.accounts = accounts;
    single_run_word(&run, "exchange_count", n);
    at = single_run_room(&run, "exchange_factors", words, (n + 4) * n);
    planes = at + 64 * (n + 1) * n;
    layout_word(&run.layout, "exchange_areas", planes);
    layout_word(&run.layout, "exchange_emissivities", planes + 64 * n);
    layout_word(&run.layout, "exchange_temperatures", planes + 128 * n);
    single_run_room(&run, "exchange_matrix", NULL, (n + 2) * n);
    at = single_run_room(&run, "exchange_results", NULL, count);
    single_run_number(&run, "exchange_outside", 0, given->outside);
    return single_run_end(&run, at, made, count, &clocks);
}

static bool take_exchange(const struct exchange_given *given, const c205_word *made,
                          struct exchange *exchange, c205_error *error)
{
    size_t n = given->count;
    const c205_word *behind = made + MADE_PLANES * n;
    int64_t singular = c205_to_integer(behind[MADE_SINGULAR]);
    if (singular > 0)
        return error_set(error,
                         "the exchange has no solution: surface %s belongs to a "
                         "group of adiabatic surfaces that see only each other",
                         given->names[singular - 1]);
    for (size_t i = 0; i < n; i++) {
        exchange->radiosity[i] = c205_to_double(made[i]);
        exchange->irradiation[i] = c205_to_double(made[n + i]);
        exchange->flow[i] = c205_to_double(made[2 * n + i]);
    }
    exchange->outside = c205_to_double(behind[MADE_OUTSIDE]);
    exchange->sum = c205_to_double(behind[MADE_SUM]);
    return true;
}

static bool exchange_begin(const struct exchange_given *given,
                           struct exchange *exchange)
{
    size_t n = given->count;
    *exchange = (struct exchange){ .count = n, .accounts = { .model = given->model } };
    exchange->radiosity = calloc(n, sizeof *exchange->radiosity);
    exchange->irradiation = calloc(n, sizeof *exchange->irradiation);
    exchange->flow = calloc(n, sizeof *exchange->flow);
    return exchange->radiosity && exchange->irradiation && exchange->flow;
}

void exchange_free(struct exchange *exchange)
{
    free(exchange->radiosity);
    free(exchange->irradiation);
    free(exchange->flow);
    accounts_free(&exchange->accounts);
    *exchange = (struct exchange){ 0 };
}

bool exchange_find(const struct exchange_given *given, struct exchange *exchange,
                   c205_error *error)
{
    size_t count = MADE_PLANES * given->count + MADE_WORDS;
    struct object *program;
    c205_word *words, *made;
    bool good;
    *exchange = (struct exchange){ 0 };
    if (!check_exchange(given, error))
        return false;
    program = form_assemble_beside("heat/exchange", given->mode, NULL, error);
    if (!program)
        return false;
    words = lay_words(given);
    made = calloc(count, sizeof *made);
    good = words && made && exchange_begin(given, exchange)
               ? run_exchange(given, program, words, made, &exchange->accounts, error)
                     && take_exchange(given, made, exchange, error)
               : error_set(error, "out of memory");
    free(words);
    free(made);
    object_free(program);
    if (!good)
        exchange_free(exchange);
    return good;
}
