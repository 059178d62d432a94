/* recording.h - what time is made from, kept of a run; see c205.h. */
#ifndef C205_RECORDING_H
#define C205_RECORDING_H

#include "vm/decode.h"

/* One executed instruction. */
void recording_add(c205_recording *recording, const struct decoded *decoded,
                   const struct effect *effect, size_t region);

#endif
