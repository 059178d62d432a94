/* falsi.h - the rules by which the root solver's falsi (regula falsi) scales the
 * retained end of a bracket. They are the values of FALSI in
 * rt/kernels/roots/quartic_constants.s, which also has the default. */
#ifndef RT_FALSI_H
#define RT_FALSI_H

#include "asm/object/object.h"

enum falsi {
    FALSI_DEFAULT = -1,
    FALSI_PAPER,
    FALSI_ILLINOIS,
    FALSI_PEGASUS,
    FALSI_ANDERSON_BJORCK,
    FALSI_RULES
};
const char *falsi_name(enum falsi rule);
bool falsi_named(const char *name, enum falsi *rule);

/* Returns the rule that a program was assembled with, or FALSI_DEFAULT if it has
 * none. */
enum falsi falsi_of(const struct object *program);

#endif
