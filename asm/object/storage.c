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

/* Defines the function that adds a zeroed element to a list of the object. */
#define STORAGE_ADD(element, owner, type) \
    type *storage_add_##element(struct storage *storage) \
    { \
        return arena_add(&storage->arena, &storage->owner.element##s, \
                         &storage->owner.element##_count, \
                         &storage->element##_capacity, NULL, sizeof(type)); \
    }

STORAGE_ADD(segment, object.program, c205_segment)
STORAGE_ADD(region, object.program, c205_region)
STORAGE_ADD(symbol, object, struct asm_symbol)
STORAGE_ADD(line, object, struct asm_line)
STORAGE_ADD(register, object, struct asm_register)
STORAGE_ADD(mention, object, struct asm_mention)
STORAGE_ADD(expectation, object, struct asm_expectation)

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
