/* sweep.h - what a ray costs while one thing changes from point to point.
 *
 * A sweep measures one target, a primitive's kernel or a scene's frame, at
 * some points: in scalar form and in queues.  The four kinds of sweep differ
 * in their points and in what they find in the measures; measuring
 * (sweep.c), tables and print (report.h) are the same.
 *
 * The clocks of a primitive are those of its kernel and its calls, as in the
 * paper's Table 1 (speedup.h); the clocks of a scene are those of all of its
 * frame.  Where both forms are run their frames must be equal bit for bit.
 */
#ifndef RT_SWEEP_SWEEP_H
#define RT_SWEEP_SWEEP_H

#include "rt/study/speedup.h"

/* What a measurement depends on. */
struct sweep_point {
    struct trace_options trace; /* its mode is the form in queues */
    struct speedup_view view;   /* of a primitive */
};

struct sweep_form {
    uint64_t clocks[C205_CAUSES], total;
};

enum { SWEEP_SCALAR, SWEEP_QUEUED, SWEEP_FORMS };

struct sweep_measure {
    struct sweep_point point;
    size_t rays; /* of the camera: pixels */
    size_t hits; /* of these */
    uint64_t checksum;
    struct sweep_form forms[SWEEP_FORMS];
};

struct sweep {
    const struct speedup_subject *subject; /* or NULL: */
    const struct scene *scene;
    struct sweep_point base; /* what the user asked for; points vary it */
    const size_t *lengths;   /* the queues that the user asked for, rising; */
    size_t length_count;     /* 0: the usual ones */
    bool pages_in_place;     /* misses and faults are left out of the clocks */

    struct sweep_measure *measures;
    size_t count;
    c205_model **models; /* that the points need */
    size_t model_count;
};

/* Subject or scene, base and lengths are set; the rest is zero. */
void sweep_free(struct sweep *sweep);

/* Measure these points too, base.trace.jobs frames at a time; progress is of
 * all of them together.  False: the error says why. */
bool sweep_run(struct sweep *sweep, const struct sweep_point *points, size_t count,
               c205_error *error);

/* The user's model with other constants, which the sweep keeps.  NULL: the
 * error says why. */
const c205_model *sweep_model(struct sweep *sweep, const c205_setting *settings,
                              size_t count, c205_error *error);

/* All pages that the program of a point touches, of its whole frame: words in
 * pages of page_words.  False: the error says why. */
bool sweep_touched(struct sweep *sweep, const struct sweep_point *point,
                   unsigned page_words, uint64_t *words, c205_error *error);

/* Causes that say the same to who looks at a queue. */
enum sweep_group {
    SWEEP_SERIAL, /* scalar instructions, their waits and branches */
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
/* Clocks per ray in a form, of all causes. */
double sweep_cost(const struct sweep_measure *measure, int form);
double sweep_speedup(const struct sweep_measure *measure);
double sweep_hit_percent(const struct sweep_measure *measure);

#endif
