/* test_pixel_order.c - the frames of both orders of pixels are compared, over random
 * sizes, queues, bands and jobs. Tiles are compared with their definition. A pixel that
 * is lost or at another place fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

/* A background, objects that leave a part of it visible, and rays of three levels. */
static const char things[] = HEAD
    "background { rgb <.1, .2, .3> }\n"
    "global_settings { max_trace_level 3 }\n"
    "camera { location <0, 1, -6> look_at 0 right 1.3*x up y }\n"
    "sphere { <-.8, 0, 0>, .9 pigment { rgb <1, .5, 0> }\n"
    "  finish { reflection .4 phong .5 } }\n"
    "box { <.2, -1, -.6>, <1.4, .5, .6> pigment { rgbt <.5, 1, 1, .6> }\n"
    "  finish { specular .4 } interior { ior 1.3 } rotate 20*y }\n"
    "cylinder { <-2, -1, 1>, <-2, 1.2, 1>, .4\n"
    "  pigment { checker rgb 1 rgb <0, .3, 1> scale .3 } }\n"
    "plane { y, -1 pigment { checker rgb 1, rgb .2 } }\n";

static void check_same(const struct scene *scene, const struct trace_options *options,
                       uint64_t expected)
{
    SCOPED(trace) *trace = run_trace(scene, options);
    FAIL_IF(trace_checksum(trace) != expected,
            "%zu x %zu, %s by %s, queue %zu, band %zu, jobs %zu: another frame",
            options->width, options->height, trace_mode_name(options->mode),
            order_name(options->order), options->queue, options->band, options->jobs);
}

TEST(same_frame)
{
    SCOPED(scene) *scene = read_text(things);
    for (int i = 0; i < 14; i++) {
        size_t width = among(1, 50), height = among(1, 40);
        struct trace_options scalar = ON_PRIOR(.mode = TRACE_SCALAR,
                                               .order = ORDER_TILES, .width = width,
                                               .height = height);
        SCOPED(trace) *trace = run_trace(scene, &scalar);
        uint64_t expected = trace_checksum(trace);
        for (int k = 0; k < 3; k++) {
            struct trace_options options = ON_PRIOR(
                    .mode = k == 2 ? TRACE_KERNELS : TRACE_VECTOR,
                    .order = k == 0 ? ORDER_ROWS : ORDER_TILES, .width = width,
                    .height = height,
                    .queue = xorshift(&traced.random) % 2 ? among(1, 60)
                                                          : among(1, 3000),
                    .band = among(1, width * height + 10), .jobs = among(1, 3));
            check_same(scene, &options, expected);
        }
    }
}

/* A band with more pixels than a vector has elements. */
TEST(one_large_band)
{
    SCOPED(scene) *scene = read_text(AHEAD "background { rgb <.5, .25, 1> }\n"
                                           "sphere { 0, 1 }\n");
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .width = 300,
                                            .height = 250, .queue = 65535,
                                            .band = 75000, .order = ORDER_ROWS);
    SCOPED(trace) *trace = run_trace(scene, &options);
    uint64_t expected = trace_checksum(trace);
    options.order = ORDER_TILES;
    check_same(scene, &options, expected);
    options.queue = 2000;
    check_same(scene, &options, expected);
}

/* Returns the clocks of a grid of small spheres. A queue that is a tile tests few
 * spheres. A queue of rows tests all spheres in a row of the grid. */
static uint64_t work_of(const struct scene *scene, enum trace_mode mode,
                        enum trace_order order)
{
    struct trace_options options = ON_PRIOR(.mode = mode, .order = order, .width = 90,
                                            .height = 90, .queue = 225);
    SCOPED(trace) *trace = run_trace(scene, &options);
    return trace_accounts(trace)->clocks;
}

TEST(tiles_meet_less)
{
    SCOPED(scene) *scene = read_text(
        STRAIGHT "#for (I, 0, 5) #for (K, 0, 5)\n"
                 "sphere { <I - 2.5, K - 2.5, 0> / 4, .1 } #end #end\n");
    uint64_t rows = work_of(scene, TRACE_VECTOR, ORDER_ROWS);
    uint64_t tiles = work_of(scene, TRACE_VECTOR, ORDER_TILES);
    assert_true(tiles < rows - rows / 8);
    assert_int_equal(work_of(scene, TRACE_VECTOR, ORDER_DEFAULT), tiles);
    assert_int_equal(work_of(scene, TRACE_KERNELS, ORDER_DEFAULT),
                     work_of(scene, TRACE_KERNELS, ORDER_ROWS));
    assert_true(work_of(scene, TRACE_KERNELS, ORDER_TILES)
                < work_of(scene, TRACE_KERNELS, ORDER_ROWS));
    assert_int_equal(work_of(scene, TRACE_SCALAR, ORDER_TILES),
                     work_of(scene, TRACE_SCALAR, ORDER_ROWS));
}
