/* test_history.c - a machine with a history. After random jumps its state, clock and
 * accounts are compared with a run from the beginning, and the record of each
 * instruction's time with the clock. A snapshot that lacks state, or a change that is
 * lost, fails here. */
#include "tests/unit/draw.h"
#include "tests/unit/saved_machine.h"

#include "base/fnv_hash.h"

enum { PROGRAMS = 50, TARGETS = 40, MAX_STEPS = 2500, CHANGES = 2 };
/* A change of a register at a step, from outside of the program. */
struct change {
    uint64_t step;
    unsigned number;
    c205_word word;
};

struct story {
    struct random_program program;
    c205_model *model;
    size_t change_count;
    struct change change[CHANGES]; /* sorted by step */
    uint64_t steps_before, steps;  /* least number of steps, without and with the
                                    * changes */
    uint64_t target[TARGETS], hash[TARGETS];
};

static bool add_to_hash(void *context, const void *bytes, size_t count)
{
    uint64_t *hash = context;
    *hash = hash_bytes(*hash, bytes, count);
    return true;
}

static uint64_t hash_of(const c205 *machine)
{
    uint64_t hash = HASH_START;
    assert_true(c205_save(machine, add_to_hash, &hash, &failure));
    return hash;
}

static bool change_at(const struct story *story, c205 *machine, uint64_t step)
{
    bool changed = false;
    for (size_t i = 0; i < story->change_count; i++)
        if (story->change[i].step == step) {
            c205_set_register(machine, story->change[i].number, story->change[i].word);
            changed = true;
        }
    return changed;
}

/* Runs the story from the beginning. Returns its number of steps. If `hashes` is set,
 * also records the state at each target step. */
static uint64_t run_plainly(struct story *story, bool hashes)
{
    SCOPED(c205) *machine = machine_of(&story->program, story->model);
    uint64_t step = 0;
    c205_stop stop;
    bool goes_on = true;
    while (goes_on) {
        change_at(story, machine, step);
        for (size_t i = 0; hashes && i < TARGETS; i++)
            if (story->target[i] == step)
                story->hash[i] = hash_of(machine);
        goes_on = step < MAX_STEPS && c205_step(machine, &stop);
        step += goes_on;
    }
    return step;
}

/* ---- Jumps ---------------------------------------------------------------- */

static void go_on_to(c205_history *history, uint64_t step)
{
    c205_stop stop;
    while (c205_history_step(history) < step)
        assert_true(c205_history_forward(history, &stop));
}

TEST(jumps)
{
    const char *wanted = getenv("HISTORY_JUMPS");
    size_t jumps = wanted ? (size_t)strtoul(wanted, NULL, 10) : 100;
    struct story story;
    for (size_t number = 0; number < PROGRAMS; number++) {
        uint64_t seed = RANDOM_SEED + (number << 16);
        story = (struct story){ .program = random_program(seed) };
        while (number % 2 == 1 && !story.program.loop) /* every second program has a
                                                        * loop */
            story.program = random_program(++seed);
        story.model = model_of(&story.program);
        story.steps_before = story.steps = run_plainly(&story, false);
        story.change_count = number % (CHANGES + 1);
        for (size_t k = 0; k < story.change_count; k++)
            story.change[k] = (struct change){ below((size_t)story.steps + 1),
                                               1 + (unsigned)below(255),
                                               xorshift(&random_state) };
        story.steps = run_plainly(&story, false);
        for (size_t k = 0; k < TARGETS; k++)
            story.target[k] = below((size_t)story.steps + 1);
        run_plainly(&story, true);
        SCOPED(c205_model) *model = story.model;
        SCOPED(c205_history) *history = NON_NULL(
            c205_history_new(machine_of(&story.program, story.model),
                             below(2) * below(1 << 20), &failure));
        /* In half of the stories the history first moves to the end of the unchanged
         * run, before a trap, and back. Then all changes are applied. */
        if (below(2)) {
            go_on_to(history, story.steps_before);
            assert_true(c205_history_back(history, 0, &failure));
        }
        for (uint64_t step = 0; step <= story.steps; step++) {
            go_on_to(history, step);
            if (change_at(&story, c205_history_machine(history), step))
                assert_true(c205_history_changed(history, &failure));
        }
        for (size_t i = 0; i < jumps; i++) {
            size_t target = below(TARGETS);
            uint64_t step = story.target[target];
            if (step < c205_history_step(history))
                assert_true(c205_history_back(history, step, &failure));
            else
                go_on_to(history, step);
            assert_int_equal(c205_history_step(history), step);
            FAIL_IF(hash_of(c205_history_machine(history)) != story.hash[target],
                    "seed %llu: step %llu is another one",
                    (unsigned long long)story.program.seed, (unsigned long long)step);
        }
        assert_true(story.change_count == 0
                    || c205_history_known(history) == story.steps);
    }
}

/* ---- The end -------------------------------------------------------------- */

