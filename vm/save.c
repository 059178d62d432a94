/* save.c - saves and restores a whole machine. */
#include "vm/hash.h"
#include "vm/machine.h"
#include "vm/time/model.h"
#include "vm/serializer.h"

#include <stdio.h>

/* The format of a saved machine, in words: magic, version, name and hash of the model,
 * hash of the program, registers, regions, memory, clock, progress of an interrupted
 * instruction, and hash of all previous words. It does not depend on the host. */

#define SAVE_MAGIC UINT64_C(0x4332303553415645) /* "C205SAVE" */
/* Must be increased with each change of the saved fields or their order. */
enum { SAVE_VERSION = 5 };

/* ---- Hashes -------------------------------------------------------------- */

/* Hashes the constants of a model. Titles, sources and remarks do not affect the
 * clock. */
static uint64_t model_hash(const c205_model *model)
{
    uint64_t hash = HASH_BEGIN;
    for (size_t i = 0; i < CONSTANTS; i++) {
        const c205_constant *constant = c205_model_constant(model, i);
        hash = hash_text(hash, constant->name);
        hash = hash_word(hash, model_millionths(model, (enum constant)i));
        hash = hash_text(hash, constant->unit);
    }
    return hash;
}

static uint64_t hash_segment(uint64_t hash, const c205_segment *segment)
{
    hash = hash_word(hash, segment->address);
    hash = hash_word(hash, segment->length);
    hash = hash_word(hash, segment->words != NULL);
    for (size_t i = 0; segment->words && i < segment->length; i++)
        hash = hash_word(hash, segment->words[i]);
    return hash;
}

static uint64_t hash_region(uint64_t hash, const c205_region *region)
{
    hash = hash_text(hash, region->name);
    return hash_word(hash_word(hash, region->begin), region->end);
}

uint64_t c205_program_hash(const c205_program *program)
{
    uint64_t hash = hash_word(HASH_BEGIN, program->entry);
    for (size_t i = 0; i < program->segment_count; i++)
        hash = hash_segment(hash, &program->segments[i]);
    for (size_t i = 0; i < program->region_count; i++)
        hash = hash_region(hash, &program->regions[i]);
    return hash;
}

/* ---- Memory -------------------------------------------------------------- */

/* A run of zero words and the run of other words after it. */
struct zero_run {
    size_t zeros, words;
};

/* Finds the run at a word of a page. It ends before the next two zeros, because a
 * single zero takes no more space than the start of a new run. */
static struct zero_run find_run(const c205_word *word, size_t left)
{
    size_t begin = 0;
    while (begin < left && word[begin] == 0)
        begin++;
    size_t end = begin;
    while (end < left && (word[end] || (end + 1 < left && word[end + 1])))
        end++;
    struct zero_run run = { begin, end - begin };
    return run;
}

/* Serializes the words of a page. A page that is read is new and contains zeros. */
static void walk_words(c205_word *words, struct serializer *serializer)
{
    for (size_t i = 0; i < C205_PAGE_WORDS;) {
        struct zero_run run = { 0, 0 };
        if (!serializer_is_read(serializer))
            run = find_run(words + i, C205_PAGE_WORDS - i);
        serializer_size(serializer, &run.zeros, C205_PAGE_WORDS - i);
        serializer_size(serializer, &run.words, C205_PAGE_WORDS - i - run.zeros);
        serializer_require(serializer, run.zeros + run.words > 0,
                           "the memory of the saved machine is damaged");
        if (serializer->failed)
            return;
        serializer_words(serializer, words + i + run.zeros, run.words);
        i += run.zeros + run.words;
    }
}

/* Saves a page that was never used, which contains zeros, without allocating it. */
static void save_untouched(struct serializer *serializer)
{
    size_t access = C205_READ_WRITE, zeros = C205_PAGE_WORDS, words = 0;
    serializer_size(serializer, &access, C205_READ_WRITE);
    serializer_size(serializer, &zeros, C205_PAGE_WORDS);
    serializer_size(serializer, &words, 0);
}

