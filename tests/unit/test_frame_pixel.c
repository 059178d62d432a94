/* test_frame_pixel.c - the queue of a pixel. Its depth and the causes of its clocks are
 * compared with the frame and its accounts, its rays in all vectors with each other and
 * with the picture, and the band under a debugger with a band that runs alone. A ray in
 * another lane, or a queue with other clocks, fails here. */
#define SMALL_FRAMES
#include "tests/unit/debugger_session.h"
#include "tests/unit/draw.h"
#include "tests/unit/traced_frame.h"

#include "asm/timeline/timeline.h"
#include "rt/view/pixel_clocks.h"
#include "rt/view/pixel_rays.h"
#include "rt/view/pixel_verbs.h"

/* Returns each of the scenes in turn. */
static struct scene *some_scene(void)
{
    static size_t next;
    static const char *const texts[] = {
        HEAD
        "camera { location -5*z look_at 0 } sphere { 0, 1.6 finish { reflection .5 } }"
        "plane { y, -1 finish { reflection .3 } }",
        HEAD "camera { location <1, 2, -5> look_at 0 }"
             "torus { 1, .4 rotate -30*x } box { <1, -1, 0>, 2 }"
             "difference { sphere { -x, 1 } box { -1, 0 } }",
        HEAD
        "camera { orthographic location -5*z right 4*x up 3*y }"
        "sphere { 0, 1 pigment { rgbt <1, 1, 1, .6> } interior { ior 1.3 }"
        "  finish { reflection .2 } }"
        "plane { z, 2 pigment { checker rgb 1 rgb .2 } finish { reflection .3 } }"
        "box { <-2, -1, -2>, <-1, 0, 1> no_image } sphere { 1.5*x, .6 no_reflection }",
        HEAD "camera { location -9*z look_at 0 }"
             "#for (I, 0, 4) #for (J, 0, 4)"
             "  sphere { <I - 2, J - 2, mod(I * J, 3)>, .4"
             "    finish { reflection .2 } } #end #end "
             "box { <-3, -3, 3>, <3, .5, 4> } box { <-4, -3, 0>, <-3, 3, 2> }"
             "light_source { <9, 9, -9>, 1 }",
        HEAD "camera { location -6*z look_at 0 }"
             "intersection { box { -1, 1 rotate 30*y } sphere { 0, 1.3 }"
             "  torus { 1, .6 } } cone { <2, -1, 0>, 1, <2, 1, 0>, 0 }"
             "quadric { 1, 0, 0, -.2 translate <-1, 1, -1> } plane { y, -1.2 }"
             "light_source { <9, 9, -9>, 1 }",
    };
    return read_text(texts[next++ % (COUNT(texts))]);
}

/* ---- State of the machine at a clock ------------------------------------- */

static c205_word channel_of(const struct frame_pixel *pixel, enum frame_channel channel)
{
    return trace_channel(pixel->trace,
                         channel)[pixel->y * trace_how(pixel->trace)->width + pixel->x];
}

/* Returns the band's machine at an instruction boundary near the clock. */
static c205 *machine_at(const struct frame_pixel *pixel, uint64_t clock)
{
    c205 *machine = NON_NULL(trace_machine(pixel->trace, pixel->band, &failure));
    c205_stop stop;
    while (c205_clock(machine) < clock && c205_step(machine, &stop))
        continue;
    return machine;
}

static uint64_t label(const struct frame_pixel *pixel, const char *name)
{
    const struct asm_symbol *symbol = object_symbol(trace_program(pixel->trace), name);
    return symbol ? (uint64_t)symbol->value : 0;
}

static c205_word memory_word(const c205 *machine, uint64_t address)
{
    c205_word word;
    assert_true(c205_read(machine, address, &word, 1));
    return word;
}

static c205_word sample(const struct frame_pixel *pixel, const c205 *machine,
                        enum frame_channel channel)
{
    c205_word frame = memory_word(machine, label(pixel, "scene_frame"));
    c205_word pixels = memory_word(machine, label(pixel, "scene_pixels"));
    return memory_word(machine,
                       frame + 64 * ((uint64_t)channel * pixels + pixel->place));
}

static void add_causes(const c205 *machine, int64_t sign, int64_t clocks[C205_CAUSES])
{
    for (size_t i = 0; i < c205_account_count(machine); i++)
        for (int cause = 0; cause < C205_CAUSES; cause++)
            clocks[cause] += sign * (int64_t)c205_account_at(machine, i)->clocks[cause];
}

/* The depth is stored while the ray is shaded, not before or after. For each cause, the
 * timeline and the accounts must have the same clocks. */
