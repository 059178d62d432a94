/* timeline_file.c - saves a timeline in the format that the name of its file
 * selects. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/timeline/timeline.h"
#include "vm/error.h"
#include "base/file.h"
#include "base/atomic_file.h"

typedef bool write_timeline(const struct timeline *timeline, const char *title,
                            const struct sink *sink);

static bool write_kanata(const struct timeline *timeline, const char *title,
                         const struct sink *sink)
{
    (void)title;
    return timeline_kanata(timeline, sink);
}

static bool write_trace_events(const struct timeline *timeline, const char *title,
                               const struct sink *sink)
{
    (void)title;
    return timeline_trace_events(timeline, sink);
}

static const struct timeline_form {
    const char *ending;
    write_timeline *write;
} forms[] = {
    { ".svg", timeline_svg },
    { ".kanata", write_kanata },
    { ".json", write_trace_events },
};
enum { FORMS = sizeof forms / sizeof *forms };

const struct timeline_form *timeline_form_of(const char *path)
{
    for (size_t i = 0; i < FORMS; i++)
        if (file_ends_with(path, forms[i].ending))
            return &forms[i];
    return NULL;
}

bool timeline_is_named(const char *path)
{
    return timeline_form_of(path);
}

bool timeline_write(const struct timeline *timeline, const struct timeline_form *form,
                    const char *title, const struct sink *sink)
{
    return form->write(timeline, title, sink);
}

bool timeline_save(const struct timeline *timeline, const char *path, const char *title,
                   c205_error *error)
{
    struct atomic_file *whole = atomic_file_open(path, error);
    struct sink sink;
    if (!whole)
        return false;
    sink = stream_sink(whole->file);
    if (timeline_write(timeline, timeline_form_of(path), title, &sink))
        return atomic_file_commit(whole, error);
    atomic_file_discard(whole);
    return error_set(error, "out of memory");
}

void timeline_title(const struct timeline *timeline, const char *program,
                    const char *model, char title[TIMELINE_TITLE])
{
    snprintf(title, TIMELINE_TITLE,
             "%.200s, clocks %" PRIu64 " to %" PRIu64 " on %.80s", program,
             timeline->from, timeline->to, model);
}

void timeline_finish(struct timeline *timeline)
{
    uint64_t end = timeline->from + 1;
    for (size_t i = 0; i < timeline->insn_count; i++)
        if (timeline->insns[i].done > end)
            end = timeline->insns[i].done;
    if (end < timeline->to)
        timeline->to = end;
}

size_t timeline_instructions(const struct timeline *timeline)
{
    size_t count = 0;
    for (size_t i = 0; i < timeline->insn_count; i++)
        count += timeline->insns[i].insn != NULL;
    return count;
}
