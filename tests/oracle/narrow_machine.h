/* narrow_machine.h - the machine's exact rules in the narrow format of narrow_oracle.h:
 * narrow_add_upper and so on, like arith_add_upper of arith.h. */
#ifndef NARROW_MACHINE_H
#define NARROW_MACHINE_H

#include "vm/number/arith.h"

#define BINARY(name, ...) arith_binary narrow_##name;
#define UNARY(name, ...) arith_unary narrow_##name;
#define RELATION(name) arith_relation narrow_##name;
#include "vm/arith.def"

#endif
