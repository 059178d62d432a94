/* compare_states.c - steps a program on the machine and on the reference. */
#include "compare_states.h"

#include "asm/object/disassemble.h"
#include "tests/oracle/random_machine.h"
#include "tests/oracle/reference_clock.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    WORD = 64,
    HALF = 32,
    MARGIN = 64, /* number of words compared before and after an area */
    STEPS = 120,
    ONE_OTHERWISE_IN = 12 /* fraction of programs run in other modes, in addition to
                           * loops */
};

/* The state of one comparison: the machine and the reference interpreter. */
struct trial {
    const struct random_program *program;
    c205 *machine;
    struct reference reference;
    struct reference_clock clock;
    struct difference *difference;
};

static c205_word *scratch; /* a buffer of one page */

/* ---- Begin and end ----------------------------------------------------- */

void compare_begin(void)
{
    random_machines_begin();
    scratch = plain_room(NULL, C205_PAGE_WORDS, sizeof *scratch);
}

void compare_end(void)
{
    random_machines_end();
    free(scratch);
}

static void begin_trial(struct trial *trial)
{
    const struct random_program *program = trial->program;
    struct reference *reference = &trial->reference;
    reference_begin(reference);
    trial->machine = random_machine_load(program);
    random_machine_memory(trial->machine, program, &reference->memory);
    reference->now.pc = program->code;
    memcpy(reference->now.registers, program->registers,
           sizeof reference->now.registers);
    reference_clock_begin(&trial->clock, c205_machine_model(trial->machine));
    reference_clock_enter(&trial->clock, program->code);
}

/* ---- Differences ------------------------------------------------------- */

static void differ(struct trial *trial, const char *format, ...)
{
    struct difference *difference = trial->difference;
    va_list arguments;
    va_start(arguments, format);
    if (difference->count < DIFFERENCES)
        vsnprintf(difference->texts[difference->count], DIFFERENCE_TEXT, format,
                  arguments);
    va_end(arguments);
    difference->count++;
}

static void compare_words(struct trial *trial, const char *what, uint64_t number,
                          c205_word machine, c205_word reference)
{
    if (machine != reference)
        differ(trial, "%s %llX: machine %016llX, reference %016llX", what,
               (unsigned long long)number, (unsigned long long)machine,
               (unsigned long long)reference);
}

static void compare_registers(struct trial *trial)
{
    const struct reference_state *state = &trial->reference.now;
    for (unsigned i = 1; i < C205_REGISTERS; i++)
        compare_words(trial, "register", i, c205_register(trial->machine, i),
                      state->registers[i]);
    compare_words(trial, "data flags", 0, c205_data_flags(trial->machine),
                  reference_flags(&trial->reference, trial->clock.now));
    compare_words(trial, "program counter", 0, c205_pc(trial->machine), state->pc);
}

static const c205_word *image_at(const struct trial *trial, uint64_t address)
{
    return plain_words(&trial->reference.memory, address);
}

/* Compares words that are on the same page. */
static void compare_memory(struct trial *trial, uint64_t address, size_t count)
{
    const c205_word *image = image_at(trial, address);
    c205_read(trial->machine, address, scratch, count);
    if (memcmp(scratch, image, count * sizeof *scratch) == 0)
        return;
    for (size_t i = 0; i < count; i++)
        compare_words(trial, "address", address + WORD * i, scratch[i], image[i]);
}

/* Compares the words of an area and of its margins, if their pages exist. */
static void compare_area(struct trial *trial, const struct random_area *area)
{
    uint64_t margin = WORD * MARGIN;
    uint64_t address = image_at(trial, area->address - margin) ? area->address - margin
                                                               : area->address;
    uint64_t end = area->address + WORD * area->words + margin;
    while (address < end && image_at(trial, address)) {
        uint64_t in_page = C205_PAGE_WORDS - address / WORD % C205_PAGE_WORDS;
        size_t count = (size_t)lesser((end - address) / WORD, in_page);
        compare_memory(trial, address, count);
        address += WORD * count;
    }
}

/* Compares the words that the reference has stored. */
static void compare_changes(struct trial *trial)
{
    const struct plain_memory *memory = &trial->reference.memory;
    for (size_t i = 0; i < memory->change_count; i++)
        compare_memory(trial, memory->changes[i].address, 1);
}