static void check_queue(const struct frame_pixel *pixel,
                        const struct clock_stretch *stretch)
{
    c205_word depth = channel_of(pixel, CHANNEL_DEPTH);
    SCOPED_VALUE(timeline) timeline = { .from = stretch->from, .to = stretch->to };
    SCOPED(c205) *machine = trace_machine(pixel->trace, pixel->band, &failure);
    SCOPED(c205) *before = machine_at(pixel, stretch->from);
    SCOPED(c205) *after = machine_at(pixel, stretch->to);
    int64_t clocks[C205_CAUSES] = { 0 };
    c205_stop stop;
    assert_true(c205_to_double(sample(pixel, before, CHANNEL_DEPTH)) == 0);
    if (c205_to_double(depth) != 0)
        assert_int_equal(sample(pixel, after, CHANNEL_DEPTH), depth);
    assert_true(machine && c205_listen(machine, timeline_listen, &timeline));
    while (c205_clock(machine) < stretch->to && c205_step(machine, &stop))
        continue;
    assert_true(timeline_is_good(&timeline) && !timeline.full);
    add_causes(after, 1, clocks);
    add_causes(before, -1, clocks);
    for (size_t i = 0; i < timeline.piece_count; i++) {
        const struct timed_piece *piece = &timeline.pieces[i];
        if (piece->begin >= stretch->from && piece->begin < stretch->to)
            clocks[piece->cause] -= (int64_t)(piece->end - piece->begin);
    }
    for (int cause = 0; cause < C205_CAUSES; cause++)
        assert_int_equal(clocks[cause], 0);
}

/* The clocks of a region must be within the clocks of the queue. Control is in the
 * region during these clocks, and not earlier in the queue. */
static void check_region(const struct frame_pixel *pixel,
                         const struct clock_stretch *queue)
{
    static const char *const regions[] = { "shade", "bound", "visible" };
    const struct object *program = trace_program(pixel->trace);
    const char *region = regions[count_between(0, 2)];
    struct clock_stretch stretch = *queue;
    c205_stop stop;
    if (!pixel_region_clocks(pixel, region, &stretch, &failure))
        return;
    assert_true(stretch.to <= queue->to && stretch.from < stretch.to);
    SCOPED(c205) *machine = machine_at(pixel, queue->from);
    while (c205_clock(machine) < stretch.to) {
        bool there = strcmp(object_region(program, c205_pc(machine)), region) == 0;
        assert_int_equal(there, c205_clock(machine) >= stretch.from);
        assert_true(c205_step(machine, &stop));
    }
    if (stretch.to < queue->to)
        assert_string_not_equal(object_region(program, c205_pc(machine)), region);
}

/* Traces the next scene with random options. */
static struct trace *some_trace(struct scene **scene, enum trace_mode mode)
{
    size_t width = count_between(3, 15);
    struct trace_options options = ON_PRIOR(
            .mode = mode, .width = width, .height = count_between(3, 12),
            .queue = count_between(1, 80), .band = width * count_between(2, 6),
            .order = (enum trace_order)count_between(0, 2));
    *scene = some_scene();
    return run_trace(*scene, &options);
}

static struct frame_pixel some_pixel(const struct trace *trace)
{
    const struct trace_options *how = trace_how(trace);
    struct frame_pixel pixel;
    assert_true(frame_pixel_find(&pixel, trace, count_between(0, how->width - 1),
                                 count_between(0, how->height - 1), &failure));
    return pixel;
}

TEST(queues)
{
    for (size_t i = 0; i < 8 * TRACE_MODES; i++) {
        SCOPED(scene) *scene;
        SCOPED(trace) *trace = some_trace(&scene, (enum trace_mode)(i % TRACE_MODES));
        for (size_t k = 0; k < 4; k++) {
            struct frame_pixel pixel = some_pixel(trace);
            struct clock_stretch stretch;
            REQUIRE(pixel_queue_clocks(&pixel, &stretch, &failure));
            check_queue(&pixel, &stretch);
            check_region(&pixel, &stretch);
        }
    }
}

/* ---- The rays ------------------------------------------------------------ */

enum { MAX_POINTS = 400 };

/* The values of a pixel that are known while its band is traced. */
struct following {
    const struct frame_pixel *pixel;
    struct pixel_element ray[32]; /* elements of the queue that contain the current
                                   * ray */
    size_t ray_count;
    bool shaded;                 /* the hits have points, directions and colours */
    size_t lists[3], near, hits; /* numbers of elements reported so far */
    c205_word points[MAX_POINTS][3], colour[3];
    size_t point_count;
    bool crossed; /* a kernel has found a crossing at the hit of the picture */
};

