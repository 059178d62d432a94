/* observer.h - the interface of observers of the machines that trace a frame.
 *
 * Each band has its own state: begin creates it, listen receives all events of the
 * band's machine, merge adds it to the observer's total when the band is done, and
 * end frees it. Bands are traced in threads. Calls of begin, merge and end never
 * overlap. Bands finish in any order, so the totals must not depend on the order;
 * sums do not.
 */
#ifndef RT_OBSERVER_H
#define RT_OBSERVER_H

#include "asm/object/object.h"

struct observer {
    /* Returns NULL on failure, with the reason in the error. */
    void *(*begin)(void *context, const struct object *program, c205_error *error);
    c205_listener *listen; /* its context is the band's state */
    void (*merge)(void *context, const void *band);
    void (*end)(void *band);
    void *context; /* passed to begin and merge */
};

#endif
