/* test_event_changes.c - the changes that an event reports, and stops, are compared
 * with the machine before and after each step of random programs, with and without a
 * listener, forwards and backwards. A store that is not reported, or a stop that is
 * missed, fails here. */
#include <inttypes.h>

#include "tests/unit/draw.h"
#include "tests/unit/saved_machine.h"

enum { PROGRAMS = 120, MAX_STEPS = 300, STOPPED = 60, PLACES = 3 };

/* ---- Changes ------------------------------------------------------------- */

/* All state that a program can change. */
struct contents {
    c205_word registers[C205_REGISTERS];
    c205_word *words[16];
};

static void take(struct contents *contents, const c205 *machine)
{
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        contents->registers[i] = c205_register(machine, i);
    for (size_t i = 0; i < random_area_count; i++) {
        const struct random_area *area = &random_areas[i];
        if (!contents->words[i])
            contents->words[i] = calloc(area->words, sizeof(c205_word));
        assert_true(c205_read(machine, area->address, contents->words[i], area->words));
    }
}

static void contents_free(struct contents *contents)
{
    for (size_t i = 0; i < random_area_count; i++)
        free(contents->words[i]);
}

static bool is_reported(const c205_event *event, uint64_t address)
{
    for (size_t i = 0; i < event->store_count; i++)
        if (event->store[i].address < address + 64
            && address < event->store[i].address + event->store[i].bits)
            return true;
    return false;
}

static void compare(const struct contents *before, const struct contents *after,
                    const c205_event *event)
{
    for (unsigned i = 1; i < C205_REGISTERS; i++)
        FAIL_IF(before->registers[i] != after->registers[i]
                    && !(event->written[i / 64] >> i % 64 & 1),
                "%s at %" PRIx64 " changed r%u", event->insn->mnemonic, event->pc, i);
    for (size_t i = 0; i < random_area_count; i++)
        for (size_t k = 0; k < random_areas[i].words; k++)
            FAIL_IF(before->words[i][k] != after->words[i][k]
                        && !is_reported(event, random_areas[i].address + 64 * k),
                    "%s at %" PRIx64 " changed %" PRIx64, event->insn->mnemonic,
                    event->pc, (random_areas[i].address + 64 * k));
}

/* Returns true for stores of consecutive elements, whose range is exact. */
static bool is_dense(const c205_event *event)
{
    const c205_insn *insn = event->insn;
    return c205_unit_is_vector(insn->unit) && strchr(insn->operands, 'd')
           && strcmp(insn->mnemonic, "POLYV") != 0
           && strncmp(insn->mnemonic, "EXTV", 4) != 0
           && !strstr(insn->mnemonic, "CONV");
}

static void take_event(void *context, const c205 *machine UNUSED,
                       const c205_event *event)
{
    *(c205_event *)context = *event;
}

static void check_changes(uint64_t seed, size_t *dense)
{
    SCOPED_VALUE(contents) before = { { 0 }, { NULL } };
    SCOPED_VALUE(contents) after = { { 0 }, { NULL } };
    struct random_program program = random_program(seed);
    SCOPED(c205_model) *model = model_of(&program);
    SCOPED(c205) *machine = machine_of(&program, model);
    c205_event event;
    c205_stop stop;
    bool goes_on = true;
    assert_true(random_area_count <= 16);
    assert_true(c205_listen(machine, take_event, &event));
    take(&before, machine);
    for (int i = 0; i < MAX_STEPS && goes_on; i++) {
        struct contents other = before;
        event.kind = C205_EVENT_STOP;
        goes_on = c205_step(machine, &stop);
        if (event.kind == C205_EVENT_TRAP || event.kind == C205_EVENT_STOP)
            break;
        take(&after, machine);
        compare(&before, &after, &event);
        if (is_dense(&event) && event.elements > 0) {
            uint64_t width = event.fields.g & C205_G_HALF ? 32 : 64;
            assert_int_equal(event.store_count, 1);
            assert_int_equal(event.store[0].bits, event.elements * width);
            ++*dense;
        }
        before = after;
        after = other;
    }
}

