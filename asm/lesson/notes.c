/* notes.c - reads the notes in the comments of a test. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "vm/error.h"
#include "base/spelling.h"

/* A note that is being read. Its text is between at and end. */
struct test_note {
    struct lesson *lesson;
    struct lesson_test *test;
    size_t line;
    const char *at, *end;
    c205_error *error;
};

static bool refuse(const struct test_note *note, const char *what)
{
    return error_set(note->error, "%.80s/%.48s:%zu: %.100s", note->lesson->folder,
                     note->test->file, note->line, what);
}

static void skip_blanks(struct test_note *note)
{
    while (note->at < note->end && isspace((unsigned char)*note->at))
        note->at++;
}

static bool take_letter(struct test_note *note, char letter)
{
    skip_blanks(note);
    if (note->at == note->end || *note->at != letter)
        return false;
    note->at++;
    return true;
}

/* Returns the number of characters up to a blank, a comma or a colon. */
static size_t word_length(const struct test_note *note)
{
    const char *at = note->at;
    while (at < note->end && !isspace((unsigned char)*at) && *at != ',' && *at != ':')
        at++;
    return (size_t)(at - note->at);
}

static bool take_word(struct test_note *note, const char *word)
{
    skip_blanks(note);
    if (word_length(note) != strlen(word) || memcmp(note->at, word, strlen(word)) != 0)
        return false;
    note->at += strlen(word);
    return true;
}

/* ---- The notes ------------------------------------------------------------- */

static bool take_test_note(struct test_note *note)
{
    while (note->end > note->at && isspace((unsigned char)note->end[-1]))
        note->end--;
    skip_blanks(note);
    if (note->at == note->end || note->test->tries)
        return refuse(note, "expected one sentence after 'test:', once");
    note->test->tries = arena_text(&note->lesson->kept, note->at,
                                   (size_t)(note->end - note->at));
    return note->test->tries || error_set(note->error, "out of memory");
}

static bool take_clocks(struct test_note *note, uint64_t *clocks)
{
    static const uint64_t most = 1000000000;
    skip_blanks(note);
    for (*clocks = 0;
         note->at < note->end && isdigit((unsigned char)*note->at) && *clocks <= most;
         note->at++)
        *clocks = 10 * *clocks + (uint64_t)(*note->at - '0');
    return *clocks > 0 && *clocks <= most;
}

static bool take_goal(struct test_note *note)
{
    for (int medal = MEDAL_BRONZE; medal < MEDALS; medal++) {
        uint64_t *goal = &note->test->goals[medal];
        if (take_word(note, medal_name((enum medal)medal)))
            return *goal == 0 && take_clocks(note, goal);
    }
    return false;
}

static bool take_goals_note(struct test_note *note)
{
    const uint64_t *goals = note->test->goals;
    bool good = !note->test->has_goals;
    note->test->has_goals = true;
    do
        good = good && take_goal(note);
    while (good && take_letter(note, ','));
    skip_blanks(note);
    if (!good || note->at < note->end || goals[MEDAL_GOLD] == 0
        || goals[MEDAL_GOLD] > goals[MEDAL_SILVER]
        || goals[MEDAL_SILVER] > goals[MEDAL_BRONZE])
        return refuse(note, "expected 'goals: gold CLOCKS, silver CLOCKS, "
                            "bronze CLOCKS' in rising order, once");
    return true;
}

static bool take_tolerance_note(struct test_note *note)
{
    struct lesson_tolerance *tolerance = arena_take(&note->lesson->kept,
                                                    sizeof *tolerance);
    size_t length;
    const char *end;
    skip_blanks(note);
    length = word_length(note);
    if (!tolerance
        || !(tolerance->label = arena_text(&note->lesson->kept, note->at, length)))
        return error_set(note->error, "out of memory");
    note->at += length;
    skip_blanks(note);
    tolerance->most = c205_to_double(c205_from_text(note->at, &end));
    if (length == 0 || end == note->at || end > note->end || !(tolerance->most >= 0)
        || !isfinite(tolerance->most))
        return refuse(note, "expected 'tolerance: LABEL NUMBER'");
    note->at = end;
    skip_blanks(note);
    if (note->at < note->end)
        return refuse(note, "expected nothing after the tolerance");
    tolerance->next = note->test->tolerances;
    note->test->tolerances = tolerance;
    return true;
}

/* ---- All notes ----------------------------------------------------------- */

static const struct {
    const char *name;
    bool (*take)(struct test_note *);
} kinds[] = { { "test", take_test_note },
              { "goals", take_goals_note },
              { "tolerance", take_tolerance_note } };

/* Rejects a name that is almost the name of a note, because it is probably misspelt.
 * Only names of four letters or more are compared, and only with goals and
 * tolerance. */
static bool check_name(const struct test_note *note, size_t length)
{
    enum { NEAR = 2, LONG = 4 };
    bool bad = false;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        size_t own = strlen(kinds[i].name);
        bad = bad
              || (own > LONG && length >= LONG
                  && spelling_distance(note->at, length, kinds[i].name, own) <= NEAR);
    }
    return !bad
           || refuse(note, "unknown note; expected 'test:', 'goals:' or 'tolerance:'");
}

/* Reads a line of a test: a note "; name: text" or .warm. Other lines are ignored. */
static bool take_line(struct test_note *note)
{
    size_t length;
    if (!take_letter(note, ';')) {
        note->test->warm = take_word(note, ".warm") || note->test->warm;
        return true;
    }
    skip_blanks(note);
    length = word_length(note);
    if (note->at + length == note->end || note->at[length] != ':')
        return true;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (take_word(note, kinds[i].name)) {
            note->at++;
            return kinds[i].take(note);
        }
    return check_name(note, length);
}

bool lesson_read_notes(struct lesson *lesson, struct lesson_test *test,
                       c205_error *error)
{
    struct test_note note = { .lesson = lesson, .test = test, .error = error };
    const char *at = test->text, *end = at + test->length;
    while (at < end) {
        const char *newline = memchr(at, '\n', (size_t)(end - at));
        note.line++;
        note.at = at;
        note.end = newline ? newline : end;
        if (!take_line(&note))
            return false;
        at = newline ? newline + 1 : end;
    }
    note.line = 1;
    return test->tries || refuse(&note, "the note '; test: SENTENCE' is missing");
}
