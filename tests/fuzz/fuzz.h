/* fuzz.h - declarations that all fuzz targets share. */
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "tests/scoped.h"
#include "vm/c205.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Targets set this when an input passes their first check, so that the input tests more
 * than an error. A target fails if none of its seeds sets it. */
extern bool fuzz_accepted;

static inline void must(bool holds)
{
    if (!holds)
        abort();
}

/* Fails unless the clocks of all causes sum to the clock. */
static inline void check_accounts(const c205 *machine)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < c205_account_count(machine); i++)
        for (int cause = 0; cause < C205_CAUSES; cause++)
            sum += c205_account_at(machine, i)->clocks[cause];
    must(sum == c205_clock(machine));
}

/* Returns the model on which seed.sh saves machines. The model is read at the first
 * call. */
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