TEST(changes)
{
    size_t dense = 0;
    for (uint64_t i = 0; i < PROGRAMS; i++)
        check_changes(RANDOM_SEED + 977 * i, &dense);
    assert_true(dense > 100);
}

/* ---- Pages --------------------------------------------------------------- */

static uint64_t constant(const c205 *machine, const char *name)
{
    return (uint64_t)c205_model_lookup(c205_machine_model(machine), name)->value;
}

/* Returns the clocks of a cause within the time of an instruction. */
static uint64_t clocks_for(const c205_times *record, c205_cause cause)
{
    uint64_t clocks = 0;
    for (size_t i = 0; i < record->phase_count; i++)
        if (record->phase[i].cause == cause)
            clocks += record->phase[i].end - record->phase[i].begin;
    for (size_t i = 0; i < record->piece_count && record->phase_count == 0; i++)
        if (record->piece[i].cause == cause && record->piece[i].pc == record->pc)
            clocks += record->piece[i].clocks;
    return clocks;
}

static void check_pages(void *context, const c205 *machine, const c205_event *event)
{
    const c205_times *record = event->record;
    uint64_t *faults = context;
    if (event->kind > C205_EVENT_REQUEST)
        return;
    assert_int_equal(record->misses * constant(machine, "translation.miss"),
                     clocks_for(record, C205_TRANSLATION_MISS));
    assert_int_equal(record->faults * constant(machine, "page_fault.clocks"),
                     clocks_for(record, C205_PAGE_FAULT));
    *faults += record->faults;
}

/* The reported number of page faults matches the clocks charged for them. */
TEST(pages)
{
    uint64_t faults = 0;
    for (uint64_t i = 0; i < PROGRAMS; i++) {
        struct random_program program = random_program(RANDOM_SEED + 41 * i);
        SCOPED(c205_model) *model = model_of(&program);
        SCOPED(c205) *machine = machine_of(&program, model);
        c205_stop stop;
        assert_true(c205_listen(machine, check_pages, &faults));
        for (int k = 0; k < MAX_STEPS && c205_step(machine, &stop); k++)
            continue;
    }
    assert_true(faults > PROGRAMS);
}

/* ---- Stops --------------------------------------------------------------- */

/* Breakpoints where a run without stops passes, and a watched range. */
struct places {
    uint64_t at[PLACES];
    uint64_t watched;
    size_t words;
};

static struct places draw_places(const struct random_program *program,
                                 c205_model *model)
{
    SCOPED(c205) *machine = machine_of(program, model);
    struct places places = { { 0 }, 0, 0 };
    c205_stop stop;
    for (size_t i = 0; i < PLACES; i++) {
        for (uint64_t k = below(20); k > 0 && c205_step(machine, &stop); k--)
            continue;
        places.at[i] = c205_pc(machine);
    }
    const struct random_area *area = &random_areas[below(random_area_count)];
    places.words = 1 + (size_t)below(area->words);
    places.watched = area->address + 64 * below(area->words - places.words + 1);
    return places;
}

static bool is_place(const struct places *places, uint64_t pc)
{
    for (size_t i = 0; i < PLACES; i++)
        if (places->at[i] == pc)
            return true;
    return false;
}

/* Finds the next stop by comparing memory after each instruction. */
static c205_trap step_to_stop(c205 *machine, const struct places *places, uint64_t most,
                              c205_stop *stop)
{
    size_t size = places->words * sizeof(c205_word);
    FREED c205_word *before = malloc(size);
    FREED c205_word *after = malloc(size);
    assert_true(c205_read(machine, places->watched, before, places->words));
    while (c205_step(machine, stop)) {
        c205_read(machine, places->watched, after, places->words);
        if (memcmp(before, after, size) != 0)
            return C205_TRAP_WATCHPOINT;
        if (is_place(places, c205_pc(machine)))
            return C205_TRAP_BREAKPOINT;
        if (--most == 0)
            return C205_TRAP_PAUSED;
    }
    return stop->trap;
}

static void pause_now(void *context, const c205 *machine UNUSED,
                      const c205_event *event)
{
    uint64_t *left = context;
    if (event->kind <= C205_EVENT_REQUEST && *left > 0 && --*left == 0)
        c205_pause((c205 *)(uintptr_t)machine);
}

