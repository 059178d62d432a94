/* random_lesson.c - makes random lessons, and writes their answers and tests. */
#include "tests/unit/random_lesson.h"

#include <inttypes.h>

#include "tests/random.h"
#include "tests/unit/asm_helper.h"

static const struct {
    unsigned width;
    const char *directive, *work, *fault_work;
} kinds[DRAWN_KINDS] = {
    { 64, ".vector", "ADDNV   [xs], [xs], [ys]", "ADDNV   [value], [value], [one]" },
    { 32, ".halfvector", "ADDNV,H [xs], [xs], [ys]",
      "ADDNV,H [value], [value], [one]" },
    { 1, ".bitvector", "NANDB   [xs], [xs], [ys]", "NANDB   [one], [one], [one]" },
};

double random_number(const struct random_lesson *drawn, c205_word element)
{
    return drawn->kind == DRAWN_WORDS    ? c205_to_double(element)
           : drawn->kind == DRAWN_HALVES ? c205_half_to_double(element)
                                         : (double)(element >> 63);
}

unsigned random_width(const struct random_lesson *drawn)
{
    return kinds[drawn->kind].width;
}

/* ---- Tests ----------------------------------------------------------------- */

static c205_word element_of(const struct random_lesson *drawn, double number)
{
    return drawn->kind == DRAWN_WORDS    ? c205_from_double(number)
           : drawn->kind == DRAWN_HALVES ? c205_half_from_double(number)
                                         : (c205_word)(number != 0) << 63;
}

/* Makes elements. All of them have different magnitudes, and none is zero. */
static void draw_elements(const struct random_lesson *drawn, struct random_test *test,
                          uint64_t *state)
{
    for (size_t i = 0; i < test->n; i++) {
        double number = (double)(50 * i + (size_t)xorshift_between(state, 1, 49));
        if (drawn->kind == DRAWN_BITS)
            number = (double)(xorshift(state) & 1);
        else if (xorshift(state) & 1)
            number = -number;
        test->x[i] = element_of(drawn, number);
        test->wanted[i] = element_of(drawn, drawn->kind == DRAWN_BITS ? 1 - number
                                                                      : 2 * number);
    }
}

static void draw_test(const struct random_lesson *drawn, size_t index,
                      struct random_test *test, uint64_t *state)
{
    static const char *const models[] = { "cyber205-1pipe", "cyber205-2pipe",
                                          "cyber205-4pipe", C205_DEFAULT_MODEL };
    *test = (struct random_test){
        .n = (size_t)(DRAWN_TESTS
                          * xorshift_between(state, 0, DRAWN_LONGEST / DRAWN_TESTS - 1)
                      + (int64_t)index + 1),
        .warm = xorshift(state) & 1,
        .has_goals = xorshift(state) & 1,
        .tolerant = xorshift(state) % 4 == 0,
        .model = models[xorshift(state) % 4],
    };
    draw_elements(drawn, test, state);
}

/* ---- The answer ------------------------------------------------------------ */

static bool fits(const struct random_lesson *drawn)
{
    size_t n = drawn->tests[drawn->faulty].n;
    switch (drawn->fault) {
    case FAULT_LAST_BIT:
    case FAULT_SIGN:
    case FAULT_NOTHING: return drawn->kind != DRAWN_BITS;
    case FAULT_LATE: return drawn->kind != DRAWN_BITS && n > 2;
    case FAULT_BACKWARDS: return drawn->kind == DRAWN_WORDS && n > 1;
    default: return true;
    }
}

static void draw_found(struct random_lesson *drawn, uint64_t *state)
{
    const struct random_test *test = &drawn->tests[drawn->faulty];
    c205_word wanted = test->wanted[drawn->element];
    double number = random_number(drawn, wanted);
    if (drawn->kind == DRAWN_BITS)
        drawn->found = ~wanted & C205_MACHINE_ZERO;
    else if (drawn->fault == FAULT_LAST_BIT)
        drawn->found = wanted + (drawn->kind == DRAWN_WORDS ? 1 : UINT64_C(1) << 32);
    else
        drawn->found = element_of(drawn, 10000 + (double)xorshift_between(state, 0, 999)
                                             + number);
}

