/* trace.h - a frame of a scene, traced by machines.
 *
 * trace_new assembles the kernels in the form asked for and lays the scene
 * out in a machine's memory once, so that what cannot be traced is known at
 * once; trace_run traces the frame band by band (band.h), several at a time
 * in threads; after that the frame and the sum of the machines' accounts can
 * be read.  Neither depends on the number of threads.
 */
#ifndef RT_TRACE_H
#define RT_TRACE_H

#include "rt/trace/band.h"
#include "rt/trace/order.h"
#include "rt/trace/visible.h"

enum trace_mode {
    TRACE_SCALAR,                /* one ray after another */
    TRACE_VECTOR,                /* a queue of rays at a time */
    TRACE_FORMS,                 /* of a kernel there are these two */
    TRACE_KERNELS = TRACE_FORMS, /* the paper's: a queue of rays is met with
                                    each primitive in vector form, all else is
                                    done ray by ray */
    TRACE_MODES
};
const char *trace_mode_name(enum trace_mode mode);
/* False: there is no mode of that name. */
bool trace_mode_named(const char *name, enum trace_mode *mode);
/* The form, scalar or vector, of all that meets no primitives: in the paper's way it is
 * serial. */
enum trace_mode trace_mode_besides(enum trace_mode mode);

enum {
    TRACE_QUEUE = 2000,      /* rays, as in the paper */
    MAX_TRACE_QUEUE = 65535, /* the longest vector */
    /* Pixels; a band is as many whole rows.  Its planes fill 4 of the 16 pages
     * that are in memory: with twice as many the scalar form, which writes
     * them pixel by pixel, would wait for pages. */
    TRACE_BAND = 32768,
    MAX_TRACE_JOBS = 256
};

/* With a threshold a pixel has one ray, and the samples besides only if it differs
 * so much from a neighbour (rt/kernels/frame/adaptive.s).  That is so in blocks of
 * pixels, across and down; a band is as many whole rows of them, one at least. A row
 * and the pixel to the left of it are one vector. */
enum { TRACE_BLOCK = 32, MAX_TRACE_COLUMNS = 65534 };
/* Pixels of a frame: what fits the memory that hosts commonly have. */
enum { MAX_TRACE_SAMPLES = 16 };
#define MAX_TRACE_PIXELS ((size_t)1 << 26)

struct job_set;
struct trace;

struct trace_options {
    enum trace_mode mode;
    size_t width, height;   /* pixels */
    size_t samples;         /* rays of a pixel, across and down; 0: one */
    double threshold;       /* see above TRACE_BLOCK; 0: none */
    size_t queue;           /* rays; not in scalar mode */
    size_t band;            /* pixels of a band at most, but one row at
                                the least; 0: TRACE_BAND */
    size_t jobs;            /* bands traced at a time; 0: one */
    bool historical;        /* the paper's ways: to Steiner patches by their
                                implicit quartic, with its falsi; to
                                cylinders by the distance from the axis */
    const char *variant;    /* a constant more that the kernels know, of a
                                formulation that is studied; or NULL */
    enum visible visible;   /* of solids; vector mode only */
    enum trace_order order; /* in which pixels go into queues */
    bool no_bounds;         /* every ray goes against every primitive */
    bool flat;              /* regions in the scene's order, trees as they
                                are written, no hierarchy */
    const struct observer *const *observers; /* of every machine; end with
                                                NULL; or NULL */
    const c205_model *model;                 /* must outlive the trace */
    /* Called now and then with the pixels done, at the end with all of them;
     * returns false to stop.  Never twice at a time.  NULL if nobody wants to
     * know. */
    bool (*progress)(void *context, size_t done, size_t pixels);
    /* Called after progress while a band is under way, and with a band that is done
     * before it is the frame's: its tracer shows it (band_look).  Never twice at a
     * time.  NULL if nobody looks. */
    void (*look)(void *context, const struct trace *trace,
                 const struct band_tracer *tracer, bool done);
    void *context;
    struct job_set
        *job_set; /* that does the bands (rt/jobs/job_set.h), and outlives the
                          trace; NULL: threads, and nothing is kept */
};

/* The order that a stage takes, told or not. */
enum trace_order trace_order(const struct trace_options *options);

struct trace *trace_new(const struct scene *scene, const struct trace_options *options,
                        c205_error *error);
void trace_free(struct trace *trace);

/* Keep the bands in the files of the job set as they are finished, and take from them those
 * that they have, of this very frame; before the run. */
bool trace_keep(struct trace *trace, c205_error *error);
/* The frame is safe elsewhere: remove the file that keeps it. */
void trace_forget(struct trace *trace);

/* Rays of a pixel, across and down: more than the options say where the scene's
 * camera has a lens. */
size_t trace_samples(const struct trace *trace);

/* False: a trap, or progress said to stop; the error says which. */
bool trace_run(struct trace *trace, c205_error *error);

/* Bands of the frame, and those that are done, of the file that keeps them or
 * of the run. */
size_t trace_bands(const struct trace *trace);
size_t trace_bands_done(const struct trace *trace);
/* Rows that are done, after a run that was stopped those of bands that are not
 * whole among them: of these the frame has the pixels, of all others it has
 * zeros. */
size_t trace_rows_done(const struct trace *trace);

/* Rows of the frame from the first on, as many as the part has; it is as wide
 * as the frame.  Its colours are linear light: what the machine computed, to
 * the power of the scene's assumed_gamma. */
void trace_read(const struct trace *trace, size_t first_row, struct frame *part);
/* The same of a band (band_look). */
void trace_read_band(const struct trace *trace, const struct band *band,
                     struct frame *part);
/* A channel's samples as the machine holds them, pixel by pixel. */
const c205_word *trace_channel(const struct trace *trace, enum frame_channel channel);
/* Rays of the camera that hit something. */
size_t trace_hits(const struct trace *trace);
/* 64-bit FNV-1a over all words of the frame, channel by channel: two frames
 * with one checksum are the same bit for bit. */
uint64_t trace_checksum(const struct trace *trace);

/* Of all bands together. */
const struct accounts *trace_accounts(const struct trace *trace);
uint64_t trace_rays(const struct trace *trace, enum ray_kind kind);

/* As it was assembled. */
const struct object *trace_program(const struct trace *trace);
/* The options, with the samples that are taken. */
const struct trace_options *trace_how(const struct trace *trace);
/* The machine of a band before it begins; the caller frees it. */
c205 *trace_machine(const struct trace *trace, size_t band, c205_error *error);
/* The first row of a band, or of what is behind the last one; all have as many but perhaps
 * the last. */
size_t trace_band_row(const struct trace *trace, size_t band);

#endif
