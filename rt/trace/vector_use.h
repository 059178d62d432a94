/* vector_use.h - counts the elements of a program's vector instructions. Also counts
 * the used elements among those under a control vector.
 *
 * The host counts them by observing the machine's instructions, which costs the machine
 * no clocks.
 */
#ifndef RT_VECTOR_USE_H
#define RT_VECTOR_USE_H

#include "rt/trace/observer.h"

struct vector_use {
    uint64_t instructions, elements;
    uint64_t controlled; /* elements under a control vector */
    uint64_t wanted;     /* controlled elements that the control vector permits */
};

/* Returns an observer that sums over all bands of a frame. The caller sets the sum to
 * zero first. */
struct observer vector_use_observer(struct vector_use *sum);

#endif
