/* contents.h - what lies at the labels of a program. */
#ifndef ASM_CONTENTS_H
#define ASM_CONTENTS_H

#include "asm/assembler.h"

/* Tells it to the labels among so many symbols; the items are in the order of their
 * addresses.  False: no memory. */
bool contents_tell(const struct assembler *assembler, struct asm_symbol *symbols,
                   size_t count);

#endif
