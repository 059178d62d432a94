/* timeline.c - a listener that records the times of instructions. */
#include "asm/timeline/timeline.h"

#include <string.h>

#include "asm/object/disassemble.h"
#include "asm/view/operand_view.h"

/* Grows an array of the timeline by one item; NULL if memory is exhausted. */
#define ROOM(timeline, what) \
    arena_grow(&(timeline)->kept, (timeline)->what##s, (timeline)->what##_count, \
               &(timeline)->what##_capacity, sizeof *(timeline)->what##s)

static bool add_piece(struct timeline *timeline, uint64_t begin,
                      const c205_piece *piece)
{
    struct timed_piece *grown = ROOM(timeline, piece);

    if (!grown)
        return false;
    timeline->pieces = grown;
    grown[timeline->piece_count++] = (struct timed_piece){ begin, begin + piece->clocks,
                                                           piece->cause, piece->wait,
                                                           piece->number };
    return true;
}

static bool add_pieces(struct timeline *timeline, const c205_times *times)
{
    uint64_t at = times->arrived;
    size_t i;

    for (i = 0; i < times->piece_count; i++) {
        if (!add_piece(timeline, at, &times->piece[i]))
            return false;
        at += times->piece[i].clocks;
    }
    return true;
}

static bool add_phases(struct timeline *timeline, const c205_times *times)
{
    size_t i;

    for (i = 0; i < times->phase_count; i++) {
        struct timed_piece *grown = ROOM(timeline, phase);

        if (!grown)
            return false;
        timeline->phases = grown;
        grown[timeline->phase_count++] = (struct timed_piece){ times->phase[i].begin,
                                                               times->phase[i].end,
                                                               times->phase[i].cause,
                                                               C205_WAIT_NONE, 0 };
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
    struct timed_insn *grown = ROOM(timeline, insn);
    struct timed_insn made = { .pc = event->pc,
                               .arrived = times->arrived,
                               .issued = times->issued,
                               .ready = times->ready,
                               .done = done_of(event),
                               .insn = event->insn,
                               .elements = event->elements,
                               .first_piece = timeline->piece_count,
                               .first_phase = timeline->phase_count };

    if (!grown)
        return;
    timeline->insns = grown;
    if (is_end(event)) {
        made.insn = NULL;
        made.issued = made.ready = made.arrived;
        made.done = made.arrived + event->clocks;
    }
    made.text = keep_text(timeline, machine, event->pc);
    if (!made.text || !add_pieces(timeline, times) || !add_phases(timeline, times))
        return;
    made.piece_count = timeline->piece_count - made.first_piece;
    made.phase_count = timeline->phase_count - made.first_phase;
    timeline->insns[timeline->insn_count++] = made;
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
