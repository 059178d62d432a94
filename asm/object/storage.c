/* storage.c - builds objects in an arena. */
#include "asm/object/storage.h"

#include <stdlib.h>
#include <string.h>

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
