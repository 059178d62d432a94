/* compare_states.c - both run a program side by side. */
#include "compare_states.h"

#include "asm/disassemble.h"
#include "tests/oracle/reference_clock.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    WORD = 64,
    HALF = 32,
    CODE_WORDS = PROGRAM_INSNS + 2,
    MARGIN = 64, /* words looked at on either side of an area */
    STEPS = 120,
    PAGES = 6
};

/* All pages there are, as they should be. */
static const struct page {
    uint64_t number;
    c205_access access;
} pages[PAGES] = {
    { 1, C205_READ_WRITE }, { 2, C205_READ_WRITE }, { 3, C205_READ_WRITE },
    { 4, C205_READ_WRITE }, { 6, C205_READ_ONLY },  { 8, C205_READ_WRITE },
};

/* What one program needs. */
struct trial {
    const struct random_program *program;
    c205 *machine;
    struct reference reference;
    struct reference_clock clock;
    struct difference *difference;
};

static c205 **machines; /* one for each model */
static c205_model **models;
static c205_word *images[PAGES], *scratch;

/* ---- Begin and end ----------------------------------------------------- */

static void fail(const char *what)
{
    fprintf(stderr, "check_random: %s\n", what);
    exit(2);
}

static void make_machine(size_t i)
{
    c205_error error;

    models[i] = c205_model_parse("random", random_models[i], &error);
    if (models[i] == NULL)
        fail(error.message);
    machines[i] = c205_new(models[i], &error);
    if (machines[i] == NULL)
        fail(error.message);
}

void compare_begin(void)
{
    models = plain_room(NULL, random_model_count, sizeof *models);
    machines = plain_room(NULL, random_model_count, sizeof *machines);
    for (size_t i = 0; i < random_model_count; i++)
        make_machine(i);
    for (size_t i = 0; i < PAGES; i++)
        images[i] = plain_room(NULL, C205_PAGE_WORDS, sizeof **images);
    scratch = plain_room(NULL, C205_PAGE_WORDS, sizeof *scratch);
}

void compare_end(void)
{
    for (size_t i = 0; i < random_model_count; i++) {
        c205_free(machines[i]);
        c205_model_free(models[i]);
    }
    for (size_t i = 0; i < PAGES; i++)
        free(images[i]);
    free(scratch);
    free(machines);
    free(models);
}

/* ---- Loading ----------------------------------------------------------- */

static c205_word *image_of(uint64_t address)
{
    for (size_t i = 0; i < PAGES; i++)
        if (pages[i].number == plain_page_number(address))
            return images[i] + address / WORD % C205_PAGE_WORDS;
    return NULL;
}

static void put(struct trial *trial, uint64_t address, c205_word word)
{
    plain_store(&trial->reference.memory, address, word);
    *image_of(address) = word;
}

static void put_code(struct trial *trial)
{
    const struct random_program *program = trial->program;

    for (size_t i = 0; i < program->insn_count; i++) {
        const uint64_t begin = program_address(program, i);
        for (unsigned k = 0; k < program->insns[i].halves; k++) {
            const uint64_t at = begin + HALF * k;
            const uint64_t half = program->insns[i].word
                                      >> (k == 0 ? HALF : 0)
                                  & 0xFFFFFFFF;
            put(trial, at / WORD * WORD,
                *image_of(at) | half << (at % WORD == 0 ? HALF : 0));
        }
    }
}

static void put_data(struct trial *trial)
{
    for (size_t a = 0; a < random_area_count; a++) {
        const struct random_area *area = random_areas + a;
        program_data(trial->program, area, scratch);
        for (size_t i = 0; i < area->words; i++)
            put(trial, area->address + WORD * i, scratch[i]);
    }
}

/* The first half of a program is a region of its own. */
static uint64_t region_end(const struct random_program *program)
{
    return program_address(program, (program->insn_count + 1) / 2);
}

