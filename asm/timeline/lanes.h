/* lanes.h - the spans of a timeline, each in a row of its own lane: spans of one row do not
 * overlap, as long as no more than 64 of a lane are at work at once, and the machine has no
 * more. */
#ifndef ASM_TIMELINE_LANES_H
#define ASM_TIMELINE_LANES_H

#include "asm/timeline/timeline.h"

enum lane {
    LANE_CHARGED, /* what the clock was charged to: one row without gaps */
    LANE_SCALAR,  /* from issue to result, by units */
    LANE_MEMORY,
    LANE_BRANCH,
    LANE_STARTUP, /* of the vector unit: start-up, misses, faults, conflicts */
    LANE_STREAM,
    LANES
};

struct timed_span {
    uint64_t begin, end;
    enum lane lane;
    unsigned row; /* within the lane */
    const struct timed_insn *insn;
    const struct timed_piece *piece; /* or phase; NULL: of a scalar instruction */
};

struct lanes {
    size_t count, capacity;
    struct timed_span *spans; /* instruction by instruction, in the order of the run */
    unsigned rows[LANES];
};

const char *lane_name(enum lane lane);
/* Spans that reach into the timeline's clocks, cut to them.  False: no memory. */
bool lanes_make(const struct timeline *timeline, struct arena *arena,
                struct lanes *lanes);

#endif
