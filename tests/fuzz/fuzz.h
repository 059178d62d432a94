/* fuzz.h - declarations that all fuzz targets share. */
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "vm/c205.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A target sets this when an input passes its first check, so that the input tests more
 * than an error. It is a failure if no seed does. */
extern bool fuzz_accepted;

static inline void must(bool holds)
{
    if (!holds)
        abort();
}

/* Returns the model on which seed.sh saves machines; it is read once. */
static inline c205_model *fuzz_model(void)
{
    static c205_model *model;
    c205_error error;

    if (!model)
        model = c205_model_find(C205_DEFAULT_MODEL, &error);
    must(model != NULL);
    return model;
}

#endif
