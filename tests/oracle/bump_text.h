/* bump_text.h - normals of scenes by chance. */
#ifndef BUMP_TEXT_H
#define BUMP_TEXT_H

#include "tests/oracle/solid_text.h"

#include <stddef.h>
#include <stdint.h>

/* To one in so many looks a normal is added.  What else a scene draws does not depend
 * on it: the state is a copy of that with which it goes on. */
void bump_words(uint64_t state, size_t in, char look[SOLID_WORDS]);

#endif
