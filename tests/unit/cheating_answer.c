/* cheating_answer.c - writes answers that contain the expected data of the tests. */
#include "tests/unit/cheating_answer.h"

#include <inttypes.h>

#include "asm/text/assemble.h"
#include "tests/unit/unit.h"

/* Elements that are reserved at a label in addition to those of a test. */
enum { ROOM = 60000, MAX_TESTS = 16 };

/* The tests of a lesson. */
struct cheated {
    const struct lesson *lesson;
    struct object *tests[MAX_TESTS];
    const struct sink *sink;
    enum cheat cheat;
};

static void put(const struct cheated *cheated, const char *format, ...)
{
    char text[2000];
    va_list list;
    va_start(list, format);
    assert_in_range(vsnprintf(text, sizeof text, format, list), 0, sizeof text - 1);
    va_end(list);
    sink_put(cheated->sink, text);
}

static bool is_data(const struct asm_symbol *symbol)
{
    return symbol->is_label && symbol->contents != ASM_NOTHING;
}

static c205_word word_at(const struct object *test, uint64_t address)
{
    const c205_segment *segment = object_segment(test, address);
    return segment && segment->words ? segment->words[(address - segment->address) / 64]
                                     : 0;
}

static size_t words_of(const struct asm_symbol *symbol)
{
    size_t in_word = symbol->contents == ASM_BITS         ? 64
                     : symbol->contents == ASM_HALF_WORDS ? 2
                                                          : 1;
    return (symbol->count + in_word - 1) / in_word;
}

/* ---- Data ------------------------------------------------------------------ */

/* Begins the lines that are assembled for the constants of a test. */
static void begin_case(const struct cheated *cheated, const struct object *test)
{
    sink_put(cheated->sink, "        .if     1");
    for (size_t i = 0; i < test->symbol_count; i++)
        if (lesson_is_constant(&test->symbols[i]))
            put(cheated, " && %s == %" PRId64, test->symbols[i].name,
                test->symbols[i].value);
    sink_put(cheated->sink, "\n");
}

static void put_words(const struct cheated *cheated, const struct object *test,
                      const struct asm_symbol *symbol)
{
    for (size_t i = 0; i < words_of(symbol); i++)
        put(cheated, "        .word   X'%016" PRIX64 "'\n",
            word_at(test, (uint64_t)symbol->value + 64 * i));
}

/* Reserves memory of the type of the data in the test. */
static void reserve(const struct cheated *cheated, const char *label,
                    const struct asm_symbol *symbol)
{
    const char *directive = symbol->contents == ASM_BITS         ? "bitvector"
                            : symbol->contents == ASM_HALF_WORDS ? "halfvector"
                                                                 : "vector";
    put(cheated,
        "        .ifndef %s\n        .align  64\n        .%s %s, %" PRIu64
        "\n        .endif\n",
        label, directive, label, symbol->count + ROOM);
}

/* Puts the expected data of a test at the labels of the results. */
static void put_results(const struct cheated *cheated, const struct object *test)
{
    begin_case(cheated, test);
    for (size_t i = 0; i < test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test->symbols[i];
        const char *label = lesson_wanted(symbol->name);
        if (!is_data(symbol) || !label)
            continue;
        put(cheated, "        .ifndef %s\n", label);
        if (symbol->contents == ASM_WORDS)
            put(cheated, "%s:\n", label);
        else
            put(cheated, "        .%s %s, %" PRIu64 "\n        .org    %s\n",
                symbol->contents == ASM_BITS ? "bitvector" : "halfvector", label,
                symbol->count, label);
        put_words(cheated, test, symbol);
        sink_put(cheated->sink, "        .endif\n");
    }
    sink_put(cheated->sink, "        .endif\n");
}

static void put_copies(const struct cheated *cheated, size_t number)
{
    const struct object *test = cheated->tests[number];
    begin_case(cheated, test);
    for (size_t i = 0; i < test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test->symbols[i];
        if (is_data(symbol) && lesson_wanted(symbol->name)) {
            put(cheated, "copy%zu_%s:\n", number, lesson_wanted(symbol->name));
            put_words(cheated, test, symbol);
        }
    }
    sink_put(cheated->sink, "        .endif\n");
}

