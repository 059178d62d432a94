/* sweep.h - measures the cost of a ray while one parameter changes.
 *
 * A sweep measures one target at several points, in scalar form and in queues. The
 * target is the kernel of a primitive or the frame of a scene. The four sweep types
 * differ in their points and findings. Measuring (sweep.c), tables and output
 * (sweep_report.h) are common to all types.
 *
 * For a primitive, the clocks of its kernel and its calls count, as in the paper's
 * Table 1 (speedup.h). For a scene, all clocks of its frame count. If both forms are
 * run, their frames must be equal bit for bit.
 */
#ifndef RT_SWEEP_SWEEP_H
#define RT_SWEEP_SWEEP_H

#include "rt/study/speedup.h"

/* The parameters with which one point of a sweep is measured. */
struct sweep_point {
    struct trace_options trace; /* its mode is the form that is used in queues */
    struct speedup_view view;   /* view of a primitive */
};

struct sweep_form {
    uint64_t clocks[C205_CAUSES], total;
};

enum { SWEEP_SCALAR, SWEEP_QUEUED, SWEEP_FORMS };

struct sweep_measure {
    struct sweep_point point;
    size_t rays; /* number of camera rays, one for each pixel */
    size_t hits; /* number of these rays that hit */
    uint64_t checksum;
    struct sweep_form forms[SWEEP_FORMS];
};

struct sweep {
    const struct speedup_subject *subject; /* NULL: the target is a scene */
    const struct scene *scene;
    struct sweep_point base; /* the user's options, some of which points change */
    const size_t *lengths;   /* queue lengths that the user requested, in increasing
                              * order */
    size_t length_count;     /* 0: default lengths */
    bool pages_in_place;     /* cache misses and page faults do not count */

    struct sweep_measure *measures;
    size_t count;
    c205_model **models; /* models of the points; the sweep owns them */
    size_t model_count;
};

/* Frees the memory of a sweep. The caller has initialised the structure: it has set the
 * subject or the scene, base and lengths, and has set the other fields to zero. */
void sweep_free(struct sweep *sweep);

/* Measures further points. Runs base.trace.jobs frames concurrently. The progress
 * counts all points together. On failure sets the error and returns false. */
bool sweep_run(struct sweep *sweep, const struct sweep_point *points, size_t count,
               c205_error *error);

/* Returns a copy of the user's model with these settings. The sweep owns the copy. On
 * failure sets the error and returns NULL. */
const c205_model *sweep_model(struct sweep *sweep, const c205_setting *settings,
                              size_t count, c205_error *error);

/* Computes the number of words in all pages that the frame of a point accesses. The
 * pages have page_words words each. On failure sets the error and returns false. */
bool sweep_touched(struct sweep *sweep, const struct sweep_point *point,
                   unsigned page_words, uint64_t *words, c205_error *error);

/* Groups of causes that depend on the queue length in the same way. */
enum sweep_group {
    SWEEP_SERIAL, /* scalar instructions and branches, and waiting for them */
    SWEEP_STARTUP,
    SWEEP_STREAM,
    SWEEP_CONFLICT,
    SWEEP_MISS,
    SWEEP_FAULT,
    SWEEP_GROUPS
};
const char *sweep_group_name(enum sweep_group group);
uint64_t sweep_group_clocks(const struct sweep_form *form, enum sweep_group group);

double sweep_per_ray(const struct sweep_measure *measure, uint64_t clocks);
/* Returns the clocks per ray of a form, for all causes together. */
double sweep_cost(const struct sweep_measure *measure, int form);
double sweep_speedup(const struct sweep_measure *measure);
double sweep_hit_percent(const struct sweep_measure *measure);

#endif
