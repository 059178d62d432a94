/* The stages side by side: all clocks belong to a part, the frames and the
 * rays are the same. */
#include "tests/unit/traced_frame.h"

#include "rt/profile.h"

#define SCENE AHEAD "light_source { <5, 9, -7>, 1 }" \
    "plane { y, -1 pigment { checker rgb 1, rgb .2 } }" \
    "sphere { 0, 1 pigment { rgb <1, .5, .2> } }"

static struct trace *stage(const struct scene *scene, int i)
{
    struct trace_options options = { .mode = profile_stages[i],
                                     .width = WIDTH,
                                     .height = HEIGHT,
                                     .queue = 200,
                                     .band = 5 * WIDTH,
                                     .watch_vectors = true,
                                     .model = model };
    c205_error error = { "" };
    struct trace *trace = trace_new(scene, &options, &error);

    if (trace == NULL || !trace_run(trace, &error))
        fail_msg("%s", error.message);
    return trace;
}

static void test_stages(void **state)
{
    struct scene *scene = read_text(SCENE);
    struct trace *traces[TRACE_MODES];

    (void)state;
    for (int i = 0; i < TRACE_MODES; i++) {
        const struct accounts *accounts;
        enum profile_part part;

        traces[i] = stage(scene, i);
        accounts = trace_accounts(traces[i]);
        for (size_t k = 0; k < accounts->count; k++)
            assert_true(profile_part_of(accounts->items[k].name, &part));
        assert_true(trace_checksum(traces[i]) == trace_checksum(traces[0]));
        for (int kind = 0; kind < RAY_KINDS; kind++)
            assert_int_equal(trace_rays(traces[i], (enum ray_kind)kind),
                             trace_rays(traces[0], (enum ray_kind)kind));
    }
    assert_int_equal(trace_rays(traces[0], RAY_PRIMARY), WIDTH * HEIGHT);
    for (int i = 0; i < TRACE_MODES; i++)
        trace_free(traces[i]);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_stages),
    };

    return cmocka_run_group_tests(tests, set_up, tear_down);
}
