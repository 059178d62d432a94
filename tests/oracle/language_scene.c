/* language_scene.c - see language_scene.h. */
#include "tests/oracle/language_scene.h"

#include "tests/oracle/language_parts.h"
#include "tests/oracle/solid_text.h"

/* --- declarations --------------------------------------------------------- */

static void declare_float(struct language *draw)
{
    begin_line(draw);
    SAY_ONE_OF(draw, "#declare ", "#local ");
    say_new_name(draw, NAME_FLOAT);
    say(draw, " = ");
    say_float(draw, 3);
    say(draw, ";\n");
    draw->names[NAME_FLOAT]++;
}

static void declare_vector(struct language *draw)
{
    begin_line(draw);
    say(draw, "#declare ");
    say_new_name(draw, NAME_VECTOR);
    say(draw, " = <.1, .2, .3> + ");
    say_vector(draw, 2);
    say(draw, ";\n");
    draw->names[NAME_VECTOR]++;
}

static void declare_color(struct language *draw)
{
    begin_line(draw);
    say(draw, "#declare ");
    say_new_name(draw, NAME_COLOR);
    say(draw, " = ");
    say_color(draw);
    say(draw, ";\n");
    draw->names[NAME_COLOR]++;
}

/* Without macros, which POV-Ray does not call there. */
static void declare_array(struct language *draw, enum language_name kind)
{
    begin_line(draw);
    say(draw, "#declare ");
    say_new_name(draw, kind);
    say(draw, " = array[%d] { ", LANGUAGE_ELEMENTS);
    draw->calling = false;
    for (int i = 0; i < LANGUAGE_ELEMENTS; i++) {
        if (kind == NAME_ARRAY)
            say_float(draw, 1);
        else
            say_color(draw);
        say(draw, i + 1 < LANGUAGE_ELEMENTS ? ", " : " }\n");
    }
    draw->calling = true;
    draw->names[kind]++;
}

static void declare_function(struct language *draw)
{
    static const char *const bodies[] = {
        "(a, b) { sin(a)*b + a/(2 + b*b) }",
        "(a, b) { a - b - 1 + (a > b & a != 0) }",
        "(a, b) { select(a - b, 1, 2, pow(abs(a), 1.5)) }",
        "(a, b) { min(a, b, 2)*max(a, .3) - -b }",
        "(a, b) { mod(abs(a) + 3, 1.7) + sqrt(abs(b)) }",
        "(x, y) { x*x*x - y*y/3 + atan2(y, 1 + x*x) }",
    };
    begin_line(draw);
    say(draw, "#declare ");
    say_new_name(draw, NAME_FUNCTION);
    say(draw, " = function");
    say(draw, "%s\n", bodies[below(&draw->state, 6)]);
    draw->names[NAME_FUNCTION]++;
}

static void declare_value(struct language *draw)
{
    begin_line(draw);
    say(draw, "#macro ");
    say_new_name(draw, NAME_VALUE);
    SAY_ONE_OF(draw, "(A, B) (A*.3 + sin(B)) #end\n", "(A, B) max(A, 2*B, .5) #end\n",
               "(A, B) #local C = A - B; (C*C > 1 ? C : B) #end\n");
    draw->names[NAME_VALUE]++;
}

static void say_declarations(struct language *draw)
{
    uint64_t *state = &draw->state;
    if (one_in(state, 3)) {
        say_line(draw, "#declare Stream = seed(%zu);", below(state, 1000));
        draw->streams = true;
    }
    declare_float(draw);
    for (size_t left = 2 + below(state, 8); left > 0; left--)
        switch (below(state, 8)) {
        case 0: declare_vector(draw); break;
        case 1: declare_color(draw); break;
        case 2: declare_array(draw, NAME_ARRAY); break;
        case 3: declare_array(draw, NAME_PALETTE); break;
        case 4: declare_function(draw); break;
        case 5: declare_value(draw); break;
        default: declare_float(draw); break;
        }
}

static void say_looks(struct language *draw)
{
    for (size_t left = below(&draw->state, 4); left > 0; left--)
        switch (below(&draw->state, 4)) {
        case 0: declare_motion(draw); break;
        case 1: declare_solid(draw); break;
        default: declare_look(draw); break;
        }
}

/* --- settings ------------------------------------------------------------- */

static void say_settings(struct language *draw)
{
    say(draw,
        "#version 3.7; global_settings { assumed_gamma %s max_trace_level %zu }\n",
        one_in(&draw->state, 4) ? "2.2" : "1.0", 3 + below(&draw->state, 10));
    if (one_in(&draw->state, 4)) {
        begin_line(draw);
        say(draw, "global_settings { ambient_light ");
        say_color(draw);
        say(draw, " }\n");
    }
    if (one_in(&draw->state, 6)) {
        say_line(draw, "#include \"colors.inc\"");
        draw->library = true;
    }
}

