/* test_band_file.c - bands that are kept come back as they were, or not at
 * all: what is harmed, cut off or of another frame is not taken. */
#include "rt/trace/band_file.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { WIDTH = 5, ROWS = 2, SAMPLES = FRAME_CHANNELS * ROWS * WIDTH };
enum { KEY = 205 };

static c205_model *model;
static char path[] = "/tmp/test_band_file.XXXXXX";

/* ---- Bands --------------------------------------------------------------- */

static struct band band_from(size_t first_row)
{
    struct band band = { .first_row = first_row, .rows = ROWS };
    c205_account account = { .name = "shade",
                             .instructions = first_row + 1,
                             .vector_instructions = 2,
                             .elements = 3,
                             .entries = 4 };

    band.words = malloc(SAMPLES * sizeof *band.words);
    assert_non_null(band.words);
    for (size_t i = 0; i < SAMPLES; i++)
        band.words[i] = UINT64_C(0x0123456789ABCDEF) * (i + first_row);
    for (size_t i = 0; i < RAY_KINDS; i++)
        band.rays[i] = 10 * first_row + i;
    for (size_t i = 0; i < C205_CAUSES; i++)
        account.clocks[i] = 100 * first_row + i;
    band.accounts.model = model;
    assert_true(accounts_add_account(&band.accounts, &account));
    account.name = "";
    assert_true(accounts_add_account(&band.accounts, &account));
    return band;
}

static void assert_same_account(const c205_account *a, const c205_account *b)
{
    assert_string_equal(a->name, b->name);
    assert_memory_equal(a->clocks, b->clocks, sizeof a->clocks);
    assert_int_equal(a->instructions, b->instructions);
    assert_int_equal(a->vector_instructions, b->vector_instructions);
    assert_int_equal(a->elements, b->elements);
    assert_int_equal(a->entries, b->entries);
}

static void assert_band_from(const struct band *band, size_t first_row)
{
    struct band expected = band_from(first_row);

    assert_int_equal(band->first_row, first_row);
    assert_int_equal(band->rows, ROWS);
    assert_memory_equal(band->words, expected.words,
                        SAMPLES * sizeof *band->words);
    assert_memory_equal(band->rays, expected.rays, sizeof band->rays);
    assert_int_equal(band->accounts.clocks, expected.accounts.clocks);
    assert_int_equal(band->accounts.count, 2);
    for (size_t i = 0; i < 2; i++)
        assert_same_account(&band->accounts.items[i],
                            &expected.accounts.items[i]);
    band_free(&expected);
}

/* ---- The file ------------------------------------------------------------ */

/* Bands of rows 0, 2, 4 and so on: counts them. */
static bool take_next(void *context, const struct band *band)
{
    size_t *count = context;

    assert_band_from(band, ROWS * *count);
    ++*count;
    return true;
}

static bool take_none(void *context, const struct band *band)
{
    (void)context;
    (void)band;
    fail_msg("there is no band to take");
    return false;
}

/* That many bands are there, of rows 0, 2, 4 and so on; one more is added. */
static void expect_and_add(size_t expected, bool add)
{
    struct band more = band_from(ROWS * expected);
    size_t count = 0;
    c205_error error = { "" };
    struct band_file *file = band_file_open(path, KEY, WIDTH, model,
                                            take_next, &count, &error);

    if (!file)
        fail_msg("%s", error.message);
    assert_int_equal(count, expected);
    assert_true(!add || band_file_add(file, &more, &error));
    band_file_close(file, false);
    band_free(&more);
}

static long size_of_file(void)
{
    FILE *file = fopen(path, "rb");
    long size;

    assert_non_null(file);
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    size = ftell(file);
    fclose(file);
    return size;
}

/* A bit of a byte of the file. */
static void turn(long at, int bit)
{
    FILE *file = fopen(path, "r+b");
    int byte;

    assert_non_null(file);
    assert_int_equal(fseek(file, at, SEEK_SET), 0);
    byte = getc(file);
    assert_int_equal(fseek(file, at, SEEK_SET), 0);
    putc(byte ^ 1 << bit, file);
    assert_int_equal(fclose(file), 0);
}

