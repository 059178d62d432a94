/* random_words.h - what a verdict has to say of an answer drawn at random, worked out from
 * what was done to it.
 */
#ifndef TESTS_DRAWN_WORDS_H
#define TESTS_DRAWN_WORDS_H

#include "base/sink.h"
#include "tests/unit/random_lesson.h"

/* Elements of y that are wrong in the test that was made to fail, */
size_t random_count_wrong(const struct random_lesson *drawn);
/* .. and the sentence about them. */
void random_say_wrong(const struct random_lesson *drawn, size_t wrong,
                      const struct sink *sink);
/* The sentence about what they look like, or ""; NULL: it is not known, for bits that are
 * flipped at random look like many things. */
const char *random_likeness(const struct random_lesson *drawn);
/* The line of the answer in which the fault is, from 1 on. */
size_t random_fault_line(const struct random_lesson *drawn);

#endif
