/* test_extreme_scenes.c - lights, cameras, objects and textures with distances and
 * sizes up to 10^30. The frames of every form, with and without bounds, are compared
 * with each other. A sum that overflows in only one form fails here. */
#define SMALL_FRAMES
#include "tests/unit/random_solids.h"

enum { SCENES = 30 };

static char text[1 << 14];

/* Returns a size. Two of three sizes are ordinary. */
static double any_size(void)
{
    return among(0, 2) > 0 ? between(.5, 3) : pow(10, between(-12, 30));
}

#define add(...) add_text(text, sizeof text, __VA_ARGS__)

static void add_place(double size)
{
    add("<%.6g, %.6g, %.6g>", size * between(-1, 1), size * between(.1, 1),
        size * between(-1, .5));
}

static void add_light(void)
{
    static const char *const kinds[] = { "",
                                         "parallel",
                                         "spotlight radius %g falloff %g tightness 2",
                                         "cylinder radius %g falloff %g",
                                         "area_light",
                                         "shadowless" };
    size_t kind = among(0, 5);
    double size = any_size();
    add("light_source { ");
    add_place(10 * any_size());
    add(", rgb %.2f ", between(.3, 1));
    if (kind == 2)
        size = between(2, 40);
    add(kinds[kind], size, size * 1.5);
    if (kind == 4) {
        add(" ");
        add_place(any_size());
        add(", ");
        add_place(any_size());
        add(", %zu, %zu", among(1, 3), among(1, 3));
    } else if (kind > 0 && kind < 4) {
        add(" point_at ");
        add_place(any_size());
    }
    if (!among(0, 3))
        add(" fade_distance %.4g fade_power %.1f", any_size(), between(1, 3));
    add(" }\n");
}

static void add_texture(void)
{
    static const char *const pigments[] = {
        "rgb <.9, .5, .2>",
        "checker rgb 1, rgb .3",
        "rgbf .8",
        "gradient x color_map { [0 rgb 1] [1 rgb .2] }",
        "brick rgb 1, rgb .4",
        "hexagon rgb 1, rgb .5, rgb .1",
        "onion color_map { [0 rgb 1] [1 rgb <1, .2, .2>] }",
        "checker rgbt .9, rgb .6",
    };
    add("pigment { %s scale %.4g translate %.4g } ", pigments[among(0, 7)], any_size(),
        any_size() - 1);
    if (!among(0, 2))
        add("normal { leopard .5 scale %.4g } ", any_size());
    add("finish { reflection %.1f phong .4 } interior { ior 1.4 } ",
        among(0, 1) ? .4 : 0);
}

static void add_object(void)
{
    size_t kind = among(0, PRIMITIVE_KINDS);
    if (kind == PRIMITIVE_KINDS)
        add("difference { sphere { 0, 1 } box { 0, 2 } ");
    else
        random_shapes[kind](text, sizeof text);
    add_texture();
    add("rotate %.1f*x scale %.4g translate ", between(-90, 90), any_size());
    add_place(2 * any_size());
    add(" }\n");
}

/* Returns NULL if the form reports an error. In this case every form must report it. */
static struct words *frame_in(const struct scene *scene, enum trace_mode mode,
                              size_t queue, bool no_bounds, bool flat)
{
    struct trace_options options = ON_PRIOR(.mode = mode, .width = WIDTH,
                                            .height = HEIGHT, .queue = queue,
                                            .no_bounds = no_bounds, .flat = flat);
    struct words *words = calloc(1, sizeof *words);
    c205_error error = { "" };
    SCOPED(trace) *trace = trace_new(scene, &options, &error);
    if (!trace || !trace_run(trace, &error)) {
        FAIL_IF(!strstr(error.message, "too large or too small"), "%s in\n%s",
                error.message, text);
        free(words);
        words = NULL;
    }
    for (int i = 0; words && i < FRAME_CHANNELS; i++)
        memcpy(words->channel[i], trace_channel(trace, (enum frame_channel)i),
               PIXELS * sizeof(c205_word));
    return words;
}

static void check_scene(const struct scene *scene)
{
    static const struct {
        enum trace_mode mode;
        size_t queue;
        bool no_bounds, flat;
    } forms[] = {
        { TRACE_SCALAR, 1, true, false },
        { TRACE_VECTOR, 37, false, false },
        { TRACE_VECTOR, 2000, true, false },
        { TRACE_VECTOR, 2000, false, true },
    };
    FREED struct words *same = frame_in(scene, TRACE_SCALAR, 1, false, false);
    for (size_t i = 0; i < COUNT(forms); i++) {
        FREED struct words *words = frame_in(scene, forms[i].mode, forms[i].queue,
                                             forms[i].no_bounds, forms[i].flat);
        FAIL_IF(!same != !words || (same && memcmp(same, words, sizeof *same) != 0),
                "form %zu gives another frame of\n%s", i, text);
    }
}

TEST(random_scenes)
{
    const struct scene_options how = { .strict = false };
    size_t scenes = 0;
    for (size_t i = 0; i < share_of(SCENES); i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        text[0] = '\0';
        add("#version 3.7; global_settings { assumed_gamma 1 }\ncamera { %s location ",
            among(0, 3) ? "" : "orthographic");
        add_place(6 * any_size());
        add(" look_at ");
        add_place(.1 * any_size());
        add(" angle %.1f }\nplane { y, -1 ", between(20, 60));
        add_texture();
        add("}\n");
        for (size_t k = among(1, 2); k > 0; k--)
            add_light();
        for (size_t k = among(1, 4); k > 0; k--)
            add_object();
        SCOPED(scene) *scene = scene_read_text("test", text, &how, &reports);
        if (scene)
            check_scene(scene);
        scenes += scene != NULL;
    }
    assert_true(scenes > share_of(SCENES) / 2);
}