/* Returns true if the instruction may store words. If another instruction changes
 * memory, the difference is found after the next storing instruction, or at the end. */
static bool may_store(const struct deed *deed)
{
    return deed->insn_count == 0 || c205_unit_is_vector(deed->insns[0]->unit)
           || deed->insns[0]->unit == C205_UNIT_MEMORY;
}

static void compare_states(struct trial *trial)
{
    compare_registers(trial);
    compare_changes(trial);
    if (may_store(&trial->reference.deed))
        for (size_t i = 0; i < random_area_count; i++)
            compare_area(trial, random_areas + i);
}

/* ---- Clocks ------------------------------------------------------------ */

static size_t region_of(const struct trial *trial, uint64_t pc)
{
    return pc >= trial->program->code && pc < random_region_end(trial->program);
}

static void compare_account(struct trial *trial, size_t region,
                            const c205_account *account)
{
    const struct counts *counts = trial->clock.counts + region;
    for (int i = 0; i < C205_CAUSES; i++)
        if (account->clocks[i] != trial->clock.charged[region][i])
            differ(trial, "clocks of %s in region %zu: machine %llu, reference %llu",
                   c205_cause_name((c205_cause)i), region,
                   (unsigned long long)account->clocks[i],
                   (unsigned long long)trial->clock.charged[region][i]);
    compare_words(trial, "instructions in region", region, account->instructions,
                  counts->instructions);
    compare_words(trial, "vector instructions in region", region,
                  account->vector_instructions, counts->vector_instructions);
    compare_words(trial, "elements in region", region, account->elements,
                  counts->elements);
    compare_words(trial, "operations in region", region, account->operations,
                  counts->operations);
    compare_words(trial, "entries to region", region, account->entries,
                  counts->entries);
}

static void compare_clocks(struct trial *trial)
{
    for (size_t i = 0; i < c205_account_count(trial->machine); i++) {
        const c205_account *account = c205_account_at(trial->machine, i);
        compare_account(trial, account->name[0] != '\0', account);
    }
    compare_words(trial, "clock", 0, c205_clock(trial->machine), trial->clock.now);
}

/* ---- Traps ------------------------------------------------------------- */

/* Returns true if the trap reports the faulting address. For a misaligned operand, this
 * may be the start of the operand. */
static bool names_address(c205_trap trap)
{
    return trap == C205_TRAP_UNMAPPED_ADDRESS || trap == C205_TRAP_PROTECTED_ADDRESS;
}

static bool has_fault(const struct reference *reference, const c205_stop *stop)
{
    if (names_address(stop->trap))
        return reference_has_fault(reference, stop->trap, stop->address);
    return reference->faults[stop->trap].possible;
}

static void differ_in_faults(struct trial *trial, const c205_stop *stop)
{
    differ(trial, "machine: trap %s, address %llX", c205_trap_name(stop->trap),
           (unsigned long long)stop->address);
    for (int i = 0; i < C205_TRAPS; i++) {
        const struct fault *fault = trial->reference.faults + i;
        if (fault->possible)
            differ(trial, "reference: %s %s, address %llX to %llX",
                   fault->certain ? "trap" : "possible trap",
                   c205_trap_name((c205_trap)i), (unsigned long long)fault->low,
                   (unsigned long long)fault->high);
    }
}

/* Skips an instruction that has trapped. Returns false if it cannot be skipped. */
static bool skip(struct trial *trial)
{
    uint64_t pc = trial->reference.deed.pc;
    unsigned halves = random_insn_halves(trial->machine, pc);
    trial->reference.now.pc = plain_address(pc + HALF * halves);
    c205_set_pc(trial->machine, trial->reference.now.pc);
    reference_clock_enter(&trial->clock, trial->reference.now.pc);
    return halves != 0;
}

/* Compares the machine with the reference after a trap, and skips the instruction.
 * Returns true if the program continues. */
static bool after_trap(struct trial *trial, bool done, const c205_stop *stop)
{
    if (!has_fault(&trial->reference, stop)) {
        differ_in_faults(trial, stop);
        return false;
    }
    if (done)
        reference_undo(&trial->reference);
    reference_clock_drain(&trial->clock);
    compare_states(trial);
    compare_clocks(trial);
    compare_words(trial, "trap at", 0, stop->pc, trial->reference.deed.pc);
    return skip(trial);
}

