/* digest.c - computes one hash of the results of a set of programs.
 *
 *   digest [-v] [-n PROGRAMS] FILE ..
 *
 * Runs the program texts and PROGRAMS random programs, each up to a limit of clocks,
 * and prints a hash of the complete state of each machine: registers, memory, clock,
 * accounts, operations in flight.  The hash must not depend on the compiler or the
 * host; tests/check_hosts.sh fails if it does.  -v also prints a line for each program.
 */
#include "asm/assemble.h"
#include "base/sink.h"
#include "tests/oracle/random_program.h"
#include "vm/hash.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { HALF_WORD = 32, MAX_TRAPS = 100 };
#define CLOCKS 400000
#define FIRST_SEED UINT64_C(1205)

struct digest {
    uint64_t hash;
    bool verbose;
    unsigned long count;
};

static void fail(const char *what)
{
    fprintf(stderr, "digest: %s\n", what);
    exit(2);
}

static bool hash_bytes(void *context, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    uint64_t *hash = context;
    for (size_t i = 0; i < count; i++)
        *hash = hash_word(*hash, byte[i]);
    return true;
}

static void take(struct digest *digest, const c205 *machine, const char *name)
{
    uint64_t hash = HASH_BEGIN;
    c205_error error;
    if (!c205_save(machine, hash_bytes, &hash, &error))
        fail(error.message);
    digest->hash = hash_word(digest->hash, hash);
    digest->count++;
    if (digest->verbose)
        printf("%016llX %s\n", (unsigned long long)hash, name);
}

/* ---- Program texts ------------------------------------------------------ */

static void run_text(struct digest *digest, const c205_model *model, const char *path)
{
    struct diagnostics errors = { 0 };
    struct sink sink = stream_sink(stderr);
    struct object *object = assemble_file(path, NULL, &errors);
    c205_error error = { "" };
    c205 *machine = c205_new(model, &error);
    diagnostics_put(&errors, &sink);
    if (!object || !machine || !c205_load(machine, &object->program, &error))
        fail(error.message);
    c205_run(machine, CLOCKS);
    take(digest, machine, path);
    c205_free(machine);
    object_free(object);
    diagnostics_free(&errors);
}

static void run_texts(struct digest *digest, char **paths)
{
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe-prior", &error);
    if (!model)
        fail(error.message);
    for (; *paths; paths++)
        run_text(digest, model, *paths);
    c205_model_free(model);
}

/* ---- Random programs ---------------------------------------------------- */

/* Runs a program; an instruction that traps is skipped, so that the program
 * continues. */
static void run_on(c205 *machine)
{
    for (int i = 0; i < MAX_TRAPS; i++) {
        c205_stop stop = c205_run(machine, CLOCKS);
        unsigned halves = stop.insn ? c205_format_halves(stop.insn->format) : 1;
        if (stop.trap == C205_TRAP_NONE || stop.trap == C205_TRAP_CLOCK_LIMIT)
            break;
        c205_set_pc(machine, stop.pc + HALF_WORD * halves);
    }
}

static void run_random(struct digest *digest, c205 *const *machines, uint64_t seed)
{
    struct random_program program = random_program(seed);
    c205 *machine = machines[program.model];
    c205_error error;
    char name[40];
    if (!random_load(machine, &program, &error))
        fail(error.message);
    run_on(machine);
    snprintf(name, sizeof name, "seed %llu", (unsigned long long)seed);
    take(digest, machine, name);
}

static void run_randoms(struct digest *digest, unsigned long count)
{
    c205_model **models = calloc(random_model_count, sizeof *models);
    c205 **machines = calloc(random_model_count, sizeof *machines);
    c205_error error = { "out of memory" };

    if (!models || !machines)
        fail(error.message);
    for (size_t i = 0; i < random_model_count; i++) {
        models[i] = c205_model_parse("random", random_models[i], &error);
        machines[i] = models[i] ? c205_new(models[i], &error) : NULL;
        if (!machines[i])
            fail(error.message);
    }
    for (unsigned long i = 0; i < count; i++)
        run_random(digest, machines, FIRST_SEED + i);
    for (size_t i = 0; i < random_model_count; i++) {
        c205_free(machines[i]);
        c205_model_free(models[i]);
    }
    free(machines);
    free(models);
}

int main(int argc, char **argv)
{
    struct digest digest = { HASH_BEGIN, false, 0 };
    unsigned long randoms = 0;
    for (int c; (c = getopt(argc, argv, "vn:")) != -1;)
        switch (c) {
        case 'v': digest.verbose = true; break;
        case 'n': randoms = strtoul(optarg, NULL, 0); break;
        default: return 2;
        }
    run_texts(&digest, argv + optind);
    run_randoms(&digest, randoms);
    printf("%016llX of %lu programs\n", (unsigned long long)digest.hash, digest.count);
    return 0;
}
