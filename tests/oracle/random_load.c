/* random_load.c - loads a random program into a machine. */
#include "random_parts.h"

#include "tests/oracle/give_up.h"

#include <string.h>

enum {
    CODE_WORDS = PROGRAM_INSNS + 2,
    MAX_AREA = 4096 /* number of words, more than any area has */
};

/* Writes the instructions. Long instructions may start in the middle of a word. */
static void put_code(c205 *machine, const struct random_program *program)
{
    uint64_t begin = program->code / WORD * WORD;
    c205_word code[CODE_WORDS] = { 0 };
    for (size_t i = 0; i < program->insn_count; i++) {
        uint64_t at = program_address(program, i) - begin;
        for (unsigned k = 0; k < program->insns[i].halves; k++) {
            size_t half = (size_t)(at / HALF) + k;
            c205_word bits = program->insns[i].word >> (k == 0 ? HALF : 0) & UINT32_MAX;
            code[half / 2] |= bits << (half % 2 == 0 ? HALF : 0);
        }
    }
    c205_write(machine, begin, code, CODE_WORDS);
}

/* Writes the data. If `all` is true, also writes the data of writable areas. */
static void put_data(c205 *machine, const struct random_program *program, bool all)
{
    c205_word words[MAX_AREA];
    for (size_t i = 0; i < random_area_count; i++)
        if (all || random_areas[i].access != C205_READ_WRITE) {
            program_data(program, random_areas + i, words);
            c205_write(machine, random_areas[i].address, words, random_areas[i].words);
        }
}

uint64_t random_region_end(const struct random_program *program)
{
    return program_address(program, (program->insn_count + 1) / 2);
}

static bool load_nothing(c205 *machine, const struct random_program *program,
                         c205_error *error)
{
    const c205_region region = { "first", program->code, random_region_end(program) };
    const c205_program empty = { program->code, 0, NULL, 1, &region, false };
    return c205_load(machine, &empty, error);
}

static void put_registers(c205 *machine, const struct random_program *program)
{
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        c205_set_register(machine, i, program->registers[i]);
}

static bool map_page(c205 *machine, size_t i, c205_error *error)
{
    return c205_map(machine, random_pages[i].address, C205_PAGE_WORDS,
                    random_pages[i].access, error);
}

bool random_load(c205 *machine, const struct random_program *program, c205_error *error)
{
    if (!load_nothing(machine, program, error))
        return false;
    for (size_t i = 0; i < RANDOM_PAGES; i++)
        if (!map_page(machine, i, error))
            return false;
    put_data(machine, program, true);
    put_code(machine, program);
    put_registers(machine, program);
    return true;
}

/* ---- Shared pages ---------------------------------------------------------- */

void random_load_shared(c205 *machine, const struct random_program *program,
                        struct random_shared *shared)
{
    static c205_word words[C205_PAGE_WORDS];
    bool good = random_load(machine, program, &last_error);
    for (size_t i = 0; i < RANDOM_PAGES; i++) {
        bool writable = random_pages[i].access == C205_READ_WRITE;
        good = good
               && c205_read(machine, random_pages[i].address, words, C205_PAGE_WORDS);
        shared->page[i] = good && writable ? c205_shared_new(words, C205_PAGE_WORDS)
                                           : NULL;
        good = good && (!writable || shared->page[i]);
    }
    good = good && load_nothing(machine, program, &last_error);
    for (size_t i = 0; good && i < RANDOM_PAGES; i++)
        good = shared->page[i] ? c205_map_shared(machine, random_pages[i].address,
                                                 shared->page[i], &last_error)
                               : map_page(machine, i, &last_error);
    need(good);
    put_data(machine, program, false);
    put_registers(machine, program);
}

void random_shared_free(struct random_shared *shared)
{
    for (size_t i = 0; i < RANDOM_PAGES; i++)
        c205_shared_free(shared->page[i]);
}
