/* source.h - finds the files that .include names. */
#ifndef ASM_SOURCE_H
#define ASM_SOURCE_H

#include "asm/text/assembler.h"

struct asm_source {
    const char *name;
    const char *text, *end;
};

/* Searches for a file in this order: the tables of the caller and the library, the
 * folder of the file `from`, the folders of the options. Returns false and sets the
 * error if nothing is found. */
bool source_find(struct assembler *assembler, const char *name, const char *from,
                 struct asm_source *source, c205_error *error);

#endif
