/* prior_model.c - found by its name, once. */
#include "prior_model.h"

c205_model *prior_model;

int set_up_model(void **state)
{
    c205_error error;

    (void)state;
    prior_model = c205_model_find("cyber205-2pipe-prior", &error);
    return !prior_model;
}

int tear_down_model(void **state)
{
    (void)state;
    c205_model_free(prior_model);
    return 0;
}
