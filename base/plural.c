/* plural.c - the ending of a noun after a count. */
#include "base/plural.h"

const char *plural(uint64_t count)
{
    return count == 1 ? "" : "s";
}