static void load_machine(struct trial *trial)
{
    const struct c205_segment nothing = { WORD * C205_PAGE_WORDS, 1, NULL };
    const struct c205_region region = { "first", trial->program->code,
                                        region_end(trial->program) };
    const c205_program empty = { .entry = trial->program->code,
                                 .segment_count = 1,
                                 .segments = &nothing,
                                 .region_count = 1,
                                 .regions = &region };
    const struct plain_memory *memory = &trial->reference.memory;
    c205_error error;

    if (!c205_load(trial->machine, &empty, &error))
        fail(error.message);
    for (size_t i = 0; i < PAGES; i++)
        if (!c205_map(trial->machine,
                      pages[i].number * C205_PAGE_WORDS * WORD,
                      C205_PAGE_WORDS, pages[i].access, &error))
            fail(error.message);
    for (size_t i = 0; i < memory->change_count; i++) {
        const uint64_t address = memory->changes[i].address;
        c205_write(trial->machine, address, image_of(address), 1);
    }
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        c205_set_register(trial->machine, i, trial->program->registers[i]);
}

static void begin_trial(struct trial *trial)
{
    struct reference *reference = &trial->reference;

    reference_begin(reference);
    for (size_t i = 0; i < PAGES; i++) {
        plain_map(&reference->memory,
                  pages[i].number * C205_PAGE_WORDS * WORD, C205_PAGE_WORDS,
                  pages[i].access);
        memset(images[i], 0, C205_PAGE_WORDS * sizeof **images);
    }
    put_data(trial);
    put_code(trial);
    reference->now.pc = trial->program->code;
    memcpy(reference->now.registers, trial->program->registers,
           sizeof reference->now.registers);
    trial->machine = machines[trial->program->model];
    reference_clock_begin(&trial->clock, models[trial->program->model]);
    reference_clock_enter(&trial->clock, trial->program->code);
    load_machine(trial);
}

/* ---- Differences ------------------------------------------------------- */

static void differ(struct trial *trial, const char *format, ...)
{
    struct difference *difference = trial->difference;
    va_list arguments;

    va_start(arguments, format);
    if (difference->count < DIFFERENCES)
        vsnprintf(difference->texts[difference->count], DIFFERENCE_TEXT,
                  format, arguments);
    va_end(arguments);
    difference->count++;
}

static void compare_words(struct trial *trial, const char *what,
                          uint64_t number, c205_word machine,
                          c205_word reference)
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
                  state->flags);
    compare_words(trial, "program counter", 0, c205_pc(trial->machine),
                  state->pc);
}

static void compare_memory(struct trial *trial, uint64_t address,
                           const c205_word *image, size_t count)
{
    c205_read(trial->machine, address, scratch, count);
    if (memcmp(scratch, image, count * sizeof *scratch) == 0)
        return;
    for (size_t i = 0; i < count; i++)
        compare_words(trial, "address", address + WORD * i, scratch[i],
                      image[i]);
}

static size_t at_most(size_t count, size_t limit)
{
    return count < limit ? count : limit;
}

/* The words of an area and those around it, as far as there are pages. */
static void compare_area(struct trial *trial, const struct random_area *area)
{
    const uint64_t margin = WORD * MARGIN;
    uint64_t address = image_of(area->address - margin)
                           ? area->address - margin
                           : area->address;
    const uint64_t end = area->address + WORD * area->words + margin;

    while (address < end && image_of(address)) {
        const size_t in_page = C205_PAGE_WORDS
                               - address / WORD % C205_PAGE_WORDS;
        const size_t count = at_most((size_t)(end - address) / WORD, in_page);
        compare_memory(trial, address, image_of(address), count);
        address += WORD * count;
    }
}

/* What the reference stored goes into the images. */
static void follow_changes(struct trial *trial)
{
    const struct plain_memory *memory = &trial->reference.memory;

    for (size_t i = 0; i < memory->change_count; i++) {
        const uint64_t address = memory->changes[i].address;
        *image_of(address) = plain_read(memory, address);
        compare_memory(trial, address, image_of(address), 1);
    }
}

static void compare_states(struct trial *trial)
{
    compare_registers(trial);
    follow_changes(trial);
    for (size_t i = 0; i < random_area_count; i++)
        compare_area(trial, random_areas + i);
}

static void compare_all_memory(struct trial *trial)
{
    for (size_t i = 0; i < PAGES; i++)
        compare_memory(trial, pages[i].number * C205_PAGE_WORDS * WORD,
                       images[i], C205_PAGE_WORDS);
}

/* ---- Clocks ------------------------------------------------------------ */

static size_t region_of(const struct trial *trial, uint64_t pc)
{
    return pc >= trial->program->code && pc < region_end(trial->program);
}

