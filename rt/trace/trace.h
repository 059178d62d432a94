/* trace.h - traces a frame of a scene on machines.
 *
 * trace_new assembles the kernels in the requested form and lays the scene out in
 * a machine's memory once, so that a scene that cannot be traced is rejected
 * early. trace_run traces the frame band by band (band.h), several bands at a time
 * in threads. The frame and the sum of the machines' accounts can be read after
 * that. Neither depends on the number of threads.
 */
#ifndef RT_TRACE_H
#define RT_TRACE_H

#include "rt/trace/band.h"

enum trace_mode {
    TRACE_SCALAR,                /* one ray after another */
    TRACE_VECTOR,                /* a queue of rays at a time */
    TRACE_FORMS,                 /* the number of forms of a kernel */
    TRACE_KERNELS = TRACE_FORMS, /* the paper's form: a queue of rays is intersected
                                  * with each primitive in vector form, and the rest
                                  * runs ray by ray */
    TRACE_MODES
};
const char *trace_mode_name(enum trace_mode mode);
/* Returns false if no mode has this name. */
bool trace_mode_named(const char *name, enum trace_mode *mode);
/* Returns the form, scalar or vector, of the programs that intersect no
 * primitives. In the paper's form they are scalar. */
enum trace_mode trace_mode_besides(enum trace_mode mode);

/* The order in which the pixels of a band enter the queues. */
enum trace_order {
    ORDER_DEFAULT, /* tiles in the vector form, rows in the others */
    ORDER_ROWS,
    ORDER_TILES, /* nearly square, with as many pixels as a queue; the scalar form
                  * has no queue and uses rows */
    ORDERS
};
const char *order_name(enum trace_order order);

/* The methods by which the vector form finds the nearest visible crossing of a
 * solid. They are the values of VISIBLE in rt/kernels/solids/visible_vector.s, which
 * also has the default. */
enum visible {
    VISIBLE_DEFAULT,
    VISIBLE_STEPPING, /* one crossing after another, until one is visible */
    VISIBLE_EVERY,
    CSG_METHODS
};
const char *visible_name(enum visible method);

enum {
    TRACE_QUEUE = 2000,      /* rays, as in the paper */
    MAX_TRACE_QUEUE = 65535, /* the longest vector */
    /* Pixels of a band, which is rounded to whole rows. The planes of a band fill 4 of
     * the 16 pages that are in memory. With twice as many pixels, the scalar form,
     * which writes the planes pixel by pixel, would wait for pages. */
    TRACE_BAND = 32768,
    MAX_TRACE_JOBS = 256
};

/* With a threshold, a pixel has one ray, and further samples only if it differs
 * from a neighbour by more than the threshold (rt/kernels/frame/adaptive.s). This
 * is decided in square blocks of TRACE_BLOCK pixels; a band is a whole number of
 * rows of blocks, at least one. A row and the pixel to the left of it form one
 * vector, which limits the columns. */
enum { TRACE_BLOCK = 32, MAX_TRACE_COLUMNS = 65534 };
/* Limits of a frame. The number of pixels fits the memory that hosts commonly
 * have. */
enum { MAX_TRACE_SAMPLES = 16 };
#define MAX_TRACE_PIXELS ((size_t)1 << 26)

struct job_set;
struct trace;

