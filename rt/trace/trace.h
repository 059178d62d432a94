/* trace.h - traces a frame of a scene on machines.
 *
 * trace_new assembles the kernels in the requested form. It also lays the scene out in
 * a machine's memory, once, so that it rejects a scene that cannot be traced. trace_run
 * traces the frame band by band (band.h), several bands at a time in threads.
 * Afterwards the frame and the sum of the machines' accounts can be read. They do not
 * depend on the number of threads.
 */
#ifndef RT_TRACE_H
#define RT_TRACE_H

#include "rt/trace/band.h"

enum trace_mode {
    TRACE_SCALAR,                /* one ray at a time */
    TRACE_VECTOR,                /* a queue of rays at a time */
    TRACE_FORMS,                 /* the number of forms of a kernel */
    TRACE_KERNELS = TRACE_FORMS, /* the paper's form: a queue of rays is intersected
                                  * with each primitive in vector form; all other work
                                  * runs ray by ray */
    TRACE_MODES
};
const char *trace_mode_name(enum trace_mode mode);
/* Sets the mode with this name. Returns false if there is no such mode. */
bool trace_mode_named(const char *name, enum trace_mode *mode);
/* Returns the form, scalar or vector, of programs that intersect no primitives. It is
 * scalar for the paper's form. */
enum trace_mode trace_mode_besides(enum trace_mode mode);

/* The order in which the pixels of a band enter the queues. */
enum trace_order {
    ORDER_DEFAULT, /* tiles in the vector form, rows in the others */
    ORDER_ROWS,
    ORDER_TILES, /* nearly square, with as many pixels as a queue; in the scalar form,
                  * which has no queue, the same as rows */
    ORDERS
};
const char *order_name(enum trace_order order);

/* The methods by which the vector form finds the nearest visible crossing of a solid.
 * VISIBLE in rt/kernels/solids/visible_vector.s has the same values, and defines the
 * default. */
enum visible {
    VISIBLE_DEFAULT,
    VISIBLE_STEPPING, /* test one crossing after another, until one is visible */
    VISIBLE_EVERY,
    CSG_METHODS
};
const char *visible_name(enum visible method);

enum {
    TRACE_QUEUE = 2000,      /* number of rays, as in the paper */
    MAX_TRACE_QUEUE = 65535, /* length of the longest vector */
    /* The number of pixels of a band; it is rounded to whole rows. The planes of a band
     * fill 4 of the 16 pages that are in memory. With twice as many pixels the scalar
     * form, which writes the planes pixel by pixel, would wait for pages. */
    TRACE_BAND = 32768,
    MAX_TRACE_JOBS = 256
};

/* With a threshold, a pixel first gets one ray. It gets further samples only if it
 * differs from a neighbour by more than the threshold (rt/kernels/frame/adaptive.s).
 * The kernel compares square blocks of TRACE_BLOCK pixels, so a band consists of whole
 * rows of blocks. A row and the pixel to its left form one vector, which limits the
 * number of columns. */
enum { TRACE_BLOCK = 32, MAX_TRACE_COLUMNS = 65534 };
/* Limits of a frame. A frame with the largest number of pixels fits in the memory of a
 * common host. */
enum { MAX_TRACE_SAMPLES = 16 };
#define MAX_TRACE_PIXELS ((size_t)1 << 26)

struct job_set;
struct trace;

