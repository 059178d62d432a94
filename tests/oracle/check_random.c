/* check_random.c - compares random programs on the machine and on the reference.
 *
 *     check_random [programs] [--seed N] [--first]
 *
 * Both run each program instruction by instruction. After each instruction the
 * registers, data flags, program counter, trap, clock and accounts must be equal. If
 * the instruction may have stored words, the words in and around all data areas must be
 * equal, too. At the end all memory must be equal. Some programs are also run in other
 * modes (random_machine.h). A failing program is reduced and printed. With --first the
 * run ends at the first failure without reducing it.
 */
#include "tests/oracle/compare_states.h"
#include "tests/oracle/read_options.h"

#include "tests/oracle/arithmetic_oracle.h"

#include <stdio.h>
#include <string.h>

/* ---- Reducing a program -------------------------------------------------- */

/* Replaces the program by the trial if the results of the trial still differ. */
static bool keep_if_differing(struct random_program *program,
                              const struct random_program *trial)
{
    struct difference difference;
    if (compare_run(trial, &difference))
        return false;
    *program = *trial;
    return true;
}

static bool without_insns(struct random_program *program)
{
    bool smaller = false;
    for (size_t i = program->insn_count; i-- > 0;) {
        struct random_program trial = *program;
        trial.insn_count--;
        memmove(trial.insns + i, trial.insns + i + 1,
                (trial.insn_count - i) * sizeof *trial.insns);
        smaller |= trial.insn_count > 0 && keep_if_differing(program, &trial);
    }
    return smaller;
}

/* Lists words that are simpler than a word, the simplest first, the word last. */
enum { SIMPLER = 6 };
static void simpler_words(c205_word word, c205_word simpler[SIMPLER])
{
    uint64_t low = word & UINT64_C(0xFFFFFFFFFFFF);
    uint64_t length = word >> 48;
    simpler[0] = 0;
    simpler[1] = C205_ONE;
    simpler[2] = UINT64_C(1) << 48 | low;
    simpler[3] = length / 2 << 48 | low;
    simpler[4] = (length > 0 ? length - 1 : 0) << 48 | low;
    simpler[5] = word;
}

static bool simpler_register(struct random_program *program, unsigned number)
{
    c205_word *word = program->registers + number;
    c205_word simpler[SIMPLER];
    simpler_words(*word, simpler);
    for (size_t i = 0; i < SIMPLER && simpler[i] != *word; i++) {
        struct random_program trial = *program;
        trial.registers[number] = simpler[i];
        if (keep_if_differing(program, &trial))
            return true;
    }
    return false;
}

static bool simpler_registers(struct random_program *program)
{
    bool simpler = false;
    for (unsigned i = 1; i < C205_REGISTERS; i++)
        while (simpler_register(program, i))
            simpler = true;
    return simpler;
}

static void simpler_surroundings(struct random_program *program)
{
    struct random_program trial = *program;
    trial.plain_data = true;
    keep_if_differing(program, &trial);
    trial = *program;
    trial.model = 0;
    keep_if_differing(program, &trial);
    trial = *program;
    trial.code = UINT64_C(0x400000);
    keep_if_differing(program, &trial);
}

/* Simplifies the program while the machine and the reference still differ. */
static void shrink_program(struct random_program *program)
{
    simpler_surroundings(program);
    while (without_insns(program))
        continue;
    while (simpler_registers(program) && without_insns(program))
        continue;
    simpler_surroundings(program);
}

/* ---- The run ------------------------------------------------------------- */

struct run {
    uint64_t seed, programs;
    bool first; /* stop at the first difference, and do not reduce it */
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

/* Each row of the instruction table that has no rule in the reference is a failure. */
static void check_rules(struct run *run)
{
    for (size_t i = 0; i < c205_insn_count; i++)
        if (!reference_knows(c205_insns + i)) {
            printf("%s: the reference has no rule for it\n", c205_insns[i].mnemonic);
            run->failed++;
        }
}

int main(int argc, char **argv)
{
    struct run run = { .seed = 205, .programs = 2000 };
    const struct check_option options[] = {
        { .name = "seed", .number = &run.seed },
        { .name = "first", .flag = &run.first },
        { .number = &run.programs },
    };
    READ_OPTIONS(argc, argv, "check_random [programs] [--seed N] [--first]", options);
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
