/* mismatch.c - what is wrong with a result: which elements, and what they look like. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"

/* ---- Elements -------------------------------------------------------------- */

static double number_of(const struct test_data *exchanged, c205_word element)
{
    switch (exchanged->contents) {
    case ASM_WORDS: return c205_to_double(element);
    case ASM_HALF_WORDS: return c205_half_to_double(element);
    case ASM_BYTES: return (double)(element >> 56);
    default: return (double)(element >> 63);
    }
}

static bool is_same(const struct test_data *exchanged, c205_word wanted,
                    c205_word found)
{
    return wanted == found
           || (exchanged->tolerance
               && fabs(number_of(exchanged, found) - number_of(exchanged, wanted))
                      <= exchanged->tolerance->most);
}

static bool is_right(const struct test_data *exchanged, size_t i)
{
    return is_same(exchanged, exchanged->wanted[i], exchanged->found[i]);
}

/* ---- What they look like --------------------------------------------------- */

/* Of a result of which something is wrong: an element, or all of it. */
typedef bool of_element(const struct test_data *exchanged, size_t i);
typedef bool of_result(const struct test_data *exchanged);

static bool all(const struct test_data *exchanged, of_element *is)
{
    size_t i = 0;

    while (i < exchanged->count && is(exchanged, i))
        i++;
    return i == exchanged->count;
}

static bool is_untouched(const struct test_data *exchanged, size_t i)
{
    return exchanged->found[i] == exchanged->before[i];
}

static bool is_zero(const struct test_data *exchanged, size_t i)
{
    return number_of(exchanged, exchanged->found[i]) == 0;
}

static bool is_equal(const struct test_data *exchanged, size_t i)
{
    return is_right(exchanged, i)
           || number_of(exchanged, exchanged->found[i])
                  == number_of(exchanged, exchanged->wanted[i]);
}

static bool is_late(const struct test_data *exchanged, size_t i)
{
    return i == 0 || is_same(exchanged, exchanged->wanted[i - 1], exchanged->found[i]);
}

static bool is_early(const struct test_data *exchanged, size_t i)
{
    return i + 1 == exchanged->count
           || is_same(exchanged, exchanged->wanted[i + 1], exchanged->found[i]);
}

static bool is_first(const struct test_data *exchanged, size_t i)
{
    return exchanged->wanted[i] == exchanged->wanted[0];
}

/* What so few bits look like is chance. */
static bool is_chance(const struct test_data *exchanged)
{
    return exchanged->contents == ASM_BITS && exchanged->count < 16;
}

/* Elements that are all the same, or one or two, stand nowhere too early. */
static bool have_places(const struct test_data *exchanged)
{
    return exchanged->count > 2 && !is_chance(exchanged) && !all(exchanged, is_first);
}

static bool too_late(const struct test_data *exchanged)
{
    return have_places(exchanged) && all(exchanged, is_late);
}

static bool too_early(const struct test_data *exchanged)
{
    return have_places(exchanged) && all(exchanged, is_early);
}

static bool is_backwards(const struct test_data *exchanged, size_t i)
{
    return is_same(exchanged, exchanged->wanted[exchanged->count - 1 - i],
                   exchanged->found[i]);
}

static bool backwards(const struct test_data *exchanged)
{
    return !is_chance(exchanged) && all(exchanged, is_backwards);
}

static int compare_words(const void *a, const void *b)
{
    const c205_word *one = a, *other = b;

    return (*one > *other) - (*one < *other);
}

/* The same elements, each as often; of bits that says little. */
static bool other_order(const struct test_data *exchanged)
{
    size_t size = exchanged->count * sizeof(c205_word);
    c205_word *wanted = malloc(size), *found = malloc(size);
    bool same = wanted && found && exchanged->contents != ASM_BITS;

    if (same) {
        memcpy(wanted, exchanged->wanted, size);
        memcpy(found, exchanged->found, size);
        qsort(wanted, exchanged->count, sizeof *wanted, compare_words);
        qsort(found, exchanged->count, sizeof *found, compare_words);
        same = memcmp(wanted, found, size) == 0;
    }
    free(wanted);
    free(found);
    return same;
}

static bool is_above(const struct test_data *exchanged, size_t i)
{
    return i == 0
           || number_of(exchanged, exchanged->wanted[i - 1])
                  <= number_of(exchanged, exchanged->wanted[i]);
}

static bool unsorted(const struct test_data *exchanged)
{
    return all(exchanged, is_above) && other_order(exchanged);
}

static bool has_other_sign(const struct test_data *exchanged, size_t i)
{
    return number_of(exchanged, exchanged->found[i])
           == -number_of(exchanged, exchanged->wanted[i]);
}

static bool is_other_bit(const struct test_data *exchanged, size_t i)
{
    return exchanged->contents == ASM_BITS && exchanged->count > 1
           && exchanged->found[i] != exchanged->wanted[i];
}

static bool is_little_off(const struct test_data *exchanged, size_t i)
{
    double little = exchanged->contents == ASM_HALF_WORDS ? 1e-5 : 1e-9;
    double wanted = number_of(exchanged, exchanged->wanted[i]);
    double found = number_of(exchanged, exchanged->found[i]);

    return is_right(exchanged, i) || fabs(found - wanted) <= little * fabs(wanted);
}

static bool is_indefinite(const struct test_data *exchanged, size_t i)
{
    return is_right(exchanged, i) || isnan(number_of(exchanged, exchanged->found[i]));
}

