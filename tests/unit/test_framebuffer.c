/* test_framebuffer.c - the words of a frame in memory and in a file are written, not
 * accessed for a while, and compared, for numbers below and above the limit for memory.
 * A word that is lost or not initially zero, or pages that stay in memory, fail here.
 */
#include "rt/platform/framebuffer.h"
#include "tests/unit/unit.h"

#include <unistd.h>

enum { PART = 100003 }; /* number of words; no multiple of it is the end of a page */

static c205_word word_at(size_t i)
{
    return (c205_word)i * UINT64_C(0x9E3779B97F4A7C15) + 1;
}

/* Returns the number of bytes of memory that the process occupies. */
static size_t resident(void)
{
    FILE *file = NON_NULL(fopen("/proc/self/statm", "r"));
    unsigned long all = 0, pages = 0;
    assert_int_equal(fscanf(file, "%lu %lu", &all, &pages), 2);
    fclose(file);
    return (size_t)pages * (size_t)sysconf(_SC_PAGESIZE);
}

static size_t part_at(size_t words, size_t i)
{
    return words - i < PART ? words - i : PART;
}

static void check_words(size_t words, bool in_file)
{
    size_t before = resident(), most = 0;
    struct frame_planes planes;
    assert_true(framebuffer_take(&planes, words));
    assert_int_equal(planes.file >= 0, in_file);
    for (size_t i = 0; i < words; i += PART) {
        for (size_t k = i; k < i + part_at(words, i); k++) {
            assert_true(planes.words[k] == 0);
            planes.words[k] = word_at(k);
        }
        framebuffer_leave(&planes, i, part_at(words, i));
        if (resident() > most)
            most = resident();
    }
    if (in_file)
        assert_true(most - before < planes.bytes / 4);
    for (size_t i = 0; i < words; i++)
        assert_true(planes.words[i] == word_at(i));
    framebuffer_leave(&planes, 0, words);
    planes_give_back(&planes);
}

TEST(few)
{
    check_words(1, false);
    check_words(3 * PART, false);
}

TEST_CALL(many, check_words(PLANES_IN_MEMORY / sizeof(c205_word) + PART, true))

/* If the folder for the file does not exist, the frame is in memory. */
TEST(no_folder)
{
    assert_int_equal(setenv("TMPDIR", "/nowhere/at/all", 1), 0);
    check_words(PLANES_IN_MEMORY / sizeof(c205_word) + 1, false);
    assert_int_equal(unsetenv("TMPDIR"), 0);
}
