/* fuzz.h - what the fuzz targets share. */
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "vm/c205.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Each target sets it when an input gets past its first check, so that the
 * input tests more than a refusal.  Seeds of which none does are a failure. */
extern bool fuzz_accepted;

static inline void must(bool holds)
{
    if (!holds)
        abort();
}

/* The model on which seed.sh saves machines; it is read once. */
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
