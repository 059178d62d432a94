/* random_machine.c - machines loaded with random programs. */
#include "random_machine.h"

#include "vm/hash.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORD = 64 };

static c205 **machines; /* one machine for each model */
static c205_model **models;

/* ---- Begin and end ----------------------------------------------------- */

void random_machines_begin(void)
{
    models = plain_room(NULL, random_model_count, sizeof *models);
    machines = plain_room(NULL, random_model_count, sizeof *machines);
    for (size_t i = 0; i < random_model_count; i++) {
        models[i] = NEEDED(c205_model_parse("random", random_models[i], &last_error));
        machines[i] = NEEDED(c205_new(models[i], &last_error));
    }
}

void random_machines_end(void)
{
    for (size_t i = 0; i < random_model_count; i++) {
        c205_free(machines[i]);
        c205_model_free(models[i]);
    }
    free(machines);
    free(models);
}

c205 *random_machine_load(const struct random_program *program)
{
    c205 *machine = machines[program->model];
    need(random_load(machine, program, &last_error));
    return machine;
}

c205 *random_machine_load_shared(const struct random_program *program,
                                 struct random_shared *shared)
{
    random_load_shared(machines[program->model], program, shared);
    return machines[program->model];
}

uint64_t random_shared_hash(c205 *machine, const struct random_shared *shared)
{
    static const c205_program nothing = { 0, 0, NULL, 0, NULL, false };
    static c205_word words[C205_PAGE_WORDS];
    uint64_t hash = HASH_BEGIN;
    for (size_t i = 0; i < RANDOM_PAGES; i++) {
        uint64_t address = random_pages[i].address;
        if (!shared->page[i])
            continue;
        need(c205_load(machine, &nothing, &last_error)
             && c205_map_shared(machine, address, shared->page[i], &last_error)
             && c205_read(machine, address, words, C205_PAGE_WORDS));
        for (size_t k = 0; k < C205_PAGE_WORDS; k++)
            hash = hash_word(hash, words[k]);
    }
    return hash;
}

/* ---- States ------------------------------------------------------------ */

static bool hash_bytes(void *context, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    uint64_t *hash = context;
    for (size_t i = 0; i < count; i++)
        *hash = hash_word(*hash, byte[i]);
    return true;
}

void random_machine_save(const c205 *machine, c205_writer *write, void *context)
{
    need(c205_save(machine, write, context, &last_error));
}

uint64_t machine_hash(const c205 *machine)
{
    uint64_t hash = HASH_BEGIN;
    random_machine_save(machine, hash_bytes, &hash);
    return hash;
}

/* ---- Memory ------------------------------------------------------------ */

/* Copies words from `address` to `end`. The range may have several pages. */
static void take_words(const c205 *machine, struct plain_memory *memory,
                       uint64_t address, uint64_t end)
{
    for (; address < end; address += WORD)
        c205_read(machine, address, plain_words(memory, address), 1);
}

void random_machine_memory(const c205 *machine, const struct random_program *program,
                           struct plain_memory *memory)
{
    for (size_t i = 0; i < RANDOM_PAGES; i++)
        plain_map(memory, random_pages[i].address, C205_PAGE_WORDS,
                  random_pages[i].access);
    for (size_t i = 0; i < random_area_count; i++)
        take_words(machine, memory, random_areas[i].address,
                   random_areas[i].address + WORD * random_areas[i].words);
    take_words(machine, memory, program->code / WORD * WORD,
               program_address(program, program->insn_count));
}

/* ---- Instructions in memory -------------------------------------------- */

unsigned random_insn_halves(const c205 *machine, uint64_t address)
{
    c205_word word;
    if (!c205_read(machine, address / WORD * WORD, &word, 1))
        return 0;
    word <<= address % WORD;
    const c205_insn *insn = c205_insn_coded((uint8_t)(word >> 56),
                                            (uint8_t)(word >> 48));
    return !insn ? 1 : c205_format_halves(insn->format);
}
