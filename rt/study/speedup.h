/* speedup.h - the paper's Table 1 on the emulated machine.
 *
 * A frame of one primitive is traced in both forms; what counts are the
 * clocks of the primitive's kernel, of what it calls and of calling it: the
 * regions that its subject names.  Making the rays, choosing the nearest hit
 * and shading are left out, as in the paper.
 */
#ifndef RT_SPEEDUP_H
#define RT_SPEEDUP_H

#include "rt/roots/falsi.h"
#include "rt/roots/iterations.h"
#include "rt/trace/trace.h"

enum { MAX_SPEEDUP_REGIONS = 4 };

/* The machines on which the scalar program is projected. */
enum speedup_projection { SPEEDUP_720, SPEEDUP_6600, SPEEDUP_PROJECTIONS };
extern const char *const speedup_projections[SPEEDUP_PROJECTIONS];
/* The name of the model that it is projected with: beside a machine whose
 * constants are priors that of the priors, so that no row mixes the two. */
const char *speedup_projection_model(const c205_model *model,
                                     enum speedup_projection machine);

/* Table 1 tells the times of so many rays. */
enum { SPEEDUP_PAPER_RAYS = 100000 };

/* What the paper says of a subject.  0: nothing. */
struct speedup_paper {
    double seconds[TRACE_FORMS]; /* CPU time of the rays, Table 1 */
    double speedup;              /* as printed there */
    struct {
        double seconds, speedup;
    } projected[SPEEDUP_PROJECTIONS];
    double solver; /* percent of the time in the root solver */
};

struct speedup_subject {
    const char *name;    /* of the row */
    const char *shape;   /* its text in the scene language */
    double from[3];      /* the eye, seen from the origin; of length one */
    bool historical;     /* by the paper's methods */
    const char *variant; /* as in trace_options; or NULL */
    const char *regions[MAX_SPEEDUP_REGIONS]; /* NULL after the last */
    struct speedup_paper paper;
};

extern const struct speedup_subject speedup_subjects[];
extern const size_t speedup_subject_count;
/* A row by its whole name, or as far as its comma, in capitals or not. */
bool speedup_is_named(const struct speedup_subject *subject, const char *name);

/* Table 1's cylinder in the formulations that were tried, its own the first. */
extern const struct speedup_subject speedup_formulations[];
extern const size_t speedup_formulation_count;

/* The region whose share the paper tells. */
extern const char speedup_solver[];

/* The view of Table 1: so narrow that all rays hit, as the paper speaks of
 * "100,000 rays intersecting a sphere and a cylinder primitive". */
#define SPEEDUP_DISTANCE 5.0
#define SPEEDUP_ANGLE 10.0

/* Where the eye is and looks. */
struct speedup_view {
    double distance; /* from the origin */
    double angle;    /* degrees, across the frame */
    double aim[3];   /* the point in the middle of the frame */
};

struct speedup_measure {
    uint64_t clocks[C205_CAUSES];
    uint64_t regions[MAX_SPEEDUP_REGIONS]; /* clocks, as in the subject */
    uint64_t total;
    double projected[SPEEDUP_PROJECTIONS]; /* seconds; of the scalar form */
    size_t rays, hits;
    uint64_t checksum; /* of the frame: equal in both forms */
    enum falsi falsi;
    struct iterations iterations; /* of the root solver */
};

/* The frame of a subject, before it runs: one band.  The caller frees it, then
 * the scene.  NULL: the error says why; the scene may be NULL too. */
struct trace *speedup_trace(const struct speedup_subject *subject,
                            const struct speedup_view *view,
                            const struct trace_options *options, struct scene **scene,
                            c205_error *error);

/* What a region of a subject took in its frame.  NULL: the error says that
 * the program has none of that name. */
const c205_account *speedup_account(const struct accounts *accounts, const char *region,
                                    c205_error *error);

/* False: the error says why. */
bool speedup_measure(const struct speedup_subject *subject,
                     const struct speedup_view *view,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error);

/* Count subjects in both forms, options.jobs frames at a time: measures[i] of
 * subjects[i].  The frames of both forms are equal; false: they are
 * not, or the error says why else. */
bool speedup_measure_all(const struct speedup_subject *subjects, size_t count,
                         const struct speedup_view *view,
                         const struct trace_options *options,
                         struct speedup_measure (*measures)[TRACE_FORMS],
                         c205_error *error);

#endif
