/* numbering.h - numbers that lie far apart, counted anew from 1 on in their order.
 *
 *   numbering_begin(&numbering, 3) and numbering_add 70, 20, 70, then
 *   numbering_settle; numbering_place of 20 is 1, of 70 it is 2, of 50 it is 0
 */
#ifndef BASE_NUMBERING_H
#define BASE_NUMBERING_H

#include <stdbool.h>
#include <stddef.h>

struct numbering {
    size_t count; /* once settled: how many there are, each once */
    size_t *numbers;
};

/* Room for so many.  False: no memory; then it may only be freed. */
bool numbering_begin(struct numbering *numbering, size_t most);
void numbering_add(struct numbering *numbering, size_t number);
/* After the last. */
void numbering_settle(struct numbering *numbering);
/* From 1 on; 0: it is none of them. */
size_t numbering_place(const struct numbering *numbering, size_t number);
void numbering_free(struct numbering *numbering);

#endif
