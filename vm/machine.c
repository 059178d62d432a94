/* machine.c - creates, loads and runs a machine. */
#include "vm/machine.h"
#include "vm/error.h"
#include "vm/events.h"
#include "vm/breakpoints.h"

#include <stdlib.h>
#include <string.h>

/* ---- Creation and loading ----------------------------------------------- */

static void clear_registers(struct c205 *machine)
{
    memset(machine->slot, 0, sizeof machine->slot);
    machine->slot[SLOT_MACHINE_ZERO] = C205_MACHINE_ZERO;
    machine->data_flags = 0;
    machine->timer = 0;
    machine->request = NO_REQUEST;
}

/* Discards the state of an interrupted instruction. It was decoded from its saved copy,
 * which may differ from memory, so the decode cache is invalidated. */
void machine_clear_resume(struct c205 *machine)
{
    if (!machine->resume.interrupted)
        return;
    machine->memory.code_changes++;
    memset(&machine->resume, 0, sizeof machine->resume);
}

c205 *c205_new(const c205_model *model, c205_error *error)
{
    if (c205_model_is_projection(model)) {
        error_set(error, "%.100s is a projection and cannot run programs",
                  c205_model_name(model));
        return NULL;
    }
    struct c205 *machine = calloc(1, sizeof *machine);
    if (!machine) {
        error_set(error, "out of memory for a machine");
        return NULL;
    }
    machine->model = model;
    memory_init(&machine->memory);
    clear_registers(machine);
    machine->clock = clock_new(model, error);
    machine->cache = decode_cache_new();
    machine->blocks = blocks_new();
    if (machine->clock && machine->cache && machine->blocks)
        return machine;
    if (machine->clock)
        error_set(error, "out of memory for a machine");
    c205_free(machine);
    return NULL;
}

void c205_free(c205 *machine)
{
    if (!machine)
        return;
    if (machine->clock)
        clock_free(machine->clock);
    memory_free(&machine->memory);
    for (size_t i = 0; i < SCRATCHES; i++)
        free(machine->scratch[i]);
    machine_free_breakpoints(machine->breakpoints);
    free(machine->ranges);
    free(machine->cache);
    free(machine->blocks);
    free(machine);
}

static bool load_segment(struct c205 *machine, const c205_segment *segment,
                         c205_error *error)
{
    if (segment->address % WORD_BITS)
        return error_set(error, "a segment at %llX does not begin on a word",
                         (unsigned long long)segment->address);
    if (!memory_map(&machine->memory, segment->address, segment->length,
                    segment->words ? C205_READ_WRITE : C205_WHEN_TOUCHED, error))
        return false;
    if (segment->words)
        memory_write_words(&machine->memory, segment->address, segment->words,
                           segment->length);
    return true;
}

bool c205_load(c205 *machine, const c205_program *program, c205_error *error)
{
    clear_registers(machine);
    machine_clear_resume(machine);
    memory_clear(&machine->memory);
    clock_reset(machine->clock);
    clock_forget_pages(machine->clock);
    machine->pc = program->entry & ADDRESS_MASK;
    machine->program = c205_program_hash(program);
    for (size_t i = 0; i < program->segment_count; i++)
        if (!load_segment(machine, &program->segments[i], error))
            return false;
    if (!machine_set_regions(machine, program, error))
        return false;
    if (program->warm)
        c205_warm(machine);
    return true;
}

c205_word *machine_scratch(struct c205 *machine, enum scratch which)
{
    if (!machine->scratch[which])
        machine->scratch[which] = malloc((C205_MAX_LENGTH + 1)
                                         * sizeof **machine->scratch);
    return machine->scratch[which];
}

/* ---- Running ------------------------------------------------------------ */