static void compare_account(struct trial *trial, size_t region,
                            const c205_account *account)
{
    char what[DIFFERENCE_TEXT];

    for (int i = 0; i < C205_CAUSES; i++) {
        snprintf(what, sizeof what, "clocks of %s in region",
                 c205_cause_name((c205_cause)i));
        compare_words(trial, what, region, account->clocks[i],
                      trial->clock.charged[region][i]);
    }
}

static void compare_clocks(struct trial *trial)
{
    for (size_t i = 0; i < c205_account_count(trial->machine); i++) {
        const c205_account *account = c205_account_at(trial->machine, i);
        compare_account(trial, account->name[0] != '\0', account);
    }
    compare_words(trial, "clock", 0, c205_clock(trial->machine),
                  trial->clock.now);
}

/* ---- Traps ------------------------------------------------------------- */

/* Traps that name the address at fault; of what is misaligned that may be the
 * beginning. */
static bool names_address(c205_trap trap)
{
    return trap == C205_TRAP_UNMAPPED_ADDRESS
           || trap == C205_TRAP_PROTECTED_ADDRESS;
}

static bool has_fault(const struct reference *reference,
                      const c205_stop *stop)
{
    if (names_address(stop->trap))
        return reference_has_fault(reference, stop->trap, stop->address);
    return reference->faults[stop->trap].possible;
}

static void differ_in_faults(struct trial *trial, const c205_stop *stop)
{
    differ(trial, "machine: trap %s, address %llX",
           c205_trap_name(stop->trap), (unsigned long long)stop->address);
    for (int i = 0; i < C205_TRAPS; i++) {
        const struct fault *fault = trial->reference.faults + i;
        if (fault->possible)
            differ(trial, "reference: %s %s, address %llX to %llX",
                   fault->certain ? "trap" : "possible trap",
                   c205_trap_name((c205_trap)i),
                   (unsigned long long)fault->low,
                   (unsigned long long)fault->high);
    }
}

/* A trapped instruction is skipped, so that the program goes on.  False: it
 * cannot. */
static bool skip(struct trial *trial)
{
    const struct deed *deed = &trial->reference.deed;
    const unsigned halves = deed->insn_count > 0
                                ? c205_format_halves(deed->insns[0]->format)
                                : 1;

    trial->reference.now.pc = plain_address(deed->pc + HALF * halves);
    c205_set_pc(trial->machine, trial->reference.now.pc);
    reference_clock_enter(&trial->clock, trial->reference.now.pc);
    return image_of(deed->pc) != NULL;
}

/* True: go on. */
static bool after_trap(struct trial *trial, bool done, const c205_stop *stop)
{
    if (!has_fault(&trial->reference, stop)) {
        differ_in_faults(trial, stop);
        return false;
    }
    if (done)
        reference_undo(&trial->reference);
    compare_states(trial);
    reference_clock_drain(&trial->clock);
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
    compare_states(trial);
    reference_clock_step(&trial->clock, &reference->deed,
                         region_of(trial, reference->deed.pc));
    if (reference->ended)
        reference_clock_drain(&trial->clock);
    compare_clocks(trial);
    return goes_on;
}

static c205_word word_at(const struct trial *trial, uint64_t address)
{
    const c205_word first = plain_read(&trial->reference.memory,
                                       address / WORD * WORD);
    const c205_word second = plain_read(&trial->reference.memory,
                                        address / WORD * WORD + WORD);

    return address % WORD == 0 ? first : first << HALF | second >> HALF;
}

bool compare_run(const struct random_program *program,
                 struct difference *difference)
{
    struct trial trial = { .program = program, .difference = difference };
    bool goes_on = true;

    *difference = (struct difference){ .count = 0 };
    begin_trial(&trial);
    while (goes_on && difference->step < STEPS && difference->count == 0) {
        difference->pc = trial.reference.now.pc;
        difference->word = word_at(&trial, difference->pc);
        goes_on = step_both(&trial);
        difference->step++;
    }
    if (difference->count == 0 && !trial.reference.lost)
        compare_all_memory(&trial);
    reference_end(&trial.reference);
    return difference->count == 0;
}

/* ---- Printing ---------------------------------------------------------- */

static void print_insn(uint64_t address, c205_word word)
{
    char text[DISASSEMBLE_TEXT_SIZE];

    disassemble_one(word, address, text);
    printf("        %-40s ; %llX: %016llX\n", text,
           (unsigned long long)address, (unsigned long long)word);
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
           program->plain_data ? "all numbers one" : "data by chance",
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
