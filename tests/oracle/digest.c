/* digest.c - computes one hash of the results of a set of programs.
 *
 *   digest [-v] [-n PROGRAMS] FILE ..
 *
 * Runs the program texts and PROGRAMS random programs, each up to a limit of clocks.
 * Prints a hash of the complete states of the machines: registers, memory, clock,
 * accounts and operations in flight.  The hash must not depend on the compiler or the
 * host; tests/check_hosts.sh fails if it does.  -v also prints a line for each program.
 */
#include "asm/text/assemble.h"
#include "base/sink.h"
#include "tests/oracle/random_machine.h"
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

static void take(struct digest *digest, const c205 *machine, const char *name)
{
    uint64_t hash = machine_hash(machine);
    digest->hash = hash_word(digest->hash, hash);
    digest->count++;
    if (digest->verbose)
        printf("%016llX %s\n", (unsigned long long)hash, name);
}

/* ---- Program texts ------------------------------------------------------ */

static void run_text(struct digest *digest, const c205_model *model, const char *path)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct sink sink = stream_sink(stderr);
    SCOPED(object) *object = assemble_file(path, NULL, &errors);
    SCOPED(c205) *machine = c205_new(model, &last_error);
    diagnostics_put(&errors, &sink);
    need(object && machine && c205_load(machine, &object->program, &last_error));
    c205_run(machine, CLOCKS);
    take(digest, machine, path);
}

static void run_texts(struct digest *digest, char **paths)
{
    SCOPED(c205_model) *model = NEEDED(
        c205_model_find("cyber205-2pipe-prior", &last_error));
    for (; *paths; paths++)
        run_text(digest, model, *paths);
}

/* ---- Random programs ---------------------------------------------------- */

/* Runs a program. An instruction that traps is skipped; the program continues. */
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

static void run_randoms(struct digest *digest, unsigned long count)
{
    random_machines_begin();
    for (unsigned long i = 0; i < count; i++) {
        struct random_program program = random_program(FIRST_SEED + i);
        c205 *machine = random_machine_load(&program);
        char name[40];
        run_on(machine);
        snprintf(name, sizeof name, "seed %llu", (unsigned long long)program.seed);
        take(digest, machine, name);
    }
    random_machines_end();
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
