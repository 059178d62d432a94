/* shared.h - creates and maps pages that several machines share. */
#ifndef C205_SHARED_H
#define C205_SHARED_H

#include "vm/memory.h"

bool shared_map(const c205_shared *shared, struct memory *memory, uint64_t address,
                c205_error *error);

#endif
