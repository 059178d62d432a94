/* random_verdict.c - derives the sentences of a verdict from the known mistake. */
#include "tests/unit/random_verdict.h"

#include <math.h>
#include <string.h>

static void format_value(const struct random_lesson *drawn, c205_word element,
                         const struct sink *sink)
{
    char text[C205_TEXT_SIZE];
    if (drawn->kind == DRAWN_BITS)
        strcpy(text, element ? "1" : "0");
    else if (drawn->kind == DRAWN_HALVES)
        c205_half_to_text(element, text);
    else
        c205_to_text(element, text);
    sink_put(sink, text);
}

/* An element that the answer does not store. */
#define UNSTORED UINT64_C(0x7BAD205B7BAD205B)

static void format_element(const struct random_lesson *drawn, c205_word found,
                           c205_word wanted, const struct sink *sink)
{
    if (found == UNSTORED) {
        sink_put(sink, " was not stored");
    } else {
        sink_put(sink, " is ");
        format_value(drawn, found, sink);
    }
    sink_put(sink, " and should be ");
    format_value(drawn, wanted, sink);
}

/* Returns the element of y after the answer has run. */
static c205_word found_at(const struct random_lesson *drawn, size_t i)
{
    const struct random_test *test = &drawn->tests[drawn->faulty];
    switch (drawn->fault) {
    case FAULT_NOTHING: return UNSTORED;
    case FAULT_LATE: return i > 0 ? test->wanted[i - 1] : UNSTORED;
    case FAULT_BACKWARDS: return test->wanted[test->n - 1 - i];
    case FAULT_SIGN:
        return drawn->kind == DRAWN_WORDS
                   ? c205_from_double(-c205_to_double(test->wanted[i]))
                   : c205_half_from_double(-c205_half_to_double(test->wanted[i]));
    case FAULT_ELEMENT:
    case FAULT_LAST_BIT: return i == drawn->element ? drawn->found : test->wanted[i];
    default: return test->wanted[i];
    }
}

static bool is_near(const struct random_lesson *drawn, c205_word found,
                    c205_word wanted)
{
    return found == wanted
           || (drawn->tests[drawn->faulty].tolerant
               && fabs(random_number(drawn, found) - random_number(drawn, wanted))
                      <= c205_to_double(c205_from_double(1e-3)));
}

size_t random_count_wrong(const struct random_lesson *drawn)
{
    const struct random_test *test = &drawn->tests[drawn->faulty];
    size_t wrong = 0;
    for (size_t i = 0; i < test->n; i++)
        wrong += !is_near(drawn, found_at(drawn, i), test->wanted[i]);
    return wrong;
}

void random_mismatch(const struct random_lesson *drawn, size_t wrong,
                     const struct sink *sink)
{
    const struct random_test *test = &drawn->tests[drawn->faulty];
    size_t reported = 0;
    if (test->n == 1) {
        sink_put(sink, "y");
        format_element(drawn, found_at(drawn, 0), test->wanted[0], sink);
        sink_put(sink, ".");
        return;
    }
    if (wrong == test->n && wrong == 2)
        sink_put(sink, "Both elements of y are");
    else if (wrong == test->n)
        sink_print(sink, "All %zu elements of y are", test->n);
    else
        sink_print(sink, "%zu of the %zu elements of y %s", wrong, test->n,
                   wrong == 1 ? "is" : "are");
    sink_put(sink, " wrong: element");
    for (size_t i = 0; i < test->n && reported < 3; i++) {
        if (is_near(drawn, found_at(drawn, i), test->wanted[i]))
            continue;
        sink_print(sink, "%s %zu", reported++ ? "," : "", i);
        format_element(drawn, found_at(drawn, i), test->wanted[i], sink);
    }
    if (wrong > reported)
        sink_print(sink, ", and %zu more", wrong - reported);
    sink_put(sink, " (counted from 0).");
}

const char *random_likeness(const struct random_lesson *drawn)
{
    static const char *const sentences[DRAWN_FAULTS] = {
        [FAULT_ELEMENT] = "",
        [FAULT_LAST_BIT] =
            "  Only the last bits are wrong: different operations, or the same in "
            "another order, round differently.",
        [FAULT_NOTHING] = "  Nothing was stored there.",
        [FAULT_LATE] =
            "  The right elements are one place too late: element 1 has the value "
            "that element 0 should have.",
        [FAULT_BACKWARDS] = "  The right elements are there, but in reverse order.",
        [FAULT_SIGN] = "  The sign is wrong.",
    };
    return drawn->kind == DRAWN_BITS ? NULL : sentences[drawn->fault];
}

size_t random_fault_line(const struct random_lesson *drawn)
{
    const char *at = drawn->answer, *fault = strstr(at, "; fault");
    size_t line = 1;
    for (; at < fault; at++)
        line += *at == '\n';
    return line;
}
