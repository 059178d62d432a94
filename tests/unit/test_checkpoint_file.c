/* test_checkpoint_file.c - units that are read from files are compared with the units
 * that were written, after truncation, flipped bits and merges. A damaged unit that is
 * accepted, or an intact unit that is lost, fails here. */
#include "rt/jobs/checkpoint_file.h"
#include "tests/unit/unit.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/unit/draw.h"

enum { KEY = 205, UNITS = 24, FILES = 4, TRIES = 60, HEAD = 16 };

static char paths[FILES][40];
FIXTURE(set_up)
{
    bool good = true;
    for (size_t i = 0; i < FILES; i++) {
        strcpy(paths[i], "/tmp/test_checkpoint_file.XXXXXX");
        int file = mkstemp(paths[i]);
        good = good && file >= 0 && close(file) == 0 && remove(paths[i]) == 0;
    }
    return !good;
}

FIXTURE(tear_down)
{
    for (size_t i = 0; i < FILES; i++)
        remove(paths[i]);
    return 0;
}

/* ---- Units --------------------------------------------------------------- */

/* Returns words that depend on the number. Some units have no words. */
static struct serialized_result words_of(uint64_t number)
{
    struct serialized_result words = { .items = NULL };
    uint64_t one = number + 1;
    size_t count = number % 5 * 7;
    for (size_t i = 0; i < count; i++)
        result_put(&words, xorshift(&one));
    return words;
}

static void add(struct checkpoint_file *file, uint64_t number)
{
    FREED_BY(result_free) struct serialized_result words = words_of(number);
    REQUIRE(checkpoint_add(file, number, &words, &failure));
}

static void assert_unit(struct checkpoint_file *file, uint64_t number)
{
    struct serialized_result expected = words_of(number), found = { .items = NULL };
    assert_true(checkpoint_read(file, number, &found));
    assert_int_equal(found.count, expected.count);
    for (size_t i = 0; i < found.count; i++)
        assert_int_equal(found.items[i], expected.items[i]);
    result_free(&expected);
    result_free(&found);
}

static struct checkpoint_file *open_file(size_t i)
{
    return NON_NULL(checkpoint_open(paths[i], KEY, &failure));
}

/* Fails unless the file contains exactly the units of the list. */
static void assert_units(struct checkpoint_file *file, const bool *there)
{
    size_t count = 0;
    for (uint64_t number = 0; number < UNITS; number++) {
        assert_int_equal(checkpoint_has(file, number), there[number]);
        if (there[number])
            assert_unit(file, number);
        count += there[number];
    }
    assert_int_equal(checkpoint_count(file), count);
}

static void expect(size_t i, const bool *there)
{
    struct checkpoint_file *file = open_file(i);
    assert_units(file, there);
    checkpoint_close(file, false);
}

/* ---- Damaged files ------------------------------------------------------- */

static long size_of(const char *path)
{
    struct stat status;
    assert_int_equal(stat(path, &status), 0);
    return (long)status.st_size;
}

static void turn_bit(const char *path, long at, int bit)
{
    FILE *file = NON_NULL(fopen(path, "r+b"));
    assert_int_equal(fseek(file, at, SEEK_SET), 0);
    int byte = getc(file);
    assert_int_equal(fseek(file, at, SEEK_SET), 0);
    putc(byte ^ 1 << bit, file);
    assert_int_equal(fclose(file), 0);
}

/* Units in random order, and the offset at which each unit ends. */
struct written {
    size_t count;
    uint64_t number[UNITS];
    long end[UNITS];
};

static void write_some(size_t i, struct written *written)
{
    bool there[UNITS] = { false };
    struct checkpoint_file *file = open_file(i);
    written->count = 1 + below(8);
    for (size_t k = 0; k < written->count;) {
        uint64_t number = below(UNITS);
        if (there[number])
            continue;
        there[number] = true;
        add(file, number);
        add(file, number); /* adding a unit again has no effect */
        written->number[k] = number;
        written->end[k++] = size_of(paths[i]);
    }
    assert_units(file, there);
    checkpoint_close(file, false);
}

/* Marks the units that end before a byte offset. */
static void whole_before(const struct written *written, long at, bool *there)
{
    memset(there, 0, UNITS * sizeof *there);
    for (size_t k = 0; k < written->count && written->end[k] <= at; k++)
        there[written->number[k]] = true;
}

