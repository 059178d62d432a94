/* timeline_lanes.c - places the spans of a timeline into lanes and rows. */
#include "asm/timeline/timeline_lanes.h"

static const char *const names[LANES] = {
    [LANE_CHARGED] = "charged to",      [LANE_SCALAR] = "scalar units",
    [LANE_MEMORY] = "loads and stores", [LANE_BRANCH] = "branches",
    [LANE_STARTUP] = "vector start-up", [LANE_STREAM] = "vector stream",
};

const char *lane_name(enum lane lane)
{
    return names[lane];
}

/* A row is free for a span if all earlier spans in the row have ended. ends has the end
 * of the last span in each row. If all rows are in use, the last row is returned. */
enum { MAX_ROWS = 64 };

static unsigned find_row(const struct timed_span *span, uint64_t ends[MAX_ROWS])
{
    unsigned row = 0;
    while (row + 1 < MAX_ROWS && ends[row] > span->begin)
        row++;
    ends[row] = span->end;
    return row;
}

static uint64_t cut(const struct timeline *timeline, uint64_t clock)
{
    return clock < timeline->from ? timeline->from
           : clock > timeline->to ? timeline->to
                                  : clock;
}

struct making {
    const struct timeline *timeline;
    struct arena *arena;
    struct lanes *lanes;
    uint64_t ends[LANES][MAX_ROWS];
};

static bool add_span(struct making *making, struct timed_span span)
{
    struct lanes *lanes = making->lanes;
    span.begin = cut(making->timeline, span.begin);
    span.end = cut(making->timeline, span.end);
    if (span.begin == span.end)
        return true;
    span.row = find_row(&span, making->ends[span.lane]);
    if (span.row + 1 > lanes->rows[span.lane])
        lanes->rows[span.lane] = span.row + 1;
    return arena_add(making->arena, &lanes->spans, &lanes->count, &lanes->capacity,
                     &span, sizeof span);
}

static bool add_pieces(struct making *making, const struct timed_insn *insn)
{
    for (size_t i = 0; i < insn->piece_count; i++) {
        const struct timed_piece *piece = &making->timeline
                                               ->pieces[insn->first_piece + i];
        if (!add_span(making, (struct timed_span){ piece->begin, piece->end,
                                                   LANE_CHARGED, 0, insn, piece }))
            return false;
    }
    return true;
}

static bool add_phases(struct making *making, const struct timed_insn *insn)
{
    for (size_t i = 0; i < insn->phase_count; i++) {
        const struct timed_piece *phase = &making->timeline
                                               ->phases[insn->first_phase + i];
        enum lane lane = phase->cause == C205_VECTOR_STREAM ? LANE_STREAM
                                                            : LANE_STARTUP;
        if (!add_span(making, (struct timed_span){ phase->begin, phase->end, lane, 0,
                                                   insn, phase }))
            return false;
    }
    return true;
}

static enum lane lane_of(const c205_insn *insn)
{
    return insn->unit == C205_UNIT_MEMORY   ? LANE_MEMORY
           : insn->unit == C205_UNIT_BRANCH ? LANE_BRANCH
                                            : LANE_SCALAR;
}

static bool add_insn(struct making *making, const struct timed_insn *insn)
{
    return add_pieces(making, insn) && add_phases(making, insn)
           && (insn->phase_count > 0 || !insn->insn
               || add_span(making,
                           (struct timed_span){ insn->issued, insn->ready,
                                                lane_of(insn->insn), 0, insn, NULL }));
}

bool lanes_make(const struct timeline *timeline, struct arena *arena,
                struct lanes *lanes)
{
    struct making *making = arena_take(arena, sizeof *making);
    bool good = making != NULL;
    if (!good)
        return false;
    making->timeline = timeline;
    making->arena = arena;
    making->lanes = lanes;
    for (size_t i = 0; good && i < timeline->insn_count; i++)
        good = add_insn(making, &timeline->insns[i]);
    return good;
}