static c205_word ray_word(const struct following *following, const char *vector)
{
    for (size_t i = 0; i < following->ray_count; i++)
        if (strcmp(following->ray[i].vector, vector) == 0)
            return following->ray[i].word;
    fail_msg("%s is not told", vector);
    return 0;
}

/* Compares an element with the vector of the queue that has the same quantity. */
static void check_same(struct following *following, const struct pixel_element *element)
{
    static const char *const same[][2] = {
        { "wox", "aox" }, { "woy", "aoy" }, { "woz", "aoz" },
        { "wdx", "adx" }, { "wdy", "ady" }, { "wdz", "adz" },
        { "hdx", "adx" }, { "hdy", "ady" }, { "hdz", "adz" },
    };
    size_t lane = following->ray[0].lane;
    for (size_t i = 0; i < COUNT(same); i++)
        if (strcmp(element->vector, same[i][0]) == 0
            && (element->group == PIXEL_NEAR || following->shaded))
            assert_int_equal(element->word, ray_word(following, same[i][1]));
    if (element->list == 0
        && (strcmp(element->vector, "tin") == 0
            || strcmp(element->vector, "tout") == 0))
        following->crossed |= element->word
                              == channel_of(following->pixel, CHANNEL_DEPTH);
    if (strcmp(element->vector, "ray_index") == 0 || strcmp(element->vector, "at") == 0)
        assert_int_equal(c205_to_integer(element->word), lane);
}

static void follow(void *context, const struct pixel_element *element)
{
    struct following *following = context;
    assert_true(element->lane < element->length);
    if (element->group == PIXEL_QUEUE) {
        if (following->ray_count > 0 && following->ray[0].lane != element->lane)
            following->ray_count = 0;
        following->ray[following->ray_count++] = *element;
        following->lists[element->list < 2 ? element->list : 2]++;
        if (element->list == 0 || strcmp(element->vector, "adz") != 0
            || trace_how(following->pixel->trace)->mode != TRACE_VECTOR)
            return;
        /* A reflected or refracted ray begins at an earlier hit. */
        const c205_word origin[] = { ray_word(following, "aox"),
                                     ray_word(following, "aoy"),
                                     ray_word(following, "aoz") };
        bool found = false;
        for (size_t i = 0; i < following->point_count; i++)
            found |= memcmp(following->points[i], origin, sizeof origin) == 0;
        assert_true(found);
        return;
    }
    *(element->group == PIXEL_NEAR ? &following->near : &following->hits) += 1;
    check_same(following, element);
    if (element->group == PIXEL_HITS) {
        assert_true(c205_to_double(ray_word(following, "nearest_primitive")) != 0);
        static const char *const names[] = { "px", "py", "pz" };
        static const char *const colours[] = { "red", "green", "blue" };
        for (size_t i = 0; following->shaded && i < 3; i++) {
            if (strcmp(element->vector, names[i]) == 0)
                following->points[following->point_count][i] = element->word;
            if (strcmp(element->vector, colours[i]) == 0 && element->list == 0)
                following->colour[i] = element->word;
        }
        if (following->shaded && strcmp(element->vector, "pz") == 0) {
            following->point_count++;
            assert_true(following->point_count < MAX_POINTS);
        }
    }
}

/* Checks the rays at borders of regions, at shaded queues and at other steps. */
static void check_rays(struct following *following)
{
    const struct frame_pixel *pixel = following->pixel;
    const struct object *program = trace_program(pixel->trace);
    uint64_t shade = label(pixel, "shade");
    uint64_t shaded = label(pixel, "shade_store_colours");
    const char *region = "";
    SCOPED(c205) *machine = trace_machine(pixel->trace, pixel->band, &failure);
    c205_stop stop;
    do {
        uint64_t pc = c205_pc(machine);
        const char *now = object_region(program, pc);
        following->shaded = pc == shaded && pc != 0;
        if (now == region && pc != shade && !following->shaded
            && strcmp(now, "sphere") != 0 && strcmp(now, "plane") != 0
            && count_between(0, 40) > 0)
            continue;
        region = now;
        following->ray_count = 0;
        size_t rays = pixel_elements(pixel, machine, follow, following);
        assert_true(rays <= 1 || following->ray[0].list > 0);
        if (rays != 1 || pc != shade || following->ray[0].list > 0
            || trace_how(pixel->trace)->mode == TRACE_SCALAR)
            continue;
        /* Before a queue is shaded, its ray's hit must be the picture's. */
        bool hit = c205_to_double(ray_word(following, "nearest_primitive")) != 0;
        assert_int_equal(hit, c205_to_integer(channel_of(pixel, CHANNEL_ID)) != 0);
        if (hit)
            assert_int_equal(ray_word(following, "nearest"),
                             channel_of(pixel, CHANNEL_DEPTH));
    } while (c205_step(machine, &stop));
}

