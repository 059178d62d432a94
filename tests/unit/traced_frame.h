/* traced_frame.h - frames of both forms of the tracer, for the tests of the tracer.
 *
 * Every frame is traced by the scalar form, and by the vector form with several queue
 * lengths. All frames must be equal bit for bit.
 */
#ifndef TESTS_TRACED_FRAME_H
#define TESTS_TRACED_FRAME_H

#include "rt/trace/trace.h"
#include "rt/scene/language/scene_read.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/random.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/unit.h"

#include <math.h>

/* A test whose frames are expensive defines SMALL_FRAMES or MIDDLING_FRAMES.
 * STRAIGHT_AHEAD makes each pixel one unit wide. */
#ifdef SMALL_FRAMES
enum { WIDTH = 17, HEIGHT = 13 };
#define STRAIGHT_AHEAD "direction 32*z right 17*x up 13*y"
/* clang-format off */
#define QUEUES { 1, WIDTH - 1, 2000 }
/* clang-format on */
#elif defined MIDDLING_FRAMES
enum { WIDTH = 31, HEIGHT = 23 };
#define STRAIGHT_AHEAD "direction 48*z right 31*x up 23*y"
/* clang-format off */
#define QUEUES { 40, 2000 }
/* clang-format on */
#else
enum { WIDTH = 41, HEIGHT = 31 };
#define STRAIGHT_AHEAD "direction 64*z right 41*x up 31*y"
/* clang-format off */
#define QUEUES { WIDTH - 1, WIDTH, 2000 }
/* clang-format on */
#endif

enum { PIXELS = WIDTH * HEIGHT, MAX_PIXELS = 41 * 31, MAX_QUEUES = 4 };

/* A frame. The words after the last pixel are zero. */
struct words {
    c205_word channel[FRAME_CHANNELS][MAX_PIXELS];
};

/* The options with which a test traces its frames. */
struct traced {
    size_t width, height, pixels;
    size_t queues[MAX_QUEUES];        /* queue lengths; if there are fewer than
                                       * MAX_QUEUES, a 0 ends them */
    uint64_t random;                  /* random state for the scenes */
    bool historical, no_bounds, flat; /* as in trace_options */
    const char *variant;              /* as in trace_options */
    enum visible visible;             /* as in trace_options */
    enum trace_order order;           /* as in trace_options */
    size_t samples;                   /* as in trace_options */
    bool reported;                    /* the scene may cause reports */
};
extern struct traced traced;

/* Group fixture: sets the model and the size of the frames. */
static inline int set_up_frames(void **state)
{
    const size_t queues[MAX_QUEUES] = QUEUES;
    traced.width = WIDTH;
    traced.height = HEIGHT;
    traced.pixels = PIXELS;
    memcpy(traced.queues, queues, sizeof queues);
    return set_up_model(state);
}
#undef FILE_FIXTURES
#define FILE_FIXTURES set_up_frames, tear_down_model

struct scene *read_text(const char *text);
/* Traces a scene to its end. */
struct trace *run_trace(const struct scene *scene, const struct trace_options *options);
struct words *trace_words(const struct scene *scene, enum trace_mode mode,
                          size_t queue);

/* Returns the scalar frame, which equals the vector frames of all queue lengths. */
struct words *same_frame_of(const struct scene *scene, const char *text);
struct words *same_frame(const char *text);

/* Returns same_frame_of a scene, and compares it with the plain tracer. A few pixels in
 * a thousand may differ, at outlines and creases, where rounding decides. */
struct words *plain_frame(const char *text);

void check_paper_stage(const char *text, const struct words *expected);
/* Returns the number of pixels that show an object. */
size_t hits(const struct words *words);

#define HEAD \
    "#version 3.7; global_settings { assumed_gamma 1 }\n" \
    "light_source { <4, 9, -7>, rgb .9 shadowless }\n" \
    "light_source { <-9, 2, -5>, rgb <.2, .3, .5> shadowless }\n"

double between(double low, double high);
/* Returns a random integer from least to most, both included. */
size_t among(size_t least, size_t most);
void add_text(char *text, size_t size, const char *format, ...);
void add_point(char *text, size_t size, double reach);
/* Writes a random patch without its closing brace. Every second patch has weights. */
void add_steiner_patch(char *text, size_t size, double reach);

/* Checks scenes with six random shapes. At least a quarter of the rays hit. */
void check_random_scenes(void (*add_shape)(char *, size_t), size_t scenes);

/* The rays of the middle column and row are in the planes of the axes. */
#define AHEAD HEAD "camera { location <0, 0, -5> direction z right x up y }\n"

/* The camera's numbers are exact: the middle ray's direction is 0, 0, 1. */
#define STRAIGHT HEAD "camera { location <0, 0, -5> " STRAIGHT_AHEAD " }\n"

void check_middle_within(const char *text, int64_t id, double depth, double tolerance);
void check_middle(const char *text, int64_t id, double depth);

#endif
