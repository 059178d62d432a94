/* prior_model.c - found by its name, once. */
#include "prior_model.h"

c205_model *prior_model;

int set_up_model(STATE)
{
    c205_error error;

    prior_model = c205_model_find("cyber205-2pipe-prior", &error);
    return !prior_model;
}

int tear_down_model(STATE)
{
    c205_model_free(prior_model);
    return 0;
}
