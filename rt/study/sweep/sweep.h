/* sweep.h - measures the cost of a ray while one parameter changes.
 *
 * A sweep measures one target, a primitive's kernel or a scene's frame, at several
 * points, in scalar form and in queues. The four kinds of sweep differ in their
 * points and in their findings. Measuring (sweep.c), tables and output (report.h)
 * are common to all.
 *
 * The clocks of a primitive are those of its kernel and its calls, as in the
 * paper's Table 1 (speedup.h). The clocks of a scene are those of its whole frame.
 * If both forms are run, their frames must be equal bit for bit.
 */
#ifndef RT_SWEEP_SWEEP_H
#define RT_SWEEP_SWEEP_H

#include "rt/study/speedup.h"

/* The parameters of a measurement. */
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
    size_t rays; /* camera rays: pixels */
    size_t hits; /* of these rays */
    uint64_t checksum;
    struct sweep_form forms[SWEEP_FORMS];
};

struct sweep {
    const struct speedup_subject *subject; /* or NULL: a scene */
    const struct scene *scene;
    struct sweep_point base; /* the user's options; points change some of them */
    const size_t *lengths;   /* the queues that the user requested, in increasing
                              * order */
    size_t length_count;     /* 0: the default ones */
    bool pages_in_place;     /* misses and faults are left out of the clocks */

    struct sweep_measure *measures;
    size_t count;
    c205_model **models; /* owned, for the points */
    size_t model_count;
};

/* Before the first call the caller sets the subject or the scene, base and lengths,
 * and zeroes the other fields. sweep_free frees the memory of the sweep. */
void sweep_free(struct sweep *sweep);

/* Measures these points, too, base.trace.jobs frames at a time. Progress covers
 * all of them together. Returns false with the reason in the error. */
bool sweep_run(struct sweep *sweep, const struct sweep_point *points, size_t count,
               c205_error *error);

/* Returns the user's model with other constants, which the sweep owns. Returns
 * NULL with the reason in the error. */
const c205_model *sweep_model(struct sweep *sweep, const c205_setting *settings,
                              size_t count, c205_error *error);

/* Computes the memory that the program of a point touches in its whole frame, as
 * words in pages of page_words. Returns false with the reason in the error. */
bool sweep_touched(struct sweep *sweep, const struct sweep_point *point,
                   unsigned page_words, uint64_t *words, c205_error *error);

/* Groups of causes that have the same meaning for the length of a queue. */
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
/* Returns the clocks per ray of a form, of all causes. */
double sweep_cost(const struct sweep_measure *measure, int form);
double sweep_speedup(const struct sweep_measure *measure);
double sweep_hit_percent(const struct sweep_measure *measure);

#endif
