/* test_atomic_file.c - atomic files are compared with expected files, over random
 * chains of links, old files and existing temporary names. A replaced link, a temporary
 * file that remains, and lost memory fail here. */
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/interrupt.h"
#include "tests/random.h"
#include "tests/unit/temporary_folder.h"

static const char *path_of(const char *format, unsigned number)
{
    return formatted("%s", in_folder(formatted(format, number)));
}

static bool is_link(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0 && S_ISLNK(status.st_mode);
}

/* Makes links. Link n refers to link n - 1 or the file, by name or complete path. */
static const char *make_links(unsigned count, bool whole_paths)
{
    const char *target = "file";
    for (unsigned i = 0; i < count; i++) {
        const char *link = path_of("link%u", i);
        assert_int_equal(symlink(whole_paths ? in_folder(target) : target, link), 0);
        target = formatted("link%u", i);
    }
    return path_of(target, 0);
}

static unsigned below(uint64_t *seed, int64_t limit)
{
    return (unsigned)xorshift_between(seed, 0, limit - 1);
}

static void write_once(uint64_t *seed)
{
    unsigned links = below(seed, 6), taken = below(seed, 3);
    bool old = below(seed, 2), committed = below(seed, 2);
    const char *path = make_links(links, below(seed, 2));
    if (old)
        write_file("file", "old");
    for (unsigned i = 0; i < taken; i++)
        write_file(formatted("file.new%u", i), "taken");
    assert_true(atomic_file_check(path, &failure));
    struct atomic_file *whole = NON_NULL(atomic_file_open(path, &failure));
    fputs("new", whole->file);
    if (committed)
        REQUIRE(atomic_file_commit(whole, &failure));
    else
        atomic_file_discard(whole);
    for (unsigned i = 0; i < links; i++)
        assert_true(is_link(path_of("link%u", i)));
    for (unsigned i = 0; i < taken; i++) {
        FREED char *text = text_of_file(formatted("file.new%u", i));
        assert_string_equal(text, "taken");
    }
    if (old || committed) {
        FREED char *text = text_of_file("file");
        assert_string_equal(text, committed ? "new" : "old");
    }
    assert_int_equal(empty_folder(), links + taken + (old || committed));
}

TEST(random_files)
{
    uint64_t seed = 7;
    for (int i = 0; i < 300; i++)
        write_once(&seed);
}

TEST(no_name_is_free)
{
    for (unsigned i = 0; i < 100; i++)
        write_file(formatted("file.new%u", i), "taken");
    assert_null(atomic_file_open(in_folder("file"), &failure));
    assert_non_null(strstr(failure.message, "File exists"));
    assert_int_equal(empty_folder(), 100);
}

TEST(no_folder)
{
    assert_null(atomic_file_open(in_folder("missing/file"), &failure));
    assert_non_null(strstr(failure.message, "No such file or directory"));
    assert_false(atomic_file_check(in_folder("missing/file"), &failure));
}

TEST(name_of_a_folder)
{
    struct atomic_file *whole = NON_NULL(atomic_file_open(in_folder("file"), &failure));
    assert_int_equal(mkdir(in_folder("file"), 0700), 0);
    assert_false(atomic_file_commit(whole, &failure));
    assert_non_null(strstr(failure.message, "Is a directory"));
    assert_int_equal(empty_folder(), 1);
}

TEST(device)
{
    struct atomic_file *whole = NON_NULL(atomic_file_open("/dev/null", &failure));
    assert_null(whole->temporary);
    fputs("lost", whole->file);
    REQUIRE(atomic_file_commit(whole, &failure));
}

/* A signal removes the incomplete file, however many files are complete. */
TEST(signals)
{
    int status;
    pid_t child = fork();
    if (child == 0) {
        interrupt_catch();
        for (int i = 0; i < 40; i++)
            atomic_file_commit(atomic_file_open(in_folder("file"), &failure), &failure);
        if (atomic_file_open(in_folder(formatted("%0200d", 1)), &failure)
            && raise(SIGTERM) == 0)
            raise(SIGTERM); /* the second signal ends the program */
        _exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(empty_folder(), 1);
}
