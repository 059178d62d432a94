/* mismatch.c - compares a result with the expected result, reports wrong elements and
 * recognises typical mistakes. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "asm/view/word_text.h"

/* ---- Elements -------------------------------------------------------------- */

static double plain_number(const struct test_item *item, c205_word element)
{
    switch (item->contents) {
    case ASM_WORDS: return c205_to_double(element);
    case ASM_HALF_WORDS: return c205_half_to_double(element);
    case ASM_BYTES: return (double)(element >> 56);
    default: return (double)(element >> 63);
    }
}

static bool is_same(const struct test_item *item, c205_word expected, c205_word actual)
{
    return expected == actual
           || (item->tolerance
               && fabs(plain_number(item, actual) - plain_number(item, expected))
                      <= item->tolerance->most);
}

static bool is_right(const struct test_item *item, size_t i)
{
    return is_same(item, item->expected[i], item->actual[i]);
}

/* ---- Typical mistakes ---------------------------------------------------- */

/* Functions that test for a property of one element of a result, or of the whole
 * result. */
typedef bool of_element(const struct test_item *item, size_t i);
typedef bool of_result(const struct test_item *item);

static bool all(const struct test_item *item, of_element *is)
{
    size_t i = 0;
    while (i < item->count && is(item, i))
        i++;
    return i == item->count;
}

static bool is_untouched(const struct test_item *item, size_t i)
{
    return item->actual[i] == item->initial[i];
}

/* Bits and bytes may equal those of LESSON_POISON by coincidence. */
static bool is_unstored(const struct test_item *item, size_t i)
{
    return item->poisoned && is_untouched(item, i)
           && (item->contents == ASM_WORDS || item->contents == ASM_HALF_WORDS);
}

static bool is_missing(const struct test_item *item, size_t i)
{
    return is_right(item, i) || is_unstored(item, i);
}

static bool is_zero(const struct test_item *item, size_t i)
{
    return plain_number(item, item->actual[i]) == 0;
}

static bool is_equal(const struct test_item *item, size_t i)
{
    return is_right(item, i)
           || plain_number(item, item->actual[i])
                  == plain_number(item, item->expected[i]);
}

static bool is_late(const struct test_item *item, size_t i)
{
    return i == 0 || is_same(item, item->expected[i - 1], item->actual[i]);
}

static bool is_early(const struct test_item *item, size_t i)
{
    return i + 1 == item->count
           || is_same(item, item->expected[i + 1], item->actual[i]);
}

static bool is_first(const struct test_item *item, size_t i)
{
    return item->expected[i] == item->expected[0];
}

/* Returns true if the result is so short that it may match a pattern by coincidence. */
static bool is_chance(const struct test_item *item)
{
    return item->contents == ASM_BITS && item->count < 16;
}

/* Returns true if a result that is shifted by one element could be recognised: it has
 * more than two elements, and they are not all equal. */
static bool have_places(const struct test_item *item)
{
    return item->count > 2 && !is_chance(item) && !all(item, is_first);
}

static bool too_late(const struct test_item *item)
{
    return have_places(item) && all(item, is_late);
}

static bool too_early(const struct test_item *item)
{
    return have_places(item) && all(item, is_early);
}

static bool is_backwards(const struct test_item *item, size_t i)
{
    return is_same(item, item->expected[item->count - 1 - i], item->actual[i]);
}

static bool backwards(const struct test_item *item)
{
    return !is_chance(item) && all(item, is_backwards);
}

static int compare_words(const void *a, const void *b)
{
    const c205_word *one = a, *other = b;
    return (*one > *other) - (*one < *other);
}

/* Returns true if the result is a permutation of the expected result. Bits are not
 * tested, because a permutation of bits is no evidence of a wrong order. */
static bool other_order(const struct test_item *item)
{
    size_t size = item->count * sizeof(c205_word);
    c205_word *expected = malloc(size), *actual = malloc(size);
    bool same = expected && actual && item->contents != ASM_BITS;
    if (same) {
        memcpy(expected, item->expected, size);
        memcpy(actual, item->actual, size);
        qsort(expected, item->count, sizeof *expected, compare_words);
        qsort(actual, item->count, sizeof *actual, compare_words);
        same = memcmp(expected, actual, size) == 0;
    }
    free(expected);
    free(actual);
    return same;
}

static bool is_above(const struct test_item *item, size_t i)
{
    return i == 0
           || plain_number(item, item->expected[i - 1])
                  <= plain_number(item, item->expected[i]);
}

static bool unsorted(const struct test_item *item)
{
    return all(item, is_above) && other_order(item);
}

static bool has_other_sign(const struct test_item *item, size_t i)
{
    return plain_number(item, item->actual[i])
           == -plain_number(item, item->expected[i]);
}

static bool is_other_bit(const struct test_item *item, size_t i)
{
    return item->contents == ASM_BITS && item->count > 1
           && item->actual[i] != item->expected[i];
}

static bool is_little_off(const struct test_item *item, size_t i)
{
    double little = item->contents == ASM_HALF_WORDS ? 1e-5 : 1e-9;
    double expected = plain_number(item, item->expected[i]);
    double actual = plain_number(item, item->actual[i]);
    return is_right(item, i) || fabs(actual - expected) <= little * fabs(expected);
}

static bool is_indefinite(const struct test_item *item, size_t i)
{
    return is_right(item, i) || isnan(plain_number(item, item->actual[i]));
}

static bool is_normalised(const struct test_item *item, c205_word element)
{
    switch (item->contents) {
    case ASM_WORDS: return c205_from_double(c205_to_double(element)) == element;
    case ASM_HALF_WORDS:
        return c205_half_from_double(c205_half_to_double(element)) == element;
    default: return true;
    }
}

