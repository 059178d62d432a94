/* narrow_machine.h - the machine's exact rule in the narrow format of
 * narrow_oracle.h: narrow_add_upper .. as arith.h has arith_add_upper. */
#ifndef NARROW_MACHINE_H
#define NARROW_MACHINE_H

#include "vm/number/arith.h"

#define BINARY(name, ...) arith_binary narrow_##name;
#define UNARY(name, ...) arith_unary narrow_##name;
#define RELATION(name) arith_relation narrow_##name;
#include "vm/arith.def"

#endif
