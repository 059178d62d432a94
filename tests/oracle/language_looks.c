/* language_looks.c - pigments, finishes, normals, textures and motions by chance. */
#include "tests/oracle/language_parts.h"

/* --- motions -------------------------------------------------------------- */

static void say_turn(struct language *draw)
{
    begin_line(draw);
    switch (below(&draw->state, 5)) {
    case 0:
        say(draw, "rotate ");
        say_point(draw, -90, 90);
        break;
    case 1:
        say(draw, "rotate ");
        say_number(draw, -90, 90);
        SAY_ONE_OF(draw, "*x", "*y", "*z");
        break;
    case 2:
        say(draw, "scale ");
        say_point(draw, .6, 1.2);
        break;
    case 3:
        say(draw, "scale ");
        say_number(draw, .7, 1.1);
        break;
    default:
        say(draw, "matrix <1, %.3f, 0, %.3f, .9, 0, 0, %.3f, 1, 0, %.3f, 0>",
            between(&draw->state, -.3, .3), between(&draw->state, -.3, .3),
            between(&draw->state, -.3, .3), between(&draw->state, -.2, .2));
        break;
    }
    end_line(draw);
}

static void say_named_motion(struct language *draw)
{
    begin_line(draw);
    say(draw, "transform { ");
    say_name(draw, NAME_MOTION);
    SAY_ONE_OF(draw, "", " inverse");
    say(draw, " }\n");
}

void say_turns(struct language *draw)
{
    for (size_t i = below(&draw->state, 3); i > 0; i--)
        if (draw->names[NAME_MOTION] && one_in(&draw->state, 5))
            say_named_motion(draw);
        else
            say_turn(draw);
}

void declare_motion(struct language *draw)
{
    begin_line(draw);
    say(draw, "#declare ");
    say_new_name(draw, NAME_MOTION);
    say(draw, " = transform {\n");
    draw->depth++;
    say_turn(draw);
    say_turn(draw);
    close_block(draw, "}");
    draw->names[NAME_MOTION]++;
}

/* --- pigments ------------------------------------------------------------- */

/* Steps of a pattern lie off the planes in which things are drawn, where a
 * rounding would decide between two of its colours. */
static void say_pattern_place(struct language *draw)
{
    say_line(draw, "scale %.4f", between(&draw->state, .3, .9));
    if (one_in(&draw->state, 2))
        say_turn(draw);
    say_line(draw, "translate <%.4f, %.4f, %.4f>", between(&draw->state, .1, .2),
             between(&draw->state, .1, .2), between(&draw->state, .1, .2));
}

static void say_checker(struct language *draw)
{
    begin_line(draw);
    say(draw, "checker");
    if (!one_in(&draw->state, 8)) {
        say(draw, " ");
        say_color(draw);
        SAY_ONE_OF(draw, ", ", " ");
        say_color(draw);
    }
    end_line(draw);
    say_pattern_place(draw);
}

/* Entries may stand at one place, and not all of 0 to 1 need have one. */
static void say_map(struct language *draw)
{
    double at = between(&draw->state, -.1, .3);
    say(draw, " color_map {\n");
    draw->depth++;
    for (size_t left = 1 + below(&draw->state, 5); left > 0; left--) {
        begin_line(draw);
        say(draw, "[%.3f ", at);
        say_color(draw);
        say(draw, "]\n");
        at += one_in(&draw->state, 4) ? 0 : between(&draw->state, .05, .4);
    }
    close_block(draw, "}");
}

static void say_gradient(struct language *draw)
{
    begin_line(draw);
    say(draw, "gradient ");
    say_arrow(draw, .5, 2);
    if (one_in(&draw->state, 6))
        end_line(draw);
    else
        say_map(draw);
    say_pattern_place(draw);
}

/* What goes round more than once or twice has edges that are as narrow as pixels. */
static void say_waves(struct language *draw)
{
    if (one_in(&draw->state, 2)) {
        begin_line(draw);
        SAY_ONE_OF(draw, "ramp_wave", "triangle_wave", "sine_wave", "scallop_wave",
                   "cubic_wave", "poly_wave");
        end_line(draw);
    }
    if (one_in(&draw->state, 6))
        say_line(draw, "poly_wave %.3f", between(&draw->state, .3, 4));
    if (one_in(&draw->state, 3)) {
        begin_line(draw);
        say(draw, "frequency ");
        say_number(draw, -2, 2);
        end_line(draw);
    }
    if (one_in(&draw->state, 3)) {
        begin_line(draw);
        say(draw, "phase ");
        say_number(draw, -1, 2);
        end_line(draw);
    }
}