static void walk_page(struct memory *memory, uint64_t address,
                      struct serializer *serializer)
{
    if (memory_is_untouched(memory_peek(memory, address))) {
        save_untouched(serializer);
        return;
    }
    struct page *page = memory_page(memory, address);
    size_t access = page && memory_may_write(page) ? C205_READ_WRITE : C205_READ_ONLY;
    serializer_size(serializer, &access, C205_READ_WRITE);
    if (!page && !serializer->failed
        && !memory_map(memory, address, C205_PAGE_WORDS, (c205_access)access,
                       serializer->error))
        serializer->failed = true;
    if (!serializer->failed)
        walk_words(memory_page(memory, address)->word, serializer);
}

/* Serializes the pages by increasing address. The end of the address space terminates
 * the list. */
static void walk_memory(struct memory *memory, struct serializer *serializer)
{
    uint64_t address = 0;
    while (!serializer->failed) {
        uint64_t least = address;
        if (!serializer_is_read(serializer))
            address = memory_next_page(memory, address);
        serializer_word(serializer, &address);
        serializer_require(serializer,
                           address >= least && address <= ADDRESS_MASK + 1
                               && address % PAGE_BITS == 0,
                           "the memory of the saved machine is damaged");
        if (address > ADDRESS_MASK)
            break;
        walk_page(memory, address, serializer);
        address += PAGE_BITS;
    }
}

/* ---- The machine --------------------------------------------------------- */

static void walk_format(struct serializer *serializer)
{
    uint64_t magic = SAVE_MAGIC, version = SAVE_VERSION;
    static const char foreign[] = "this is not a saved machine";
    serializer_require(serializer, serializer_room(serializer) > 0, foreign);
    serializer_word(serializer, &magic);
    serializer_require(serializer, magic == SAVE_MAGIC, foreign);
    serializer_word(serializer, &version);
    serializer_require(serializer, version == SAVE_VERSION,
                       "the machine was saved in another version of the format");
}

static void walk_model(const c205_model *model, struct serializer *serializer)
{
    uint64_t constants = model_hash(model), hash = constants;
    const char *name = c205_model_name(model);
    char other[sizeof serializer->error->message];
    serializer_text(serializer, &name);
    serializer_word(serializer, &hash);
    snprintf(other, sizeof other,
             "the machine was saved on the model %.60s, "
             "whose constants differ from those of %.60s",
             name, c205_model_name(model));
    serializer_require(serializer, hash == constants, other);
}

static void walk_registers(struct c205 *machine, struct serializer *serializer)
{
    serializer_array(serializer, machine->slot + 1, C205_REGISTERS - 1);
    serializer_word(serializer, &machine->data_flags);
    serializer_word(serializer, &machine->timer);
    serializer_word(serializer, &machine->pc);
    serializer_require(serializer, machine->pc <= ADDRESS_MASK,
                       "the program address of the saved machine is invalid");
}

static void walk_progress(struct c205 *machine, struct serializer *serializer)
{
    struct resume_state *resume = &machine->resume;
    resume_walk(resume, serializer);
    if (resume->kept == 0)
        return;
    c205_word *kept = machine_scratch(machine, SCRATCH_KEPT);
    if (kept)
        serializer_words(serializer, kept, resume->kept);
    else
        serializer_refuse(serializer, "out of memory for a machine");
}

static void walk(struct c205 *machine, struct serializer *serializer)
{
    walk_format(serializer);
    serializer_verify(serializer);
    walk_model(machine->model, serializer);
    serializer_word(serializer, &machine->program);
    walk_registers(machine, serializer);
    machine_walk_regions(machine, serializer);
    walk_memory(&machine->memory, serializer);
    clock_walk(machine->clock, serializer);
    walk_progress(machine, serializer);
    serializer_end(serializer);
}

/* Saves a machine. The machine is const because writing changes nothing. */
bool c205_save(const c205 *machine, c205_writer *write, void *context,
               c205_error *error)
{
    struct serializer serializer = serializer_to(write, context, error);
    walk((struct c205 *)machine, &serializer);
    return !serializer.failed;
}

c205 *c205_restore(const void *bytes, size_t count, const c205_model *model,
                   c205_error *error)
{
    struct serializer serializer = serializer_from(bytes, count, error);
    c205 *machine = c205_new(model, error);
    if (machine)
        walk(machine, &serializer);
    if (!serializer.failed)
        return machine;
    c205_free(machine);
    return NULL;
}
