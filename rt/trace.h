/* trace.h - a frame of a scene, traced by a machine.
 *
 * trace_new assembles the kernels in the form asked for, loads them into a
 * machine and lays the scene out in its memory; trace_run lets it run; after
 * that the frame and the machine's accounts can be read.
 */
#ifndef RT_TRACE_H
#define RT_TRACE_H

#include "rt/falsi.h"
#include "rt/iterations.h"
#include "rt/picture.h"
#include "rt/scene/scene.h"

enum trace_mode {
    TRACE_SCALAR, /* one ray after another */
    TRACE_VECTOR, /* a queue of rays at a time */
    TRACE_MODES
};
const char *trace_mode_name(enum trace_mode mode);
/* False: there is no mode of that name. */
bool trace_mode_named(const char *name, enum trace_mode *mode);

enum {
    TRACE_QUEUE = 2000,      /* rays, as in the paper */
    TRACE_QUEUE_MOST = 65535 /* the longest vector */
};
/* Pixels of a frame: what fits the memory that hosts commonly have. */
#define TRACE_PIXELS_MOST ((size_t)1 << 26)

struct trace_options {
    enum trace_mode mode;
    size_t width, height;    /* pixels */
    size_t queue;            /* rays; vector mode only */
    bool historical;         /* the paper's way to Steiner patches: by their
                                implicit quartic, with its falsi */
    const c205_model *model; /* must outlive the trace */
    /* Called now and then with the pixels done, at the end with all of them;
     * returns false to stop.  NULL if nobody wants to know. */
    bool (*progress)(void *context, size_t done, size_t pixels);
    void *context;
};

struct trace;

struct trace *trace_new(const struct scene *scene,
                        const struct trace_options *options,
                        c205_error *error);
void trace_free(struct trace *trace);

/* Count the steps of the root solver from now on; before the run. */
bool trace_watch(struct trace *trace, struct iterations *iterations);

/* False: a trap, or progress said to stop; the error says which. */
bool trace_run(struct trace *trace, c205_error *error);

/* The frame so far; the caller frees it.  Its colours are linear light: what
 * the machine computed, to the power of the scene's assumed_gamma. */
bool trace_read(const struct trace *trace, struct frame *frame,
                c205_error *error);
/* A channel's samples as the machine holds them, pixel by pixel. */
bool trace_read_words(const struct trace *trace, enum frame_channel channel,
                      c205_word *words);
/* 64-bit FNV-1a over all words of the frame, channel by channel: two frames
 * with one checksum are the same bit for bit. */
bool trace_checksum(const struct trace *trace, uint64_t *checksum,
                    c205_error *error);
/* The rule of the root solver. */
enum falsi trace_falsi(const struct trace *trace);
const c205 *trace_machine(const struct trace *trace);

#endif