static void say_list(struct language *draw, const char *pattern, size_t count)
{
    begin_line(draw);
    say(draw, "%s ", pattern);
    if (!one_in(&draw->state, 4))
        for (size_t i = 0; i < count; i++) {
            say_color(draw);
            if (i + 1 < count)
                SAY_ONE_OF(draw, ", ", " ");
        }
    end_line(draw);
}

static void say_pattern(struct language *draw)
{
    switch (below(&draw->state, 5)) {
    case 0: say_list(draw, "hexagon", 3); break;
    case 1:
        say_list(draw, "brick", 2);
        say_line(draw, "brick_size <%.3f, %.3f, %.3f>", between(&draw->state, .5, 1.5),
                 between(&draw->state, .3, 1), between(&draw->state, .4, 1.2));
        say_line(draw, "mortar %.3f", between(&draw->state, .05, .2));
        break;
    default:
        begin_line(draw);
        SAY_ONE_OF(draw, "planar", "spherical", "cylindrical", "boxed", "onion",
                   "leopard", "radial", "gradient x", "gradient <1, 1, .5>");
        if (one_in(&draw->state, 6))
            end_line(draw);
        else
            say_map(draw);
        say_waves(draw);
        break;
    }
    say_pattern_place(draw);
}

static void say_mapped(struct language *draw)
{
    if (one_in(&draw->state, 2))
        say_gradient(draw);
    else
        say_pattern(draw);
}

static void say_plain_color(struct language *draw)
{
    begin_image(draw, 4, false);
    begin_line(draw);
    say_color(draw);
    end_line(draw);
    end_image(draw);
}

static void say_clear_color(struct language *draw)
{
    begin_image(draw, 4, true);
    begin_line(draw);
    switch (below(&draw->state, 4)) {
    case 0:
        say(draw, "rgbf <%.2f, %.2f, %.2f, ", between(&draw->state, .4, 1),
            between(&draw->state, .4, 1), between(&draw->state, .4, 1));
        say_number(draw, .5, .9);
        say(draw, ">");
        break;
    case 1:
        say(draw, "color rgbt ");
        say_number(draw, .3, .9);
        break;
    case 2:
        say(draw, "rgbft <%.2f, %.2f, %.2f, .5, ", between(&draw->state, .4, 1),
            between(&draw->state, .4, 1), between(&draw->state, .4, 1));
        say_number(draw, .1, .4);
        say(draw, ">");
        break;
    default:
        say_color(draw);
        SAY_ONE_OF(draw, " transmit .6", " filter .7", " filter .4 transmit .3");
        break;
    }
    end_line(draw);
    end_image(draw);
}

void say_pigment(struct language *draw, bool clear)
{
    open_block(draw, "pigment {");
    size_t kind = below(&draw->state, 8);
    if (clear)
        say_clear_color(draw);
    else if (kind == 0 && draw->names[NAME_PIGMENT]) {
        begin_line(draw);
        say_name(draw, NAME_PIGMENT);
        end_line(draw);
        say_turns(draw);
    } else if (kind < 3)
        say_checker(draw);
    else if (kind < 5)
        say_mapped(draw);
    else
        say_plain_color(draw);
    close_block(draw, "}");
}

void say_far_pigment(struct language *draw)
{
    open_block(draw, "pigment {");
    if (one_in(&draw->state, 2))
        say_checker(draw);
    else
        say_plain_color(draw);
    close_block(draw, "}");
}

/* --- finishes ------------------------------------------------------------- */

static void say_share(struct language *draw, const char *word, double most)
{
    begin_line(draw);
    say(draw, "%s ", word);
    if (one_in(&draw->state, 3)) {
        say(draw, "rgb ");
        say_point(draw, .02, most);
    } else
        say_number(draw, .02, most);
    end_line(draw);
}

static void say_reflection(struct language *draw)
{
    if (one_in(&draw->state, 3))
        say_line(draw, "reflection { %.3f }", between(&draw->state, .1, .5));
    else
        say_share(draw, "reflection", .5);
}

/* Not where light may pass: of a checker whose colours let different shares pass a
 * metal is another one in POV-Ray. */