/* Writes half of an element's number, as the digits of its word. */
static void put_value(const struct random_lesson *drawn, const struct sink *sink)
{
    if (drawn->kind == DRAWN_WORDS)
        sink_print(sink, "v:      .word   X'%016" PRIX64 "'\n",
                   drawn->found - (UINT64_C(1) << 48));
    else
        sink_print(sink, "v:      .half   0x%08" PRIX64 "\n",
                   (drawn->found - (UINT64_C(1) << 56)) >> 32);
}

static void put_work(const struct random_lesson *drawn, const struct sink *sink)
{
    if (drawn->way == WAY_VECTOR)
        sink_print(sink, "        %s\n", kinds[drawn->kind].work);
    else if (drawn->way == WAY_LINKED)
        sink_put(sink, "        load_constant value, 1.0\n"
                       "        descriptor one, x, n\n"
                       "        LINKV           ; a pair\n"
                       "        MPYSV   [xs], value, [one]\n"
                       "        ADDNV   [one], [xs], [ys]\n");
    else
        sink_print(sink,
                   "        ES      one, 0\n        .rept   n\n"
                   "        LOD     [xs, one], value\n"
                   "        .rept   %zu\n        ES      idle, 1\n"
                   "        .endr\n        ADDN    value, value, value\n"
                   "        STO     [ys, one], value ; no LINKV\n"
                   "        IS      one, 1\n        .endr\n",
                   drawn->idle);
}

static void put_fault(const struct random_lesson *drawn, const struct sink *sink)
{
    unsigned width = kinds[drawn->kind].width;
    const char *half = width == 32 ? ",H" : "";
    switch (drawn->fault) {
    case FAULT_NOTHING: return;
    case FAULT_LATE:
        sink_print(sink,
                   "        descriptor xs, x, n - 1\n"
                   "        descriptor ys, y + %u, n - 1\n        %s\n",
                   width, kinds[drawn->kind].work);
        return;
    case FAULT_BACKWARDS:
        sink_put(sink, "        ADDNV   [xs], [xs], [xs]\n"
                       "        VREVV   [xs], [ys]\n");
        return;
    case FAULT_SIGN:
        sink_print(sink, "        SUBNV%s [xs], [xs], [ys]\n", half);
        for (int i = 0; i < 2; i++)
            sink_print(sink, "        SUBNV%s [ys], [xs], [ys]\n", half);
        return;
    default: break;
    }
    for (size_t i = 0; i <= drawn->repeated; i++)
        put_work(drawn, sink);
    if (drawn->fault == FAULT_ELEMENT || drawn->fault == FAULT_LAST_BIT)
        sink_print(sink,
                   "        descriptor value, v, 1\n"
                   "        descriptor one, y + %u * %zu, 1\n        %s\n",
                   width, drawn->element, kinds[drawn->kind].fault_work);
    if (drawn->fault == FAULT_TRAP)
        sink_put(sink, "        LOD     [r0], value ; fault\n");
    if (drawn->fault == FAULT_LOOP)
        sink_put(sink, "here:   BIM     here ; fault\n");
}

static void write_answer(struct random_lesson *drawn)
{
    const char *directive = kinds[drawn->kind].directive;
    SCOPED_VALUE(text_buffer) text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    sink_print(&sink,
               "        .include \"core.s\"\n        .ifndef n\n"
               "        .equ    n, 5\n        .endif\n"
               "        .regs   r16, xs, ys, one, value, idle\n        .data\n"
               "        %s x, n\n        %s y, n\n",
               directive, directive);
    put_value(drawn, &sink);
    sink_print(&sink,
               "        .code\n        descriptor xs, x, n\n"
               "        descriptor ys, y, n\n        .if n == %zu\n",
               drawn->tests[drawn->faulty].n);
    put_fault(drawn, &sink);
    sink_print(&sink, "        .else\n        %s\n        .endif\n        EXIT\n",
               kinds[drawn->kind].work);
    assert_true(text.length < sizeof drawn->answer);
    strcpy(drawn->answer, text.text);
}

