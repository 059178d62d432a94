/* lesson_internal.h - types and functions of the files that grade answers. Not
 * public. */
#ifndef ASM_LESSON_LESSON_INTERNAL_H
#define ASM_LESSON_LESSON_INTERNAL_H

#include "asm/check/runtime_check.h"
#include "asm/lesson/lesson.h"
#include "asm/measure/line_profile.h"
#include "asm/text/assemble.h"
#include "asm/view/print.h"
#include "vm/error.h"

/* Reads the comments of a test, whose name and text are set (notes.c). */
bool lesson_read_notes(struct lesson *lesson, struct lesson_test *test,
                       c205_error *error);

/* report_printf adds a sentence of at most 1,023 bytes. report_buffer adds the text of
 * a buffer, without its trailing newlines, and frees the buffer. The arena is marked as
 * failed if memory is exhausted. */
void report_printf(struct lesson_report *report, const char *format, ...)
    PRINTF_FORMAT(2, 3);
void report_buffer(struct lesson_report *report, struct text_buffer *buffer);
/* Reports a sentence and all diagnostics of a severity. */
void report_diagnostics(struct lesson_report *report, const char *sentence,
                        const struct diagnostics *said, enum severity severity);
/* Moves the last sentence before all others. */
void report_first(struct lesson_report *report);
/* Returns a source line without leading blanks. */
const char *lesson_source(const char *line);

/* ---- test_source.c: a test that is ready to run ----------------------------- */

struct test_case {
    const struct lesson_test *notes;
    struct object *object;
    struct asm_define *defines; /* constants for the answer; the last has no name */
    c205_model *model;
    c205 *data; /* machine with the data of the test */
};

/* Assembles a test, after the definition of constants (NULL: none). A fresh test is
 * like another test: the answer receives only the constants that both have, and the
 * test runs on the model of the other test unless it has its own. NULL: not a fresh
 * test. Must be closed in all cases. */
bool test_case_open(struct test_case *test, const struct lesson_test *notes,
                    const struct asm_define *defines, const struct object *like,
                    c205_error *error);
void test_case_close(struct test_case *test);

/* ---- test_data.c: data of a test and an answer --------------------------- */

/* Results that a test does not set are filled with this word before the run. It is an
 * indefinite, as are both of its halves. No operation computes it, because the
 * indefinite result of an operation has a zero coefficient. */
#define LESSON_POISON UINT64_C(0x7BAD205B7BAD205B)

/* The data of a label that both test and answer have. */
struct test_item {
    const char *label; /* label in the answer */
    enum asm_contents contents;
    size_t count;
    uint64_t expected_at, actual_at; /* bit addresses in the test and in the answer */
    const struct lesson_tolerance *tolerance; /* NULL: the words must be equal */
    /* Expected values, and values of the answer before and after the run. Each element
     * is left-aligned in a word. NULL for inputs. */
    c205_word *expected, *initial, *actual;
    bool poisoned; /* initial is LESSON_POISON */
};

struct lesson_test_data {
    const struct object *test, *answer;
    const c205 *data; /* machine with the data of the test */
    c205 *machine;    /* machine with the answer */
    size_t count;
    struct test_item *items;
    const struct lesson_test *notes;
    struct lesson_report *report, *general; /* reports about this test, and about all
                                               tests */
    struct arena *kept;
};

/* Returns true if a test has data at want_LABEL; NULL: any label (test_source.c). */
bool test_wants(const struct object *object, const char *label);
/* Returns true if a symbol is the label of data. */
bool test_holds_data(const struct asm_symbol *symbol);
/* Reads the elements of an item from an address on, each left-aligned in a word. */
void test_data_read(const c205 *machine, uint64_t at, const struct test_item *item,
                    c205_word *words);
/* Copies the inputs to the answer, lists the results to compare, and fills those that
 * the test does not set with LESSON_POISON. Returns false if
 * labels are missing, too small or of another type. Each such label has a report. */
