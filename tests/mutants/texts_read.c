/* texts_read.c - records which texts the assembler reads.
 *
 * cover.sh links the file into programs with --wrap=source_find. It appends the name of
 * each text to the file that the environment variable TEXTS_READ names.
 */
#include "asm/text/source.h"

#include <stdio.h>
#include <stdlib.h>

bool __real_source_find(struct assembler *assembler, const char *name, const char *from,
                        struct asm_source *source, c205_error *error);
bool __wrap_source_find(struct assembler *assembler, const char *name, const char *from,
                        struct asm_source *source, c205_error *error);

bool __wrap_source_find(struct assembler *assembler, const char *name, const char *from,
                        struct asm_source *source, c205_error *error)
{
    const char *path = getenv("TEXTS_READ");
    FILE *file = path ? fopen(path, "a") : NULL;
    if (file) {
        fprintf(file, "%s\n", name);
        fclose(file);
    }
    return __real_source_find(assembler, name, from, source, error);
}
