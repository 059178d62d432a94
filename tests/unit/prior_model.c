/* prior_model.c - finds the machine models by their names, only once. */
#include "prior_model.h"

#include "tests/oracle/arithmetic_oracle.h"

c205_model *prior_model, *fitted_model;

int set_up_model(STATE)
{
    prior_model = c205_model_find("cyber205-2pipe-prior", &failure);
    return !prior_model;
}

int tear_down_model(STATE)
{
    c205_model_free(prior_model);
    return 0;
}

int set_up_oracle(STATE)
{
    oracle_begin();
    return 0;
}

int tear_down_oracle(STATE)
{
    oracle_end();
    return 0;
}

int set_up_both(void **state)
{
    return set_up_oracle(state) || set_up_model(state);
}

int tear_down_both(void **state)
{
    return tear_down_oracle(state) || tear_down_model(state);
}

int set_up_fitted(STATE)
{
    fitted_model = c205_model_find("cyber205-2pipe", &failure);
    return !fitted_model;
}

int tear_down_fitted(STATE)
{
    c205_model_free(fitted_model);
    return 0;
}
