/* speedup.h - measures the paper's Table 1 on the emulated machine.
 *
 * A frame of one primitive is traced in both forms. The clocks that count are
 * those of the primitive's kernel, of its callees and of its calls: the regions
 * that its subject names. Generating rays, choosing the nearest hit and shading
 * are left out, as in the paper.
 */
#ifndef RT_SPEEDUP_H
#define RT_SPEEDUP_H

#include "rt/roots/roots.h"
#include "rt/roots/iterations.h"
#include "rt/trace/trace.h"

enum { MAX_SPEEDUP_REGIONS = 4 };

/* The machines on which the scalar program is projected. */
enum speedup_projection { SPEEDUP_720, SPEEDUP_6600, SPEEDUP_PROJECTIONS };
extern const char *const speedup_projections[SPEEDUP_PROJECTIONS];
/* Returns the name of the model for a projection. If the constants of the given
 * model are priors, it is the model of the other machine's priors, so that no row
 * mixes priors and fitted values. */
const char *speedup_projection_model(const c205_model *model,
                                     enum speedup_projection machine);

/* Table 1 has the times of this many rays. */
enum { SPEEDUP_PAPER_RAYS = 100000 };

/* The paper's figures of a subject; 0: not given. */
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
    double from[3];      /* direction of the eye from the origin, of length 1 */
    bool historical;     /* use the paper's methods */
    const char *variant; /* as in trace_options, or NULL */
    const char *regions[MAX_SPEEDUP_REGIONS]; /* NULL after the last */
    struct speedup_paper paper;
};

extern const struct speedup_subject speedup_subjects[];
extern const size_t speedup_subject_count;
/* Returns true if the name is that of a row, complete or up to its comma. The case
 * of letters is ignored. */
bool speedup_is_named(const struct speedup_subject *subject, const char *name);
/* Returns the first row with this name, or NULL. */
const struct speedup_subject *speedup_subject_named(const char *name);

/* Table 1's cylinder in several formulations. The first one is that of Table 1. */
extern const struct speedup_subject speedup_formulations[];
extern const size_t speedup_formulation_count;

/* The region whose share the paper reports. */
extern const char speedup_solver[];

/* The view of Table 1. It is so narrow that all rays hit, since the paper speaks
 * of "100,000 rays intersecting a sphere and a cylinder primitive". */
#define SPEEDUP_DISTANCE 5.0
#define SPEEDUP_ANGLE 10.0

/* The position and the direction of the eye. */
struct speedup_view {
    double distance; /* from the origin */
    double angle;    /* degrees, across the frame */
    double aim[3];   /* the point in the centre of the frame */
};

struct speedup_measure {
    uint64_t clocks[C205_CAUSES];
    uint64_t regions[MAX_SPEEDUP_REGIONS]; /* clocks, in the order of the subject */
    uint64_t total;
    double projected[SPEEDUP_PROJECTIONS]; /* seconds, of the scalar form */
    size_t rays, hits;
    uint64_t checksum; /* of the frame: equal in both forms */
    enum falsi falsi;
    struct iterations iterations; /* of the root solver */
};

/* Returns the frame of a subject, in one band, before it runs. The caller frees
 * it, then the scene. Returns NULL with the reason in the error; the scene may
 * then be NULL, too. */
struct trace *speedup_trace(const struct speedup_subject *subject,
                            const struct speedup_view *view,
                            const struct trace_options *options, struct scene **scene,
                            c205_error *error);

/* Returns the account of a region of a subject in its frame, or NULL with an error
 * if the program has no such region. */
const c205_account *speedup_account(const struct accounts *accounts, const char *region,
                                    c205_error *error);

/* Measures a subject. Returns false with the reason in the error. */
bool speedup_measure(const struct speedup_subject *subject,
                     const struct speedup_view *view,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error);

/* Measures count subjects in both forms, options.jobs frames at a time.
 * measures[i] is of subjects[i]. Returns false if the frames of the two forms
 * differ, or for another reason in the error. */
bool speedup_measure_all(const struct speedup_subject *subjects, size_t count,
                         const struct speedup_view *view,
                         const struct trace_options *options,
                         struct speedup_measure (*measures)[TRACE_FORMS],
                         c205_error *error);

#endif
