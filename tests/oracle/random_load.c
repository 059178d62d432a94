/* random_load.c - a random program into a machine. */
#include "random_parts.h"

#include <string.h>

enum {
    CODE_WORDS = PROGRAM_INSNS + 2,
    AREA_MOST = 4096 /* words, more than any area has */
};

/* Long instructions may begin in the middle of a word. */
static void put_code(c205 *machine, const struct random_program *program)
{
    uint64_t begin = program->code / WORD * WORD;
    c205_word code[CODE_WORDS] = { 0 };

    for (size_t i = 0; i < program->insn_count; i++) {
        uint64_t at = program_address(program, i) - begin;
        for (unsigned k = 0; k < program->insns[i].halves; k++) {
            size_t half = (size_t)(at / HALF) + k;
            c205_word bits = program->insns[i].word >> (k == 0 ? HALF : 0)
                             & UINT32_MAX;
            code[half / 2] |= bits << (half % 2 == 0 ? HALF : 0);
        }
    }
    c205_write(machine, begin, code, CODE_WORDS);
}

static void put_data(c205 *machine, const struct random_program *program)
{
    c205_word words[AREA_MOST];

    for (size_t i = 0; i < random_area_count; i++) {
        program_data(program, random_areas + i, words);
        c205_write(machine, random_areas[i].address, words,
                   random_areas[i].words);
    }
}

uint64_t random_region_end(const struct random_program *program)
{
    return program_address(program, (program->insn_count + 1) / 2);
}

bool random_load(c205 *machine, const struct random_program *program,
                 c205_error *error)
{
    const c205_segment page = { random_pages[0].address, 1, NULL };
    const c205_region region = { "first", program->code,
                                 random_region_end(program) };
    const c205_program empty = { program->code, 1, &page, 1, &region, false };

    if (!c205_load(machine, &empty, error))
        return false;
    for (size_t i = 0; i < RANDOM_PAGES; i++)
        if (!c205_map(machine, random_pages[i].address, C205_PAGE_WORDS,
                      random_pages[i].access, error))
            return false;
    put_data(machine, program);
    put_code(machine, program);
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        c205_set_register(machine, i, program->registers[i]);
    return true;
}
