/* unidentifiable.c - finds constants on which no fitted observation depends. */
#include "rt/study/fit/unidentifiable.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"

typedef double region_clocks[MAX_RUN_REGIONS];

/* The fit whose constants are tested, and the clocks of its timings before a constant
 * changes. */
struct question {
    const struct fit *fit;
    const struct fit_change *change;
    region_clocks *before; /* clocks of each timing */
};

/* The smallest relative change of a time that counts as a change. */
#define CHANGED .01

static double sum_of(const struct term *term, const struct fit_run *run,
                     const region_clocks clocks)
{
    double sum = 0;
    for (size_t i = 0; i < run->region_count; i++)
        if (term->chosen[i])
            sum += clocks[i];
    return sum;
}

/* Returns true if the time of a term changes when the constant is doubled, halved or
 * divided by eight. A value that the model rejects counts as no change. */
static bool changes(const struct question *question, const struct term *term,
                    const char *name)
{
    static const double factors[] = { 2, .5, .125 };
    const struct run_timing *timing = &question->fit->observations
                                           ->timings[term->timing];
    double value = c205_model_lookup(timing->model, name)->value;
    double before = sum_of(term, timing->run, question->before[term->timing]);
    for (size_t i = 0; i < sizeof factors / sizeof *factors; i++) {
        double moved = value == 0 ? 1 : value * factors[i];
        c205_setting setting = { name, value == floor(value) ? floor(moved) : moved };
        region_clocks after;
        c205_error refused;
        if (run_time(timing->run, timing->model, &setting, 1, RUN_FINE, after, &refused)
            && fabs(sum_of(term, timing->run, after) / before - 1) >= CHANGED)
            return true;
    }
    return false;
}

static bool changes_any(const struct question *question, const struct observation *item,
                        const char *machine, const char *name)
{
    const struct observations *all = question->fit->observations;
    for (size_t i = 0; i < item->term_count; i++)
        if (model_is_of(all->timings[item->terms[i].timing].model, machine,
                        strlen(machine))
            && changes(question, &item->terms[i], name))
            return true;
    return false;
}

/* Returns true if a constant changes a fitted time. The clock period changes all
 * times. */
static bool is_touched(const struct question *question, const char *machine,
                       const c205_constant *constant)
{
    const struct observations *all = question->fit->observations;
    bool touched = strcmp(constant->name, "clock.period") == 0;
    for (size_t i = 0; i < all->count && !touched; i++)
        touched = all->items[i].use == OBSERVATION_FIT && !question->change->held[i]
                  && changes_any(question, &all->items[i], machine, constant->name);
    return touched;
}

static const struct free_constant *find_mover(const struct constants *constants,
                                              const char *machine, const char *name)
{
    for (size_t i = 0; i < constants->count; i++) {
        const struct free_constant *item = &constants->items[i];
        for (size_t k = 0; k < item->member_count; k++)
            if (strcmp(item->machine, machine) == 0
                && strcmp(item->members[k].name, name) == 0)
                return item;
    }
    return NULL;
}

static void add_machine(const struct question *question, const char *machine,
                        struct unidentifiable_list *unidentifiable)
{
    const struct constants *constants = question->fit->constants;
    const c205_model *prior = constants_prior(constants, machine);
    for (size_t i = 0; i < c205_model_size(prior); i++) {
        const c205_constant *constant = c205_model_constant(prior, i);
        if (unidentifiable->count < MAX_UNTOUCHED
            && !is_touched(question, machine, constant))
            unidentifiable->items[unidentifiable->count++] = (struct unidentifiable){
                machine, constant, find_mover(constants, machine, constant->name)
            };
    }
}

/* Adds the unidentifiable constants of each machine that has a free constant, once per
 * machine. */
static void add_machines(const struct question *question,
                         struct unidentifiable_list *unidentifiable)
{
    const struct constants *constants = question->fit->constants;
    for (size_t i = 0; i < constants->count; i++) {
        const char *machine = constants->items[i].machine;
        size_t first = 0;
        while (strcmp(constants->items[first].machine, machine) != 0)
            first++;
        if (first == i)
            add_machine(question, machine, unidentifiable);
    }
}

bool unidentifiable_find(const struct fit *fit, const struct fit_change *change,
                         struct unidentifiable_list *unidentifiable, c205_error *error)
{
    const struct observations *all = fit->observations;
    struct question question = { fit, change,
                                 calloc(all->timing_count, sizeof(region_clocks)) };
    bool good = question.before != NULL;
    unidentifiable->count = 0;
    if (!good)
        error_set(error, "out of memory");
    for (size_t i = 0; good && i < all->timing_count; i++)
        good = run_time(all->timings[i].run, all->timings[i].model, NULL, 0, RUN_FINE,
                        question.before[i], error);
    if (good)
        add_machines(&question, unidentifiable);
    free(question.before);
    return good;
}