static void set_trap(struct c205 *machine, c205_trap trap, const c205_insn *insn,
                     c205_stop *stop)
{
    stop->trap = trap;
    stop->pc = machine->pc;
    stop->address = machine->fault;
    stop->insn = trap == C205_TRAP_UNDEFINED_INSTRUCTION ? NULL : insn;
    stop->rule = machine_broken_rule(machine, trap);
    stop->status = 0;
    machine->fault = 0;
    machine->rule = RULE_NONE;
}

/* Stops the run between two instructions, and notifies the listeners. */
static bool stop_between(struct c205 *machine, c205_trap why, uint64_t address,
                         c205_stop *stop)
{
    const struct decoded *decoded;
    c205_trap trap = decode_at(machine, machine->pc, &decoded);
    machine->fault = address;
    set_trap(machine, why, trap == C205_TRAP_NONE ? decoded->insn : NULL, stop);
    machine_notify_stop(machine, stop, clock_now(machine->clock), false);
    return false;
}

static bool stop_at_limit(struct c205 *machine, c205_stop *stop)
{
    return stop_between(machine, C205_TRAP_CLOCK_LIMIT, 0, stop);
}

/* Stops before an instruction that cannot begin. The clock includes the wait for
 * everything in flight. */
static bool stop_before(struct c205 *machine, c205_trap trap, const c205_insn *insn,
                        c205_stop *stop)
{
    uint64_t before = clock_now(machine->clock);
    set_trap(machine, trap, insn, stop);
    clock_show_drained(machine->clock);
    machine_notify_stop(machine, stop, before, true);
    return false;
}

/* Stops within a vector instruction. The cause is the limit, or a trap before an
 * interrupted instruction could continue. */
static bool stop_within(struct c205 *machine, c205_trap trap,
                        const struct decoded *decoded, uint64_t limit, c205_stop *stop)
{
    uint64_t before = clock_now(machine->clock);
    if (trap == C205_TRAP_CLOCK_LIMIT)
        resume_interrupt(&machine->resume, decoded);
    else if (!machine->resume.interrupted)
        return stop_before(machine, trap, decoded->insn, stop);
    else
        limit = machine->resumed_at;
    set_trap(machine, trap, decoded->insn, stop);
    clock_show(machine->clock, decoded, limit);
    machine_notify_stop(machine, stop, before, false);
    return false;
}

/* Returns false if a breakpoint, a watchpoint or the request of a listener ends the run
 * after this instruction. */
static bool go_past_stops(struct c205 *machine, c205_stop *stop)
{
    uint64_t address = 0;
    c205_trap trap = machine->breakpoints ? machine_hits_breakpoint(machine, &address)
                                          : C205_TRAP_NONE;
    if (trap == C205_TRAP_NONE && machine->pausing)
        trap = C205_TRAP_PAUSED;
    machine->pausing = false;
    return trap == C205_TRAP_NONE || stop_between(machine, trap, address, stop);
}

/* Notifies the listeners after an instruction or a request. Returns false if the run
 * ends. */
static bool attend(struct c205 *machine, const struct decoded *decoded, uint64_t before,
                   c205_stop *stop)
{
    uint64_t after = clock_now(machine->clock);
    unsigned request = machine->request;
    machine_notify_instruction(machine, decoded, before);
    machine->request = NO_REQUEST;
    machine->eventful = machine->listener_count > 0 || machine->breakpoints;
    if (request != REQUEST_EXIT)
        return go_past_stops(machine, stop);
    machine->pausing = false;
    stop->trap = C205_TRAP_NONE;
    stop->pc = decoded->pc;
    stop->address = 0;
    stop->rule = NULL;
    stop->insn = decoded->insn;
    stop->status = c205_to_integer(machine->slot[decoded->a]);
    clock_drain(machine->clock);
    machine_notify_stop(machine, stop, after, true);
    return false;
}

static inline void clear_effect(struct effect *effect)
{
    effect->elements = effect->idle = effect->recurrent = 0;
    effect->taken = false;
    effect->touch_count = 0;
    effect->indices = NULL;
    effect->swapped = effect->saved = 0;
}

