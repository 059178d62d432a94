/* recording.h - records the input of the clock during a run: each executed instruction
 * and its effect; see c205_time.h. */
#ifndef C205_RECORDING_H
#define C205_RECORDING_H

#include "vm/decode.h"

/* Adds an executed instruction and its effect to a recording. */
void recording_add(c205_recording *recording, const struct decoded *decoded,
                   const struct effect *effect, size_t region);

#endif
