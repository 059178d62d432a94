/* lesson_internal.h - what the parts of grading share.  Not public. */
#ifndef ASM_LESSON_LESSON_INTERNAL_H
#define ASM_LESSON_LESSON_INTERNAL_H

#include "asm/lesson/lesson.h"
#include "asm/line_profile.h"

/* notes.c: what the comments of a test say; its name and text are there. */
bool lesson_read_notes(struct lesson *lesson, struct lesson_test *test,
                       c205_error *error);

/* A sentence of at most 1,023 bytes; or what a buffer holds, which is freed, but for the
 * newlines at its end.  Where there is no memory the arena says so. */
void report_printf(struct lesson_report *report, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
void report_buffer(struct lesson_report *report, struct text_buffer *buffer);
/* A source line without its margin. */
const char *lesson_source(const char *line);

/* ---- test_data.c: data between a test and an answer ------------------------- */

/* A label of both. */
struct test_item {
    const char *label; /* of the answer */
    enum asm_contents contents;
    size_t count;
    uint64_t expected_at,
        actual_at; /* where it begins, in the test and in the answer */
    const struct lesson_tolerance *tolerance; /* NULL: the same words */
    /* What is wanted, and what the answer has there before the run and behind it, an element
     * at the left of each word; inputs have none. */
    c205_word *expected, *initial, *actual;
};

struct lesson_test_data {
    const struct object *test, *answer;
    const c205 *data; /* the test's, loaded */
    c205 *machine;    /* the answer's, loaded */
    size_t count;
    struct test_item *items;
    const struct lesson_test *notes;
    struct lesson_report *report, *general; /* of this test; of all */
    struct arena *kept;
};

/* Lists what is wanted and puts the data.  False: labels are missing, too small or of another
 * kind; each is told. */
bool test_data_begin(struct lesson_test_data *test_data);
/* Behind the run.  False: something is wrong; it is told. */
bool test_data_end(struct lesson_test_data *test_data);

/* ---- In words -------------------------------------------------------------- */

/* mismatch.c: false, and told, if what was found is not what was wanted. */
bool mismatch_report(const struct test_item *item, struct lesson_report *report);

/* performance_hint.c: why it takes more clocks than the next goal. */
void performance_hint_report(const struct lesson_trial *trial, const c205 *machine,
                             const struct line_profile *profile,
                             struct lesson_report *report);

#endif