bool test_data_begin(struct lesson_test_data *test_data);
/* Replaces the inputs at a label by LESSON_POISON. */
void test_data_spoil(const struct lesson_test_data *test_data, const char *label);
/* Compares the results after the run. Returns false with a report if a result is
 * wrong. */
bool test_data_end(struct lesson_test_data *test_data);
/* Copies the results of the solution to the expected data of the test. Returns false if
 * the solution has not stored a result. */
bool test_data_keep(const struct lesson_test_data *test_data, c205 *data,
                    c205_error *error);

/* ---- answer_run.c: an answer in a test --------------------------------------- */

struct answer_run {
    const char *name, *text;
    size_t length;
    const struct test_case *test;
    const char
        *spoilt;    /* label of an input that is replaced by LESSON_POISON, or NULL */
    uint64_t limit; /* maximum clocks; 0: those of the test */
    bool checked;   /* collect the warnings of the answer */
    struct lesson_report *report, *general; /* reports about this test, and about all
                                               tests */
    struct arena *kept;
    c205_error *error; /* error of the lesson */

    struct object *object; /* the answer with the constants of the test */
    c205 *machine;
    struct line_profile *profile;
    struct lesson_test_data data;
    struct printer printer;
    struct text_buffer printed;
    struct diagnostics said;        /* warnings of the assembler */
    struct runtime_checker *checks; /* warnings of the run; NULL: not checked */
    c205_stop stop;
    uint64_t clocks;
    bool ended; /* the run ended as expected */
};

/* Runs an answer in a test. Reports why it cannot run, or does not end as the test
 * expects. Returns false if memory is exhausted. Must be freed in all cases. */
bool answer_run(struct answer_run *run);
/* Returns true if the results are correct, and otherwise reports them. */
bool answer_is_right(struct answer_run *run);
/* Reports the warnings before all other sentences, unless the trial of an earlier test
 * has reported the same. */
void answer_report_warnings(const struct answer_run *run,
                            const struct lesson_verdict *verdict);
void answer_run_free(struct answer_run *run);

/* ---- fresh.c: tests with new inputs ------------------------------------------ */

/* The number of draws from which the first draw of an answer is selected. */
enum { LESSON_DRAWS = 1000000 };

struct fresh_test {
    struct lesson_test notes;
    struct test_case test;
    uint64_t clocks; /* of the solution */
};

/* Makes the fresh test of a draw. It is like the test of the lesson that is the model,
 * with the same constants, or has its own constants. The expected data are the results
 * of the solution. The goals are those of the model, times the ratio of the clocks of
 * the solution. Must be closed in all cases. */
bool fresh_open(struct fresh_test *fresh, const struct lesson *lesson,
                const struct test_case *model, bool like, uint64_t draw,
                struct arena *kept, c205_error *error);
void fresh_close(struct fresh_test *fresh);

/* ---- remarks.c: properties of suspicious answers ------------------------------- */

/* Sets the hash of the instructions of an answer, without the numbers of registers and
 * the addresses of data. Adds a remark if it is that of the solution. */
void lesson_compare_code(struct lesson_verdict *verdict, const struct object *object);
/* Adds a remark for each input of the tests that the answer does not read: without the
 * input its results are still right, and its clocks the same. The answer must be right
 * in all tests of the lesson, which are open. */
bool lesson_find_unread(struct lesson_verdict *verdict, const struct test_case *tests,
                        const char *text, size_t length, c205_error *error);

/* ---- Reports ------------------------------------------------------------- */

/* Returns true if the values match. Otherwise reports the mismatch and returns false
 * (mismatch.c). */
bool mismatch_report(const struct test_item *item, struct lesson_report *report);

/* Reports why the answer takes more clocks than its next goal (performance_hint.c). */
void performance_hint_report(const struct lesson_trial *trial, const c205 *machine,
                             const struct line_profile *profile,
                             struct lesson_report *report);

#endif
