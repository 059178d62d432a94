/* shared.h - creates and maps pages that several machines share. */
#ifndef C205_SHARED_H
#define C205_SHARED_H

#include "vm/memory.h"

/* Maps the shared pages at consecutive addresses from the start of a page on. On
 * failure sets the error and returns false. */
bool shared_map(const c205_shared *shared, struct memory *memory, uint64_t address,
                c205_error *error);

#endif
