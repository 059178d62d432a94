/* cheating_answer.h - answers that a lesson's tests make possible without any work. */
#ifndef TESTS_CHEATING_ANSWER_H
#define TESTS_CHEATING_ANSWER_H

#include "asm/lesson/lesson.h"

enum cheat {
    CHEAT_DATA,      /* the expected data are the data of the results */
    CHEAT_VECTOR,    /* VTOV copies the expected data */
    CHEAT_SCALAR,    /* a loop copies the expected data */
    CHEAT_LOOK_UP,   /* copies the expected data if it recognises the first input, and
                      otherwise does nothing */
    CHEAT_FALL_BACK, /* copies the expected data if it recognises the first input, and
                        otherwise is right but too slow */
    CHEATS
};

/* Writes an answer that recognises the tests of the lesson by their constants. */
void cheat_write(const struct lesson *lesson, enum cheat cheat,
                 const struct sink *sink);

/* Writes the program without its instruction i. A macro that makes instructions counts
 * as one. Returns false if there are fewer instructions. */
bool cheat_remove(const char *program, size_t i, const struct sink *sink);

#endif