static void put_data(const struct cheated *cheated)
{
    for (size_t i = 0; i < cheated->lesson->test_count; i++)
        if (cheated->cheat == CHEAT_DATA)
            put_results(cheated, cheated->tests[i]);
        else
            put_copies(cheated, i);
    for (size_t i = 0; i < cheated->lesson->test_count; i++)
        for (size_t k = 0; k < cheated->tests[i]->symbol_count; k++) {
            const struct asm_symbol *symbol = &cheated->tests[i]->symbols[k];
            const char *label = lesson_wanted(symbol->name);
            if (is_data(symbol))
                reserve(cheated, label ? label : symbol->name, symbol);
        }
}

/* ---- Code ------------------------------------------------------------------ */

/* Branches to the next test unless the first word of an input is that of the test. */
static void put_recognition(const struct cheated *cheated, size_t number)
{
    const struct object *test = cheated->tests[number];
    for (size_t i = 0; i < test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test->symbols[i];
        if (!is_data(symbol) || lesson_wanted(symbol->name))
            continue;
        put(cheated,
            "        EX      copy_from, %s\n        LOD     [copy_from], copy_left\n"
            "        load_constant copy_right, X'%016" PRIX64 "'\n"
            "        IBXNE   copy_left, r0, copy_right, copy_next%zu\n",
            symbol->name, word_at(test, (uint64_t)symbol->value), number);
        return;
    }
}

static void put_copy(const struct cheated *cheated, size_t number,
                     const struct asm_symbol *symbol)
{
    const char *label = lesson_wanted(symbol->name);
    size_t words = words_of(symbol);
    if (cheated->cheat != CHEAT_SCALAR)
        put(cheated,
            "        descriptor copy_from, copy%zu_%s, %zu\n"
            "        descriptor copy_to, %s, %zu\n"
            "        VTOV    [copy_from], [copy_to]\n",
            number, label, words, label, words);
    else
        put(cheated,
            "        EX      copy_from, copy%zu_%s\n        EX      copy_to, %s\n"
            "        EX      copy_right, %zu\n        ES      copy_i, 0\n"
            "loop%zu_%s:\n        LOD     [copy_from, copy_i], copy_left\n"
            "        STO     [copy_to, copy_i], copy_left\n"
            "        IBXLT   copy_i, copy_one, copy_right, loop%zu_%s, copy_i\n",
            number, label, label, words, number, label, number, label);
}

static bool has_constants(const struct object *test)
{
    size_t i = 0;
    while (i < test->symbol_count && !lesson_is_constant(&test->symbols[i]))
        i++;
    return i < test->symbol_count;
}

static void put_code(const struct cheated *cheated)
{
    for (size_t i = 0; i < cheated->lesson->test_count; i++) {
        const struct object *test = cheated->tests[i];
        begin_case(cheated, test);
        if (cheated->cheat >= CHEAT_LOOK_UP || !has_constants(test))
            put_recognition(cheated, i);
        for (size_t k = 0; k < test->symbol_count; k++)
            if (is_data(&test->symbols[k]) && lesson_wanted(test->symbols[k].name))
                put_copy(cheated, i, &test->symbols[k]);
        put(cheated, "        EXIT\ncopy_next%zu:\n        .endif\n", i);
    }
}

/* ---- Answers --------------------------------------------------------------- */

/* Defines the constants of the tests. The tests usually come first. */
static void put_constants(const struct cheated *cheated)
{
    for (size_t i = 0; i < cheated->lesson->test_count; i++)
        for (size_t k = 0; k < cheated->tests[i]->symbol_count; k++) {
            const struct asm_symbol *symbol = &cheated->tests[i]->symbols[k];
            if (lesson_is_constant(symbol))
                put(cheated,
                    "        .ifndef %s\n        .equ    %s, -1\n        .endif\n",
                    symbol->name, symbol->name);
        }
}

