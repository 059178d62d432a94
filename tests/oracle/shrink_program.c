/* shrink_program.c - removes and simplifies parts of a program on which the machine and
 * the reference differ (shrink_program.h). */
#include "shrink_program.h"

#include "tests/oracle/compare_states.h"

#include <string.h>

/* Keeps the trial if the results still differ. */
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

/* Simpler words than a given one, the simplest first; the last is the word itself. */
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

void shrink_program(struct random_program *program)
{
    simpler_surroundings(program);
    while (without_insns(program))
        continue;
    while (simpler_registers(program) && without_insns(program))
        continue;
    simpler_surroundings(program);
}
