/* random_verdict.h - the verdict of a random answer, from its known mistake. */
#ifndef TESTS_RANDOM_VERDICT_H
#define TESTS_RANDOM_VERDICT_H

#include "base/sink.h"
#include "tests/unit/random_lesson.h"

/* Returns the number of wrong elements of y in the test that must fail. */
size_t random_count_wrong(const struct random_lesson *drawn);
/* Writes the sentence about the wrong elements. */
void random_mismatch(const struct random_lesson *drawn, size_t wrong,
                     const struct sink *sink);
/* Returns the sentence about the likely mistake, or "". Returns NULL if it cannot be
 * predicted, because randomly flipped bits resemble many mistakes. */
const char *random_likeness(const struct random_lesson *drawn);
/* Returns the line of the answer that contains the mistake. The first line is 1. */
size_t random_fault_line(const struct random_lesson *drawn);

#endif
