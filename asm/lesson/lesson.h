/* lesson.h - builds lessons from the texts of their files, and grades answers to their
 * exercises.
 *
 * A lesson is a folder with a text, a program to complete and tests. A test is a source
 * file of the assembler that holds data:
 *
 *   - The data at its label L are copied to the answer's label L before the run.
 *   - The data at its label want_L must be at the answer's label L after the run.
 *   - Its integer constants are defined in the answer before the first line.
 *
 * Comments of a test have these forms:
 *
 *   ; test: a sentence that names what is tested
 *   ; tolerance: L 1e-12       numbers at L may differ by this; without it: same words
 *   ; goals: gold 700, silver 900, bronze 4000   clocks at most; bronze passes
 *
 * A test may also use the expectations of expect.h, for registers and output. The file
 * fresh.s is a test without expected data, from which the grader makes tests with new
 * inputs. docs/grading.md describes the rest. These functions neither print nor access
 * files.
 */
#ifndef ASM_LESSON_H
#define ASM_LESSON_H

#include "asm/object/object.h"
#include "base/arena.h"
#include "base/json.h"
#include "base/sink.h"

/* ---- Lessons --------------------------------------------------------------- */

enum medal { MEDAL_NONE, MEDAL_BRONZE, MEDAL_SILVER, MEDAL_GOLD, MEDALS };
/* Returns the name of a medal, such as "bronze", or "" for no medal. */
const char *medal_name(enum medal medal);

struct lesson_tolerance {
    const char *label;
    double most;
    const struct lesson_tolerance *next;
};

struct lesson_test {
    const char *name; /* the NAME in test-NAME.s */
    const char *file; /* name of the file */
    const char *text;
    size_t length;
    const char *tries;
    bool warm; /* the test has a line .warm */
    bool has_goals;
    uint64_t goals[MEDALS]; /* maximum clocks for each medal */
    const struct lesson_tolerance *tolerances;
};

struct lesson {
    const char *folder; /* for example "03-first-vector" */
    const char *name;   /* for example "first-vector" */
    unsigned number;    /* for example 3; 0: none */
    const char *title, *text, *start;
    size_t test_count, test_capacity;
    struct lesson_test *tests; /* tests with goals come last */
    const char *solution;      /* solution.s, or NULL */
    struct lesson_test fresh;  /* fresh.s; its text is NULL if there is none */
    struct arena kept;
};

/* Build a lesson, which must be zeroed: begin, then the files of its folder in any
 * order, then end. Files that do not belong to a lesson are ignored. They return false
 * and set the error, which names the file, if a file is invalid. */
bool lesson_begin(struct lesson *lesson, const char *folder, c205_error *error);
bool lesson_take(struct lesson *lesson, const char *file, const char *text,
                 size_t length, c205_error *error);
bool lesson_end(struct lesson *lesson, c205_error *error);
void lesson_free(struct lesson *lesson);
/* Returns true if a name is "first-vector", "3", "03" or "03-first-vector" for the
 * lesson of that folder. */
bool lesson_is_named(const struct lesson *lesson, const char *name);

/* The lessons of the library. */
struct lessons {
    size_t count;
    struct lesson *items; /* in the order of their folders */
};
bool lessons_open(struct lessons *lessons, c205_error *error);
void lessons_free(struct lessons *lessons);
/* Returns the lesson with a name. Returns NULL if there is none; the error then
 * suggests a similar name. */
struct lesson *lessons_find(const struct lessons *lessons, const char *name,
                            c205_error *error);

/* Assembles the text of a test. Returns NULL and sets the error on failure. */
struct object *lesson_assemble_test(const struct lesson_test *test, c205_error *error);
/* Returns the label of the results in the answer for a label of the test: "y" for
 * "want_y". Returns NULL if the label of the test does not begin with "want_". */
const char *lesson_wanted(const char *label);
/* Returns true if the symbol is an integer constant. The constants of a test are also
 * defined for the answer. */
bool lesson_is_constant(const struct asm_symbol *symbol);

/* ---- Answers --------------------------------------------------------------- */

/* A report on an answer, as sentences. Source lines of the answer may follow a
 * sentence. */
struct lesson_report {
    size_t count, capacity;
    const char **sentences;
    struct arena *kept;
};

/* The result of a test. */
struct lesson_trial {
    const struct lesson_test *test;
    uint64_t draw; /* number of the draw of a fresh test; 0: a test of the lesson */
    const struct lesson_test *like; /* the test that the fresh test is like, or NULL */
    bool right;                     /* all results are correct */
    bool passed;                    /* correct, and within the clocks for bronze */
    uint64_t clocks;                /* 0: the answer did not run */
    enum medal medal;               /* MEDAL_NONE if the test has no goals */
    struct lesson_report report;
};

struct lesson_verdict {
    const struct lesson *lesson;
    const char *answer; /* name of the answer */
    bool graded;        /* the tests have run */
    bool passed;        /* all tests passed */
    enum medal medal;   /* the lowest medal of all tests */
    uint64_t clocks;    /* maximum clocks of a correct test with goals */
    size_t count;
    struct lesson_trial *trials; /* the tests of the lesson, then its fresh tests */
    struct lesson_report report; /* reports about more than one test */
    /* A test of the lesson counts as right if its fresh tests are right, too. The fresh
     * tests of other lengths count as one more test. */
    size_t right_count, of_count;
    unsigned points; /* of 100 */
    /* With fresh tests: reasons to look at the answer, and a hash of its instructions.
     * The hash is 0 if it is unknown or that of start.s. */
    struct lesson_report remarks;
    uint64_t code;
    struct arena kept;
};

/* The draws of fresh tests. Each draw has a fresh test for every test of the lesson,
 * and one more of other lengths. */
struct lesson_draws {
    size_t count; /* 0: no fresh tests */
    uint64_t
        first; /* number of the first draw; 0: derived from the text of the answer */
};

/* Returns true if the lesson has fresh tests. */
bool lesson_has_fresh(const struct lesson *lesson, c205_error *error);

/* Writes the fresh tests of a draw as texts of tests. */
bool lesson_fresh_put(const struct lesson *lesson, uint64_t draw,
                      const struct sink *sink, c205_error *error);

/* Grades an answer. The verdict must be zeroed, and must be freed in all cases. The
 * lesson and the name must outlive it. Returns false and sets the error if the lesson
 * is invalid or memory is exhausted. */
bool lesson_grade(struct lesson_verdict *verdict, const struct lesson *lesson,
                  struct lesson_draws draws, const char *name, const char *text,
                  size_t length, c205_error *error);
/* Sets the verdict of an answer that cannot be graded: not passed, with the reason as
 * its report. lesson is NULL if the lesson is unknown. */
void lesson_refuse(struct lesson_verdict *verdict, const struct lesson *lesson,
                   const char *name, const char *reason);
/* Adds the remark that another answer has the same code. */
void lesson_remark_same_code(struct lesson_verdict *verdict, const char *other);
void lesson_verdict_free(struct lesson_verdict *verdict);

void lesson_report_put(const struct lesson_report *report, const struct sink *sink);
void lesson_verdict_put(const struct lesson_verdict *verdict, const struct sink *sink);
/* Writes the verdict as members of the JSON object that is open. */
void lesson_verdict_json(const struct lesson_verdict *verdict, struct json *json);

#endif
