/* error.h - why something failed, in words. */
#ifndef BASE_ERROR_H
#define BASE_ERROR_H

#include "vm/c205.h"

#include <stdbool.h>

/* As printf, cut to the room that there is; always false. */
bool error_say(c205_error *error, const char *format, ...);

#endif