/* Limits a vector instruction to the elements that it can process before the clock
 * reaches the limit. */
static void limit_elements(struct c205 *machine, const struct decoded *decoded,
                           uint64_t limit)
{
    if (decoded->insn->timing == C205_TIMING_vlink
        && decode_pair(machine, decoded) != C205_TRAP_NONE)
        return; /* the execution will trap */
    machine->allowed = clock_elements(machine->clock, decoded, limit);
}

/* Executes one instruction. Returns false if the run ends, with the reason in *stop. */
static inline bool step(struct c205 *machine, uint64_t limit, c205_stop *stop)
{
    const struct decoded *decoded = decode_cached(machine->cache,
                                                  machine->memory.code_changes,
                                                  machine->pc);
    uint64_t before = clock_now(machine->clock);
    c205_trap trap = C205_TRAP_NONE;
    if (before >= limit)
        return stop_at_limit(machine, stop);
    if (!decoded)
        trap = decode_at(machine, machine->pc, &decoded);
    if (trap != C205_TRAP_NONE)
        return stop_before(machine, trap, decoded->insn, stop);
    if (limit != C205_NO_LIMIT && c205_unit_is_vector(decoded->insn->unit))
        limit_elements(machine, decoded, limit);
    clear_effect(&machine->effect);
    trap = decoded->execute(machine, decoded);
    if (trap != C205_TRAP_NONE)
        return stop_within(machine, trap, decoded, limit, stop);
    clock_charge(machine->clock, decoded, &machine->effect);
    machine->pc = machine->effect.taken ? machine->effect.target : decoded->next;
    return !machine->eventful || attend(machine, decoded, before, stop);
}

/* ---- Runs --------------------------------------------------------------- */

/* Executes blocks as far as possible, then one instruction that cannot run in a
 * block. */
static inline bool continue_run(struct c205 *machine, uint64_t limit, c205_stop *stop)
{
    const c205_insn *insn;
    c205_trap trap = C205_TRAP_NONE;
    if (!machine->eventful)
        trap = blocks_run(machine, limit, &insn);
    if (trap != C205_TRAP_NONE)
        return stop_before(machine, trap, insn, stop);
    return step(machine, limit, stop);
}

/* Executes the first step of a run. It continues at the point where the previous run
 * stopped. */
static bool first_step(struct c205 *machine, uint64_t limit, c205_stop *stop)
{
    machine->pausing = false;
    machine->resumed_at = clock_now(machine->clock);
    machine->allowed = SIZE_MAX;
    if (machine->resumed_at >= limit)
        return stop_at_limit(machine, stop);
    clock_go_back(machine->clock);
    bool goes_on = step(machine, limit, stop);
    if (goes_on || stop->trap == C205_TRAP_NONE || trap_is_behind(stop->trap))
        machine_clear_resume(machine);
    return goes_on;
}

c205_stop c205_run(c205 *machine, uint64_t limit)
{
    c205_stop stop;
    machine_sample_watchpoints(machine);
    if (first_step(machine, limit, &stop))
        while (continue_run(machine, limit, &stop))
            continue;
    return stop;
}

c205_stop c205_run_steps(c205 *machine, uint64_t count, uint64_t limit)
{
    c205_stop stop;
    machine_sample_watchpoints(machine);
    if (count == 0)
        stop_between(machine, C205_TRAP_PAUSED, 0, &stop);
    else if (first_step(machine, limit, &stop)) {
        while (--count > 0 && step(machine, limit, &stop))
            continue;
        if (count == 0)
            stop_between(machine, C205_TRAP_PAUSED, 0, &stop);
    }
    return stop;
}

void c205_pause(c205 *machine)
{
    machine->pausing = true;
}

bool c205_step(c205 *machine, c205_stop *stop)
{
    machine_sample_watchpoints(machine);
    return first_step(machine, C205_NO_LIMIT, stop);
}
