/* performance_hint.c - explains why an answer misses its next goal. It names the
 * largest cause and the lines that took most of the clocks. */
#include <inttypes.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "base/accounts.h"
#include "base/plural.h"

enum { LINES_TOLD = 3 };

/* Advice for each cause. */
static const char *const helps[C205_CAUSES] = {
    [C205_ISSUE] =
        "Each instruction takes clocks to issue: use fewer of them; a vector "
        "instruction replaces a whole loop.",
    [C205_OPERAND_WAIT] = "Put other work between an instruction and the one "
                          "that needs its result; quotients and roots take "
                          "the longest.",
    [C205_UNIT_BUSY] = "Spread the work over the units, or put other work "
                       "between two instructions of one unit.",
    [C205_BRANCH] =
        "A taken branch costs the time of many instructions: do more work between "
        "branches, or use vectors.",
    [C205_MEMORY_WAIT] =
        "Load early and use late; keep values that are needed again in registers.",
    [C205_VECTOR_STARTUP] =
        "Each vector instruction has a start-up time, even a short one: use fewer "
        "and longer ones.",
    [C205_VECTOR_STREAM] = "The elements themselves take the time: do fewer "
                           "operations, link two of them, or leave out "
                           "elements that are not needed.",
    [C205_BANK_CONFLICT] =
        "Elements at a distance of a power of two are in the same banks: use another "
        "distance.",
    [C205_TRANSLATION_MISS] =
        "Work page by page: each page that is used again must be translated again.",
    [C205_PAGE_FAULT] =
        "Each page is loaded at its first use, and again after it was evicted: do "
        "all the work on a page while it is in memory."
};

static int percent_of(uint64_t clocks, uint64_t all)
{
    return all > 0 ? (int)((200 * clocks / all + 1) / 2) : 0;
}

/* ---- The goal -------------------------------------------------------------- */

static void print_goal(const struct lesson_trial *trial, struct lesson_report *report)
{
    enum medal next = trial->medal + 1;
    uint64_t goal = trial->test->goals[next];
    report_printf(report,
                  "It took %" PRIu64 " clock%s, %" PRIu64 " more than the %" PRIu64
                  " of %s.",
                  trial->clocks, plural(trial->clocks), trial->clocks - goal, goal,
                  medal_name(next));
}

/* ---- The cause ------------------------------------------------------------- */

/* An answer that has executed this many instructions must contain a loop. */
static const uint64_t many = 1000;

static bool is_scalar(const c205_account *all)
{
    return all->vector_instructions == 0;
}

static int find_most(const c205_account *all, int first)
{
    int most = first;
    for (int cause = first + 1; cause < C205_CAUSES; cause++)
        if (all->clocks[cause] > all->clocks[most])
            most = cause;
    return most;
}

/* Reports the largest cause. In a short scalar program the issue of instructions is
 * unavoidable, so the longest wait is reported. */
static void print_cause(const struct lesson_trial *trial, const c205_account *all,
                        struct lesson_report *report)
{
    int most = find_most(all, C205_ISSUE);
    int wait = find_most(all, C205_ISSUE + 1);
    bool waits = most == C205_ISSUE && all->clocks[wait] > 0 && is_scalar(all)
                 && all->instructions < many;
    int cause = waits ? wait : most;
    report_printf(report, "%s is %s: %" PRIu64 " clock%s, %d %%.  %s",
                  waits ? "The longest wait" : "The largest part",
                  c205_cause_name((c205_cause)cause), all->clocks[cause],
                  plural(all->clocks[cause]),
                  percent_of(all->clocks[cause], trial->clocks), helps[cause]);
}

static void print_scalar(const c205_account *all, struct lesson_report *report)
{
    if (is_scalar(all) && all->instructions >= many)
        report_printf(
            report,
            "All of its %" PRIu64
            " instructions are scalar: use vector instructions for the same work on "
            "many elements.",
            all->instructions);
}

/* ---- The lines ------------------------------------------------------------- */

/* Returns the line with the most clocks after the line `before` in descending order.
 * Lines with equal clocks are in the order of the rows. Returns NULL if no line is
 * left. */
static const struct profile_row *next_line(const struct line_profile *profile,
                                           const struct profile_row *before)
{
    const struct profile_row *found = NULL;
    for (size_t i = 0; i < line_profile_count(profile); i++) {
        const struct profile_row *row = line_profile_row(profile, i);
        uint64_t clocks = line_profile_clocks(row);
        if (row->file && clocks > (found ? line_profile_clocks(found) : 0)
            && (!before || clocks < line_profile_clocks(before)
                || (clocks == line_profile_clocks(before) && row > before)))
            found = row;
    }
    return found;
}

/* Returns true for the prefix of a linked pair. It is charged with the clocks of the
 * pair. The next two lines contain the operations and are never executed separately. */
static bool is_link(const struct profile_row *row)
{
    return strstr(row->source, "LINKV") && row[1].executions == 0 && row[1].file
           && row[2].file;
}

static void print_line(const struct lesson_trial *trial, const struct profile_row *row,
                       struct lesson_report *report)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    uint64_t clocks = line_profile_clocks(row);
    bool link = is_link(row);
    sink_print(&sink, "Line %zu took %" PRIu64 " clock%s, %d %%, in %" PRIu64 " %s%s:",
               row->number, clocks, plural(clocks), percent_of(clocks, trial->clocks),
               row->executions, link ? "linked pair" : "instruction",
               plural(row->executions));
    if (!link)
        sink_print(&sink, " %.200s", lesson_source(row->source));
    for (int i = 1; link && i <= 2; i++)
        sink_print(&sink, "\n    %.200s", lesson_source(row[i].source));
    report_buffer(report, &text);
}

/* Reports the line with the most clocks, and other lines that took at least a tenth of
 * all clocks. */
static void print_lines(const struct lesson_trial *trial,
                        const struct line_profile *profile,
                        struct lesson_report *report)
{
    const struct profile_row *row = NULL;
    for (int i = 0; i < LINES_TOLD && (row = next_line(profile, row)); i++) {
        if (i > 0 && 10 * line_profile_clocks(row) < trial->clocks)
            return;
        print_line(trial, row, report);
    }
}

void performance_hint_report(const struct lesson_trial *trial, const c205 *machine,
                             const struct line_profile *profile,
                             struct lesson_report *report)
{
    c205_account all;
    if (!accounts_whole(machine, &all))
        report->kept->failed = true;
    print_goal(trial, report);
    print_cause(trial, &all, report);
    print_lines(trial, profile, report);
    print_scalar(&all, report);
}
