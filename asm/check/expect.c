/* expect.c - compares the result of a run with the expectations of the program. */
#include "asm/check/expect.h"
#include "asm/view/operand_view.h"
#include "asm/view/word_text.h"
#include "base/plural.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

enum { WORD_BITS = 64, HALF_BITS = 32 };

/* The result of a run, and the sink for the report. */
struct outcome {
    const c205 *machine;
    const c205_stop *stop;
    const char *printed; /* the rest of the output, which no expectation has compared
                            yet */
    warning_set warned;  /* warnings of the program */
    bool other_model;    /* the expected clocks belong to another model */
    const struct sink *report;
};

static void print_where(const struct outcome *outcome,
                        const struct asm_expectation *expectation)
{
    sink_print(outcome->report, "%s:%zu: expected ", expectation->file,
               expectation->line);
}

static void print_tolerance(const struct outcome *outcome,
                            const struct asm_expectation *expectation)
{
    char text[C205_TEXT_SIZE];
    c205_to_text(expectation->tolerance, text);
    sink_print(outcome->report, " ~ %s", text);
}

static double value_number(bool half, c205_word word)
{
    return (half ? c205_half_to_double : c205_to_double)(word);
}

/* Compares two values with the tolerance of an expectation. No value is near an
 * indefinite value, not even itself. */
static bool is_near(const struct asm_expectation *expectation, bool half,
                    c205_word wanted, c205_word found)
{
    double distance = value_number(half, found) - value_number(half, wanted);
    return fabs(distance) <= c205_to_double(expectation->tolerance);
}

/* Explains a difference of words whose numbers are equal. */
static void print_why(const struct outcome *outcome,
                      const struct asm_expectation *expectation, bool half,
                      c205_word wanted, c205_word found)
{
    if (expectation->kind != EXPECT_FLAGS
        && value_number(half, wanted) == value_number(half, found))
        sink_put(outcome->report,
                 ": the numbers are equal, the words are not: 5 is an integer, 5.0 is "
                 "normalised; ~ 0 accepts both");
}

static bool compare(const struct outcome *outcome,
                    const struct asm_expectation *expectation, const char *place,
                    c205_word wanted, c205_word found)
{
    bool half = expectation->kind == EXPECT_HALF_REGISTER
                || expectation->kind == EXPECT_HALVES;
    if (wanted == found
        || (expectation->has_tolerance && is_near(expectation, half, wanted, found)))
        return true;
    print_where(outcome, expectation);
    sink_print(outcome->report, "%s = ", place);
    word_print(wanted, half, outcome->report);
    if (expectation->has_tolerance)
        print_tolerance(outcome, expectation);
    sink_put(outcome->report, ", found ");
    word_print(found, half, outcome->report);
    print_why(outcome, expectation, half, wanted, found);
    sink_put(outcome->report, "\n");
    return false;
}

/* Returns the half of a word that contains a bit, left-aligned. */
static c205_word half_of(c205_word word, uint64_t bit)
{
    return word << bit % WORD_BITS / HALF_BITS * HALF_BITS & ~(c205_word)UINT32_MAX;
}

static bool check_register(struct outcome *outcome,
                           const struct asm_expectation *expectation)
{
    bool half = expectation->kind == EXPECT_HALF_REGISTER;
    struct text_line place = { "", 0 };
    struct sink sink = text_line_sink(&place);
    sink_print(&sink, "%c%u", half ? 'h' : 'r', expectation->number);
    return compare(outcome, expectation, place.text, expectation->words[0],
                   view_register(outcome->machine, expectation->number, half));
}

static bool check_flags(struct outcome *outcome,
                        const struct asm_expectation *expectation)
{
    return compare(outcome, expectation, "data flags", expectation->words[0],
                   c205_data_flags(outcome->machine));
}

/* ---- Memory ---- */

static bool unmapped(const struct outcome *outcome,
                     const struct asm_expectation *expectation, uint64_t address)
{
    print_where(outcome, expectation);
    sink_print(outcome->report, "a value at %" PRIX64 ", found unmapped memory\n",
               address);
    return false;
}

static bool compare_element(const struct outcome *outcome,
                            const struct asm_expectation *expectation, const char *what,
                            size_t i, uint64_t address, c205_word found)
{
    struct text_line place = { "", 0 };
    struct sink sink = text_line_sink(&place);
    sink_print(&sink, "%s %zu, at %" PRIX64 ",", what, i, address);
    return compare(outcome, expectation, place.text, expectation->words[i], found);
}

static bool check_elements(struct outcome *outcome,
                           const struct asm_expectation *expectation)
{
    bool half = expectation->kind == EXPECT_HALVES, good = true;
    for (size_t i = 0; i < expectation->count; i++) {
        uint64_t address = expectation->address
                           + (half ? HALF_BITS : WORD_BITS) * (uint64_t)i;
        c205_word found;
        if (!c205_read(outcome->machine, address - (half ? address % WORD_BITS : 0),
                       &found, 1))
            return unmapped(outcome, expectation, address);
        good = compare_element(outcome, expectation, half ? "half" : "word", i, address,
                               half ? half_of(found, address) : found)
               && good;
    }
    return good;
}

static bool check_bits(struct outcome *outcome,
                       const struct asm_expectation *expectation)
{
    for (size_t i = 0; i < expectation->count; i++) {
        uint64_t address = expectation->address + i;
        c205_word word;
        unsigned wanted, found;
        if (!c205_read(outcome->machine, address / 64 * 64, &word, 1))
            return unmapped(outcome, expectation, address);
        wanted = expectation->words[i / 64] >> (63 - i % 64) & 1;
        found = word >> (63 - address % 64) & 1;
        if (wanted == found)
            continue;
        print_where(outcome, expectation);
        sink_print(outcome->report, "bit %zu, at %" PRIX64 ", = %u, found %u\n", i,
                   address, wanted, found);
        return false;
    }
    return true;
}