static void say_sky(struct language *draw)
{
    begin_line(draw);
    say(draw, "background { ");
    say_color(draw);
    say(draw, " }\n");
    if (!one_in(&draw->state, 4))
        return;
    bool named = one_in(&draw->state, 3);
    open_block(draw, named ? "#declare Heaven = sky_sphere {" : "sky_sphere {");
    open_block(draw, "pigment {");
    begin_image(draw, 3, false);
    begin_line(draw);
    SAY_ONE_OF(draw, "gradient y", "gradient y triangle_wave", "planar",
               "radial frequency 3", "boxed", "leopard frequency 2");
    end_line(draw);
    say_line(draw,
             "color_map { [0 rgb <.8, .7, %.2f>] [%.2f rgb .4] "
             "[1 rgb <.1, .3, .6>] }",
             between(&draw->state, 0, 1), between(&draw->state, .1, .9));
    if (one_in(&draw->state, 2))
        say_line(draw, "scale 2");
    say_line(draw, "translate -.37");
    end_image(draw);
    close_block(draw, "}");
    close_block(draw, "}");
    if (named)
        say_line(draw, "sky_sphere { Heaven rotate <0, %.2f, 20> }",
                 between(&draw->state, -90, 90));
}

/* In a fog nothing is clear: here it fills such a thing, in POV-Ray only if that
 * is hollow. */
static void say_fog(struct language *draw)
{
    size_t which = below(&draw->state, 5);
    draw->clear = which > 1;
    draw->metals = !draw->clear;
    if (which > 0)
        return;
    begin_line(draw);
    say(draw, "fog { distance %.2f color ", between(&draw->state, 8, 40));
    switch (below(&draw->state, 3)) {
    case 0: say(draw, "rgbt <.6, .7, .8, .2>"); break;
    case 1: say(draw, "rgbft <.6, .5, .8, .4, .1>"); break;
    default: say_point(draw, .2, 1); break;
    }
    say(draw, " }\n");
}

/* --- cameras and lights --------------------------------------------------- */

/* Aslant, so that no ray runs in a face. */
static void say_eye(struct language *draw)
{
    double turn = between(&draw->state, -3.1, 3.1);
    double far = between(&draw->state, 7, 9);
    say_line(draw, "location <%.4f, %.4f, %.4f>", far * sin(turn),
             between(&draw->state, -1, 4), -far * cos(turn));
}

static void say_width(struct language *draw)
{
    begin_line(draw);
    SAY_ONE_OF(draw, "right x*image_width/image_height", "right 4/3*x", "right -x*4/3",
               "right x*4/3 up y", "up 1.2*y right 1.6*x");
    end_line(draw);
}

static void say_aim(struct language *draw)
{
    begin_line(draw);
    say(draw, "look_at ");
    say_point(draw, -.4, .4);
    end_line(draw);
    if (one_in(&draw->state, 4)) {
        begin_line(draw);
        say(draw, "sky <");
        say_number(draw, -.6, .6);
        say(draw, ", 1, .2>\n");
    }
}

static void say_looking_camera(struct language *draw)
{
    bool parallel = one_in(&draw->state, 5);
    if (parallel)
        say_line(draw, "orthographic");
    say_eye(draw);
    if (one_in(&draw->state, 2))
        say_width(draw);
    if (!one_in(&draw->state, 5)) {
        begin_line(draw);
        say(draw, "angle ");
        say_number(draw, 30, 48);
        end_line(draw);
    }
    say_aim(draw);
}

/* By its vectors, and turned as a whole. */
static void say_turned_camera(struct language *draw)
{
    bool parallel = one_in(&draw->state, 3);
    if (parallel)
        say_line(draw, "orthographic");
    say_line(draw, "location <.021, .033, -8>");
    say_line(draw, "direction <.02, .01, %.3f>", between(&draw->state, 1.2, 2));
    if (parallel)
        say_line(draw, "right %.3f*x up %.3f*y", between(&draw->state, 5, 8),
                 between(&draw->state, 4, 6));
    else if (one_in(&draw->state, 2))
        say_width(draw);
    begin_line(draw);
    say(draw, "rotate <");
    say_number(draw, -5, 35);
    say(draw, ", ");
    say_number(draw, -180, 180);
    say(draw, ", ");
    say_number(draw, -20, 20);
    say(draw, ">\n");
}

