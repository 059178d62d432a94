/* plain_run.c - records a program's states and finds a debugger's stops among them. */
#include "tests/unit/plain_run.h"

#include "tests/random.h"

struct moment moment_of(const c205 *machine, uint64_t watched)
{
    struct moment moment = { .pc = c205_pc(machine), .clock = c205_clock(machine) };
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        moment.registers[i] = c205_register(machine, i);
    c205_read(machine, watched, &moment.watched, 1);
    return moment;
}

struct plain run_plainly(struct object *object, uint64_t *random_state)
{
    struct plain plain = { .object = object };
    SCOPED(c205) *machine = c205_new(prior_model, &failure);
    c205_stop stop;
    assert_non_null(object);
    const c205_segment *last = &object->program
                                    .segments[object->program.segment_count - 1];
    plain.watched = last->address + 64 * (xorshift(random_state) % last->length);
    plain.moments = malloc((MAX_PLAIN_STEPS + 1) * sizeof *plain.moments);
    assert_true(c205_load(machine, &object->program, &failure));
    plain.moments[0] = moment_of(machine, plain.watched);
    for (bool goes_on = true; goes_on && plain.end < MAX_PLAIN_STEPS;) {
        goes_on = c205_step(machine, &stop);
        plain.moments[++plain.end] = moment_of(machine, plain.watched);
    }
    assert_true(plain.end < MAX_PLAIN_STEPS);
    return plain;
}

const char *plain_region(const struct plain *plain, uint64_t pc)
{
    const c205_program *program = &plain->object->program;
    for (size_t i = 0; i < program->region_count; i++)
        if (pc >= program->regions[i].begin && pc < program->regions[i].end)
            return program->regions[i].name;
    return "";
}

/* ---- Where a debugger stops -------------------------------------------------- */

static bool enters(const struct plain *plain, const char *region, size_t step)
{
    return strcmp(plain_region(plain, plain->moments[step].pc), region) == 0
           && strcmp(plain_region(plain, plain->moments[step - 1].pc), region) != 0;
}

bool plain_stops_at(const struct plain *plain, const struct plain_stops *stops,
                    size_t step)
{
    const struct moment *now = &plain->moments[step];
    if (step == 0 || step >= plain->end)
        return false;
    return (stops->by_place && now->pc == stops->place
            && (stops->every == 0 || step % stops->every == 0))
           || (stops->region && enters(plain, stops->region, step))
           || (stops->by_watch && now->watched != now[-1].watched);
}

size_t plain_on(const struct plain *plain, const struct plain_stops *stops, size_t step,
                uint64_t count)
{
    while (step < plain->end && count-- > 0)
        if (plain_stops_at(plain, stops, ++step))
            break;
    return step;
}

size_t plain_back(const struct plain *plain, const struct plain_stops *stops,
                  size_t step)
{
    while (step > 0 && !plain_stops_at(plain, stops, --step))
        continue;
    return step;
}

size_t plain_to_clock(const struct plain *plain, size_t step, uint64_t clock)
{
    if (plain->moments[step].clock >= clock)
        step = 0;
    while (step < plain->end && plain->moments[step].clock < clock)
        step++;
    return step;
}