/* ---- The run as a whole ---- */

static bool check_clocks(struct outcome *outcome,
                         const struct asm_expectation *expectation)
{
    int64_t wanted = c205_to_integer(expectation->words[0]);
    uint64_t found = c205_clock(outcome->machine);
    if (found == (uint64_t)wanted || outcome->other_model)
        return true;
    print_where(outcome, expectation);
    sink_print(outcome->report, "%" PRId64 " clock%s, found %" PRIu64 "\n", wanted,
               plural((uint64_t)wanted), found);
    return false;
}

static bool check_trap(struct outcome *outcome,
                       const struct asm_expectation *expectation)
{
    c205_error found;
    if (strcmp(c205_trap_name(outcome->stop->trap), expectation->text) == 0)
        return true;
    print_where(outcome, expectation);
    c205_describe_stop(outcome->machine, outcome->stop, &found);
    sink_print(outcome->report, "trap %s, found: %s\n", expectation->text,
               found.message);
    return false;
}

/* Compares the next line of the output, without its newline, with an expectation. */
static bool check_print(struct outcome *outcome,
                        const struct asm_expectation *expectation)
{
    const char *line = outcome->printed;
    size_t length = strcspn(line, "\n");
    outcome->printed += length + (line[length] == '\n');
    if (strlen(expectation->text) == length
        && memcmp(expectation->text, line, length) == 0)
        return true;
    print_where(outcome, expectation);
    sink_print(outcome->report, "'%s' printed, found '%.*s'\n", expectation->text,
               length < 400 ? (int)length : 400, line);
    return false;
}

static bool check_warning(struct outcome *outcome,
                          const struct asm_expectation *expectation)
{
    enum warning warning = warning_named(expectation->text);
    if (warning < WARNINGS && outcome->warned & WARNING_BIT(warning))
        return true;
    print_where(outcome, expectation);
    sink_print(outcome->report, "the warning %s, found none\n", expectation->text);
    return false;
}

/* Accepts any model, because the expectation only determines the runs in which clocks
 * are compared. */
static bool check_model(struct outcome *outcome,
                        const struct asm_expectation *expectation)
{
    (void)outcome;
    (void)expectation;
    return true;
}

const struct asm_expectation *expect_find(const struct object *object,
                                          enum expectation_kind kind)
{
    for (size_t i = 0; i < object->expectation_count; i++)
        if (object->expectations[i].kind == kind)
            return &object->expectations[i];
    return NULL;
}

warning_set expect_warnings(const struct object *object)
{
    warning_set set = 0;
    for (size_t i = 0; i < object->expectation_count; i++) {
        const struct asm_expectation *expectation = &object->expectations[i];
        if (expectation->kind == EXPECT_WARNING
            && warning_named(expectation->text) < WARNINGS)
            set |= WARNING_BIT(warning_named(expectation->text));
    }
    return set;
}

bool expect_anything(const struct object *object)
{
    return object->expectation_count > (expect_find(object, EXPECT_MODEL) != NULL);
}

const char *expect_model(const struct object *object)
{
    const struct asm_expectation *found = expect_find(object, EXPECT_MODEL);
    return found ? found->text : NULL;
}

bool expect_other_model(const struct object *object, const c205 *machine)
{
    const char *named = expect_model(object);
    return named && expect_find(object, EXPECT_CLOCKS)
           && strcmp(named, c205_model_name(c205_machine_model(machine))) != 0;
}

static bool check_end(const struct outcome *outcome, const struct object *object)
{
    c205_error found;
    if (outcome->stop->trap == C205_TRAP_NONE || expect_find(object, EXPECT_TRAP))
        return true;
    c205_describe_stop(outcome->machine, outcome->stop, &found);
    sink_print(outcome->report, "expected the program to end with EXIT, found: %s\n",
               found.message);
    return false;
}

/* Fails if output is left that no expectation has compared. A program that expects any
 * line must expect all lines. */
static bool check_rest(const struct outcome *outcome, const struct object *object)
{
    size_t length = strcspn(outcome->printed, "\n");
    if (!*outcome->printed || !expect_find(object, EXPECT_PRINT))
        return true;
    sink_print(outcome->report,
               "expected the end of the output, found "
               "'%.*s'\n",
               length < 400 ? (int)length : 400, outcome->printed);
    return false;
}

bool expect_check(const struct object *object, const c205 *machine,
                  const c205_stop *stop, const char *printed, warning_set warned,
                  const struct sink *report)
{
    static bool (*const checks[EXPECT_KINDS])(struct outcome *,
                                              const struct asm_expectation *) = {
        [EXPECT_REGISTER] = check_register, [EXPECT_HALF_REGISTER] = check_register,
        [EXPECT_WORDS] = check_elements,    [EXPECT_HALVES] = check_elements,
        [EXPECT_BITS] = check_bits,         [EXPECT_FLAGS] = check_flags,
        [EXPECT_CLOCKS] = check_clocks,     [EXPECT_TRAP] = check_trap,
        [EXPECT_PRINT] = check_print,       [EXPECT_MODEL] = check_model,
        [EXPECT_WARNING] = check_warning
    };
    struct outcome outcome = { .machine = machine,
                               .stop = stop,
                               .printed = printed,
                               .warned = warned,
                               .other_model = expect_other_model(object, machine),
                               .report = report };
    bool good = check_end(&outcome, object);
    for (size_t i = 0; i < object->expectation_count; i++) {
        const struct asm_expectation *expectation = &object->expectations[i];
        good = checks[expectation->kind](&outcome, expectation) && good;
    }
    return check_rest(&outcome, object) && good;
}