static void put_registers(const struct cheated *cheated)
{
    sink_put(cheated->sink,
             "        .regs   r200, copy_from, copy_to, copy_left, copy_right, copy_i, "
             "copy_one\n        ES      copy_one, 1\n");
}

/* Writes a loop that takes more clocks than bronze allows. */
static void put_delay(const struct cheated *cheated)
{
    enum { CLOCKS_OF_BRANCH = 4 };
    uint64_t most = 0;
    for (size_t i = 0; i < cheated->lesson->test_count; i++)
        if (cheated->lesson->tests[i].goals[MEDAL_BRONZE] > most)
            most = cheated->lesson->tests[i].goals[MEDAL_BRONZE];
    put(cheated,
        "        ES      copy_i, 0\n        EX      copy_right, %" PRIu64 "\n"
        "copy_delay:\n"
        "        IBXLT   copy_i, copy_one, copy_right, copy_delay, copy_i\n",
        most / CLOCKS_OF_BRANCH + 1);
}

/* Writes the solution with a search for known inputs, and a delay, before its code. */
static void put_slow_solution(const struct cheated *cheated)
{
    static const char code[] = "\n        .code\n";
    const char *solution = cheated->lesson->solution;
    const char *at = NON_NULL(strstr(solution, code)) + strlen(code);
    cheated->sink->put(cheated->sink->context, solution, (size_t)(at - solution));
    sink_put(cheated->sink, "        .data\n");
    for (size_t i = 0; i < cheated->lesson->test_count; i++)
        put_copies(cheated, i);
    sink_put(cheated->sink, "        .code\n");
    put_registers(cheated);
    put_code(cheated);
    put_delay(cheated);
    sink_put(cheated->sink, at);
}

static void put_answer(const struct cheated *cheated)
{
    sink_put(cheated->sink, "        .include \"core.s\"\n");
    put_constants(cheated);
    sink_put(cheated->sink, "        .data\n");
    put_data(cheated);
    sink_put(cheated->sink, "        .code\n");
    put_registers(cheated);
    if (cheated->cheat != CHEAT_DATA)
        put_code(cheated);
    sink_put(cheated->sink, "        EXIT\n");
}

void cheat_write(const struct lesson *lesson, enum cheat cheat, const struct sink *sink)
{
    struct cheated cheated = { .lesson = lesson, .sink = sink, .cheat = cheat };
    assert_in_range(lesson->test_count, 1, MAX_TESTS);
    for (size_t i = 0; i < lesson->test_count; i++)
        cheated.tests[i] = NON_NULL(lesson_assemble_test(&lesson->tests[i], &failure));
    if (cheat == CHEAT_FALL_BACK)
        put_slow_solution(&cheated);
    else
        put_answer(&cheated);
    for (size_t i = 0; i < lesson->test_count; i++)
        object_free(cheated.tests[i]);
}

/* ---- Removed instructions -------------------------------------------------- */

/* Returns the line of the program that makes instruction i, or 0. */
static size_t line_of(const char *program, size_t i)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct object *object = NON_NULL(assemble_text("my.s", program, NULL, &errors));
    size_t found = 0, last = 0;
    for (size_t k = 0; k < object->line_count && found == 0; k++) {
        const struct asm_line *line = &object->lines[k];
        bool own = strcmp(line->call.file, "my.s") == 0;
        if (line->is_code && own && line->call.number != last && i-- == 0)
            found = line->call.number;
        last = line->call.number;
    }
    object_free(object);
    return found;
}

bool cheat_remove(const char *program, size_t i, const struct sink *sink)
{
    size_t removed = line_of(program, i), number = 1;
    if (removed == 0)
        return false;
    for (const char *line = program; *line; number++) {
        size_t length = strcspn(line, "\n"), kept = length;
        if (number == removed)
            kept = *line == ' ' ? 0 : strcspn(line, ":") + 1;
        sink->put(sink->context, line, kept);
        sink_put(sink, "\n");
        line += length + (line[length] == '\n');
    }
    return true;
}
