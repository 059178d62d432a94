/* timeline.c - a listener that records the times of instructions. */
#include "asm/timeline/timeline.h"

#include <string.h>

#include "asm/object/disassemble.h"
#include "asm/view/operand_view.h"
#include "asm/view/source_line.h"

/* Adds a copy of an item to an array of the timeline. NULL: memory is exhausted. */
#define ADD(timeline, what, item) \
    arena_add(&(timeline)->kept, &(timeline)->what##s, &(timeline)->what##_count, \
              &(timeline)->what##_capacity, &(item), sizeof(item))

static bool add_pieces(struct timeline *timeline, const c205_times *times)
{
    uint64_t at = times->arrived;
    for (size_t i = 0; i < times->piece_count; i++) {
        const c205_piece *piece = &times->piece[i];
        struct timed_piece timed = { at, at + piece->clocks, piece->cause, piece->wait,
                                     piece->number };
        if (!ADD(timeline, piece, timed))
            return false;
        at = timed.end;
    }
    return true;
}

static bool add_phases(struct timeline *timeline, const c205_times *times)
{
    for (size_t i = 0; i < times->phase_count; i++) {
        struct timed_piece timed = { times->phase[i].begin, times->phase[i].end,
                                     times->phase[i].cause, C205_WAIT_NONE, 0 };
        if (!ADD(timeline, phase, timed))
            return false;
    }
    return true;
}

static const char *keep_text(struct timeline *timeline, const c205 *machine,
                             uint64_t pc)
{
    char text[DISASSEMBLE_TEXT_SIZE];
    disassemble_one(view_word_at(machine, pc), pc, text);
    return arena_text(&timeline->kept, text, strlen(text));
}

static const char *keep_line(struct timeline *timeline, uint64_t pc)
{
    const struct asm_line *line = timeline->object ? object_line(timeline->object, pc)
                                                   : NULL;
    struct text_buffer text = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&text);
    const char *kept = NULL;
    if (!line || !asm_line_is_called(line))
        return "";
    source_line_shown(line, &sink);
    if (!text.failed)
        kept = arena_text(&timeline->kept, text.text, text.length);
    else
        timeline->kept.failed = true;
    text_buffer_free(&text);
    return kept;
}

static uint64_t done_of(const c205_event *event)
{
    uint64_t after = event->record->arrived + event->clocks;
    return event->record->ready > after ? event->record->ready : after;
}

static bool is_end(const c205_event *event)
{
    return event->kind == C205_EVENT_STOP || event->kind == C205_EVENT_TRAP;
}

static void add_insn(struct timeline *timeline, const c205 *machine,
                     const c205_event *event)
{
    const c205_times *times = event->record;
    struct timed_insn made = { .pc = event->pc,
                               .arrived = times->arrived,
                               .issued = times->issued,
                               .ready = times->ready,
                               .done = done_of(event),
                               .insn = event->insn,
                               .elements = event->elements,
                               .first_piece = timeline->piece_count,
                               .first_phase = timeline->phase_count };
    if (is_end(event)) {
        made.insn = NULL;
        made.issued = made.ready = made.arrived;
        made.done = made.arrived + event->clocks;
    }
    made.line = made.insn ? keep_line(timeline, event->pc) : "";
    made.text = keep_text(timeline, machine, event->pc);
    if (!made.text || !made.line || !add_pieces(timeline, times)
        || !add_phases(timeline, times))
        return;
    made.piece_count = timeline->piece_count - made.first_piece;
    made.phase_count = timeline->phase_count - made.first_phase;
    ADD(timeline, insn, made);
}

void timeline_listen(void *context, const c205 *machine, const c205_event *event)
{
    struct timeline *timeline = context;
    if (!event->record || event->record->arrived >= timeline->to
        || done_of(event) <= timeline->from)
        return;
    if (timeline->insn_count == (timeline->most > 0 ? timeline->most : MAX_TIMELINE))
        timeline->full = true;
    else
        add_insn(timeline, machine, event);
}

bool timeline_is_good(const struct timeline *timeline)
{
    return !timeline->kept.failed;
}

void timeline_free(struct timeline *timeline)
{
    arena_free(&timeline->kept);
}