struct trace_options {
    enum trace_mode mode;
    size_t width, height;   /* pixels */
    size_t samples;         /* rays of a pixel, across and down; 0: one */
    double threshold;       /* see TRACE_BLOCK; 0: none */
    size_t queue;           /* rays; ignored in scalar mode */
    size_t band;            /* most pixels of a band, but at least one row; 0:
                             * TRACE_BAND */
    size_t jobs;            /* bands traced concurrently; 0: one */
    bool historical;        /* the paper's methods: Steiner patches by their implicit
                             * quartic, with its falsi; cylinders by the distance
                             * from the axis */
    const char *variant;    /* an additional constant of the kernels that selects a
                             * formulation under study; or NULL */
    enum visible visible;   /* of solids; vector mode only */
    enum trace_order order; /* the order in which pixels enter queues */
    bool no_bounds;         /* test every ray against every primitive */
    bool flat;              /* no hierarchy: regions in the scene's order, trees as
                             * written */
    const struct observer *const *observers; /* of every machine; ends with NULL; may
                                              * be NULL */
    const c205_model *model;                 /* must outlive the trace */
    /* Called at intervals with the number of pixels done, and at the end with all of
     * them. Returns false to stop. Calls never overlap. May be NULL. */
    bool (*progress)(void *context, size_t done, size_t pixels);
    /* Called after progress while a band is in progress, and with each finished band
     * before it is added to the frame. Its tracer gives the pixels (band_look). Calls
     * never overlap. May be NULL. */
    void (*look)(void *context, const struct trace *trace,
                 const struct band_tracer *tracer, bool done);
    void *context;
    struct job_set
        *job_set; /* runs the bands (rt/jobs/job_set.h) and outlives the trace;
                        * NULL: threads, without checkpoints */
};

/* Returns the order in which pixels enter the queues, with defaults resolved. */
enum trace_order trace_order(const struct trace_options *options);

struct trace *trace_new(const struct scene *scene, const struct trace_options *options,
                        c205_error *error);
void trace_free(struct trace *trace);

/* Opens the checkpoint files of the job set for this frame. The run then takes the
 * finished bands that the files have of this very frame, and stores each band that
 * it finishes. Call this before the run. */
bool trace_keep(struct trace *trace, c205_error *error);
/* Removes the checkpoint file. Call this when the frame is saved elsewhere. */
void trace_forget(struct trace *trace);

/* Returns the rays of a pixel, across and down. This is more than the number in the
 * options if the camera's lens needs more. */
size_t trace_samples(const struct trace *trace);

/* Returns false with the reason in the error after a trap, or if progress returned
 * false. */
bool trace_run(struct trace *trace, c205_error *error);

/* Returns the number of bands of the frame, and of those that are done, including
 * bands from the checkpoint file. */
size_t trace_bands(const struct trace *trace);
size_t trace_bands_done(const struct trace *trace);
/* Returns the number of rows that are done. After a stopped run this includes rows
 * of unfinished bands. The frame has the pixels of these rows, and zeros
 * elsewhere. */
size_t trace_rows_done(const struct trace *trace);

/* Reads the rows from first_row on, as many as the part has; the part is as wide
 * as the frame. Colours are linear light: the machine's values raised to the power
 * of the scene's assumed_gamma. */
void trace_read(const struct trace *trace, size_t first_row, struct frame *part);
/* Does the same for a band (band_look). */
void trace_read_band(const struct trace *trace, const struct band *band,
                     struct frame *part);
/* Returns a channel's samples as the machine holds them, pixel by pixel. */
const c205_word *trace_channel(const struct trace *trace, enum frame_channel channel);
/* Returns the number of camera rays that hit something. */
size_t trace_hits(const struct trace *trace);
/* Returns the 64-bit FNV-1a hash of all words of the frame, channel by channel.
 * Frames with equal checksums are taken to be the same bit for bit. */
uint64_t trace_checksum(const struct trace *trace);

/* Return the sums over all bands. */
const struct accounts *trace_accounts(const struct trace *trace);
uint64_t trace_rays(const struct trace *trace, enum ray_kind kind);

/* Returns the assembled program. */
const struct object *trace_program(const struct trace *trace);
/* Returns the options, with the number of samples that is used. */
const struct trace_options *trace_how(const struct trace *trace);
/* Returns the machine of a band, loaded but not run. The caller frees it. */
c205 *trace_machine(const struct trace *trace, size_t band, c205_error *error);
/* Returns the first row of a band, or the row after the last one. All bands have
 * the same number of rows, except perhaps the last. */
size_t trace_band_row(const struct trace *trace, size_t band);

#endif
