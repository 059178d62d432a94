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

c205_segment *storage_add_segment(struct storage *storage)
{
    c205_program *program = &storage->object.program;
    return arena_add(&storage->arena, &program->segments, &program->segment_count,
                     &storage->segment_capacity, NULL, sizeof *program->segments);
}

c205_region *storage_add_region(struct storage *storage)
{
    c205_program *program = &storage->object.program;
    return arena_add(&storage->arena, &program->regions, &program->region_count,
                     &storage->region_capacity, NULL, sizeof *program->regions);
}

struct asm_symbol *storage_add_symbol(struct storage *storage)
{
    struct object *object = &storage->object;
    return arena_add(&storage->arena, &object->symbols, &object->symbol_count,
                     &storage->symbol_capacity, NULL, sizeof *object->symbols);
}

struct asm_line *storage_add_line(struct storage *storage)
{
    struct object *object = &storage->object;
    return arena_add(&storage->arena, &object->lines, &object->line_count,
                     &storage->line_capacity, NULL, sizeof *object->lines);
}

struct asm_register *storage_add_register(struct storage *storage)
{
    struct object *object = &storage->object;
    return arena_add(&storage->arena, &object->registers, &object->register_count,
                     &storage->register_capacity, NULL, sizeof *object->registers);
}

struct asm_mention *storage_add_mention(struct storage *storage)
{
    struct object *object = &storage->object;
    return arena_add(&storage->arena, &object->mentions, &object->mention_count,
                     &storage->mention_capacity, NULL, sizeof *object->mentions);
}

struct asm_expectation *storage_add_expectation(struct storage *storage)
{
    struct object *object = &storage->object;
    return arena_add(&storage->arena, &object->expectations, &object->expectation_count,
                     &storage->expectation_capacity, NULL,
                     sizeof *object->expectations);
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
