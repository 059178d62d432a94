/* state.h - saved machines as files (vm/save.c says what they hold). */
#ifndef ASM_STATE_H
#define ASM_STATE_H

#include "vm/c205.h"

/* Written whole or not at all. */
bool state_save(const c205 *machine, const char *path, c205_error *error);
/* NULL: it cannot be read, or is refused. */
c205 *state_load(const char *path, const c205_model *model, c205_error *error);

#endif
