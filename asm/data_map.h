/* data_map.h - what lies at the labels of a program. */
#ifndef ASM_DATA_MAP_H
#define ASM_DATA_MAP_H

#include "asm/assembler.h"

/* Sets the data types of the labels among the count symbols; the items are in the order of their
 * addresses.  False: no memory. */
bool data_map_fill(const struct assembler *assembler, struct asm_symbol *symbols,
                   size_t count);

#endif