static bool is_normalised(const struct test_data *exchanged, c205_word element)
{
    switch (exchanged->contents) {
    case ASM_WORDS: return c205_from_double(c205_to_double(element)) == element;
    case ASM_HALF_WORDS:
        return c205_half_from_double(c205_half_to_double(element)) == element;
    default: return true;
    }
}

static bool keeps_bits(const struct test_data *exchanged, size_t i)
{
    return is_zero(exchanged, i) || is_normalised(exchanged, exchanged->found[i])
           || !is_normalised(exchanged, exchanged->wanted[i]);
}

static bool lost_bits(const struct test_data *exchanged)
{
    return !all(exchanged, keeps_bits);
}

/* Some at the beginning are right, and nothing was stored behind them. */
static bool only_begun(const struct test_data *exchanged)
{
    size_t i = 0;

    if (!is_right(exchanged, 0))
        return false;
    while (is_right(exchanged, i))
        i++;
    while (i < exchanged->count && is_untouched(exchanged, i))
        i++;
    return i == exchanged->count;
}

/* The first that fits is told. */
static const struct likeness {
    of_element *each; /* it fits if this is true of each element; .. */
    of_result *whole; /* .. or this of all together */
    const char *sentence;
} likenesses[] = {
    { is_untouched, NULL,
      "It holds what it held before the run: nothing was stored there, or "
      "nothing new." },
    { is_zero, NULL, "All that stands there is zero." },
    { is_equal, NULL,
      "The numbers are equal, but not their words: 5 is an integer word and "
      "5.0 a normalised one, with other bits." },
    { NULL, too_late,
      "The right elements stand one place too far behind: element 1 has what "
      "element 0 should have." },
    { NULL, too_early,
      "The right elements stand one place too far in front: element 0 has "
      "what element 1 should have." },
    { NULL, backwards, "The right elements stand there from back to front." },
    { NULL, unsorted, "The right elements stand there, but they are not sorted." },
    { NULL, other_order, "The right elements stand there, in another order." },
    { has_other_sign, NULL, "The sign is wrong." },
    { is_other_bit, NULL, "Each bit is the opposite of the right one." },
    { is_little_off, NULL,
      "Only the last bits are wrong: other operations, or the same in "
      "another order, round otherwise." },
    { is_indefinite, NULL,
      "Indefinite comes of a division by zero or a root of a negative "
      "number, and of all that is computed with it." },
    { NULL, lost_bits,
      "They are not normalised: an integer word among the operands, 2 for "
      "2.0, costs a result its bits." },
    { NULL, only_begun, "Nothing new was stored behind those that are right." },
};

static bool fits(const struct likeness *likeness, const struct test_data *exchanged)
{
    return likeness->each ? all(exchanged, likeness->each) : likeness->whole(exchanged);
}

/* ---- In words -------------------------------------------------------------- */

enum { MAX_LISTED = 3 };

/* Words of equal numbers are told by their bits as well. */
static void print_value(const struct test_data *exchanged, c205_word element,
                        bool with_bits, const struct sink *sink)
{
    char text[C205_TEXT_SIZE], bits[C205_TEXT_SIZE];
    bool half = exchanged->contents == ASM_HALF_WORDS;

    if (exchanged->contents == ASM_BITS || exchanged->contents == ASM_BYTES) {
        sink_print(sink, "%.0f", number_of(exchanged, element));
        return;
    }
    (half ? c205_half_to_text : c205_to_text)(element, text);
    c205_to_hex(element, bits);
    if (half)
        bits[9] = '\0'; /* 8 digits and a blank */
    if (with_bits)
        sink_print(sink, "X'%s' (%s)", bits, text);
    else
        sink_put(sink, text);
}

static void print_element(const struct test_data *exchanged, size_t i,
                          const struct sink *sink)
{
    c205_word wanted = exchanged->wanted[i], found = exchanged->found[i];
    bool with_bits = is_equal(exchanged, i);

    sink_put(sink, " is ");
    print_value(exchanged, found, with_bits, sink);
    sink_put(sink, " and should be ");
    print_value(exchanged, wanted, with_bits, sink);
}

static void print_elements(const struct test_data *exchanged, size_t wrong,
                           const struct sink *sink)
{
    size_t reported = 0;

    for (size_t i = 0; i < exchanged->count && reported < MAX_LISTED; i++)
        if (!is_right(exchanged, i)) {
            sink_print(sink, "%s %zu", reported == 0 ? "element" : ",", i);
            print_element(exchanged, i, sink);
            reported++;
        }
    if (wrong > reported)
        sink_print(sink, ", and %zu more", wrong - reported);
}

/* What single results are is told without counting. */
static void print_wrong(const struct test_data *exchanged, size_t wrong,
                        const struct sink *sink)
{
    const char *label = exchanged->label;
    size_t count = exchanged->count;

    if (count == 1) {
        sink_put(sink, label);
        print_element(exchanged, 0, sink);
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
    print_elements(exchanged, wrong, sink);
    sink_put(sink, " (counted from 0).");
}

static void print_likeness(const struct test_data *exchanged, const struct sink *sink)
{
    size_t i = 0, count = sizeof likenesses / sizeof *likenesses;

    while (i < count && !fits(&likenesses[i], exchanged))
        i++;
    if (i < count)
        sink_print(sink, "  %s", likenesses[i].sentence);
}

bool mismatch_report(const struct test_data *exchanged, struct lesson_report *report)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    size_t wrong = 0;

    for (size_t i = 0; i < exchanged->count; i++)
        wrong += !is_right(exchanged, i);
    if (wrong == 0)
        return true;
    print_wrong(exchanged, wrong, &sink);
    print_likeness(exchanged, &sink);
    report_buffer(report, &text);
    return false;
}