/* A program that has ended does not continue, but can move backwards. */
TEST(end)
{
    SCOPED(c205_model) *model = c205_model_find(C205_DEFAULT_MODEL, &failure);
    c205 *machine = machine_from("asm/examples/dot.s", model);
    SCOPED(c205_history) *history = c205_history_new(machine, 1 << 20, &failure);
    c205_stop stop, again;
    uint64_t end, clock;
    while (c205_history_forward(history, &stop))
        continue;
    assert_int_equal(stop.trap, C205_TRAP_NONE);
    end = c205_history_step(history);
    clock = c205_clock(c205_history_machine(history));
    assert_false(c205_history_forward(history, &again));
    assert_same_stop(&stop, &again);
    assert_int_equal(c205_history_step(history), end);
    assert_true(c205_history_back(history, end - 2, &failure));
    assert_true(c205_history_forward(history, &again));
    assert_false(c205_history_forward(history, &again));
    assert_same_stop(&stop, &again);
    assert_int_equal(c205_clock(c205_history_machine(history)), clock);
}

/* ---- Times ---------------------------------------------------------------- */

static uint64_t vectors; /* number of vector instructions of all runs */

struct heard {
    uint64_t clock;
    uint64_t sums[64][C205_CAUSES]; /* sums of all pieces, for each region and cause */
};

static uint64_t constant_of(const c205 *machine, const char *kind,
                            const c205_insn *insn)
{
    const char *name = formatted("%s.%s", kind, c205_timing_name(insn->timing));
    const c205_constant *constant = NON_NULL(
        c205_model_lookup(c205_machine_model(machine), name));
    return (uint64_t)constant->value;
}

static void hear(void *context, const c205 *machine, const c205_event *event)
{
    struct heard *heard = context;
    const c205_times *times = event->record;
    uint64_t sum = 0;
    for (size_t i = 0; i < times->piece_count; i++) {
        const c205_piece *piece = &times->piece[i];
        assert_true(piece->clocks > 0);
        sum += piece->clocks;
        heard->sums[piece->region][piece->cause] += piece->clocks;
    }
    assert_int_equal(sum, event->clocks);
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST)
        return;
    assert_int_equal(times->arrived, heard->clock);
    assert_int_equal(times->issued, event->issued);
    assert_in_range(times->issued, times->arrived, times->arrived + event->clocks);
    assert_true(times->ready >= times->issued && times->unit_free >= times->issued);
    if (c205_unit_is_vector(event->insn->unit)) {
        /* Phases must be adjacent, from the issue to the result. */
        uint64_t at = times->issued;
        for (size_t i = 0; i < times->phase_count; at = times->phase[i++].end) {
            assert_int_equal(times->phase[i].begin, at);
            assert_true(times->phase[i].end > at);
        }
        assert_int_equal(at, times->ready);
        vectors++;
    } else {
        /* SWAP takes longer than its constant. */
        uint64_t ready = times->issued + constant_of(machine, "latency", event->insn);
        assert_int_equal(times->phase_count, 0);
        assert_true(event->insn->timing == C205_TIMING_swap ? times->ready >= ready
                                                            : times->ready == ready);
        assert_int_equal(times->unit_free,
                         times->issued + constant_of(machine, "busy", event->insn));
    }
    heard->clock += event->clocks;
}

/* Runs a machine to its end. Results in flight at the end belong to no instruction. The
 * sums of all pieces must equal the accounts. */
static void check_times(c205 *machine)
{
    struct heard heard = { 0 };
    c205_stop stop;
    assert_true(c205_listen(machine, hear, &heard));
    for (size_t i = 0; i < 20000 && c205_step(machine, &stop); i++) {
        assert_int_equal(c205_clock(machine), heard.clock);
        if (i % 64 != 0)
            continue;
        for (size_t k = 0; k < c205_account_count(machine); k++)
            assert_memory_equal(c205_account_at(machine, k)->clocks, heard.sums[k],
                                sizeof heard.sums[k]);
    }
    c205_free(machine);
}

static void check_program(const char *path)
{
    SCOPED(c205_model) *model = c205_model_find(C205_DEFAULT_MODEL, &failure);
    check_times(machine_from(path, model));
}

TEST(times)
{
    each_file("asm/examples/*.s", check_program);
    check_program("tests/programs/swap.s");
    for (size_t number = 0; number < 400; number++) {
        struct random_program program = random_program(RANDOM_SEED ^ number << 20);
        SCOPED(c205_model) *own_model = model_of(&program);
        check_times(machine_of(&program, own_model));
    }
    assert_true(vectors > 1000);
}

/* ---- Pages ---------------------------------------------------------------- */

TEST(pages)
{
    struct random_program program = random_program(RANDOM_SEED);
    SCOPED(c205_model) *model = c205_model_find(C205_DEFAULT_MODEL, &failure);
    SCOPED(c205) *machine = machine_of(&program, model);
    c205_page page = { 0 };
    uint64_t from = 0;
    size_t count = 0;
    while (c205_next_page(machine, from, &page)) {
        bool known = false;
        for (size_t i = 0; i < RANDOM_PAGES; i++)
            known |= random_pages[i].address == page.address
                     && (random_pages[i].access != C205_READ_ONLY) == page.writable;
        assert_true(known);
        from = page.address + UINT64_C(64) * C205_PAGE_WORDS;
        count++;
    }
    assert_int_equal(count, RANDOM_PAGES);
}
