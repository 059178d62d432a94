/* frame_profile.h - where the clocks of a frame went, line by line of its kernels. */
#ifndef RT_FRAME_PROFILE_H
#define RT_FRAME_PROFILE_H

#include "asm/line_profile.h"
#include "rt/trace/observer.h"

/* Of all bands of a frame; NULL to begin, and freed by its owner before the frame's
 * program is. */
struct observer frame_profile_observer(struct line_profile **sum);

#endif