static void refuse(uint64_t key, size_t width, const char *message)
{
    c205_error error = { "" };

    assert_null(
        band_file_open(path, key, width, model, take_none, NULL, &error));
    assert_non_null(strstr(error.message, message));
}

/* ---- Tests --------------------------------------------------------------- */

static void test_kept(void **state)
{
    (void)state;
    for (size_t i = 0; i < 3; i++)
        expect_and_add(i, true);
    expect_and_add(3, false);
}

/* Any bit of the second band, its length and its checksum among them. */
static void test_harmed(void **state)
{
    long first, both;

    (void)state;
    expect_and_add(0, true);
    first = size_of_file();
    expect_and_add(1, true);
    both = size_of_file();
    for (long at = first; at < both; at++) {
        int bit = (int)(at % 8);

        turn(at, bit);
        expect_and_add(1, false);
        turn(at, bit);
    }
    turn(first + 99, 0);
    expect_and_add(1, true); /* in the place of the one that is harmed */
    expect_and_add(2, false);
    turn(first - 1, 0);
    expect_and_add(0, false);
}

static void test_cut_off(void **state)
{
    long first, both;

    (void)state;
    expect_and_add(0, true);
    first = size_of_file();
    expect_and_add(1, true);
    both = size_of_file();
    for (long size = both - 1; size >= first; size -= 3) {
        assert_int_equal(truncate(path, size), 0);
        expect_and_add(1, false);
    }
    expect_and_add(1, true);
    expect_and_add(2, false);
}

static void test_of_something_else(void **state)
{
    (void)state;
    expect_and_add(0, true);
    refuse(KEY + 1, WIDTH, "of another frame");
    refuse(KEY, WIDTH + 1, "of another frame");
    turn(0, 0);
    refuse(KEY, WIDTH, "does not hold bands");
    turn(0, 0);
    expect_and_add(1, false);
}

/* ---- Two at a time ------------------------------------------------------- */

/* Another process that has the file open, and says so, until it is killed. */
static pid_t open_elsewhere(void)
{
    int ready[2];
    char byte;
    pid_t child;

    assert_int_equal(pipe(ready), 0);
    child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        size_t count = 0;
        c205_error error;
        bool opened = band_file_open(path, KEY, WIDTH, model, take_next,
                                     &count, &error);

        if (opened && write(ready[1], "", 1) == 1)
            pause();
        _exit(1);
    }
    close(ready[1]);
    assert_int_equal(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    return child;
}

static void test_in_use(void **state)
{
    pid_t other;

    (void)state;
    expect_and_add(0, true);
    other = open_elsewhere();
    refuse(KEY, WIDTH, "another run is using it");
    assert_int_equal(kill(other, SIGKILL), 0);
    assert_int_equal(waitpid(other, NULL, 0), other);
    expect_and_add(1, true);
}

/* One that holds nothing, of some other program perhaps, is begun. */
static void test_empty(void **state)
{
    (void)state;
    expect_and_add(0, false);
    assert_int_equal(truncate(path, 0), 0);
    expect_and_add(0, true);
    for (long size = 23; size > 0; size -= 11) {
        assert_int_equal(truncate(path, size), 0);
        refuse(KEY, WIDTH, "does not hold bands");
    }
}

/* A name for which there is no file yet. */
static int set_up(void **state)
{
    c205_error error;
    int file;

    (void)state;
    strcpy(path + strlen(path) - 6, "XXXXXX");
    file = mkstemp(path);
    model = c205_model_find("cyber205-2pipe", &error);
    return file < 0 || close(file) != 0 || remove(path) != 0 || !model;
}

static int tear_down(void **state)
{
    (void)state;
    c205_model_free(model);
    return remove(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_kept, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_in_use, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_empty, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_harmed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_cut_off, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_of_something_else, set_up,
                                        tear_down),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