static void say_metallic(struct language *draw)
{
    if (!draw->metals || !one_in(&draw->state, 3))
        return;
    if (one_in(&draw->state, 3))
        say_line(draw, "metallic");
    else
        say_amount(draw, "metallic", .2, 1);
}

/* A mirror that depends on the angle. */
static void say_turned_mirror(struct language *draw)
{
    uint64_t *state = &draw->state;
    open_block(draw, "reflection {");
    begin_line(draw);
    say(draw, "rgb <%.3f, %.3f, %.3f>, %.3f\n", between(state, 0, .4),
        between(state, 0, .4), between(state, 0, .4), between(state, .2, .9));
    if (one_in(state, 2))
        say_line(draw, "fresnel");
    else if (one_in(state, 2))
        say_amount(draw, "falloff", .5, 4);
    say_metallic(draw);
    close_block(draw, "}");
}

static void say_highlights(struct language *draw)
{
    uint64_t *state = &draw->state;
    if (one_in(state, 3)) {
        say_amount(draw, "phong", .2, .9);
        if (one_in(state, 2))
            say_amount(draw, "phong_size", 8, 60);
    }
    if (one_in(state, 3)) {
        say_amount(draw, "specular", .2, .9);
        if (one_in(state, 2))
            say_amount(draw, "roughness", .02, .2);
    }
}

static void say_finish_words(struct language *draw, bool mirror)
{
    uint64_t *state = &draw->state;
    if (draw->names[NAME_FINISH] && one_in(state, 4)) {
        begin_line(draw);
        say_name(draw, NAME_FINISH);
        end_line(draw);
    }
    if (one_in(state, 2))
        say_share(draw, "ambient", .4);
    if (one_in(state, 2))
        say_amount(draw, "diffuse", .4, .9);
    if (one_in(state, 4))
        say_amount(draw, "brilliance", .4, 4);
    if (one_in(state, 5))
        say_share(draw, "emission", .3);
    say_highlights(draw);
    say_metallic(draw);
    if (mirror && one_in(state, 2))
        say_turned_mirror(draw);
    else if (mirror)
        say_reflection(draw);
}

void say_finish(struct language *draw, bool mirror)
{
    open_block(draw, "finish {");
    say_finish_words(draw, mirror);
    close_block(draw, "}");
}

static bool is_mirror(struct language *draw)
{
    return one_in(&draw->state, 5);
}

/* --- normals -------------------------------------------------------------- */

/* Without the functions and streams that numbers may have: what else is drawn does
 * not depend on normals. */
static void say_bump(struct language *draw, double most)
{
    uint64_t *state = &draw->state;
    say(draw, "%s",
        (const char *const[]){ "gradient x", "gradient <1, -1, .5>", "onion", "leopard",
                               "radial frequency 3", "boxed", "spherical",
                               "cylindrical", "planar", "quilted" }[below(state, 10)]);
    say(draw, "%s",
        (const char *const[]){ "", " sine_wave", " triangle_wave", " scallop_wave",
                               " cubic_wave" }[below(state, 5)]);
    say(draw, " bump_size %.3f", between(state, -most, most));
    if (one_in(state, 4))
        say(draw, " phase %.3f", between(state, 0, 1));
    say(draw, " scale %.4f", between(state, .2, .6));
}

static void say_bump_list(struct language *draw, double most)
{
    static const struct {
        const char *word;
        int count;
    } lists[] = { { "checker", 2 }, { "hexagon", 3 }, { "brick", 2 } };
    size_t which = below(&draw->state, 3);
    begin_line(draw);
    say(draw, "%s", lists[which].word);
    if (one_in(&draw->state, 2))
        say(draw, ", %.3f", between(&draw->state, -most, most));
    else
        for (int i = 0; i < lists[which].count; i++) {
            say(draw, " normal { ");
            say_bump(draw, most);
            say(draw, " }");
        }
    if (which == 2)
        say(draw, " brick_size <.713, .427, .531> mortar .061");
    end_line(draw);
}

static void say_bump_map(struct language *draw, double most)
{
    bool average = one_in(&draw->state, 3);
    double at = between(&draw->state, 0, .3);
    say_line(draw, average                   ? "average"
                   : one_in(&draw->state, 2) ? "gradient y sine_wave"
                                             : "onion");
    open_block(draw, "normal_map {");
    for (size_t left = 1 + below(&draw->state, 3); left > 0; left--) {
        begin_line(draw);
        say(draw, "[%.3f ", at);
        say_bump(draw, most);
        say(draw, "]\n");
        at += between(&draw->state, .1, .5);
    }
    close_block(draw, "}");
}

