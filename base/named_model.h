/* named_model.h - opens the machine model that a user names. */
#ifndef BASE_NAMED_MODEL_H
#define BASE_NAMED_MODEL_H

#include "base/command.h"
#include "vm/c205.h"

/* Opens a built-in model or a file, as c205_model_find does. A NULL name is the default
 * model. Returns NULL after an error message on stderr. For an invalid file the message
 * shows the line with the error. */
c205_model *model_open(const char *command, const char *name);
/* Like c205_model_find, for names that occur in the user's files. Rejects a file that
 * the command writes. */
c205_model *model_find(const char *name, c205_error *error);

/* The names of the built-in models. */
command_choice command_model_choice;

#endif
