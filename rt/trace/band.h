/* band.h - a band of a frame, traced by a machine.
 *
 * A band is some whole rows.  What a band's pixels are does not depend on the
 * other bands, nor do its clocks: every band begins with a machine that has
 * just been loaded.  So bands may be traced in any order, in threads, or on
 * another day.
 */
#ifndef RT_BAND_H
#define RT_BAND_H

#include "base/accounts.h"
#include "rt/layout/layout.h"
#include "rt/picture/picture.h"
#include "rt/trace/observer.h"

/* Rays by kind, as the program counts them. */
enum ray_kind { RAY_PRIMARY, RAY_REFLECTED, RAY_REFRACTED, RAY_SHADOW, RAY_KINDS };
const char *ray_kind_name(enum ray_kind kind);

/* What a band is traced from; all of it outlives the work. */
struct band_work {
    const struct object *program;
    const struct scene_layout *layout;
    const c205_model *model;
    size_t width, height; /* of the frame, pixels */
    size_t samples;       /* rays of a pixel, across and down; 0: one */
    double threshold;     /* as in trace_options */
    bool tiles;           /* the order in which pixels go into queues */
    size_t rays_a_call;   /* that one call of the program's generate makes */
    bool ray_by_ray;      /* a pixel is done before the next one is begun */
    const struct observer *const *observers; /* end with NULL; or NULL */
    /* Called now and then with the pixels of this band that are begun; false:
     * stop.  NULL if nobody wants to know. */
    bool (*progress)(void *context, size_t pixels);
};

struct band {
    size_t first_row, rows;
    size_t rows_done; /* fewer, from the first on, where it was stopped */
    c205_word *words; /* FRAME_CHANNELS planes of rows x width samples */
    struct accounts accounts;
    uint64_t rays[RAY_KINDS];
};

/* The machine before it begins; the caller frees it. */
c205 *band_machine(const struct band_work *work, size_t first_row, size_t rows,
                   struct frame_layout *layout, c205_error *error);

/* Observers of one machine: so many may listen. */
enum { MAX_BAND_OBSERVERS = C205_LISTENERS };

/* Traces bands, one after another. */
struct band_tracer {
    const struct band_work *work;
    c205 *machine; /* NULL before the first; its owner frees it */
    struct band_watch {
        const struct observer *observer;
        void *band; /* its state of the band that the tracer is at */
    } watches[MAX_BAND_OBSERVERS];
    size_t watch_count;
    struct frame_layout layout; /* of the band that it is at */
    struct lock *lock;          /* held while observers begin, merge and end */
};

/* Trace the rows that the band names and fill in the rest, which the caller
 * frees.  False: a trap, no memory, or progress said to stop (*stopped): then
 * the band holds the words of the rows that are done, and no accounts. */
bool band_trace(struct band_tracer *tracer, struct band *band, void *progress_context,
                bool *stopped, c205_error *error);
/* The band that the tracer is at, as it is in the machine's memory: of
 * pixels that are not done their colour so far, and of a frame of samples
 * nothing before its end.  False: no memory.  The caller frees it. */
bool band_look(const struct band_tracer *tracer, struct band *band);
void band_free(struct band *band);

#endif
