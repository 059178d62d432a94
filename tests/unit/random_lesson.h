/* random_lesson.h - random lessons, and answers with a known mistake.
 *
 * The exercise is y := 2 x over n elements of one kind. For bits it is y := not x. An
 * answer is correct in all tests except one, in which it makes the mistake.
 */
#ifndef TESTS_RANDOM_LESSON_H
#define TESTS_RANDOM_LESSON_H

#include "asm/lesson/lesson.h"

enum { DRAWN_LONGEST = 60, DRAWN_TESTS = 3 };

enum random_kind { DRAWN_WORDS, DRAWN_HALVES, DRAWN_BITS, DRAWN_KINDS };

/* The method of the answer. The second and third method are only used for words. */
enum random_way { WAY_VECTOR, WAY_LINKED, WAY_SCALAR, DRAWN_WAYS };

enum random_fault {
    FAULT_NONE, /* the answer is correct; it may repeat the work */
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
    size_t n; /* different from the n of all other tests */
    bool warm, has_goals, tolerant;
    const char *model;
    c205_word x[DRAWN_LONGEST], wanted[DRAWN_LONGEST]; /* left-aligned in a word */
    uint64_t goals[MEDALS];
};

struct random_lesson {
    enum random_kind kind;
    size_t count;
    struct random_test tests[DRAWN_TESTS];
    /* Properties of the answer. */
    enum random_fault fault;
    enum random_way way;
    size_t faulty, element, repeated, /* the test with the mistake, the wrong element,
                                       * number of repetitions */
        idle;        /* number of instructions between two others in scalar code */
    c205_word found; /* wrong value, for FAULT_ELEMENT and FAULT_LAST_BIT */
    char answer[8192];
};

/* Makes a lesson, except its goals. */
void draw_lesson(struct random_lesson *drawn, uint64_t *random_state);
/* Opens the lesson like a folder on disk. A rejected lesson fails the test. */
void random_open(const struct random_lesson *drawn, struct lesson *lesson);

/* Grades an answer. If the lesson itself is wrong, the test fails. */
void grade_well(struct lesson_verdict *verdict, const struct lesson *lesson,
                const char *answer);

double random_number(const struct random_lesson *drawn, c205_word element);
unsigned random_width(const struct random_lesson *drawn);

#endif
