/* columns.h - computes the moments of solids on machines, as sums over columns: the
 * rays of three views.
 *
 * A view looks along one of the axes x, y and z. It has 2^rays_log parallel rays
 * through the box around the scene's bodies, at points of a lattice, a grid or the
 * random stream. Programs of the machine (rt/kernels/mass/, rt/kernels/query/) compute
 * the crossings, and their contributions to volumes, moments and areas. The rays are
 * divided into packets of COLUMNS_PACKET rays, which run on separate machines. A final
 * program adds the sums of the packets in order. The sums are therefore equal bit for
 * bit in both forms, for any queue length and any number of jobs.
 */
#ifndef RT_MASS_COLUMNS_H
#define RT_MASS_COLUMNS_H

#include "rt/mass/overlaps.h"
#include "rt/trace/trace.h"

enum { VIEWS = 3, COLUMNS_PACKET = 4096, MAX_COLUMNS_LOG = 20 };

enum columns_points { POINTS_RANDOM, POINTS_LATTICE, POINTS_GRID, POINTS_KINDS };

/* The moments of a part in a view along s. The other axes are p and q. Coordinates are
 * relative to the centre of the box, in world units. rt/kernels/mass/columns.s defines
 * the order. */
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
/* The sums of a packet are one vector: the sums of each part, of all parts together,
 * and of each pair of parts. */
enum {
    MAX_COLUMNS_PAIRS = 16384,
    MAX_COLUMNS_PARTS = (65535 - MAX_COLUMNS_PAIRS) / MOMENTS - 1
};

/* The stages of the computation on the machines, in their order. */
enum columns_stage {
    STAGE_RAYS,
    STAGE_CROSSINGS,
    STAGE_SUMS,
    STAGE_OVERLAPS, /* if requested */
    STAGE_TOTALS,
    COLUMNS_STAGES
};
const char *columns_stage_name(enum columns_stage stage);

struct columns_options {
    enum trace_mode mode;
    size_t queue; /* number of rays in a queue; ignored in scalar mode */
    enum columns_points points;
    size_t rays_log; /* a view has 2^rays_log rays for each shift; at most
                      * MAX_COLUMNS_LOG */
    size_t repeats;  /* number of shifts, each with its own rays */
    size_t seed;
    size_t jobs;                     /* number of packets computed concurrently; 0:
                                      * one */
    size_t part_count;               /* 1 .. MAX_COLUMNS_PARTS */
    const size_t *part_of;           /* part of each object of the scene */
    const struct overlaps *overlaps; /* overlaps of these parts; NULL: not requested */
    const c205_model *model;
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
    struct job_set *job_set; /* runs the packets; NULL: threads, without checkpoints */
};

struct columns_sums {
    size_t parts; /* number of parts, including the last one, which is all parts
                   * together */
    size_t pairs;
    size_t units; /* number of packets of all views and shifts */
    size_t repeats;
    size_t rays_log;            /* a view has 2^rays_log rays for each shift */
    double middle[3], width[3]; /* centre and widths of the box */
    c205_word *words;           /* Sums over all rays of a shift, for [VIEWS][repeats]:
                                 * [parts][MOMENTS] words, then [pairs] words. */
    uint64_t clocks[COLUMNS_STAGES];
    uint64_t crossings;
};

/* Computes the sums over the rays of all views and shifts. If the job set does not
 * collect packets, the words stay 0. Returns false for invalid options; if the scene
 * has no bodies, an unbounded body or an open surface, which the error names; after a
 * trap; or if progress returned false. */
bool columns_sum(const struct scene *scene, const struct columns_options *options,
                 struct columns_sums *sums, c205_error *error);
void columns_sums_free(struct columns_sums *sums);

/* Converts the sum of a moment over the rays of a shift to an integral over space:
 * multiplies it by the area of a ray. */
double columns_integral(const struct columns_sums *sums, size_t view, size_t repeat,
                        size_t part, enum moment moment);
/* Returns the volume that both parts of a pair occupy. */
double columns_overlap(const struct columns_sums *sums, size_t view, size_t repeat,
                       size_t pair);
/* Returns the 64-bit FNV-1a hash of all sums. */
uint64_t columns_checksum(const struct columns_sums *sums);

#endif