struct trace_options {
    enum trace_mode mode;
    size_t width, height;   /* in pixels */
    size_t samples;         /* samples x samples rays for each pixel; 0: one ray */
    double threshold;       /* see TRACE_BLOCK; 0: none */
    size_t queue;           /* number of rays in a queue; ignored in scalar mode */
    size_t band;            /* largest number of pixels in a band, which has at least
                             * one row; 0: TRACE_BAND */
    size_t jobs;            /* number of bands traced concurrently; 0: one */
    bool historical;        /* use the paper's methods: for Steiner patches the implicit
                             * quartic and the paper's regula falsi; for cylinders the
                             * distance from the axis */
    const char *variant;    /* A constant of the kernels that selects a formulation
                             * under study; NULL: none. */
    enum visible visible;   /* CSG method for solids; vector mode only */
    enum trace_order order; /* the order in which pixels enter queues */
    bool no_bounds;         /* test every ray against every primitive */
    bool flat;              /* no hierarchy: regions in the order of the scene, trees as
                             * written */
    const struct observer *const *observers; /* observers of every machine; ends with
                                              * NULL; may be NULL */
    const c205_model *model;                 /* must outlive the trace */
    /* Called at intervals with the number of finished pixels, and at the end with the
     * number of all pixels. Returns whether to continue. Calls never overlap. May be
     * NULL. */
    bool (*progress)(void *context, size_t done, size_t pixels);
    /* Called after `progress` while a band is traced, and with each finished band
     * before it is added to the frame. band_look reads the pixels from the tracer.
     * Calls never overlap. May be NULL. */
    void (*look)(void *context, const struct trace *trace,
                 const struct band_tracer *tracer, bool done);
    void *context;
    struct job_set
        *job_set; /* runs the bands (rt/jobs/job_set.h); must outlive the trace; NULL:
                   * threads without checkpoints */
};

/* Returns the order in which pixels enter the queues, with defaults resolved. */
enum trace_order trace_order(const struct trace_options *options);

struct trace *trace_new(const struct scene *scene, const struct trace_options *options,
                        c205_error *error);
void trace_free(struct trace *trace);

/* Opens the checkpoint files of the job set for this frame; call it before the run. The
 * run then takes finished bands of exactly this frame from the files, and stores each
 * band that it finishes. */
bool trace_keep(struct trace *trace, c205_error *error);
/* Removes the checkpoint file. Call this after the frame has been saved. */
void trace_forget(struct trace *trace);

/* Returns the number of rays across and down a pixel. It exceeds the number in the
 * options if the camera's lens needs more rays. */
size_t trace_samples(const struct trace *trace);

/* Traces the frame. Returns false with the error after a trap, or if progress returned
 * false. */
bool trace_run(struct trace *trace, c205_error *error);

/* Return the number of bands of the frame, and the number of finished bands, including
 * bands from checkpoint files. */
size_t trace_bands(const struct trace *trace);
size_t trace_bands_done(const struct trace *trace);
/* Returns the number of finished rows. After a stopped run this includes rows of
 * unfinished bands. The other rows of the frame are zeros. */
size_t trace_rows_done(const struct trace *trace);

/* Reads rows from first_row on; `part` sets their number and has the width of the
 * frame. Colours are linear light: the machine's values raised to the power of the
 * scene's assumed_gamma. */
void trace_read(const struct trace *trace, size_t first_row, struct frame *part);
/* Reads all rows of a band (band_look), which may be unfinished. Converts the samples
 * as trace_read does. */
void trace_read_band(const struct trace *trace, const struct band *band,
                     struct frame *part);
/* Returns the samples of a channel in the machine's format, pixel by pixel. */
const c205_word *trace_channel(const struct trace *trace, enum frame_channel channel);
/* Returns the number of camera rays that hit something. */
size_t trace_hits(const struct trace *trace);
/* Returns the 64-bit FNV-1a hash of all words of the frame, channel by channel. Frames
 * with equal checksums are assumed to be equal bit for bit. */
uint64_t trace_checksum(const struct trace *trace);

/* Return the accounts, and the number of rays of a kind, summed over all bands. */
const struct accounts *trace_accounts(const struct trace *trace);
uint64_t trace_rays(const struct trace *trace, enum ray_kind kind);

/* Returns the assembled program. */
const struct object *trace_program(const struct trace *trace);
/* Returns the options, in which `samples` is the number of samples that is used. */
const struct trace_options *trace_how(const struct trace *trace);
/* Returns the machine of a band, which has been loaded but has not run. The caller
 * frees it. */
c205 *trace_machine(const struct trace *trace, size_t band, c205_error *error);
/* Returns the first row of a band. All bands have the same number of rows, except
 * perhaps the last. */
size_t trace_band_row(const struct trace *trace, size_t band);

#endif
