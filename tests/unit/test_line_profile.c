/* test_line_profile.c - the sums over all lines of a run's profile are compared with
 * the machine's accounts, for each cause, over all examples and test programs. A clock
 * that is lost or belongs to another line fails here. */
#include "asm/measure/line_profile.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"

static void check_sums(const struct line_profile *profile, const c205 *machine,
                       const char *path)
{
    uint64_t instructions = 0, elements = 0; /* sums over the lines, minus the
                                              * accounts */
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        uint64_t sum = 0, all = clocks_of_cause(machine, (c205_cause)cause);
        for (size_t i = 0; i < line_profile_count(profile); i++)
            sum += line_profile_row(profile, i)->clocks[cause];
        FAIL_IF(sum != all, "%s: %s is %llu line by line, %llu in all", path,
                c205_cause_name((c205_cause)cause), (unsigned long long)sum,
                (unsigned long long)all);
    }
    for (size_t i = 0; i < line_profile_count(profile); i++) {
        instructions += line_profile_row(profile, i)->executions;
        elements += line_profile_row(profile, i)->elements;
    }
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        instructions -= c205_account_at(machine, i)->instructions;
        elements -= c205_account_at(machine, i)->elements;
    }
    assert_int_equal(instructions, 0);
    assert_int_equal(elements, 0);
}

/* Runs a program in slices, which may end inside an instruction. */
static void check_run(const char *path, uint64_t limit, uint64_t slice)
{
    SCOPED(object) *object = good_file(path);
    SCOPED(line_profile) *profile = line_profile_new(object);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    c205_stop stop;
    assert_true(c205_listen(machine, line_profile_listen, profile));
    do
        stop = c205_run(machine, slice < limit - c205_clock(machine)
                                     ? c205_clock(machine) + slice
                                     : limit);
    while (stop.trap == C205_TRAP_CLOCK_LIMIT && c205_clock(machine) < limit);
    check_sums(profile, machine, path);
}

/* Runs a program to its end or a trap, then with stops, some within instructions. */
static void check_program(const char *path)
{
    static uint64_t more;
    check_run(path, 100000000, C205_NO_LIMIT);
    check_run(path, 1100 + more, C205_NO_LIMIT);
    check_run(path, 20000, 100 + more);
    more += 7;
}

TEST(programs)
{
    static const char *const patterns[] = { "asm/examples/*.s", "tests/programs/*.s",
                                            "tests/programs/traps/*.s" };
    size_t count = 0;
    for (size_t i = 0; i < COUNT(patterns); i++)
        count += each_file(patterns[i], check_program);
    assert_true(count > 100);
}

static const struct profile_row *row_of(const struct line_profile *profile,
                                        size_t number)
{
    for (size_t i = 0; i < line_profile_count(profile); i++)
        if (line_profile_row(profile, i)->file
            && line_profile_row(profile, i)->number == number)
            return line_profile_row(profile, i);
    fail_msg("line %zu has no row", number);
    return NULL;
}

/* A macro of the library is summed at its call, other macros and repetitions at their
 * own lines. A vector instruction has the clocks of the instructions that wait for it.
 * Warm pages cost no clocks. */
TEST(lines)
{
    SCOPED(object) *object = good("        .include \"vectors.s\"\n"
                                  "        .macro twice r\n"
                                  "        ADDX \\r, \\r, \\r\n"
                                  "        ADDX \\r, \\r, \\r\n"
                                  "        .endm\n"
                                  "        .regs r16, a, b\n"
                                  "        words a, 1.0, 2.0, 3.0, 4.0\n"
                                  "        twice r20\n"
                                  "        twice r20\n"
                                  "        .rept 3\n"
                                  "        ES r21, 5\n"
                                  "        .endr\n"
                                  "        ADDNV [a], [a], [a]\n"
                                  "        ADDNV [a], [a], [a]\n"
                                  "        EXIT\n");
    SCOPED(line_profile) *profile = line_profile_new(object);
    SCOPED(c205) *machine = machine_with(&object->program, prior_model);
    const struct profile_row *row;
    assert_true(c205_listen(machine, line_profile_listen, profile));
    c205_warm(machine);
    assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
    check_sums(profile, machine, "lines");
    assert_int_equal(row_of(profile, 3)->executions, 2);
    assert_int_equal(row_of(profile, 4)->executions, 2);
    assert_string_equal(row_of(profile, 3)->source, "        ADDX \\r, \\r, \\r");
    assert_string_equal(row_of(profile, 7)->source,
                        "        words a, 1.0, 2.0, 3.0, 4.0");
    assert_int_equal(row_of(profile, 11)->executions, 3);
    for (size_t number = 13; number <= 14; number++) {
        row = row_of(profile, number);
        assert_int_equal(row->elements, 4);
        assert_true(row->clocks[C205_VECTOR_STARTUP] > 30);
        assert_in_range(row->clocks[C205_VECTOR_STREAM], 1, 2);
        assert_int_equal(row->clocks[C205_PAGE_FAULT], 0);
    }
    SCOPED(table) *table = line_profile_table(profile,
                                              (struct profile_view){ PROFILE_HOTTEST,
                                                                     false },
                                              false);
    for (size_t i = 1; i < table_rows(table); i++)
        assert_true(table_value(table, i - 1, 1) >= table_value(table, i, 1));
    assert_true(table_value(table, 0, 1) > 40);
    /* Each cause has a column with its name. */
    enum { BEFORE = 5 };
    static const struct profile_view view = { PROFILE_AS_WRITTEN, false };
    SCOPED(table) *columns = line_profile_table(profile, view, false);
    size_t shown = 0;

    for (int cause = 0; cause < C205_CAUSES; cause++) {
        const char *key = table_key(columns, BEFORE + (size_t)cause);
        const char *name = c205_cause_name((c205_cause)cause);
        for (; *name; name++)
            if (*name == ' ')
                assert_int_equal(*key++, '_');
            else if (*name != '-')
                assert_int_equal(*key++, *name);
    }
    for (size_t i = 0; i < line_profile_count(profile); i++) {
        row = line_profile_row(profile, i);
        if (row->executions == 0)
            continue;
        for (int cause = 0; cause < C205_CAUSES; cause++)
            assert_true(table_value(columns, shown, BEFORE + (size_t)cause)
                        == (double)row->clocks[cause]);
        shown++;
    }
    assert_int_equal(shown, table_rows(columns));
}
