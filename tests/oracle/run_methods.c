/* run_methods.c - runs a program whole, in slices, restored, and in other modes. */
#include "tests/oracle/operands.h"
#include "tests/oracle/random_machine.h"

#include <stdlib.h>
#include <string.h>

enum {
    HALF = 32,
    CLOCKS = 6000, /* limit for a program that may run forever */
    TRAPS = 120,
    LONGEST_SLICE = 150,
    ONE_SAVED_IN = 40,
    ONE_HEARD_IN = 10
};

/* ---- Saved and restored ------------------------------------------------ */

struct bytes {
    unsigned char *bytes;
    size_t count, room;
};

static bool keep_bytes(void *context, const void *bytes, size_t count)
{
    struct bytes *kept = context;
    if (kept->room - kept->count < count) {
        kept->room = 2 * kept->room + count;
        kept->bytes = plain_room(kept->bytes, kept->room, 1);
    }
    memcpy(kept->bytes + kept->count, bytes, count);
    kept->count += count;
    return true;
}

/* Returns a machine restored from the saved state of another one. */
static c205 *copy_machine(const c205 *machine)
{
    struct bytes kept = { NULL, 0, 0 };
    random_machine_save(machine, keep_bytes, &kept);
    c205 *copy = NEEDED(
        c205_restore(kept.bytes, kept.count, c205_machine_model(machine), &last_error));
    free(kept.bytes);
    return copy;
}

/* ---- Running ----------------------------------------------------------- */

struct way {
    const char *name;
    bool sliced, saved, heard;
};

struct run {
    const struct way *way;
    c205 *machine;
    bool restored; /* the run owns the machine */
    uint64_t random, limit;
    unsigned traps;
};

static void change_machine(struct run *run)
{
    c205 *copy = copy_machine(run->machine);
    if (run->restored)
        c205_free(run->machine);
    run->machine = copy;
    run->restored = true;
}

static void ignore_events(void *context UNUSED, const c205 *machine UNUSED,
                          const c205_event *event UNUSED)
{
}

/* Listeners cannot be removed from reused machines, so a copy gets the listener. */
static void listen(struct run *run)
{
    change_machine(run);
    c205_listen(run->machine, ignore_events, NULL);
}

static uint64_t next_limit(struct run *run)
{
    uint64_t end = c205_clock(run->machine)
                   + (uint64_t)random_between(&run->random, 1, LONGEST_SLICE);
    return run->way->sliced && end < run->limit ? end : run->limit;
}

/* Skips an instruction that has trapped. Returns false if the run ends. */
static bool skip(struct run *run, const c205_stop *stop)
{
    unsigned halves = random_insn_halves(run->machine, stop->pc);
    c205_set_pc(run->machine, stop->pc + HALF * halves);
    return halves != 0 && ++run->traps < TRAPS;
}

/* Runs one slice. Returns false if it is the last slice. */
static bool run_on(struct run *run)
{
    c205_stop stop = c205_run(run->machine, next_limit(run));
    if (stop.trap == C205_TRAP_NONE)
        return false;
    if (stop.trap != C205_TRAP_CLOCK_LIMIT)
        return skip(run, &stop);
    if (run->way->saved && random_between(&run->random, 1, ONE_SAVED_IN) == 1)
        change_machine(run);
    if (run->way->heard && random_between(&run->random, 1, ONE_HEARD_IN) == 1)
        listen(run);
    else if (run->way->heard && random_between(&run->random, 1, ONE_HEARD_IN) == 1)
        change_machine(run);
    return c205_clock(run->machine) < run->limit;
}

static uint64_t hash_at_end(const struct random_program *program, const struct way *way,
                            uint64_t limit)
{
    struct run run = { .way = way,
                       .machine = random_machine_load(program),
                       .random = program->seed,
                       .limit = limit };
    if (way->heard && !way->sliced)
        listen(&run);
    while (run_on(&run))
        continue;
    uint64_t hash = machine_hash(run.machine);
    if (run.restored)
        c205_free(run.machine);
    return hash;
}

/* Runs the program on shared pages, whose contents must not change. */
static const char *disagreeing_share(const struct random_program *program,
                                     uint64_t limit, uint64_t expected)
{
    const struct way way = { "a run of shared pages", program->insn_count % 3 == 0,
                             false, false };
    struct random_shared shared;
    uint64_t before, hash;
    struct run run = { .way = &way, .random = program->seed, .limit = limit };
    run.machine = random_machine_load_shared(program, &shared);
    before = random_shared_hash(run.machine, &shared);
    random_shared_free(&shared);
    run.machine = random_machine_load_shared(program, &shared);
    while (run_on(&run))
        continue;
    hash = machine_hash(run.machine);
    before ^= random_shared_hash(run.machine, &shared);
    random_machine_load(program);
    random_shared_free(&shared);
    return hash != expected ? way.name
           : before != 0    ? "a program that writes to pages of others"
                            : NULL;
}

const char *disagreeing_way(const struct random_program *program,
                            const uint64_t *stepped)
{
    static const struct way whole = { "a whole run", false, false, false };
    static const struct way others[] = {
        { "a run in slices", true, false, false },
        { "a run saved and restored", true, true, false },
        { "a run with a listener", false, false, true },
        { "a run with a listener now and then", true, false, true },
    };
    uint64_t limit = stepped ? C205_NO_LIMIT : CLOCKS;
    uint64_t expected = hash_at_end(program, &whole, limit);
    if (stepped && *stepped != expected)
        return whole.name;
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (hash_at_end(program, others + i, limit) != expected)
            return others[i].name;
    return disagreeing_share(program, limit, expected);
}
