/* lesson.h - lessons with an exercise, and what an answer to one is worth.
 *
 * A lesson is a folder: its text, a program to complete and tests.  A test is a text in the
 * assembler's language that holds other data: what is at its label L is put to the
 * answer's label L before the run, what is at want_L must be at L behind it, and its
 * integer constants are defined in the answer before the first line.  Comments of a test say
 *
 *   ; test: what it tries, a sentence
 *   ; tolerance: L 1e-12       numbers at L may be off by so much; without: the same words
 *   ; goals: gold 700, silver 900, bronze 4000   at most so many clocks; bronze passes
 *
 * beside what registers, prints and the like are expected of the run (expect.h).  docs/grading.md
 * has the rest.  Nothing here prints or touches a file.
 */
#ifndef ASM_LESSON_H
#define ASM_LESSON_H

#include "asm/assemble.h"
#include "base/arena.h"
#include "base/json.h"
#include "base/sink.h"

/* ---- Lessons --------------------------------------------------------------- */

enum medal { MEDAL_NONE, MEDAL_BRONZE, MEDAL_SILVER, MEDAL_GOLD, MEDALS };
/* "bronze"; "" where there is none. */
const char *medal_name(enum medal medal);

struct lesson_tolerance {
    const char *label;
    double most;
    const struct lesson_tolerance *next;
};

struct lesson_test {
    const char *name; /* of test-NAME.s */
    const char *text;
    size_t length;
    const char *tries;
    bool warm; /* a line of it says .warm */
    bool has_goals;
    uint64_t goals[MEDALS]; /* clocks, at most */
    const struct lesson_tolerance *tolerances;
};

struct lesson {
    const char *folder; /* "03-first-vector" */
    const char *name;   /* "first-vector" */
    unsigned number;    /* 3; 0: it has none */
    const char *title, *text, *start;
    size_t test_count, test_capacity;
    struct lesson_test *tests; /* those with goals come last */
    struct arena kept;
};

/* A folder's files, one after the other in any order; those that are none of a lesson's are
 * left out.  Begin with all zero; false: the error says which file is wrong, and how. */
bool lesson_begin(struct lesson *lesson, const char *folder, c205_error *error);
bool lesson_take(struct lesson *lesson, const char *file, const char *text,
                 size_t length, c205_error *error);
bool lesson_end(struct lesson *lesson, c205_error *error);
void lesson_free(struct lesson *lesson);
/* By "first-vector", "3", "03" or "03-first-vector". */
bool lesson_is_named(const struct lesson *lesson, const char *name);

/* Those that the library carries with it. */
struct lessons {
    size_t count;
    struct lesson *items; /* in their order */
};
bool lessons_open(struct lessons *lessons, c205_error *error);
void lessons_free(struct lessons *lessons);
/* The one that is named so; NULL: the error says what was meant. */
const struct lesson *lessons_find(const struct lessons *lessons, const char *name,
                                  c205_error *error);

/* A test's text, of which the labels hold the data; NULL: the error says what is wrong. */
struct object *lesson_assemble_test(const struct lesson_test *test, c205_error *error);
/* The label of the answer where that must be which a label of a test holds: "y" for "want_y";
 * NULL: it is an input. */
const char *lesson_wanted(const char *label);
/* One of the integers that are defined in the answer. */
bool lesson_is_constant(const struct asm_symbol *symbol);

/* ---- Answers --------------------------------------------------------------- */

/* Sentences, some with a piece of the program's text below them. */
struct lesson_report {
    size_t count, capacity;
    const char **sentences;
    struct arena *kept;
};

/* What came of one test. */
struct lesson_trial {
    const struct lesson_test *test;
    bool right;       /* all that it wants came true */
    bool passed;      /* .. and in time */
    uint64_t clocks;  /* 0: it did not run */
    enum medal medal; /* of tests with goals */
    struct lesson_report report;
};

struct lesson_verdict {
    const struct lesson *lesson;
    const char *answer; /* its name */
    bool graded;        /* the tests were tried */
    bool passed;        /* every test */
    enum medal medal;   /* the worst of them */
    uint64_t clocks;    /* of the slowest right one with goals */
    size_t count;
    struct lesson_trial *trials;
    struct lesson_report report; /* what is not of one test alone */
    struct arena kept;
};

/* The lesson and the name of the answer outlive the verdict.  Begin with all zero; false: the
 * lesson is wrong itself, or there is no memory; to be freed in either case. */
bool lesson_grade(struct lesson_verdict *verdict, const struct lesson *lesson,
                  const char *name, const char *text, size_t length, c205_error *error);
/* The verdict of a hand-in that cannot be graded: not passed, with the reason as its report.
 * The lesson is NULL if it is not known. */
void lesson_refuse(struct lesson_verdict *verdict, const struct lesson *lesson,
                   const char *name, const char *reason);
void lesson_verdict_free(struct lesson_verdict *verdict);

void lesson_verdict_put(const struct lesson_verdict *verdict, const struct sink *sink);
/* Into an object that is open. */
void lesson_verdict_json(const struct lesson_verdict *verdict, struct json *json);

#endif
