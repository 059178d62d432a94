/* processors.h - the number of processors, and the number of threads to use. */
#ifndef RT_PROCESSORS_H
#define RT_PROCESSORS_H

#include <stddef.h>

/* Returns the number of online processors, at least 1. */
size_t processors(void);
/* Returns the number of threads for the option --jobs. It is `asked`, or the number of
 * processors if `asked` is 0, but not more than `most`. */
size_t jobs_wanted(size_t asked, size_t most);

#endif
