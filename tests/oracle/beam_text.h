/* beam_text.h - where a light of a scene by chance shines. */
#ifndef BEAM_TEXT_H
#define BEAM_TEXT_H

#include "tests/oracle/solid_text.h"

#include <stdint.h>

/* Of every other light words of its beam, of its parallel rays, of how it fades, else
 * none.  They begin with an empty place.  What else a scene draws does not depend on
 * them: the state is a copy of that with which it goes on. */
void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS]);

#endif
