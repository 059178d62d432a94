/* slow.c - why an answer is slower than the next goal: the cause and the lines that took most
 * of its clocks. */
#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#include "asm/lesson/parts.h"

enum { LINES_TOLD = 3 };

/* What helps against a cause. */
static const char *const helps[C205_CAUSES] = {
    [C205_ISSUE] = "Each instruction takes its clocks to issue: one vector "
                   "instruction does what a loop needs thousands for.",
    [C205_OPERAND_WAIT] = "Put other work between an instruction and the one "
                          "that needs its result.",
    [C205_UNIT_BUSY] = "Spread the work over the units, or put other work "
                       "between two instructions of one unit.",
    [C205_BRANCH] = "A branch that is taken costs many instructions' time: "
                    "do more between two of them, or use vectors.",
    [C205_MEMORY_WAIT] = "Load early, use late; and what is needed again "
                         "can stay in a register.",
    [C205_VECTOR_STARTUP] = "Each vector instruction has its start-up, "
                            "however short it is: use fewer and longer "
                            "ones.",
    [C205_VECTOR_STREAM] = "The elements themselves take the time: do fewer "
                           "operations, link two of them, or leave out "
                           "elements that are not needed.",
    [C205_BANK_CONFLICT] = "Elements that lie some power of two apart come "
                           "from the same banks: another distance does "
                           "better.",
    [C205_TRANSLATION_MISS] = "Work page by page: each page touched anew "
                              "must be looked up.",
    [C205_PAGE_FAULT] = "Each page costs its first touch: use fewer pages."
};

static int percent_of(uint64_t clocks, uint64_t all)
{
    return all > 0 ? (int)((200 * clocks / all + 1) / 2) : 0;
}

/* ---- The goal -------------------------------------------------------------- */

static void tell_goal(const struct lesson_trial *trial,
                      struct lesson_report *report)
{
    enum medal next = trial->medal + 1;
    uint64_t goal = trial->test->goals[next];

    report_say(report,
               "It took %" PRIu64 " clocks, %" PRIu64
               " more than the %" PRIu64 " of %s.",
               trial->clocks, trial->clocks - goal, goal, medal_name(next));
}

/* ---- The cause ------------------------------------------------------------- */

static void tell_cause(const c205 *machine, uint64_t all,
                       struct lesson_report *report)
{
    uint64_t clocks[C205_CAUSES] = { 0 };
    int most = 0;

    for (size_t i = 0; i < c205_account_count(machine); i++)
        for (int cause = 0; cause < C205_CAUSES; cause++)
            clocks[cause] += c205_account_at(machine, i)->clocks[cause];
    for (int cause = 1; cause < C205_CAUSES; cause++)
        if (clocks[cause] > clocks[most])
            most = cause;
    report_say(report, "Most of them are %s: %" PRIu64 " clocks, %d %%.  %s",
               c205_cause_name((c205_cause)most), clocks[most],
               percent_of(clocks[most], all), helps[most]);
}

/* ---- The lines ------------------------------------------------------------- */

static uint64_t clocks_of(const struct profile_row *row)
{
    uint64_t sum = 0;

    for (int cause = 0; cause < C205_CAUSES; cause++)
        sum += row->clocks[cause];
    return sum;
}

/* The hottest line behind the one before it, of equals the first; NULL: none took time. */
static const struct profile_row *next_line(const struct line_profile *profile,
                                           const struct profile_row *before)
{
    const struct profile_row *found = NULL;

    for (size_t i = 0; i < line_profile_count(profile); i++) {
        const struct profile_row *row = line_profile_row(profile, i);
        uint64_t clocks = clocks_of(row);

        if (row->file && clocks > (found ? clocks_of(found) : 0)
            && (!before || clocks < clocks_of(before)
                || (clocks == clocks_of(before) && row > before)))
            found = row;
    }
    return found;
}

/* Those that took a tenth of it or more. */
static void tell_lines(const struct line_profile *profile, uint64_t all,
                       struct lesson_report *report)
{
    const struct profile_row *row = NULL;

    for (int i = 0; i < LINES_TOLD && (row = next_line(profile, row)); i++) {
        const char *source = row->source;

        if (10 * clocks_of(row) < all)
            return;
        while (isspace((unsigned char)*source))
            source++;
        report_say(report,
                   "Line %zu of %s took %" PRIu64
                   " clocks, %d %%, in %" PRIu64 " instructions: %.200s",
                   row->number, row->file, clocks_of(row),
                   percent_of(clocks_of(row), all), row->executions, source);
    }
}

void slow_tell(const struct lesson_trial *trial, const c205 *machine,
               const struct line_profile *profile,
               struct lesson_report *report)
{
    tell_goal(trial, report);
    tell_cause(machine, trial->clocks, report);
    tell_lines(profile, trial->clocks, report);
}