/* Runs up to `most` instructions. The machine or a listener counts them. */
static c205_stop run_some(c205 *machine, uint64_t most, uint64_t *left)
{
    c205_stop stop;
    if (!left)
        return c205_run_steps(machine, most, C205_NO_LIMIT);
    *left = most;
    do { /* run in slices, which interrupt vector instructions */
        uint64_t limit = below(3) ? c205_clock(machine) + 1 + below(300)
                                  : C205_NO_LIMIT;

        stop = c205_run(machine, limit);
    } while (stop.trap == C205_TRAP_CLOCK_LIMIT);
    return stop;
}

static void check_stops(uint64_t seed, bool listens)
{
    struct random_program program = random_program(seed);
    SCOPED(c205_model) *model = model_of(&program);
    struct places places = draw_places(&program, model);
    SCOPED(c205) *machine = machine_of(&program, model);
    SCOPED(c205) *plain = machine_of(&program, model);
    uint64_t left = 0;
    for (size_t i = 0; i < PLACES; i++)
        assert_true(c205_break(machine, places.at[i], true));
    assert_true(c205_break(machine, places.at[0] + 0x100000000, true));
    assert_true(c205_break(machine, places.at[0] + 0x100000000, false));
    assert_true(c205_watch(machine, places.watched, places.words, true));
    assert_false(c205_watch(machine, UINT64_C(0xF00000000000), 1, true));
    if (listens)
        assert_true(c205_listen(machine, pause_now, &left));
    for (int i = 0; i < STOPPED; i++) {
        uint64_t most = 1 + below(30);
        c205_stop expected, stop = run_some(machine, most, listens ? &left : NULL);
        c205_trap trap = step_to_stop(plain, &places, most, &expected);
        assert_string_equal(c205_trap_name(stop.trap), c205_trap_name(trap));
        assert_int_equal(c205_pc(machine), c205_pc(plain));
        assert_int_equal(c205_clock(machine), c205_clock(plain));
        if (trap == C205_TRAP_WATCHPOINT)
            assert_int_equal(stop.address, places.watched);
        if (trap != C205_TRAP_WATCHPOINT && trap != C205_TRAP_BREAKPOINT
            && trap != C205_TRAP_PAUSED)
            break;
    }
    assert_same(machine, plain);
}

TEST(stops)
{
    for (uint64_t i = 0; i < PROGRAMS; i++)
        check_stops(RANDOM_SEED + 31 * i, i % 2 == 0);
}

/* Moves both ways with stops. A machine without history takes the same steps. */
static void check_history(uint64_t seed)
{
    enum { STEPS = 60 };
    struct random_program program = random_program(seed);
    SCOPED(c205_model) *model = model_of(&program);
    struct places places = draw_places(&program, model);
    c205 *machine = machine_of(&program, model);
    SCOPED(c205) *plain = machine_of(&program, model);
    SCOPED(c205_history) *history = NON_NULL(
        c205_history_new(machine, 1 << 20, &failure));
    uint64_t pc[STEPS + 1], steps = 0;
    c205_stop stop;
    for (size_t i = 0; i < PLACES; i++)
        assert_true(c205_break(machine, places.at[i], true));
    assert_true(c205_watch(machine, places.watched, places.words, true));
    pc[0] = c205_pc(plain);
    while (steps < STEPS && c205_step(plain, &stop)) {
        c205_history_forward(history, &stop);
        pc[++steps] = c205_pc(plain);
        assert_int_equal(c205_history_step(history), steps);
        assert_int_equal(c205_pc(c205_history_machine(history)), pc[steps]);
    }
    for (int i = 0; i < 30 && steps > 0; i++) {
        uint64_t step = below(steps + 1);
        assert_true(c205_history_back(history, step, &failure));
        while (c205_history_step(history) < step)
            c205_history_forward(history, &stop);
        assert_int_equal(c205_pc(c205_history_machine(history)), pc[step]);
        for (uint64_t k = below(10); k > 0 && c205_history_step(history) < steps; k--)
            c205_history_forward(history, &stop);
    }
}

TEST(history)
{
    for (uint64_t i = 0; i < PROGRAMS / 2; i++)
        check_history(RANDOM_SEED + 57 * i);
}
