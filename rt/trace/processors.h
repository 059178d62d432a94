/* processors.h - how many threads there are processors for. */
#ifndef RT_PROCESSORS_H
#define RT_PROCESSORS_H

#include <stddef.h>

/* At least one. */
size_t processors(void);
/* What --jobs asks for: 0, nothing, is one for each processor. */
size_t jobs_wanted(size_t asked, size_t most);

#endif
