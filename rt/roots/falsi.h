/* falsi.h - the rule by which the root solver's falsi scales the kept end of
 * a bracket: the numbers of FALSI in rt/kernels/roots/quartic_constants.s, which has
 * the default.
 */
#ifndef RT_FALSI_H
#define RT_FALSI_H

#include "asm/assemble.h"

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

/* The rule that a program was assembled with; FALSI_DEFAULT: it has none. */
enum falsi falsi_of(const struct object *program);

#endif
