/* source.h - finding the texts that .include names. */
#ifndef ASM_SOURCE_H
#define ASM_SOURCE_H

#include "asm/assembler.h"

struct asm_source {
    const char *name;
    const char *text, *end;
};

/* A text that the caller or the library carries under this name; else a file
 * in the folder of the file from; else one in the folders to search.  False: the error has the
 * reason. */
bool source_find(struct assembler *assembler, const char *name, const char *from,
                 struct asm_source *source, c205_error *error);

#endif
