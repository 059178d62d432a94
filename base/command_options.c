/* command_options.c - the choices of the shared options. */
#include "base/command_options.h"

const char *command_model_choice(size_t number)
{
    return c205_model_names()[number];
}
