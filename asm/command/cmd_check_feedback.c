/* cmd_check_feedback.c - writes a file with the verdicts for each student. */
#include <inttypes.h>
#include <string.h>

#include "asm/command/cmd_check.h"
#include "base/atomic_file.h"
#include "base/visible_text.h"

/* Returns the page of a student, or adds one. */
static struct feedback_page *find_page(struct feedback *feedback, const char *name)
{
    struct feedback_page page = { .text = { 0 } };
    for (size_t i = 0; i < feedback->count; i++)
        if (strcmp(feedback->pages[i].name, name) == 0)
            return &feedback->pages[i];
    page.name = arena_text(&feedback->kept, name, strlen(name));
    return page.name ? arena_add(&feedback->kept, &feedback->pages, &feedback->count,
                                 &feedback->capacity, &page, sizeof page)
                     : NULL;
}

void feedback_add(struct feedback *feedback, const struct hand_in *hand_in)
{
    const struct lesson_verdict *verdict = hand_in->verdict;
    const char *lesson = verdict->lesson ? verdict->lesson->name : "unknown";
    struct feedback_page *page = find_page(feedback, *hand_in->student
                                                         ? hand_in->student
                                                         : lesson);
    struct sink sink;
    if (!page)
        return;
    sink = text_buffer_sink(&page->text);
    sink_print(&sink, "%s%s", page->text.length > 0 ? "\n" : "", hand_in->path);
    sink_print(&sink, "%s%s\n", *hand_in->date ? ", " : "", hand_in->date);
    if (verdict->of_count > 0) {
        lesson_verdict_put(verdict, &sink);
        sink_print(&sink, "Tests: %zu of %zu right.  Points: %u of 100.\n",
                   verdict->right_count, verdict->of_count, verdict->points);
    } else {
        lesson_report_put(&verdict->report, &sink);
    }
}

static bool write_page(const struct feedback_page *page, const char *folder,
                       c205_error *error)
{
    struct text_buffer path = { 0 };
    struct sink sink = text_buffer_sink(&path);
    struct atomic_file *whole;
    sink_print(&sink, "%s/%s.txt", folder, page->name);
    whole = path.failed || page->text.failed ? NULL
                                             : atomic_file_open(path.text, error);
    if (whole) {
        struct sink file = visible_stream(whole->file);
        sink_put(&file, page->text.text);
    }
    text_buffer_free(&path);
    return whole && atomic_file_commit(whole, error);
}

bool feedback_write(const struct feedback *feedback, const char *folder,
                    c205_error *error)
{
    bool good = !feedback->kept.failed;
    strcpy(error->message, "out of memory");
    for (size_t i = 0; good && i < feedback->count; i++)
        good = write_page(&feedback->pages[i], folder, error);
    return good;
}

void feedback_free(struct feedback *feedback)
{
    for (size_t i = 0; i < feedback->count; i++)
        text_buffer_free(&feedback->pages[i].text);
    arena_free(&feedback->kept);
}
