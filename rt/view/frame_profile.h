/* frame_profile.h - profiles the clocks of a frame by lines of its kernels. */
#ifndef RT_FRAME_PROFILE_H
#define RT_FRAME_PROFILE_H

#include "asm/measure/line_profile.h"
#include "rt/trace/observer.h"

/* Returns an observer that sums over all bands of a frame. *sum must initially be NULL.
 * The owner of *sum frees it before the frame's program. */
struct observer frame_profile_observer(struct line_profile **sum);

#endif