static bool keeps_bits(const struct test_item *item, size_t i)
{
    return is_zero(item, i) || is_normalised(item, item->actual[i])
           || !is_normalised(item, item->expected[i]);
}

static bool lost_bits(const struct test_item *item)
{
    return !all(item, keeps_bits);
}

/* Returns true if only a beginning of the result was computed: some elements from the
 * first on are right, and all later elements are unchanged. */
static bool only_begun(const struct test_item *item)
{
    size_t i = 0;
    if (!is_right(item, 0))
        return false;
    while (is_right(item, i))
        i++;
    while (i < item->count && is_untouched(item, i))
        i++;
    return i == item->count;
}

/* The mistakes in the order of priority. The first mistake that matches is reported. */
static const struct likeness {
    of_element *each; /* the mistake matches if this is true of each element */
    of_result *whole; /* or if this is true of the whole result */
    const char *sentence;
} likenesses[] = {
    { is_unstored, NULL, "Nothing was stored there." },
    { is_untouched, NULL,
      "The run did not change it: nothing was stored there, or only the same values." },
    { is_zero, NULL, "It contains only zeros." },
    { is_equal, NULL,
      "The numbers are equal, but not their words: 5 is an integer word and 5.0 a "
      "normalised one, with different bits." },
    { NULL, too_late,
      "The right elements are one place too late: element 1 has the value that "
      "element 0 should have." },
    { NULL, too_early,
      "The right elements are one place too early: element 0 has the value that "
      "element 1 should have." },
    { NULL, backwards, "The right elements are there, but in reverse order." },
    { NULL, unsorted, "The right elements are there, but they are not sorted." },
    { NULL, other_order, "The right elements are there, but in another order." },
    { has_other_sign, NULL, "The sign is wrong." },
    { is_other_bit, NULL, "Each bit is the opposite of the right one." },
    { is_little_off, NULL,
      "Only the last bits are wrong: different operations, or the same in another "
      "order, round differently." },
    { is_missing, NULL, "Nothing was stored at the wrong elements." },
    { is_indefinite, NULL,
      "Indefinite results from a division by zero, the root of a negative number, or "
      "an operation on another indefinite.  Results that the test does not set are "
      "indefinite before the run." },
    { NULL, lost_bits,
      "They are not normalised: an integer operand, such as 2 instead of 2.0, makes "
      "a result lose bits." },
    { NULL, only_begun, "Nothing new was stored after the right elements." },
};

static bool fits(const struct likeness *likeness, const struct test_item *item)
{
    return likeness->each ? all(item, likeness->each) : likeness->whole(item);
}

/* ---- Sentences ----------------------------------------------------------- */

enum { MAX_LISTED = 3 };

/* Prints a value. Its bits are also printed if the numbers are equal and only the bits
 * differ. */
static void print_value(const struct test_item *item, c205_word element, bool with_bits,
                        const struct sink *sink)
{
    bool half = item->contents == ASM_HALF_WORDS;
    struct word_text text = word_text(element, half);
    if (item->contents == ASM_BITS || item->contents == ASM_BYTES) {
        sink_print(sink, "%.0f", plain_number(item, element));
        return;
    }
    if (with_bits)
        word_print(element, half, sink);
    else
        sink_put(sink, text.number);
}

static void print_element(const struct test_item *item, size_t i,
                          const struct sink *sink)
{
    c205_word expected = item->expected[i], actual = item->actual[i];
    bool with_bits = is_equal(item, i);
    if (is_unstored(item, i)) {
        sink_put(sink, " was not stored");
    } else {
        sink_put(sink, " is ");
        print_value(item, actual, with_bits, sink);
    }
    sink_put(sink, " and should be ");
    print_value(item, expected, with_bits, sink);
}

static void print_elements(const struct test_item *item, size_t wrong,
                           const struct sink *sink)
{
    size_t reported = 0;
    for (size_t i = 0; i < item->count && reported < MAX_LISTED; i++)
        if (!is_right(item, i)) {
            sink_print(sink, "%s %zu", reported == 0 ? "element" : ",", i);
            print_element(item, i, sink);
            reported++;
        }
    if (wrong > reported)
        sink_print(sink, ", and %zu more", wrong - reported);
}

/* Reports a wrong element. The report of a result with one element has no index. */
static void print_wrong(const struct test_item *item, size_t wrong,
                        const struct sink *sink)
{
    const char *label = item->label;
    size_t count = item->count;
    if (count == 1) {
        sink_put(sink, label);
        print_element(item, 0, sink);
        sink_put(sink, ".");
        return;
    }
    if (wrong == count && count == 2)
        sink_print(sink, "Both elements of %s are wrong: ", label);
    else if (wrong == count)
        sink_print(sink, "All %zu elements of %s are wrong: ", count, label);
    else
        sink_print(sink, "%zu of the %zu elements of %s %s wrong: ", wrong, count,
                   label, wrong == 1 ? "is" : "are");
    print_elements(item, wrong, sink);
    sink_put(sink, " (counted from 0).");
}

static void print_likeness(const struct test_item *item, const struct sink *sink)
{
    size_t i = 0, count = sizeof likenesses / sizeof *likenesses;
    while (i < count && !fits(&likenesses[i], item))
        i++;
    if (i < count)
        sink_print(sink, "  %s", likenesses[i].sentence);
}

bool mismatch_report(const struct test_item *item, struct lesson_report *report)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    size_t wrong = 0;
    for (size_t i = 0; i < item->count; i++)
        wrong += !is_right(item, i);
    if (wrong == 0)
        return true;
    print_wrong(item, wrong, &sink);
    print_likeness(item, &sink);
    report_buffer(report, &text);
    return false;
}
