/* random_lesson.h - random lessons, and answers of which it is known what is wrong.
 *
 * The exercise is y := 2 x (of bits: y := not x), n elements of one kind.  An answer does the
 * work in all tests but one, and there something else.
 */
#ifndef TESTS_DRAWN_LESSON_H
#define TESTS_DRAWN_LESSON_H

#include "asm/lesson/lesson.h"

enum { DRAWN_LONGEST = 60, DRAWN_TESTS = 3 };

enum random_kind { DRAWN_WORDS, DRAWN_HALVES, DRAWN_BITS, DRAWN_KINDS };

/* How the work is done where nothing is wrong; but for words always the first way. */
enum random_way { WAY_VECTOR, WAY_LINKED, WAY_SCALAR, DRAWN_WAYS };

enum random_fault {
    FAULT_NONE, /* the work is done over and over, though */
    FAULT_ELEMENT,
    FAULT_LAST_BIT,
    FAULT_NOTHING,
    FAULT_LATE,
    FAULT_BACKWARDS,
    FAULT_SIGN,
    FAULT_TRAP,
    FAULT_LOOP,
    DRAWN_FAULTS
};

struct random_test {
    size_t n; /* no other test has as many */
    bool warm, has_goals, tolerant;
    const char *model;
    c205_word x[DRAWN_LONGEST], wanted[DRAWN_LONGEST]; /* at the left of a word */
    uint64_t goals[MEDALS];
};

struct random_lesson {
    enum random_kind kind;
    size_t count;
    struct random_test tests[DRAWN_TESTS];
    /* The answer. */
    enum random_fault fault;
    enum random_way way;
    size_t faulty, element, repeated, /* in which test, where, how often more */
        idle;        /* instructions between two others of scalar code */
    c205_word found; /* there, of FAULT_ELEMENT and FAULT_LAST_BIT */
    char answer[8192];
};

/* All but the goals. */
void draw_lesson(struct random_lesson *drawn, uint64_t *random_state);
/* The folder as it would be on disk; fails the test where that is refused. */
void random_open(const struct random_lesson *drawn, struct lesson *lesson);

/* Fails the test where the lesson is wrong itself. */
void grade_well(struct lesson_verdict *verdict, const struct lesson *lesson,
                const char *answer);

double random_number(const struct random_lesson *drawn, c205_word element);
unsigned random_width(const struct random_lesson *drawn);

#endif
