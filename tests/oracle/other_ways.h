/* other_ways.h - a random program run otherwise than step by step.
 *
 * As a whole; in slices, each ended by the clock limit; in slices between
 * which the machine is saved and another one restored from that; with somebody
 * who listens, from the beginning or now and then; on pages in common with others,
 * which keep what they have.  What traps is skipped.  All ways must end in one state: everything that a saved
 * machine holds, clock and accounts among it.
 */
#ifndef OTHER_WAYS_H
#define OTHER_WAYS_H

#include "tests/oracle/random_program.h"

/* Of all that a machine is. */
uint64_t machine_hash(const c205 *machine);

/* NULL: they agree; else the name of a way that did not.  stepped is the hash
 * of a machine that went to the end of the program step by step; NULL: it did
 * not come to the end, and the ways agree among themselves only. */
const char *disagreeing_way(const struct random_program *program,
                            const uint64_t *stepped);

#endif
