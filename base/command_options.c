/* command_options.c - see command_options.h. */
#include "base/command_options.h"

const char *command_model_choice(size_t number)
{
    return c205_model_names()[number];
}
