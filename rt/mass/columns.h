/* columns.h - sums over columns through solids, formed by machines.
 *
 * A view looks along an axis, x, y or z: 2^rays_log parallel rays, at points of a
 * lattice, a grid or the random stream, go through the box about the scene's bodies.
 * What is seen along them, and what that adds to volumes, moments and areas, programs
 * of the machine find (rt/kernels/mass/, rt/kernels/query/): packet by packet of
 * COLUMNS_PACKET rays, each in machines of its own, whose sums a last program adds in the
 * order of packets.  So the sums are equal bit for bit in both forms, for any queue
 * and any number of jobs.
 */
#ifndef RT_MASS_COLUMNS_H
#define RT_MASS_COLUMNS_H

#include "rt/mass/overlaps.h"
#include "rt/trace/trace.h"

enum { VIEWS = 3, COLUMNS_PACKET = 4096, MAX_COLUMNS_LOG = 20 };

enum columns_points { POINTS_RANDOM, POINTS_LATTICE, POINTS_GRID, POINTS_KINDS };

/* Of a part: in a view along s, whose other axes are p and q, relative to the
 * middle of the box; lengths in the world.  As in rt/kernels/mass/columns.s. */
enum moment {
    MOMENT_1,
    MOMENT_P,
    MOMENT_Q,
    MOMENT_S,
    MOMENT_PP,
    MOMENT_QQ,
    MOMENT_SS,
    MOMENT_PQ,
    MOMENT_PS,
    MOMENT_QS,
    MOMENT_AREA,
    MOMENTS
};
/* All sums of a packet, of the parts, of all together and of the pairs, are one vector. */
enum {
    MAX_COLUMNS_PAIRS = 16384,
    MAX_COLUMNS_PARTS = (65535 - MAX_COLUMNS_PAIRS) / MOMENTS - 1
};

/* What the machines do one after another. */
enum columns_stage {
    STAGE_RAYS,
    STAGE_CROSSINGS,
    STAGE_SUMS,
    STAGE_OVERLAPS, /* if they are asked */
    STAGE_TOTALS,
    COLUMNS_STAGES
};
const char *columns_stage_name(enum columns_stage stage);

struct columns_options {
    enum trace_mode mode;
    size_t queue; /* rays at a time; not in scalar mode */
    enum columns_points points;
    size_t rays_log; /* 2^rays_log rays of a view under a shift, at most
                        2^MAX_COLUMNS_LOG */
    size_t repeats;  /* shifts, each with rays of its own */
    size_t seed;
    size_t jobs;                     /* packets at a time; 0: one */
    size_t part_count;               /* 1 .. MAX_COLUMNS_PARTS */
    const size_t *part_of;           /* of each of the scene's objects, its part */
    const struct overlaps *overlaps; /* .. of these parts; NULL: not asked */
    const c205_model *model;
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
    struct job_set *job_set; /* that does the packets; NULL: threads, and nothing is
                          kept */
};

struct columns_sums {
    size_t parts; /* with, as the last one, all of them together */
    size_t pairs;
    size_t units; /* packets, of all views and shifts */
    size_t repeats;
    size_t rays_log;            /* 2^rays_log rays of a view under a shift */
    double middle[3], width[3]; /* of the box */
    c205_word *words;           /* of all rays of a shift: [VIEWS][repeats], in each
                  [parts][MOMENTS], then [pairs] */
    uint64_t clocks[COLUMNS_STAGES];
    uint64_t crossings;
};

/* Where the job set does not collect what packets come to, there are no words. */
/* False: options that cannot be; a scene without bodies, with one that has no end, or with
 * an open surface, which the error names; a trap; progress said to stop. */
bool columns_sum(const struct scene *scene, const struct columns_options *options,
                 struct columns_sums *sums, c205_error *error);
void columns_sums_free(struct columns_sums *sums);

/* Of a sum over the rays of a shift the integral over space: the sum, times the area
 * that belongs to a ray. */
double columns_integral(const struct columns_sums *sums, size_t view, size_t repeat,
                        size_t part, enum moment moment);
/* .. the volume that both parts of a pair claim. */
double columns_overlap(const struct columns_sums *sums, size_t view, size_t repeat,
                       size_t pair);
/* 64-bit FNV-1a over all words. */
uint64_t columns_checksum(const struct columns_sums *sums);

#endif
