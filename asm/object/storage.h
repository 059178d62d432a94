/* storage.h - builds an object in an arena that owns its memory. */
#ifndef ASM_STORAGE_H
#define ASM_STORAGE_H

#include "asm/object/expectation.h"
#include "asm/object/object.h"
#include "base/arena.h"

struct storage {
    /* Must be the first member, because object_free() converts the pointer. */
    struct object object;
    struct arena arena;
    size_t segment_capacity, region_capacity, symbol_capacity;
    size_t line_capacity, expectation_capacity;
    size_t register_capacity, mention_capacity;
};

struct storage *storage_new(void);

/* Each function appends a zeroed item to a list of the object and returns it. NULL:
 * memory is exhausted. */
c205_segment *storage_add_segment(struct storage *storage);
c205_region *storage_add_region(struct storage *storage);
struct asm_symbol *storage_add_symbol(struct storage *storage);
struct asm_line *storage_add_line(struct storage *storage);
struct asm_register *storage_add_register(struct storage *storage);
struct asm_mention *storage_add_mention(struct storage *storage);
struct asm_expectation *storage_add_expectation(struct storage *storage);

void storage_sort_symbols(struct storage *storage);

#endif
