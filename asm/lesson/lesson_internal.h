/* lesson_internal.h - types and functions of the files that grade answers. Not
 * public. */
#ifndef ASM_LESSON_LESSON_INTERNAL_H
#define ASM_LESSON_LESSON_INTERNAL_H

#include "asm/lesson/lesson.h"
#include "asm/measure/line_profile.h"
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
/* Returns a source line without leading blanks. */
const char *lesson_source(const char *line);

/* ---- test_data.c: data of a test and an answer --------------------------- */

/* Results that a test does not set are filled with this word before the run. It is an
 * indefinite, as are both of its halves. No operation computes it, because the indefinite
 * result of an operation has a zero coefficient. */
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

/* Copies the inputs to the answer, lists the results to compare, and fills those that
 * the test does not set with LESSON_POISON. Returns false if
 * labels are missing, too small or of another type. Each such label has a report. */
bool test_data_begin(struct lesson_test_data *test_data);
/* Compares the results after the run. Returns false with a report if a result is
 * wrong. */
bool test_data_end(struct lesson_test_data *test_data);

/* ---- Reports ------------------------------------------------------------- */

/* Returns true if the values match. Otherwise reports the mismatch and returns false
 * (mismatch.c). */
bool mismatch_report(const struct test_item *item, struct lesson_report *report);

/* Reports why the answer takes more clocks than its next goal (performance_hint.c). */
void performance_hint_report(const struct lesson_trial *trial, const c205 *machine,
                             const struct line_profile *profile,
                             struct lesson_report *report);

#endif
