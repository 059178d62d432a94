/* polynomials.h - reads polynomials from a file.
 *
 * A line has c4,c3,c2,c1,c0 and optionally a bound, which is otherwise 0. These
 * are decimal numbers with commas between them, in the range of the machine's
 * numbers. Empty lines and lines that begin with # are skipped. The first other
 * line may have the names of the columns. Lines may end with CR LF, and the file
 * may begin with a UTF-8 byte order mark.
 */
#ifndef RT_POLYNOMIALS_H
#define RT_POLYNOMIALS_H

#include "base/diagnostic.h"
#include "rt/roots/roots.h"

/* Must start as zeros. */
struct polynomials {
    size_t count;
    struct polynomial *items;
    size_t *lines; /* line numbers in the file, from 1 */
};

/* Reads a file. Returns false if there are errors; the reports name every bad
 * line. */
bool polynomials_read(struct polynomials *polynomials, const char *path,
                      struct diagnostics *reports);
void polynomials_free(struct polynomials *polynomials);

#endif
