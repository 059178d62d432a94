/* machine.c - creates, loads, runs and inspects a machine. */
#include "vm/machine.h"
#include "vm/shared.h"
#include "vm/events.h"
#include "vm/breakpoints.h"
#include "vm/time/schedule.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Creation and loading ----------------------------------------------- */

static bool no_memory(c205_error *error)
{
    snprintf(error->message, sizeof error->message, "out of memory for a machine");
    return false;
}

static void clear_registers(struct c205 *machine)
{
    memset(machine->slot, 0, sizeof machine->slot);
    machine->slot[SLOT_MACHINE_ZERO] = C205_MACHINE_ZERO;
    machine->data_flags = 0;
    machine->timer = 0;
    machine->request = NO_REQUEST;
}

/* Discards an interrupted instruction. It was decoded from its saved copy, which may
 * differ from memory, so the decode cache is invalidated. */
static void clear_resume(struct c205 *machine)
{
    if (!machine->resume.interrupted)
        return;
    machine->memory.code_changes++;
    memset(&machine->resume, 0, sizeof machine->resume);
}

c205 *c205_new(const c205_model *model, c205_error *error)
{
    if (c205_model_is_projection(model)) {
        snprintf(error->message, sizeof error->message,
                 "%.100s is a projection and cannot run programs",
                 c205_model_name(model));
        return NULL;
    }
    struct c205 *machine = calloc(1, sizeof *machine);
    if (!machine) {
        no_memory(error);
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
        no_memory(error);
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
    if (segment->address % WORD_BITS) {
        snprintf(error->message, sizeof error->message,
                 "a segment at %llX does not begin on a word",
                 (unsigned long long)segment->address);
        return false;
    }
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
    clear_resume(machine);
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

static const char *const rule_texts[RULES] = {
#define RULE(name, trap, text) [RULE_##name] = text,
#include "vm/rules.def"
#undef RULE
};

/* Returns the text of the recorded rule, or of the first rule of the trap. */
static const char *broken_rule(const struct c205 *machine, c205_trap trap)
{
    unsigned rule = machine->rule;
    if (rule_trap(machine->rule) != trap)
        rule = RULE_NONE + 1;
    while (rule < RULES && rule_trap((enum rule)rule) != trap)
        rule++;
    return rule < RULES ? rule_texts[rule] : NULL;
}

static void set_trap(struct c205 *machine, c205_trap trap, const c205_insn *insn,
                     c205_stop *stop)
{
    stop->trap = trap;
    stop->pc = machine->pc;
    stop->address = machine->fault;
    stop->insn = trap == C205_TRAP_UNDEFINED_INSTRUCTION ? NULL : insn;
    stop->rule = broken_rule(machine, trap);
    stop->status = 0;
    machine->fault = 0;
    machine->rule = RULE_NONE;
}

/* Stops between two instructions. */
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

/* Stops at an instruction that cannot begin. The clock shows the time when everything
 * in flight is done. */
static bool stop_before(struct c205 *machine, c205_trap trap, const c205_insn *insn,
                        c205_stop *stop)
{
    uint64_t before = clock_now(machine->clock);
    set_trap(machine, trap, insn, stop);
    clock_show_drained(machine->clock);
    machine_notify_stop(machine, stop, before, true);
    return false;
}

/* Stops within a vector instruction: at the limit, or at a trap when an interrupted
 * instruction was to continue. */
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

/* Returns false if a breakpoint or watchpoint was reached or a listener requested a
 * stop. */
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

/* Limits a vector instruction to the elements that stream before the limit. */
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

/* ---- Blocks -------------------------------------------------------------- */

/* Returns the number of executed instructions, less than all after a trap or a change
 * of code. */
static inline unsigned execute_block(struct c205 *machine,
                                     const struct code_block *block, c205_trap *trap)
{
    const struct decoded *insn = block->insn, *end = insn + block->count;
    struct effect *effect = &machine->effect;
    effect->taken = effect->ends = false;
    effect->touch_count = 0;
    effect->swapped = 0;
    do
        *trap = insn->execute(machine, insn);
    while (*trap == C205_TRAP_NONE && ++insn < end && !effect->ends);
    return (unsigned)(insn - block->insn);
}

/* Executes a block as far as possible, without listeners and without reaching the
 * limit. Returns false if the run ends, with the reason in *stop. */
static inline bool run_block(struct c205 *machine, struct code_block *block,
                             c205_stop *stop)
{
    c205_trap trap;
    struct effect *effect = &machine->effect;
    unsigned count = execute_block(machine, block, &trap);
    if (!clock_repeat(machine->clock, block, count, effect))
        clock_charge_block(machine->clock, block, count, effect);
    machine->pc = effect->taken ? effect->target
                  : count > 0   ? block->insn[count - 1].next
                                : block->pc;
    if (trap == C205_TRAP_NONE)
        return true;
    clock_materialize(machine->clock);
    return stop_before(machine, trap, block->insn[count].insn, stop);
}

static inline struct code_block *block_at(struct c205 *machine, uint64_t pc)
{
    struct code_block *block = *block_place(machine->blocks, pc);
    if (block && block->pc == pc && block->version == machine->memory.code_changes)
        return block;
    return block_make(machine, pc);
}

/* Executes a block, or one instruction if a block is not possible. */
static inline bool go_on(struct c205 *machine, uint64_t limit, c205_stop *stop)
{
    if (!machine->eventful) {
        struct code_block *block = block_at(machine, machine->pc);
        if (block->count > 0
            && (limit == C205_NO_LIMIT
                || clock_ends_before(machine->clock, block, limit)))
            return run_block(machine, block, stop);
        clock_materialize(machine->clock);
    }
    return step(machine, limit, stop);
}

/* ---- Runs --------------------------------------------------------------- */

/* The first step continues at the point where the previous run stopped. */
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
        clear_resume(machine);
    return goes_on;
}

c205_stop c205_run(c205 *machine, uint64_t limit)
{
    c205_stop stop;
    machine_sample_watchpoints(machine);
    if (first_step(machine, limit, &stop))
        while (go_on(machine, limit, &stop))
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

/* ---- Inspection --------------------------------------------------------- */

static const char *const trap_names[C205_TRAPS] = {
    [C205_TRAP_NONE] = "none",
    [C205_TRAP_UNDEFINED_INSTRUCTION] = "undefined-instruction",
    [C205_TRAP_UNMAPPED_ADDRESS] = "unmapped-address",
    [C205_TRAP_PROTECTED_ADDRESS] = "protected-address",
    [C205_TRAP_BAD_DESCRIPTOR] = "bad-descriptor",
    [C205_TRAP_MISALIGNED_OPERAND] = "misaligned-operand",
    [C205_TRAP_BAD_LINK] = "bad-link",
    [C205_TRAP_BAD_REQUEST] = "bad-request",
    [C205_TRAP_CLOCK_LIMIT] = "clock-limit",
    [C205_TRAP_NO_MEMORY] = "no-memory",
    [C205_TRAP_PAUSED] = "paused",
    [C205_TRAP_BREAKPOINT] = "breakpoint",
    [C205_TRAP_WATCHPOINT] = "watchpoint"
};

const char *c205_trap_name(c205_trap trap)
{
    return trap_names[trap];
}

/* Address 0 is shown for these traps too, because an uninitialised descriptor holds
 * it. */
static bool has_address(const c205_stop *stop)
{
    return stop->address || stop->trap == C205_TRAP_UNMAPPED_ADDRESS
           || stop->trap == C205_TRAP_PROTECTED_ADDRESS;
}

/* Writes ": 56000000", the half word that is not an instruction. */
static void describe_code(const c205 *machine, uint64_t pc, char text[20])
{
    c205_word word;
    uint64_t skip = pc % WORD_BITS;
    text[0] = '\0';
    if (c205_read(machine, pc - skip, &word, 1))
        snprintf(text, 20, ": %08llX",
                 (unsigned long long)(word << skip >> WORD_BITS / 2));
}

/* Returns true if the host could not allocate a page at its first use. */
static bool lacks_page(const c205 *machine, const c205_stop *stop)
{
    return stop->trap == C205_TRAP_UNMAPPED_ADDRESS && stop->address <= ADDRESS_MASK
           && memory_is_untouched(memory_peek(&machine->memory, stop->address));
}

void c205_describe_stop(const c205 *machine, const c205_stop *stop, c205_error *text)
{
    unsigned long long pc = stop->pc, address = stop->address;
    char code[20] = "", operand[32] = "";
    const char *rule = lacks_page(machine, stop) ? MEMORY_NO_PAGE : stop->rule;
    if (stop->trap == C205_TRAP_NONE) {
        snprintf(text->message, sizeof text->message, "ended at %llX with status %lld",
                 pc, (long long)stop->status);
        return;
    }
    if (stop->insn)
        snprintf(code, sizeof code, ": %s", stop->insn->mnemonic);
    else if (stop->trap == C205_TRAP_UNDEFINED_INSTRUCTION)
        describe_code(machine, stop->pc, code);
    if (has_address(stop))
        snprintf(operand, sizeof operand, ": address %llX", address);
    snprintf(text->message, sizeof text->message, "trap %s at %llX%s%s%s%s",
             c205_trap_name(stop->trap), pc, code, operand, rule ? ": " : "",
             rule ? rule : "");
}

bool c205_map(c205 *machine, uint64_t address, size_t words, c205_access access,
              c205_error *error)
{
    return memory_map(&machine->memory, address, words, access, error);
}

bool c205_map_shared(c205 *machine, uint64_t address, const c205_shared *shared,
                     c205_error *error)
{
    return shared_map(shared, &machine->memory, address, error);
}

void c205_warm(c205 *machine)
{
    uint64_t address = memory_next_page(&machine->memory, 0);
    for (; address <= ADDRESS_MASK;
         address = memory_next_page(&machine->memory, address + PAGE_BITS))
        clock_warm_page(machine->clock, address, PAGE_BITS);
}

bool c205_next_page(const c205 *machine, uint64_t from, c205_page *page)
{
    uint64_t address = memory_next_page(&machine->memory, from & ~(PAGE_BITS - 1));
    const struct page *found;
    if (from > ADDRESS_MASK || address > ADDRESS_MASK)
        return false;
    found = memory_peek(&machine->memory, address);
    page->address = address;
    page->touched = !memory_is_untouched(found);
    page->writable = !page->touched || memory_may_write(found);
    return true;
}

static bool host_may_copy(const c205 *machine, uint64_t address, size_t count)
{
    uint64_t fault;
    return address % WORD_BITS == 0 && address <= ADDRESS_MASK
           && (uint64_t)count <= ADDRESS_SPACE_WORDS
           && memory_check(&machine->memory, address, (uint64_t)count * WORD_BITS,
                           false, &fault)
                  == C205_TRAP_NONE;
}

bool c205_read(const c205 *machine, uint64_t address, c205_word *words, size_t count)
{
    if (!host_may_copy(machine, address, count))
        return false;
    memory_read_words(&machine->memory, address, words, count);
    return true;
}

bool c205_write(c205 *machine, uint64_t address, const c205_word *words, size_t count)
{
    if (!host_may_copy(machine, address, count))
        return false;
    memory_write_words(&machine->memory, address, words, count);
    return true;
}

c205_word c205_register(const c205 *machine, unsigned number)
{
    return number < C205_REGISTERS ? machine->slot[number] : 0;
}

/* Register 0 cannot be changed. */
void c205_set_register(c205 *machine, unsigned number, c205_word word)
{
    if (number > 0 && number < C205_REGISTERS)
        machine->slot[number] = word;
}

uint64_t c205_pc(const c205 *machine)
{
    return machine->pc;
}

void c205_set_pc(c205 *machine, uint64_t address)
{
    clear_resume(machine);
    clock_commit(machine->clock);
    machine->pc = address & ADDRESS_MASK;
}

c205_word c205_data_flags(const c205 *machine)
{
    return machine_flags(machine);
}

uint64_t c205_loaded_program(const c205 *machine)
{
    return machine->program;
}

/* ---- Time --------------------------------------------------------------- */

uint64_t c205_clock(const c205 *machine)
{
    return clock_now(machine->clock);
}

const c205_model *c205_machine_model(const c205 *machine)
{
    return machine->model;
}

size_t c205_account_count(const c205 *machine)
{
    return clock_account_count(machine->clock);
}

const c205_account *c205_account_at(const c205 *machine, size_t i)
{
    return clock_account(machine->clock, i);
}

void c205_reset_clock(c205 *machine)
{
    machine_raise_flags(machine);
    if (machine->timer)
        machine->timer -= clock_now(machine->clock);
    clock_reset(machine->clock);
}

bool c205_listen(c205 *machine, c205_listener *listener, void *context)
{
    if (machine->listener_count == C205_LISTENERS)
        return false;
    machine->listener[machine->listener_count].call = listener;
    machine->listener[machine->listener_count++].context = context;
    machine->eventful = true;
    clock_listen(machine->clock, &machine->record);
    return true;
}
