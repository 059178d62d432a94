/* check_random.c - compares random programs on the machine and on the reference.
 *
 *     check_random [programs] [--seed N] [--first]
 *
 * Both run each program instruction by instruction.  After each instruction the
 * registers, data flags, program counter, trap, clock and accounts must be equal, and
 * also the words in and around all data areas if the instruction may have stored some;
 * at the end all of memory.  Some programs are also run in other modes (other_ways.h).
 * A program that fails is reduced and printed; with --first the run ends there without
 * reducing it.
 */
#include "tests/oracle/compare_states.h"
#include "tests/oracle/read_number.h"
#include "tests/oracle/shrink_program.h"

#include "tests/oracle/arithmetic_oracle.h"

#include <getopt.h>
#include <stdio.h>

struct run {
    uint64_t seed, programs;
    bool first; /* stop at the first difference, do not reduce it */
    uint64_t passed, failed;
};

enum { ENOUGH_FAILURES = 5 };

static void report(const struct random_program *program)
{
    struct difference difference;
    compare_run(program, &difference);
    print_program(program);
    print_difference(&difference);
}

static void check_one(struct run *run, uint64_t seed)
{
    struct random_program program = random_program(seed);
    struct difference difference;
    if (compare_run(&program, &difference)) {
        run->passed++;
        return;
    }
    run->failed++;
    if (run->first) {
        print_difference(&difference);
        return;
    }
    shrink_program(&program);
    report(&program);
}

/* Fails for each row of the instruction table without a rule in the reference. */
static void check_rules(struct run *run)
{
    for (size_t i = 0; i < c205_insn_count; i++)
        if (!reference_knows(c205_insns + i)) {
            printf("%s: the reference has no rule for it\n", c205_insns[i].mnemonic);
            run->failed++;
        }
}

static bool read_arguments(struct run *run, int argc, char **argv)
{
    static const struct option options[] = {
        { "seed", required_argument, NULL, 's' },
        { "first", no_argument, NULL, 'f' },
        { NULL, 0, NULL, 0 },
    };
    for (int c; (c = getopt_long(argc, argv, "", options, NULL)) != -1;)
        if (c == 'f')
            run->first = true;
        else if (c != 's' || !read_number(optarg, &run->seed))
            return false;
    if (optind < argc && !read_number(argv[optind++], &run->programs))
        return false;
    return optind == argc;
}

int main(int argc, char **argv)
{
    struct run run = { .seed = 205, .programs = 2000 };
    if (!read_arguments(&run, argc, argv)) {
        fprintf(stderr, "usage: check_random [programs] [--seed N] "
                        "[--first]\n");
        return 2;
    }
    uint64_t enough = run.first ? 1 : ENOUGH_FAILURES;
    oracle_begin();
    compare_begin();
    for (uint64_t i = 0; i < run.programs && run.failed < enough; i++)
        check_one(&run, run.seed + i);
    check_rules(&run);
    compare_end();
    oracle_end();
    printf("%llu passed, %llu failed\n", (unsigned long long)run.passed,
           (unsigned long long)run.failed);
    return run.failed == 0 ? 0 : 1;
}
