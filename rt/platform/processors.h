/* processors.h - the number of processors, and of threads to use. */
#ifndef RT_PROCESSORS_H
#define RT_PROCESSORS_H

#include <stddef.h>

/* Returns the number of online processors, at least 1. */
size_t processors(void);
/* Returns the number of threads for --jobs: the number given, or one for each
 * processor if it is 0; never more than `most`. */
size_t jobs_wanted(size_t asked, size_t most);

#endif
