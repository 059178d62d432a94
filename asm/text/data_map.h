/* data_map.h - finds the type and the number of data at each label of a program. */
#ifndef ASM_DATA_MAP_H
#define ASM_DATA_MAP_H

#include "asm/text/assembler.h"

/* Sets the data types of the labels among `count` symbols. The items must be sorted by
 * address. Returns false if memory is exhausted. */
bool data_map_fill(const struct assembler *assembler, struct asm_symbol *symbols,
                   size_t count);

#endif
