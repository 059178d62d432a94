/* address_space.h - limits and default addresses of a program. Not public. */
#ifndef ASM_ADDRESS_SPACE_H
#define ASM_ADDRESS_SPACE_H

#include "vm/c205.h"

#define MAX_WORDS ((uint64_t)1 << 26) /* of a program; it must fit in memory */
#define ADDRESS_BITS 48
#define PAGE_BITS ((uint64_t)C205_PAGE_WORDS * 64)
/* Default start addresses of code and data. */
#define CODE_ORIGIN (1 * PAGE_BITS) /* page 0 is not mapped */
#define DATA_ORIGIN (2 * PAGE_BITS)

#endif
