/* model.h - the machine model that a user names. */
#ifndef BASE_MODEL_H
#define BASE_MODEL_H

#include "vm/c205.h"

/* A built-in model or one from a file, by the rule of c205_model_find; without
 * a name the default.  NULL after telling on stderr why it cannot be had, of a
 * file that is wrong with its line. */
c205_model *model_open(const char *command, const char *name);
/* c205_model_find for a name from a text: a file that the command writes is
 * refused. */
c205_model *model_find(const char *name, c205_error *error);

#endif
