/* vector_use.h - how long a program's vectors are, and how many of the
 * elements under a control vector are wanted.
 *
 * Counted by the host as it watches the machine's instructions, which costs
 * the machine nothing.
 */
#ifndef RT_VECTOR_USE_H
#define RT_VECTOR_USE_H

#include "vm/c205.h"

struct vector_use {
    uint64_t instructions, elements;
    uint64_t controlled; /* elements under a control vector */
    uint64_t wanted;     /* of these, those it lets through */
};

/* A c205_listener; its context is a struct vector_use. */
void vector_use_listen(void *use, const c205 *machine,
                       const c205_event *event);
void vector_use_add(struct vector_use *sum, const struct vector_use *use);

#endif
