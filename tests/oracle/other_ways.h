/* other_ways.h - runs a random program in other modes than step by step.
 *
 * The modes are: as a whole; in slices, each ended by the clock limit; in slices
 * between which the machine is saved and another one restored from it; with a listener,
 * from the start or from some time on; on pages shared with other machines, whose
 * contents must not change.  Instructions that trap are skipped.  All modes must end in
 * the same state: everything that a saved machine contains, including clock and
 * accounts.
 */
#ifndef OTHER_WAYS_H
#define OTHER_WAYS_H

#include "tests/oracle/random_program.h"

/* Returns NULL if the modes agree, else the name of one that differs.  stepped is the
 * hash of a machine that ran step by step to the end of the program.  NULL: it did not
 * reach the end, and the modes are only compared with each other. */
const char *disagreeing_way(const struct random_program *program,
                            const uint64_t *stepped);

#endif
