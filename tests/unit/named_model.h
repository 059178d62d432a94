/* named_model.h - machine models for the tests of models and clocks. */
#ifndef TESTS_NAMED_MODEL_H
#define TESTS_NAMED_MODEL_H

#include "tests/unit/unit.h"
#include "vm/time/model.h"

/* Return the model with a name, or the model of a text, whose name is "test". If there
 * is an error, the test fails. The caller frees the model. */
static inline c205_model *named_model(const char *name)
{
    return NON_NULL(c205_model_find(name, &failure));
}

static inline c205_model *parsed_model(const char *text)
{
    return NON_NULL(c205_model_parse("test", text, &failure));
}

#endif