/* Kernels must find the crossing of every hit in scenes of a sphere and a plane. The
 * colour of the hit is the colour of the pixel if there are no mirrors and no glass. */
static void check_hit(const struct following *following, const struct scene *scene)
{
    const struct frame_pixel *pixel = following->pixel;
    enum trace_mode mode = trace_how(pixel->trace)->mode;
    if (c205_to_integer(channel_of(pixel, CHANNEL_ID)) == 0)
        return;
    if (scene->primitive_count == 2 && mode != TRACE_SCALAR)
        assert_true(following->crossed);
    if (mode != TRACE_VECTOR || trace_rays(pixel->trace, RAY_REFLECTED) > 0
        || trace_rays(pixel->trace, RAY_REFRACTED) > 0)
        return;
    for (int i = 0; i < 3; i++)
        assert_int_equal(following->colour[i],
                         channel_of(pixel, (enum frame_channel)i));
}

TEST(rays)
{
    static struct following sum;
    for (size_t i = 0; i < 15 * TRACE_MODES; i++) {
        SCOPED(scene) *scene;
        SCOPED(trace) *trace = some_trace(&scene, (enum trace_mode)(i % TRACE_MODES));
        struct frame_pixel pixel = some_pixel(trace);
        struct following following = { .pixel = &pixel };
        check_rays(&following);
        assert_true(following.lists[0] > 0);
        check_hit(&following, scene);
        for (size_t k = 0; k < 3; k++)
            sum.lists[k] += following.lists[k];
        sum.near += following.near;
        sum.hits += following.hits;
    }
    assert_true(sum.lists[1] > 0 && sum.lists[2] > 0 && sum.near > 1000
                && sum.hits > 1000);
}

/* ---- Debugger sessions --------------------------------------------------- */

/* A session moves both ways to the queue of a pixel, and to the end. */
TEST(sessions)
{
    for (size_t i = 0; i < 2 * TRACE_MODES; i++) {
        enum trace_mode mode = (enum trace_mode)(i % TRACE_MODES);
        SCOPED(scene) *scene;
        SCOPED(trace) *trace = some_trace(&scene, mode);
        const struct line_said lines[] = {
            { "lane", "is in no current queue" },
            { mode == TRACE_SCALAR ? "lane dx" : "lane adx", "dx  " },
            { "continue", "the program has ended" },
        };
        FREED_BY(session_end) struct debug_session session = { .object = NULL };
        struct frame_pixel pixel = some_pixel(trace);
        struct debugger_setup setup = { .object = trace_program(trace),
                                        .name = "frame",
                                        .model = trace_how(trace)->model,
                                        .out = text_buffer_sink(&session.said),
                                        .clocks_most = C205_NO_LIMIT,
                                        .machine = pixel_machine,
                                        .verbs = pixel_verbs,
                                        .context = &pixel };
        session.debugger = NON_NULL(debugger_new(&setup, &failure));
        session_check(&session, lines, 1);
        session_obey(&session, "seek");
        const char *again = formatted("%s", session.said.text);
        assert_true(pixel_is_made(&pixel, debugger_machine(session.debugger)));
        session_obey(&session, "step 50");
        session_obey(&session, "reverse-step 50");
        assert_string_equal(session.said.text, again);
        session_obey(&session, "goto 0");
        session_obey(&session, "seek");
        assert_string_equal(session.said.text, again);
        session_check(&session, lines + 1, 2);
        const c205 *machine = debugger_machine(session.debugger);
        SCOPED(c205) *plain = trace_machine(pixel.trace, pixel.band, &failure);
        assert_int_equal(c205_run(plain, C205_NO_LIMIT).trap, C205_TRAP_NONE);
        assert_int_equal(c205_account_count(plain), c205_account_count(machine));
        for (size_t k = 0; k < c205_account_count(plain); k++)
            assert_memory_equal(c205_account_at(plain, k)->clocks,
                                c205_account_at(machine, k)->clocks,
                                sizeof c205_account_at(plain, k)->clocks);
        if (trace_bands(pixel.trace) == 1)
            assert_int_equal(c205_clock(machine), trace_accounts(pixel.trace)->clocks);
        assert_int_equal(debugger_faults(session.debugger), 0);
        session_obey(&session, "lane nothing");
        session_obey(&session, "seek nothing");
        assert_true(debugger_faults(session.debugger) > 0);
    }
}
