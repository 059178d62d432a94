/* timeline_lanes.h - the spans of a timeline, each in a row of a lane. Spans of a row
 * do not overlap if at most 64 spans of the lane are active at once. The machine never
 * has more. */
#ifndef ASM_TIMELINE_TIMELINE_LANES_H
#define ASM_TIMELINE_TIMELINE_LANES_H

#include "asm/timeline/timeline.h"

enum lane {
    LANE_CHARGED, /* causes that are charged: one row without gaps */
    LANE_SCALAR,  /* from issue to result, for each unit */
    LANE_MEMORY,
    LANE_BRANCH,
    LANE_STARTUP, /* vector unit: start-up, misses, faults, conflicts */
    LANE_STREAM,
    LANES
};

struct timed_span {
    uint64_t begin, end;
    enum lane lane;
    unsigned row; /* row of the lane */
    const struct timed_insn *insn;
    const struct timed_piece *piece; /* piece or phase; NULL: a scalar instruction */
};

struct lanes {
    size_t count, capacity;
    struct timed_span *spans; /* by instruction, in the order of the run */
    unsigned rows[LANES];
};

const char *lane_name(enum lane lane);
/* Makes the spans that overlap the timeline's range of clocks, clipped to that range.
 * Returns false if memory is exhausted. */
bool lanes_make(const struct timeline *timeline, struct arena *arena,
                struct lanes *lanes);

#endif