void draw_lesson(struct random_lesson *drawn, uint64_t *state)
{
    drawn->kind = (enum random_kind)(xorshift(state) % DRAWN_KINDS);
    drawn->count = 1 + xorshift(state) % DRAWN_TESTS;
    for (size_t i = 0; i < drawn->count; i++)
        draw_test(drawn, i, &drawn->tests[i], state);
    do {
        drawn->fault = (enum random_fault)(xorshift(state) % DRAWN_FAULTS);
        drawn->faulty = xorshift(state) % drawn->count;
    } while (!fits(drawn));
    drawn->element = xorshift(state) % drawn->tests[drawn->faulty].n;
    drawn->repeated = drawn->fault == FAULT_NONE ? xorshift(state) % 20 : 0;
    drawn->way = drawn->fault == FAULT_NONE && drawn->kind == DRAWN_WORDS
                     ? (enum random_way)(xorshift(state) % DRAWN_WAYS)
                     : WAY_VECTOR;
    drawn->idle = xorshift(state) % 20;
    draw_found(drawn, state);
    write_answer(drawn);
}

/* ---- The folder ------------------------------------------------------------ */

static void put_elements(const struct random_lesson *drawn, const char *label,
                         const c205_word *elements, size_t n, const struct sink *sink)
{
    if (drawn->kind == DRAWN_BITS)
        sink_print(sink, "        .bitvector %s, %zu, \"", label, n);
    else
        sink_print(sink, "%s:\n", label);
    for (size_t i = 0; i < n; i++)
        if (drawn->kind == DRAWN_BITS)
            sink_print(sink, "%d", (int)(elements[i] >> 63));
        else if (drawn->kind == DRAWN_HALVES)
            sink_print(sink, "        .half   0x%08" PRIX64 "\n", elements[i] >> 32);
        else
            sink_print(sink, "        .word   X'%016" PRIX64 "'\n", elements[i]);
    sink_put(sink, drawn->kind == DRAWN_BITS ? "\"\n" : "");
}

static void put_test(const struct random_lesson *drawn, const struct random_test *test,
                     const struct sink *sink)
{
    sink_print(sink, "; test: so many as %zu\n; expect-model: %s\n", test->n,
               test->model);
    if (test->tolerant)
        sink_put(sink, "; tolerance: y 1e-3\n");
    if (test->has_goals)
        sink_print(sink,
                   ";goals: bronze %" PRIu64 ",gold %" PRIu64 " , silver %" PRIu64 "\n",
                   test->goals[MEDAL_BRONZE], test->goals[MEDAL_GOLD],
                   test->goals[MEDAL_SILVER]);
    sink_print(sink, "        .equ    n, %zu\n%s        .data\n", test->n,
               test->warm ? "        .warm\n" : "");
    put_elements(drawn, "want_y", test->wanted, test->n, sink);
    sink_put(sink, "        .align  64\n");
    put_elements(drawn, "x", test->x, test->n, sink);
}

static void take(struct lesson *lesson, const char *file, const char *text)
{
    FAIL_IF(!lesson_take(lesson, file, text, strlen(text), &failure), "%s\n%s",
            failure.message, text);
}

void random_open(const struct random_lesson *drawn, struct lesson *lesson)
{
    *lesson = (struct lesson){ 0 };
    assert_true(lesson_begin(lesson, "07-drawn", &failure));
    for (size_t i = 0; i < drawn->count; i++) {
        char file[] = "test-0.s";
        SCOPED_VALUE(text_buffer) text = { 0 };
        struct sink sink = text_buffer_sink(&text);
        file[5] = (char)(file[5] + (int)i);
        put_test(drawn, &drawn->tests[i], &sink);
        take(lesson, file, text.text);
    }
    take(lesson, "start.s", "        EXIT\n");
    take(lesson, "solution.s", "nothing of it is read\n");
    take(lesson, "lesson.md", "# Drawn at random\n\nText.\n");
    REQUIRE(lesson_end(lesson, &failure));
}

void grade_well(struct lesson_verdict *verdict, const struct lesson *lesson,
                const char *answer)
{
    *verdict = (struct lesson_verdict){ 0 };
    FAIL_IF(!lesson_grade(verdict, lesson, (struct lesson_draws){ 0 }, "my.s", answer,
                          strlen(answer), &failure),
            "%s\n%s", failure.message, answer);
}