/* ---- A run ------------------------------------------------------------- */

static bool step_both(struct trial *trial)
{
    struct reference *reference = &trial->reference;
    c205_stop stop = { .trap = C205_TRAP_NONE };
    bool done, goes_on;
    reference->clock = trial->clock.now;
    done = reference_step(reference);

    if (reference->lost)
        return false;
    goes_on = c205_step(trial->machine, &stop);
    if (!goes_on && stop.trap != C205_TRAP_NONE)
        return after_trap(trial, done, &stop);
    if (!done)
        differ_in_faults(trial, &stop);
    else if (goes_on == reference->ended)
        differ(trial, "one of them has ended");
    else if (reference->ended)
        compare_words(trial, "status", 0, (c205_word)stop.status,
                      (c205_word)reference->status);
    reference_clock_step(&trial->clock, &reference->deed,
                         region_of(trial, reference->deed.pc));
    if (reference->ended)
        reference_clock_drain(&trial->clock);
    compare_states(trial);
    compare_clocks(trial);
    return goes_on;
}

static c205_word word_at(const struct trial *trial, uint64_t address)
{
    c205_word first = plain_read(&trial->reference.memory, address / WORD * WORD);
    c205_word second = plain_read(&trial->reference.memory,
                                  address / WORD * WORD + WORD);
    return address % WORD == 0 ? first : first << HALF | second >> HALF;
}

/* Runs until the program ends, differs or gets lost, or until the limit of steps. */
static void run_steps(struct trial *trial)
{
    struct difference *difference = trial->difference;
    bool goes_on = true;
    while (goes_on && difference->step < STEPS && difference->count == 0) {
        difference->pc = trial->reference.now.pc;
        difference->word = word_at(trial, difference->pc);
        goes_on = step_both(trial);
        difference->step++;
    }
    if (difference->count == 0 && !trial->reference.lost)
        for (size_t i = 0; i < RANDOM_PAGES; i++)
            compare_memory(trial, random_pages[i].address, C205_PAGE_WORDS);
}

/* Compares other modes of execution. They load the machine again. */
static void compare_other_ways(struct trial *trial)
{
    uint64_t hash = machine_hash(trial->machine);
    const char *way = disagreeing_way(trial->program,
                                      trial->reference.ended ? &hash : NULL);
    if (way)
        differ(trial, "%s ends in another state", way);
}

bool compare_run(const struct random_program *program, struct difference *difference)
{
    struct trial trial = { .program = program, .difference = difference };
    *difference = (struct difference){ .count = 0 };
    begin_trial(&trial);
    run_steps(&trial);
    if (difference->count == 0 && !trial.reference.lost
        && (program->loop || program->seed % ONE_OTHERWISE_IN == 0))
        compare_other_ways(&trial);
    reference_end(&trial.reference);
    return difference->count == 0;
}

/* ---- Printing ---------------------------------------------------------- */

static void print_insn(uint64_t address, c205_word word)
{
    char text[DISASSEMBLE_TEXT_SIZE];
    disassemble_one(word, address, text);
    printf("        %-40s ; %llX: %016llX\n", text, (unsigned long long)address,
           (unsigned long long)word);
}

static void print_registers(const struct random_program *program)
{
    char text[C205_TEXT_SIZE];
    for (unsigned i = 1; i < C205_REGISTERS; i++)
        if (program->registers[i] != 0) {
            c205_to_hex(program->registers[i], text);
            printf("        load_constant r%u, X'%s'\n", i, text);
        }
}

void print_program(const struct random_program *program)
{
    printf("; seed %llu, %s; model:\n%s", (unsigned long long)program->seed,
           program->plain_data ? "all numbers one" : "random data",
           random_models[program->model]);
    print_registers(program);
    printf("        .org    0x%llX\n", (unsigned long long)program->code);
    for (size_t i = 0; i < program->insn_count; i++)
        print_insn(program_address(program, i), program->insns[i].word);
}

void print_difference(const struct difference *difference)
{
    printf("; after step %llu:\n", (unsigned long long)difference->step);
    print_insn(difference->pc, difference->word);
    for (size_t i = 0; i < difference->count && i < DIFFERENCES; i++)
        printf(";   %s\n", difference->texts[i]);
    printf("; %zu differences\n\n", difference->count);
}
