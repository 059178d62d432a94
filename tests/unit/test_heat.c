/* test_heat.c - the rounds of a heat computation are compared with the requested error,
 * and runs with each other. A run that stops too early fails here. */
#include "rt/heat/heat.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

static const char balls[] = "sphere { -1.5*x, 1 } sphere { 1.5*x, 1 }";

static struct heat_request usual(void)
{
    return (struct heat_request)ON_PRIOR(.mode = TRACE_VECTOR, .queue = 2000,
                                         .by = BY_PRIMITIVE, .drawn = 16, .repeats = 2,
                                         .lattice = true, .seed = 1);
}

static void find(const struct scene *scene, const struct heat_request *request,
                 struct heat *heat)
{
    REQUIRE(heat_begin(scene, request, heat, &failure) && heat_find(heat, &failure));
}

static size_t random_of(const char *text, const struct heat_request *request,
                        bool precise)
{
    SCOPED(scene) *scene = read_scene(text);
    SCOPED_VALUE(heat) heat;
    find(scene, request, &heat);
    assert_int_equal(heat_is_precise(&heat), precise);
    return heat.drawn;
}

/* Each round has four times as many points, up to the limit, which has its own round.
 * The number of lines is a power of two. */
TEST(rounds)
{
    struct heat_request request = usual();
    assert_int_equal(random_of(balls, &request, true), 16);
    request.tolerance = 1e-9;
    request.limit = 100;
    assert_int_equal(random_of(balls, &request, false), 100);
    request.limit = 4;
    assert_int_equal(random_of(balls, &request, false), 16);
    request.by_lines = true;
    request.limit = 1000;
    assert_int_equal(random_of(balls, &request, false), 512);
    request.limit = 1024;
    assert_int_equal(random_of(balls, &request, false), 1024);
    request.tolerance = .5;
    assert_int_equal(random_of(balls, &request, true), 16);
    /* All rays of an isolated ball go to the environment in every repeat. The spread of
     * zero must not end the rounds early. */
    request = usual();
    request.tolerance = .01;
    request.limit = 1000;
    assert_int_equal(random_of("sphere { 0, 1 }", &request, true), 64);
}

TEST(same)
{
    static const char *const warm[] = { "default=300" };
    SCOPED(scene) *scene = read_scene(balls);
    struct heat_request request = usual();
    SCOPED_VALUE(heat) one;
    SCOPED_VALUE(heat) other;
    request.smooth = request.exchange = true;
    request.temperatures = warm;
    request.temperature_count = 1;
    find(scene, &request, &one);
    find(scene, &request, &other);
    struct surface *last = &other.surfaces.list[1];
    assert_true(heat_is_same(&one, &other));
    double *const numbers[] = { &last->area.value,
                                &last->factor[0].value,
                                &last->factor[2].error,
                                &last->smooth[0],
                                &other.thermal.exchange.radiosity[1],
                                &other.thermal.exchange.irradiation[1],
                                &other.thermal.exchange.flow[1] };
    for (size_t i = 0; i < COUNT(numbers); i++) {
        /* Two runs differ if a number differs in its last bit. */
        double kept = *numbers[i];
        *numbers[i] = nextafter(kept, INFINITY);
        assert_false(heat_is_same(&one, &other));
        *numbers[i] = kept;
        assert_true(heat_is_same(&one, &other));
    }
    last->count[2]++;
    assert_false(heat_is_same(&one, &other));
    last->count[2]--;
    last->tried++;
    assert_false(heat_is_same(&one, &other));
    last->tried--;
    assert_true(heat_is_same(&one, &other));
}
