/* observer.h - what watches the machines that trace a frame.
 *
 * Each band is watched by a state of its own: begin makes it, listen hears all
 * events of the band's machine, merge adds it to what the observer gathers
 * once the band is done, end frees it.  Bands are traced in threads; begin,
 * merge and end are never called twice at a time.  The bands come in any
 * order, so what is gathered must not depend on it: sums.
 */
#ifndef RT_OBSERVER_H
#define RT_OBSERVER_H

#include "asm/assemble.h"

struct observer {
    /* NULL: the error says why. */
    void *(*begin)(void *context, const struct object *program, c205_error *error);
    c205_listener *listen; /* its context is the band's state */
    void (*merge)(void *context, const void *band);
    void (*end)(void *band);
    void *context; /* the observer's own, of begin and merge */
};

#endif
