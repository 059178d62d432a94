/* observer.h - the interface of observers of the machines that trace a frame.
 *
 * Each band has its own state. `begin` creates the state, `listen` receives all events
 * of the band's machine, `merge` adds the state to the observer's total when the band
 * is done, and `end` frees it. Bands are traced in threads, but calls of begin, merge
 * and end never overlap. Bands finish in any order, so a total must not depend on the
 * order; a sum does not.
 */
#ifndef RT_OBSERVER_H
#define RT_OBSERVER_H

#include "asm/object/object.h"

struct observer {
    /* Creates the state for a band. On failure sets the error and returns NULL. */
    void *(*begin)(void *context, const struct object *program, c205_error *error);
    c205_listener *listen; /* receives the band's state as its context */
    void (*merge)(void *context, const void *band);
    void (*end)(void *band);
    void *context; /* passed to begin and merge */
};

#endif
