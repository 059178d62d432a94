/* narrow_machine.h - the machine's exact rule in the narrow format of
 * narrow_oracle.h: narrow_add_upper .. as arith.h has arith_add_upper. */
#ifndef NARROW_MACHINE_H
#define NARROW_MACHINE_H

#include "vm/number/arith.h"

#define ARITH_OF_NARROW(name) narrow_##name
ARITH_FUNCTIONS(ARITH_OF_NARROW);

#endif
