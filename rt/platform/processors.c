/* processors.c - counts the processors of the host. */
#include "rt/platform/processors.h"

#include <unistd.h>

size_t processors(void)
{
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online > 0 ? (size_t)online : 1;
}

size_t jobs_wanted(size_t asked, size_t most)
{
    size_t jobs = asked > 0 ? asked : processors();
    return jobs < most ? jobs : most;
}