static void say_camera(struct language *draw)
{
    open_block(draw, "camera {");
    if (one_in(&draw->state, 4))
        say_turned_camera(draw);
    else
        say_looking_camera(draw);
    close_block(draw, "}");
}

/* Below all lamps. */
static void say_point_at(struct language *draw)
{
    begin_line(draw);
    say(draw, "point_at ");
    say_point(draw, -3, 3);
    end_line(draw);
}

/* False: its rays are parallel.  What lies behind such a light is faded in another
 * way in POV-Ray (docs/povray.md). */
static bool say_beam(struct language *draw)
{
    bool cone = one_in(&draw->state, 2);
    if (one_in(&draw->state, 4)) {
        say_line(draw, "parallel");
        say_point_at(draw);
        return false;
    }
    say_line(draw, cone ? "spotlight" : "cylinder");
    say_point_at(draw);
    if (one_in(&draw->state, 2))
        say_amount(draw, "radius", cone ? 5 : .5, cone ? 60 : 3);
    if (one_in(&draw->state, 2))
        say_amount(draw, "falloff", cone ? 10 : 1, cone ? 100 : 6);
    if (one_in(&draw->state, 2))
        say_amount(draw, "tightness", 0, 8);
    return cone;
}

static void say_fading(struct language *draw)
{
    say_amount(draw, "fade_distance", 1, 12);
    say_amount(draw, "fade_power", .5, 4);
}

/* What else is drawn does not depend on it. */
static void say_area(struct language *draw)
{
    uint64_t state = stream_beside(draw->state, 5, 1);
    if (!one_in(&state, 5))
        return;
    size_t across = 1 + below(&state, 6), down = 1 + below(&state, 4);
    say_line(draw, "area_light <%.3f, 0, %.3f>, <0, %.3f, 1>, %zu, %zu",
             between(&state, .3, 2), between(&state, -1, 1), between(&state, -1, 1),
             across, down);
    if (across > 1 && down > 1 && one_in(&state, 2))
        say_line(draw, "circular");
}

static void say_lamp(struct language *draw)
{
    open_block(draw, "light_source {");
    begin_line(draw);
    say(draw, "<");
    say_number(draw, -9, 9);
    say(draw, ", ");
    say_number(draw, 4, 12);
    say(draw, ", ");
    say_number(draw, -9, 9);
    say(draw, ">, ");
    say_color(draw);
    end_line(draw);
    bool fades = true;
    if (one_in(&draw->state, 5))
        say_line(draw, "shadowless");
    else if (one_in(&draw->state, 3))
        fades = say_beam(draw);
    if (fades)
        say_area(draw);
    if (fades && one_in(&draw->state, 5))
        say_fading(draw);
    if (one_in(&draw->state, 5))
        say_line(draw, "translate <%.3f, 1, .5>", between(&draw->state, -2, 2));
    close_block(draw, "}");
}

/* --- scenes --------------------------------------------------------------- */

/* Below all else.  It is hollow, as an orthographic picture may begin below it: in
 * a body that is not POV-Ray sees no fog. */
static void say_ground(struct language *draw)
{
    if (one_in(&draw->state, 2)) {
        open_block(draw, "plane {");
        say_line(draw, "y, -2.6137 hollow");
        say_far_pigment(draw);
    } else {
        open_block(draw, "disc {");
        say_line(draw, "-2.6137*y, y, 6");
        say_pigment(draw, false);
    }
    if (one_in(&draw->state, 3))
        say_finish(draw, one_in(&draw->state, 3));
    close_block(draw, "}");
}

static void say_default(struct language *draw)
{
    open_block(draw, "#default {");
    say_finish(draw, false);
    close_block(draw, "}");
}

static void say_scene(struct language *draw)
{
    uint64_t *state = &draw->state;
    say_settings(draw);
    say_declarations(draw);
    say_sky(draw);
    say_fog(draw);
    say_camera(draw);
    for (size_t left = 1 + below(state, 3); left > 0; left--)
        say_lamp(draw);
    if (one_in(state, 4))
        say_default(draw);
    say_looks(draw);
    if (one_in(state, 2))
        say_ground(draw);
    if (one_in(state, 6))
        say_macro(draw);
    for (size_t left = 2 + below(state, 5); left > 0; left--)
        say_thing(draw);
}

char *language_scene_text(uint64_t seed)
{
    char *words;
    struct language draw = { .state = seed,
                             .text = test_text(&words),
                             .calling = true };
    for (int i = 0; i < 8; i++)
        xorshift(&draw.state);
    say_scene(&draw);
    fclose(draw.text);
    return words;
}
