/* polynomials.h - reads polynomials from a file.
 *
 * A line contains c4,c3,c2,c1,c0 and an optional bound, whose default is 0. They are
 * decimal numbers in the range of the machine's numbers, separated by commas. Empty
 * lines and lines that begin with # are skipped. The first other line may contain the
 * names of the columns. Lines may end with CR LF. The file may begin with a UTF-8 byte
 * order mark.
 */
#ifndef RT_POLYNOMIALS_H
#define RT_POLYNOMIALS_H

#include "base/diagnostic.h"
#include "rt/roots/roots.h"

/* A list of polynomials. It must initially be zeros. */
struct polynomials {
    size_t count;
    struct polynomial *items;
    size_t *lines; /* line numbers in the file from 1 */
};

/* Reads a file. Returns false if it has errors. The reports name all wrong lines. */
bool polynomials_read(struct polynomials *polynomials, const char *path,
                      struct diagnostics *reports);
void polynomials_free(struct polynomials *polynomials);

#endif
