/* scoped_machine.h - small machines that are freed at the end of their block. */
#ifndef TESTS_SCOPED_MACHINE_H
#define TESTS_SCOPED_MACHINE_H

#include "tests/unit/machine_fixture.h"

static inline void small_machine_free(struct small_machine *fixture)
{
    free_small_machine(fixture);
}

#endif
