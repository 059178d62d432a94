/* test_asm_mutations.c - programs with random mistakes. Every text must give an object
 * or an error, and the position of every report must be within its line. A crash, a
 * silent failure or a position outside of the line fails here. */
#include "tests/unit/asm_helper.h"

#include "base/file.h"
#include "tests/random.h"

enum { TRIES = 150, MISTAKES = 4 };

static const char *const programs[] = {
    "asm/examples/dot.s",          "asm/examples/lookup.s",
    "asm/examples/sieve.s",        "asm/examples/saxpy_linked.s",
    "tests/programs/exit.s",       "tests/programs/branch.s",
    "tests/programs/gather.s",     "tests/programs/add.s",
    "tests/programs/half_reduce.s"
};

/* Texts that typical mistakes insert into a program. */
static const char *const pieces[] = {
    "[",         "]",     ",",      "(",     ")",          "?",
    "?!",        "|",     "-",      ";",     ":",          "\"",
    "'",         "#",     "X'",     "1.0f",  "0x",         "r256",
    "h300",      ".",     "..",     "\\@",   "\\",         ".rept 3\n",
    ".endr",     ".if 0", ".endif", "\n",    "~",          ".macro m a\n",
    ".endm",     ",H",    "ADDVN",  "65536", ".org",       "\t",
    "; expct: ", "\x80",  "*/",     "<<",    "99999999999"
};

static void cut(char *text, size_t at, size_t count)
{
    size_t length = strlen(text);
    if (at + count <= length)
        memmove(text + at, text + at + count, length - at - count + 1);
}

static void put(char *text, size_t at, const char *piece)
{
    size_t length = strlen(piece);
    memmove(text + at + length, text + at, strlen(text + at) + 1);
    memcpy(text + at, piece, length);
}

/* Makes a random mistake. The buffer has room for one more piece. */
static void make_mistake(char *text, uint64_t *seed)
{
    size_t at = xorshift_below(seed, strlen(text) + 1);
    switch (xorshift_below(seed, 4)) {
    case 0: cut(text, at, 1 + xorshift_below(seed, 8)); break;
    case 1: put(text, at, pieces[xorshift_below(seed, COUNT(pieces))]); break;
    case 2:
        if (text[at] && text[at + 1]) {
            char swapped = text[at];
            text[at] = text[at + 1];
            text[at + 1] = swapped;
        }
        break;
    default:
        if (text[at])
            text[at] = (char)(' ' + xorshift_below(seed, 95));
    }
}

static size_t check_text(const char *path, const char *text)
{
    SCOPED_VALUE(diagnostics) found = { 0 };
    SCOPED(object) *object = assemble_bytes(path, text, strlen(text), NULL, &found);
    size_t errors = found.errors;
    FAIL_IF(!object != (errors > 0), "%s: %zu errors, and %s object in\n%s", path,
            errors, object ? "an" : "no", text);
    for (size_t i = 0; i < found.count; i++) {
        const struct diagnostic *item = &found.items[i];
        FAIL_IF(item->line == 0 || item->column < 1
                    || item->column > strlen(item->source) + 1 || !*item->message
                    || strchr(item->source, '\n'),
                "%s:%zu:%zu: %s\n%s\nin\n%s", item->file, item->line, item->column,
                item->message, item->source, text);
    }
    return errors;
}

TEST(mutations)
{
    uint64_t seed = RANDOM_SEED;
    size_t i, k, wrong = 0;
    for (i = 0; i < COUNT(programs); i++) {
        size_t length;
        FREED char *text = file_read(programs[i], FILE_LARGEST, &length, &failure);
        FREED char *copy = NON_NULL(text ? malloc(length + 100 * MISTAKES) : NULL);
        for (int try = 0; try < TRIES; try++) {
            memcpy(copy, text, length + 1);
            for (k = 0; k < 1 + xorshift_below(&seed, MISTAKES); k++)
                make_mistake(copy, &seed);
            wrong += check_text(programs[i], copy) > 0;
        }
    }
    assert_true(wrong > TRIES);
}
