/* storage.c - builds objects in an arena, and looks up their lines,
 * regions and symbols. */
#include "asm/storage.h"

#include <stdlib.h>
#include <string.h>

enum { HALF_BITS = 32 };

struct storage *storage_new(void)
{
    return calloc(1, sizeof(struct storage));
}

void object_free(struct object *object)
{
    struct storage *storage = (struct storage *)object;

    if (storage)
        arena_free(&storage->arena);
    free(storage);
}

/* Adds an item to an array of the object. Returns the array, with
 * the count increased. */
static void *grow(struct storage *storage, const void *items, size_t *count,
                  size_t *capacity, size_t size)
{
    void *grown = arena_grow(&storage->arena, (void *)(uintptr_t)items, *count,
                             capacity, size);

    *count += grown != NULL;
    return grown;
}

c205_segment *storage_add_segment(struct storage *storage)
{
    c205_program *program = &storage->object.program;
    c205_segment *grown = grow(storage, program->segments, &program->segment_count,
                               &storage->segment_capacity, sizeof *grown);

    if (!grown)
        return NULL;
    program->segments = grown;
    return &grown[program->segment_count - 1];
}

c205_region *storage_add_region(struct storage *storage)
{
    c205_program *program = &storage->object.program;
    c205_region *grown = grow(storage, program->regions, &program->region_count,
                              &storage->region_capacity, sizeof *grown);

    if (!grown)
        return NULL;
    program->regions = grown;
    return &grown[program->region_count - 1];
}

struct asm_symbol *storage_add_symbol(struct storage *storage)
{
    struct object *object = &storage->object;
    struct asm_symbol *grown = grow(storage, object->symbols, &object->symbol_count,
                                    &storage->symbol_capacity, sizeof *grown);

    if (!grown)
        return NULL;
    object->symbols = grown;
    return &grown[object->symbol_count - 1];
}

struct asm_line *storage_add_line(struct storage *storage)
{
    struct object *object = &storage->object;
    struct asm_line *grown = grow(storage, object->lines, &object->line_count,
                                  &storage->line_capacity, sizeof *grown);

    if (!grown)
        return NULL;
    object->lines = grown;
    return &grown[object->line_count - 1];
}

struct asm_register *storage_add_register(struct storage *storage)
{
    struct object *object = &storage->object;
    struct asm_register *grown = grow(storage, object->registers,
                                      &object->register_count,
                                      &storage->register_capacity, sizeof *grown);

    if (!grown)
        return NULL;
    object->registers = grown;
    return &grown[object->register_count - 1];
}

struct asm_mention *storage_add_mention(struct storage *storage)
{
    struct object *object = &storage->object;
    struct asm_mention *grown = grow(storage, object->mentions, &object->mention_count,
                                     &storage->mention_capacity, sizeof *grown);

    if (!grown)
        return NULL;
    object->mentions = grown;
    return &grown[object->mention_count - 1];
}

struct asm_expectation *storage_add_expectation(struct storage *storage)
{
    struct object *object = &storage->object;
    struct asm_expectation *grown = grow(storage, object->expectations,
                                         &object->expectation_count,
                                         &storage->expectation_capacity, sizeof *grown);

    if (!grown)
        return NULL;
    object->expectations = grown;
    return &grown[object->expectation_count - 1];
}

static int compare_symbols(const void *a, const void *b)
{
    return strcmp(((const struct asm_symbol *)a)->name,
                  ((const struct asm_symbol *)b)->name);
}

void storage_sort_symbols(struct storage *storage)
{
    const struct object *object = &storage->object;

    if (object->symbol_count > 0)
        qsort((void *)(uintptr_t)object->symbols, object->symbol_count,
              sizeof *object->symbols, compare_symbols);
}

const struct asm_line *object_line(const struct object *object, uint64_t address)
{
    const struct asm_line *lines = object->lines;
    size_t low = 0, high = object->line_count;

    while (low < high) {
        size_t middle = low + (high - low) / 2;

        if (lines[middle].address <= address)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0
                   && address - lines[low - 1].address
                          < HALF_BITS * lines[low - 1].halves
               ? &lines[low - 1]
               : NULL;
}

const char *object_region(const struct object *object, uint64_t address)
{
    const c205_region *regions = object->program.regions;

    for (size_t i = 0; i < object->program.region_count; i++)
        if (address >= regions[i].begin && address < regions[i].end)
            return regions[i].name;
    return "";
}

struct position asm_line_position(const struct asm_line *line)
{
    const struct position position = { line->file, line->number,
                                       strspn(line->source, " \t") + 1, line->source,
                                       strlen(line->source) };

    return position;
}

const struct asm_symbol *object_symbol(const struct object *object, const char *name)
{
    struct asm_symbol key = { .name = NULL };

    key.name = name;
    if (object->symbol_count == 0)
        return NULL;
    return bsearch(&key, object->symbols, object->symbol_count, sizeof *object->symbols,
                   compare_symbols);
}

static bool is_used(const struct object *object, const char *name)
{
    const struct asm_symbol *symbol = object_symbol(object, name);

    return symbol && symbol->is_used;
}

const char *asm_unused_define(const struct asm_define *defines,
                              struct object *const *objects, size_t count)
{
    for (; defines && defines->name; defines++) {
        size_t i = 0;

        while (i < count && !is_used(objects[i], defines->name))
            i++;
        if (i == count)
            return defines->name;
    }
    return NULL;
}
