/* state.h - saves machines to files and restores them. vm/save.c defines the format. */
#ifndef ASM_STATE_H
#define ASM_STATE_H

#include "vm/c205.h"

/* Saves a machine to a file. If this fails, an existing file remains unchanged. */
bool state_save(const c205 *machine, const char *path, c205_error *error);
/* Restores a machine from a file. Returns NULL with the error if the file cannot be
 * read or is rejected. */
c205 *state_load(const char *path, const c205_model *model, c205_error *error);

#endif
