/* test_unwritten.c - random programs that read at most one register before they have
 * written it. The assembler and the runtime checker together must report exactly that
 * register at that line. A warning that is missing, false, repeated or misplaced fails
 * here. */
#include <stdarg.h>

#include "tests/unit/saved_machine.h"

#include "asm/check/runtime_check.h"
#include "tests/random.h"

enum { FIRST = 10, LAST = 40, LINES = 30, SIZE = 4096 };

struct drawn {
    uint64_t *random;
    char text[SIZE];
    size_t length, line;
    bool written[LAST + 1];
    size_t fault_at, fault_line; /* 0: no fault */
    unsigned fault;
};

static void put(struct drawn *drawn, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    drawn->length += (size_t)vsnprintf(drawn->text + drawn->length,
                                       SIZE - drawn->length, format, arguments);
    va_end(arguments);
    assert_true(drawn->length < SIZE);
    drawn->line++;
}

static unsigned some(struct drawn *drawn, bool written)
{
    unsigned r;
    do
        r = (unsigned)xorshift_between(drawn->random, FIRST, LAST);
    while (drawn->written[r] != written);
    return r;
}

/* Returns a source register. At the line of the fault it is not written. */
static unsigned source(struct drawn *drawn)
{
    if (drawn->fault_at != drawn->line + 1 || drawn->fault)
        return some(drawn, true);
    drawn->fault = some(drawn, false);
    drawn->fault_line = drawn->line + 1;
    return drawn->fault;
}

static void put_insn(struct drawn *drawn)
{
    static const char *const three[] = { "ADDX", "XOR", "ADDN", "MPYU", "SUBX", "AND" };
    unsigned a = source(drawn), b = some(drawn, true), result;
    bool swapped = xorshift(drawn->random) % 2;
    result = (unsigned)xorshift_between(drawn->random, FIRST, LAST);
    switch (xorshift_below(drawn->random, 5)) {
    case 0: put(drawn, " RTOR r%u, r%u\n", a, result); break;
    case 1:
        put(drawn, " ADDNH h%u, h%u, h%u\n", 2 * a + swapped, 2 * b, 2 * result);
        break;
    case 2:
        put(drawn, " CFPEQ r%u, r%u, after%zu\n", swapped ? a : b, swapped ? b : a,
            drawn->line);
        put(drawn, "after%zu:", drawn->line - 1);
        drawn->line--;
        return;
    case 3: put(drawn, " SHIFTI r%u, 3, r%u\n", a, result); break;
    default:
        put(drawn, " %s r%u, r%u, r%u\n", three[xorshift_below(drawn->random, 6)],
            swapped ? a : b, swapped ? b : a, result);
    }
    drawn->written[result] = true;
}

/* The sum of a vector is in an even register and the next one. The vector of r50 is
 * empty. */
static void put_sum(struct drawn *drawn)
{
    unsigned result = 2
                      * (unsigned)xorshift_between(drawn->random, FIRST / 2,
                                                   LAST / 2 - 1);
    put(drawn, " SUMV [r50], r%u\n", result);
    drawn->written[result] = drawn->written[result + 1] = true;
}

/* Draws a program of two passes over its instructions. Its branches lead to the next
 * instruction, so that all instructions are executed. */
static void draw(struct drawn *drawn, bool faulty)
{
    drawn->fault_at = faulty ? 5 + xorshift_below(drawn->random, LINES) : 0;
    put(drawn, " ES r10, 0\n");
    put(drawn, " ES r4, 2\n");
    put(drawn, " EX r50, 0\n");
    put(drawn, " EX r6, again\nagain:");
    drawn->written[FIRST] = true;
    for (size_t i = 0; i < LINES; i++) {
        if (drawn->line + 1 != drawn->fault_at
            && xorshift_below(drawn->random, 8) == 0) {
            put(drawn, " BIM next%zu\n", i);
            drawn->fault_at += drawn->fault_at == drawn->line + 1;
            put(drawn, "next%zu: ES r%u, 1\n", i, FIRST);
            continue;
        }
        if (drawn->line + 1 != drawn->fault_at && xorshift_below(drawn->random, 8) == 0)
            put_sum(drawn);
        else
            put_insn(drawn);
    }
    put(drawn, " DBNZ r4, [r6]\n");
    put(drawn, " EXIT\n");
}

static size_t count_found(const struct diagnostics *found, const char *part,
                          size_t line)
{
    size_t count = 0;
    for (size_t i = 0; i < found->count; i++)
        if (strstr(found->items[i].message, "[-Wunwritten-register]"))
            count += !part
                     || (found->items[i].line == line
                         && strncmp(found->items[i].message, part, strlen(part)) == 0);
    return count;
}

static void check_program(uint64_t *random, bool faulty)
{
    static const struct warning_choice all;
    struct drawn drawn = { .random = random };
    SCOPED_VALUE(diagnostics) said = { 0 };
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &failure);
    draw(&drawn, faulty);
    SCOPED(object) *object = NON_NULL(assemble_text("test.s", drawn.text, NULL, &said));
    SCOPED(c205) *machine = machine_with(&object->program, model);
    struct runtime_checker *watch = NON_NULL(runtime_new(object, "", &all, NULL));
    assert_true(c205_listen(machine, runtime_listen, watch));
    runtime_begin(watch, machine);
    c205_run(machine, 100000);
    const struct diagnostics *found = runtime_found(watch);
    const char *whole = formatted("r%u is read ", drawn.fault);
    const char *low = formatted("h%u is read ", 2 * drawn.fault);
    const char *high = formatted("h%u is read ", 2 * drawn.fault + 1);
    size_t right = 0,
           all_count = count_found(&said, NULL, 0) + count_found(found, NULL, 0);
    for (int i = 0; i < 3; i++) {
        const char *part = i == 0 ? whole : i == 1 ? low : high;
        right += count_found(&said, part, drawn.fault_line)
                 + count_found(found, part, drawn.fault_line);
    }
    size_t expected = drawn.fault_line > 0;
    FAIL_IF(all_count != expected || right != expected,
            "%s\nexpected %zu at line %zu for r%u, found %zu, %zu of them right",
            drawn.text, expected, drawn.fault_line, drawn.fault, all_count, right);
    runtime_free(watch);
}

TEST(random_programs)
{
    uint64_t random = RANDOM_SEED;
    for (int i = 0; i < 400; i++)
        check_program(&random, i % 2);
}
