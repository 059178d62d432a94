/* prior_model.h - the machine model of tests that do not check clocks, and the fitted
 * model of those that do. */
#ifndef TESTS_PRIOR_MODEL_H
#define TESTS_PRIOR_MODEL_H

#include "tests/unit/unit.h"
#include "vm/c205.h"

extern c205_model *prior_model, *fitted_model;

/* Initialises options with the model and other members. */
#define ON_PRIOR(...) \
    { \
        .model = prior_model, __VA_ARGS__ \
    }

/* Group fixtures: the model, the arithmetic of the oracle, or both. */
int set_up_model(void **state);
int tear_down_model(void **state);
int set_up_oracle(void **state);
int tear_down_oracle(void **state);
int set_up_both(void **state);
int tear_down_both(void **state);
int set_up_fitted(void **state);
int tear_down_fitted(void **state);
#undef FILE_FIXTURES
#define FILE_FIXTURES set_up_model, tear_down_model

#endif
