/* band.h - traces one band of a frame on a machine.
 *
 * A band consists of whole rows. Each band starts on a machine that has just been
 * loaded. The pixels and the clocks of a band therefore do not depend on other bands,
 * and bands may be traced in any order, in threads, or in a later run.
 */
#ifndef RT_BAND_H
#define RT_BAND_H

#include "base/accounts.h"
#include "rt/layout/layout.h"
#include "rt/picture/picture.h"
#include "rt/trace/observer.h"

/* Kinds of rays, as the program counts them. */
enum ray_kind { RAY_PRIMARY, RAY_REFLECTED, RAY_REFRACTED, RAY_SHADOW, RAY_KINDS };
const char *ray_kind_name(enum ray_kind kind);

/* The input of a band. Everything that it points to must outlive the work. */
struct band_work {
    const struct object *program;
    const struct scene_layout *layout;
    const c205_model *model;
    size_t width, height; /* size of the whole frame in pixels */
    size_t samples;       /* samples x samples rays for each pixel; 0: one ray */
    double threshold;     /* as in trace_options */
    bool tiles;           /* the order in which pixels go into queues */
    size_t rays_a_call;   /* rays made by one call of the program's generate */
    bool ray_by_ray;      /* a pixel is finished before the next one starts */
    const struct observer *const *observers; /* ends with NULL; may be NULL */
    /* Called at intervals with the number of pixels of this band that have been
     * started. Returns whether to continue. May be NULL. */
    bool (*progress)(void *context, size_t pixels);
};

struct band {
    size_t first_row, rows;
    size_t rows_done; /* fewer than `rows` if the band was stopped */
    c205_word *words; /* FRAME_CHANNELS planes of rows x width samples */
    struct accounts accounts;
    uint64_t rays[RAY_KINDS];
};

/* Returns a new machine that is loaded to trace `rows` rows from first_row on, but has
 * not run. On failure sets the error and returns NULL. The caller frees the machine. */
c205 *band_machine(const struct band_work *work, size_t first_row, size_t rows,
                   struct frame_layout *layout, c205_error *error);

/* The largest number of observers of a machine. */
enum { MAX_BAND_OBSERVERS = C205_LISTENERS };

/* The state with which bands are traced one after another on one machine. */
struct band_tracer {
    const struct band_work *work;
    c205 *machine; /* NULL before the first band; freed by the owner of the tracer */
    struct band_watch {
        const struct observer *observer;
        void *band; /* the observer's state for the current band */
    } watches[MAX_BAND_OBSERVERS];
    size_t watch_count;
    struct frame_layout layout; /* layout of the current band */
    struct lock *lock;          /* held during begin, merge and end of the observers */
};

/* Traces the rows that the band names, and fills in its other fields, which the caller
 * frees with band_free. Returns false after a trap, if out of memory, or if progress
 * returned false. If progress returned false, *stopped is set, and the band contains
 * only the words of the finished rows, without accounts. */
bool band_trace(struct band_tracer *tracer, struct band *band, void *progress_context,
                bool *stopped, c205_error *error);
/* Copies the current band of the tracer from the machine's memory. An unfinished pixel
 * has its colour so far. If pixels have several samples, there are no colours until the
 * band ends. Returns false if out of memory. The caller frees the band. */
bool band_look(const struct band_tracer *tracer, struct band *band);
void band_free(struct band *band);

#endif
