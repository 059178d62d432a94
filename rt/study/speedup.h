/* speedup.h - measures the paper's Table 1 on the emulated machine.
 *
 * A frame of one primitive is traced in both forms. The clocks of the regions that the
 * subject names are measured: the primitive's kernel, its callees and its calls. As in
 * the paper, generating rays, choosing the nearest hit and shading do not count.
 */
#ifndef RT_SPEEDUP_H
#define RT_SPEEDUP_H

#include "rt/roots/roots.h"
#include "rt/roots/iterations.h"
#include "rt/trace/trace.h"

enum { MAX_SPEEDUP_REGIONS = 4 };

/* The machines to which the scalar program is projected. */
enum speedup_projection { SPEEDUP_720, SPEEDUP_6600, SPEEDUP_PROJECTIONS };
extern const char *const speedup_projections[SPEEDUP_PROJECTIONS];
/* Returns the name of the model for a projection. If the given model has priors, so has
 * the returned model, so that no row mixes priors and fitted values. */
const char *speedup_projection_model(const c205_model *model,
                                     enum speedup_projection machine);

/* The times in Table 1 are for this number of rays. */
enum { SPEEDUP_PAPER_RAYS = 100000 };

/* The paper's figures for a subject. 0: not in the paper. */
struct speedup_paper {
    double seconds[TRACE_FORMS]; /* CPU time of the rays in Table 1 */
    double speedup;              /* as printed in Table 1 */
    struct {
        double seconds, speedup;
    } projected[SPEEDUP_PROJECTIONS];
    double solver; /* percentage of the time in the root solver */
};

struct speedup_subject {
    const char *name;    /* name of the row */
    const char *shape;   /* shape in the scene language */
    double from[3];      /* unit vector from the origin to the eye */
    bool historical;     /* use the paper's methods */
    const char *variant; /* as in trace_options, or NULL */
    const char *regions[MAX_SPEEDUP_REGIONS]; /* ends with NULL */
    struct speedup_paper paper;
};

extern const struct speedup_subject speedup_subjects[];
extern const size_t speedup_subject_count;
/* Returns true if the name is that of the subject, either complete or up to its comma.
 * Case is ignored. */
bool speedup_is_named(const struct speedup_subject *subject, const char *name);
/* Returns the first row with this name, or NULL. */
const struct speedup_subject *speedup_subject_named(const char *name);

/* The cylinder of Table 1 in several formulations. The first formulation is the
 * cylinder of Table 1. */
extern const struct speedup_subject speedup_formulations[];
extern const size_t speedup_formulation_count;

/* The name of the root solver's region. The paper reports its fraction of the time. */
extern const char speedup_solver[];

/* The view of Table 1. It is so narrow that all rays hit, because the paper refers to
 * "100,000 rays intersecting a sphere and a cylinder primitive". */
#define SPEEDUP_DISTANCE 5.0
#define SPEEDUP_ANGLE 10.0

/* The camera of a frame. Its direction from the origin is a member of the subject. */
struct speedup_view {
    double distance; /* distance from the origin */
    double angle;    /* horizontal angle of view in degrees */
    double aim[3];   /* point in the centre of the frame */
};

struct speedup_measure {
    uint64_t clocks[C205_CAUSES];
    uint64_t regions[MAX_SPEEDUP_REGIONS]; /* clocks of the subject's regions, in
                                            * order */
    uint64_t total;
    double projected[SPEEDUP_PROJECTIONS]; /* seconds of the scalar form on other
                                            * machines */
    size_t rays, hits;
    uint64_t checksum; /* checksum of the frame, which is equal in both forms */
    enum falsi falsi;
    struct iterations iterations; /* iterations of the root solver */
};

/* Returns a new trace of the subject's frame in one band. On failure sets the error and
 * returns NULL. The caller frees the trace and then the scene, even after a failure;
 * *scene may be NULL. */
struct trace *speedup_trace(const struct speedup_subject *subject,
                            const struct speedup_view *view,
                            const struct trace_options *options, struct scene **scene,
                            c205_error *error);

/* Returns the account of a region of the subject in its frame. If the program has no
 * such region, sets the error and returns NULL. */
const c205_account *speedup_account(const struct accounts *accounts, const char *region,
                                    c205_error *error);

/* Measures a subject. On failure sets the error and returns false. */
bool speedup_measure(const struct speedup_subject *subject,
                     const struct speedup_view *view,
                     const struct trace_options *options,
                     struct speedup_measure *measure, c205_error *error);

/* Measures all subjects in both forms. Traces options.jobs frames concurrently.
 * measures[i] belongs to subjects[i]. On failure, or if the frames of the two forms
 * differ, sets the error and returns false. */
bool speedup_measure_all(const struct speedup_subject *subjects, size_t count,
                         const struct speedup_view *view,
                         const struct trace_options *options,
                         struct speedup_measure (*measures)[TRACE_FORMS],
                         c205_error *error);

#endif