/* Checks the intact units, then adds the lost units, which are appended. */
static void expect_and_mend(const struct written *written, long at)
{
    bool there[UNITS];
    whole_before(written, at, there);
    struct checkpoint_file *file = open_file(0);
    assert_units(file, there);
    for (size_t k = 0; k < written->count; k++)
        add(file, written->number[k]);
    checkpoint_close(file, false);
    whole_before(written, written->end[written->count - 1], there);
    expect(0, there);
    assert_int_equal(size_of(paths[0]), written->end[written->count - 1]);
}

/* A truncated file or flipped bit discards the damaged unit and all later ones. */
TEST_WITH(damaged, set_up, tear_down)
{
    struct written written;
    for (int i = 0; i < 2 * TRIES; i++) {
        write_some(0, &written);
        long size = written.end[written.count - 1];
        long at = HEAD + (long)below((size_t)(size - HEAD));
        if (i < TRIES)
            assert_int_equal(truncate(paths[0], at), 0);
        else
            turn_bit(paths[0], at, (int)below(8));
        expect_and_mend(&written, at);
        remove(paths[0]);
    }
}

/* ---- Merged files -------------------------------------------------------- */

static void check_merge(void)
{
    bool there[UNITS] = { false };
    struct written written;
    size_t count = 2 + below(FILES - 1);
    for (size_t i = 0; i < count; i++) {
        write_some(i, &written);
        for (size_t k = 0; k < written.count; k++)
            there[written.number[k]] = true;
    }
    struct checkpoint_file *file = open_file(0);
    for (size_t i = 1; i < count; i++)
        REQUIRE(checkpoint_merge(file, paths[i], &failure));
    assert_units(file, there);
    checkpoint_close(file, false);
    expect(0, there);
    for (size_t i = 0; i < count; i++)
        remove(paths[i]);
}

TEST_WITH(merged, set_up, tear_down)
{
    for (int i = 0; i < TRIES; i++)
        check_merge();
}

static void refuse_merge(struct checkpoint_file *file, const char *path,
                         const char *message)
{
    c205_error error = { "" };
    assert_false(checkpoint_merge(file, path, &error));
    assert_non_null(strstr(error.message, message));
}

TEST_WITH(not_merged, set_up, tear_down)
{
    struct written written;
    write_some(0, &written);
    struct checkpoint_file *file = open_file(0);
    refuse_merge(file, paths[0], "named twice");
    refuse_merge(file, paths[1], "No such file");
    assert_int_not_equal(access(paths[1], F_OK), 0);
    struct checkpoint_file *other = NON_NULL(
        checkpoint_open(paths[1], KEY + 1, &failure));
    checkpoint_close(other, false);
    refuse_merge(file, paths[1], "belongs to another run");
    checkpoint_close(file, false);
}

/* ---- Rejected files ------------------------------------------------------ */

static void refuse(uint64_t key, const char *message)
{
    c205_error error = { "" };
    assert_null(checkpoint_open(paths[0], key, &error));
    assert_non_null(strstr(error.message, message));
}

TEST_WITH(of_something_else, set_up, tear_down)
{
    struct written written;
    write_some(0, &written);
    refuse(KEY + 1, "belongs to another run");
    turn_bit(paths[0], 0, 0);
    refuse(KEY, "does not hold units");
    for (long size = HEAD - 1; size > 0; size -= 5) {
        assert_int_equal(truncate(paths[0], size), 0);
        refuse(KEY, "does not hold units");
    }
    assert_int_equal(truncate(paths[0], 0), 0);
    expect(0, (bool[UNITS]){ false });
}

/* Starts a process that keeps the file open until killed, and reports it. */
static pid_t open_elsewhere(void)
{
    int ready[2];
    char byte;
    assert_int_equal(pipe(ready), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        if (checkpoint_open(paths[0], KEY, &failure) && write(ready[1], "", 1) == 1)
            pause();
        _exit(1);
    }
    close(ready[1]);
    assert_int_equal(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    return child;
}

TEST_WITH(in_use, set_up, tear_down)
{
    struct written written;
    struct checkpoint_file *file = open_file(1);
    write_some(0, &written);
    pid_t other = open_elsewhere();
    refuse(KEY, "another run is using it: wait for its end, or name another file");
    refuse_merge(file, paths[0],
                 "another run is using it: wait for its end, or name another file");
    assert_int_equal(kill(other, SIGKILL), 0);
    assert_int_equal(waitpid(other, NULL, 0), other);
    checkpoint_close(open_file(0), true);
    assert_int_not_equal(access(paths[0], F_OK), 0);
    checkpoint_close(file, true);
}
