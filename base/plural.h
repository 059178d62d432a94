/* plural.h - counts with a noun: "1 clock", "2 clocks", "0 clocks".
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
