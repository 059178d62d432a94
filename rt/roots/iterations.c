/* iterations.c - counts the steps of the root solver's refinement. */
#include "rt/roots/iterations.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"

static const struct {
    const char *name, *routine;
} stages[STAGES] = {
    [STAGE_SLOPE] = { "slope", "refine_cubic" },
    [STAGE_VALUE] = { "value", "refine_quartic" },
};

const char *stage_name(enum stage stage)
{
    return stages[stage].name;
}

static bool find_label(const struct object *program, const char *routine,
                       const char *suffix, uint64_t *address)
{
    char name[64];
    const struct asm_symbol *symbol;
    snprintf(name, sizeof name, "%s%s", routine, suffix);
    symbol = object_symbol(program, name);
    *address = symbol ? (uint64_t)symbol->value : 0;
    return symbol != NULL;
}

bool iterations_begin(struct iterations *iterations, const struct object *program,
                      bool vector)
{
    bool good = true;
    memset(iterations, 0, sizeof *iterations);
    iterations->vector = vector;
    for (int i = 0; i < STAGES; i++) {
        struct stage_labels *labels = &iterations->labels[i];
        const char *routine = stages[i].routine;
        good = find_label(program, routine, "", &labels->begin)
               && find_label(program, routine, "_wide", &labels->wide)
               && find_label(program, routine, "_step", &labels->step)
               && find_label(program, routine, "_midpoint", &labels->midpoint)
               && find_label(program, routine, "_left", &labels->left) && good;
    }
    return good;
}

/* Returns the number of lanes of an instruction. An instruction of the scalar form has
 * no elements and counts as one lane. */
static uint64_t lanes_of(const c205_event *event)
{
    return event->elements > 0 ? event->elements : 1;
}

/* Returns the number of brackets that the instruction has written to its register T.
 * The scalar form has one bracket at a time; the number is then `scalar`. */
static uint64_t result_of(const struct iterations *iterations, const c205 *machine,
                          const c205_event *event, uint64_t scalar)
{
    return iterations->vector
               ? (uint64_t)c205_to_integer(c205_register(machine, event->fields.t))
               : scalar;
}

static void count_pass(struct iterations *iterations, struct stage_count *count,
                       uint64_t lanes)
{
    size_t pass = iterations->pass++;
    count->passes++;
    count->steps += iterations->active;
    count->lanes += lanes;
    if (pass < MAX_ITERATIONS) {
        count->active[pass] += iterations->active;
        count->in_loop[pass] += lanes;
    }
}

void iterations_listen(void *context, const c205 *machine, const c205_event *event)
{
    struct iterations *iterations = context;
    if (event->kind != C205_EVENT_INSTRUCTION)
        return;
    for (int i = 0; i < STAGES; i++) {
        const struct stage_labels *labels = &iterations->labels[i];
        struct stage_count *count = &iterations->stage[i];
        if (event->pc == labels->begin) {
            iterations->pass = 0;
            iterations->active = result_of(iterations, machine, event, 1);
            count->brackets += iterations->active;
        } else if (event->pc == labels->wide) {
            count->halvings += result_of(iterations, machine, event, 1);
        } else if (event->pc == labels->step || event->pc == labels->midpoint) {
            count_pass(iterations, count, lanes_of(event));
        } else if (event->pc == labels->left) {
            iterations->active = result_of(iterations, machine, event, 0);
        }
    }
}

/* ---- A frame, band by band ----------------------------------------------- */

static void *begin_band(void *context, const struct object *program, c205_error *error)
{
    const struct iterations *sum = context;
    struct iterations *band = malloc(sizeof *band);
    if (band && iterations_begin(band, program, sum->vector))
        return band;
    error_set(error, band ? "the root solver cannot be watched" : "out of memory");
    free(band);
    return NULL;
}

static void add_stage(struct stage_count *sum, const struct stage_count *band)
{
    sum->brackets += band->brackets;
    sum->passes += band->passes;
    sum->steps += band->steps;
    sum->lanes += band->lanes;
    sum->halvings += band->halvings;
    for (size_t i = 0; i < MAX_ITERATIONS; i++) {
        sum->active[i] += band->active[i];
        sum->in_loop[i] += band->in_loop[i];
    }
}

static void merge_band(void *context, const void *band)
{
    struct iterations *sum = context;
    const struct iterations *of_band = band;
    for (int i = 0; i < STAGES; i++)
        add_stage(&sum->stage[i], &of_band->stage[i]);
}

struct observer iterations_observer(struct iterations *sum)
{
    return (struct observer){ begin_band, iterations_listen, merge_band, free, sum };
}
