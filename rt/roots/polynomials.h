/* polynomials.h - reading polynomials from a file.
 *
 * A line holds c4,c3,c2,c1,c0 and, if wanted, a bound, which is 0 otherwise:
 * decimal numbers between commas, of any size that the machine has.  Empty
 * lines and lines that begin with # are passed over; the first other line may
 * name the columns.  Lines may end with CR LF; a mark of UTF-8
 * may come first.
 */
#ifndef RT_POLYNOMIALS_H
#define RT_POLYNOMIALS_H

#include "base/diagnostic.h"
#include "rt/roots/roots.h"

/* Zero it to begin. */
struct polynomials {
    size_t count;
    struct polynomial *items;
    size_t *lines; /* of the file, from 1 */
};

/* False: there are errors among the reports, which name every bad line. */
bool polynomials_read(struct polynomials *polynomials, const char *path,
                      struct diagnostics *reports);
void polynomials_free(struct polynomials *polynomials);

#endif
