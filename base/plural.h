/* plural.h - the ending of a noun after a count: "1 clock", "2 clocks".
 *
 *   printf("%zu clock%s", clocks, plural(clocks));
 */
#ifndef BASE_PLURAL_H
#define BASE_PLURAL_H

#include <stdint.h>

/* Returns the ending of a regular noun: "" for 1, otherwise "s". */
static inline const char *plural(uint64_t count)
{
    return count == 1 ? "" : "s";
}

#endif