static void say_slopes(struct language *draw, double most)
{
    uint64_t *state = &draw->state;
    double at = between(state, 0, .3);
    say_line(draw, one_in(state, 2) ? "gradient y" : "onion");
    say_line(draw, "bump_size %.3f", between(state, -most, most));
    open_block(draw, "slope_map {");
    for (size_t left = 1 + below(state, 4); left > 0; left--) {
        say_line(draw, "[%.3f <%.3f, %.3f>]", at, between(state, 0, 1),
                 between(state, -1, 1));
        at += one_in(state, 4) ? 0 : between(state, .1, .4);
    }
    close_block(draw, "}");
}

static void say_own_normal(struct language *draw, double most)
{
    uint64_t *state = &draw->state;
    open_block(draw, "normal {");
    switch (below(state, 6)) {
    case 0: say_bump_list(draw, most); break;
    case 1: say_bump_map(draw, most); break;
    case 2: say_slopes(draw, most); break;
    default:
        begin_line(draw);
        say_bump(draw, most);
        end_line(draw);
        break;
    }
    say_line(draw, "scale <1, %.4f, 1>", between(state, .6, 1.2));
    say_line(draw, "rotate <%.2f, %.2f, 0>", between(state, -60, 60),
             between(state, -60, 60));
    say_line(draw, "translate <%.4f, %.4f, %.4f>", between(state, .1, .2),
             between(state, .1, .2), between(state, .1, .2));
    if (one_in(state, 6))
        say_line(draw, "no_bump_scale");
    close_block(draw, "}");
}

/* Now and then; of mirrors not so steep: what then goes along the surface meets it again
 * or not, by how near POV-Ray looks. */
static void say_normal(struct language *draw, double most)
{
    uint64_t before = draw->state;
    draw->state = stream_beside(before, 5, 3);
    if (one_in(&draw->state, 4))
        say_own_normal(draw, most);
    draw->state = before;
}

/* --- textures ------------------------------------------------------------- */

static void say_texture_words(struct language *draw)
{
    bool named = draw->names[NAME_TEXTURE] && one_in(&draw->state, 3);
    if (named) {
        begin_line(draw);
        say_name(draw, NAME_TEXTURE);
        end_line(draw);
    }
    if (!named || one_in(&draw->state, 3))
        say_pigment(draw, false);
    if (!named || one_in(&draw->state, 3))
        say_finish(draw, is_mirror(draw));
    say_normal(draw, .2);
    say_turns(draw);
}

void say_look(struct language *draw)
{
    switch (below(&draw->state, 4)) {
    case 0:
        say_pigment(draw, false);
        say_normal(draw, 1);
        break;
    case 1:
        say_pigment(draw, false);
        say_finish(draw, is_mirror(draw));
        say_normal(draw, .2);
        break;
    default:
        open_block(draw, "texture {");
        say_texture_words(draw);
        close_block(draw, "}");
        break;
    }
}

void say_clear_look(struct language *draw, bool bent)
{
    say_pigment(draw, true);
    if (one_in(&draw->state, 2))
        say_finish(draw, is_mirror(draw));
    say_normal(draw, .2);
    if (bent) {
        begin_line(draw);
        say(draw, "interior { ior ");
        say_number(draw, 1.1, 1.7);
        say(draw, " }\n");
    }
}

void declare_look(struct language *draw)
{
    static const struct {
        enum language_name kind;
        const char *word;
    } kinds[] = {
        { NAME_PIGMENT, "pigment" },
        { NAME_FINISH, "finish" },
        { NAME_TEXTURE, "texture" },
    };
    size_t which = below(&draw->state, 3);
    begin_line(draw);
    SAY_ONE_OF(draw, "#declare ", "#local ");
    say_new_name(draw, kinds[which].kind);
    say(draw, " = %s {\n", kinds[which].word);
    draw->depth++;
    switch (which) {
    case 0:
        if (one_in(&draw->state, 2))
            say_mapped(draw);
        else
            say_checker(draw);
        break;
    case 1: say_finish_words(draw, is_mirror(draw)); break;
    default: say_texture_words(draw); break;
    }
    close_block(draw, "}");
    draw->names[kinds[which].kind]++;
}
