/* vector_use.h - how long a program's vectors are, and how many of the
 * elements under a control vector are wanted.
 *
 * Counted by the host as it watches the machine's instructions, which costs
 * the machine nothing.
 */
#ifndef RT_VECTOR_USE_H
#define RT_VECTOR_USE_H

#include "rt/trace/observer.h"

struct vector_use {
    uint64_t instructions, elements;
    uint64_t controlled; /* elements under a control vector */
    uint64_t wanted;     /* of these, those it lets through */
};

/* Of all bands of a frame; zero the sum to begin. */
struct observer vector_use_observer(struct vector_use *sum);

#endif
