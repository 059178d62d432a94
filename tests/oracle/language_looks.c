/* language_looks.c - random pigments, finishes, normals, textures and transforms. */
#include "tests/oracle/language_parts.h"

/* Rotations and scales; an object at the origin stays there. */
void say_turns(struct language *draw)
{
    for (size_t i = below(&draw->state, 3); i > 0; i--)
        if (draw->names[NAME_MOTION] && one_in(&draw->state, 5))
            say(draw, "transform { $=Motion;$[| inverse$] }\n");
        else
            say(draw, "$turn;");
}

/* --- pigments ------------------------------------------------------------- */

/* Entries may have equal positions, and need not cover 0 to 1. */
void say_map(struct language *draw)
{
    double at = between(&draw->state, -.1, .3);
    say(draw, " color_map {\n");
    for (size_t left = 1 + below(&draw->state, 5); left > 0; left--) {
        say(draw, "[%.3f $color;]\n", at);
        at += one_in(&draw->state, 4) ? 0 : between(&draw->state, .05, .4);
    }
    say(draw, "}\n");
}

void say_plain_color(struct language *draw)
{
    begin_image(draw, 4, false);
    say(draw, "$color;\n");
    end_image(draw);
}

void say_pigment(struct language *draw)
{
    say(draw, "pigment {\n");
    size_t kind = below(&draw->state, 8);
    if (kind == 0 && draw->names[NAME_PIGMENT])
        say(draw, "$=Paint;\n$turns;");
    else
        say(draw, kind < 3 ? "$checker;" : kind < 5 ? "$mapped;" : "$plain_color;");
    say(draw, "}\n");
}

/* A closed solid that transmits light, and its texture. */
void say_clear_look(struct language *draw)
{
    open_solid_shape(draw, true);
    say(draw, "$turns;pigment {\n");
    below(&draw->state, 8);
    begin_image(draw, 4, true);
    say(draw, "$clear_color;");
    end_image(draw);
    say(draw, "}\n$2[$finish;|$]$normal;");
}

/* --- finishes ------------------------------------------------------------- */

/* Metals are not used where light is transmitted: for a checker whose colours transmit
 * different shares, POV-Ray computes a metal differently. */
void say_metallic(struct language *draw)
{
    if (draw->metals && one_in(&draw->state, 3))
        say(draw, "$3[metallic\n|metallic ~.2:1~\n$]");
}

static void say_finish_words(struct language *draw, bool mirror)
{
    if (draw->names[NAME_FINISH] && one_in(&draw->state, 4))
        say(draw, "$=Shine;\n");
    say(draw,
        mirror ? "$finish_words;$2[$turned_mirror;|$reflection;$]" : "$finish_words;");
}

static void say_finish_of(struct language *draw, bool mirror)
{
    say(draw, "finish {\n");
    say_finish_words(draw, mirror);
    say(draw, "}\n");
}

void say_finish(struct language *draw)
{
    say_finish_of(draw, one_in(&draw->state, 5));
}

void say_ground_finish(struct language *draw)
{
    say_finish_of(draw, one_in(&draw->state, 3));
}

/* --- normals -------------------------------------------------------------- */

void say_steepness(struct language *draw)
{
    say(draw, "%.3f", between(&draw->state, -draw->steep, draw->steep));
}

void say_bump_map(struct language *draw)
{
    bool average = one_in(&draw->state, 3);
    double at = between(&draw->state, 0, .3);
    say(draw, average ? "average\n" : "$2[gradient y sine_wave|onion$]\n");
    say(draw, "normal_map {\n");
    for (size_t left = 1 + below(&draw->state, 3); left > 0; left--) {
        say(draw, "[%.3f $bump;]\n", at);
        at += between(&draw->state, .1, .5);
    }
    say(draw, "}\n");
}

void say_slopes(struct language *draw)
{
    double at = between(&draw->state, 0, .3);
    say(draw, "$2[gradient y|onion$]\nbump_size $steepness;\nslope_map {\n");
    for (size_t left = 1 + below(&draw->state, 4); left > 0; left--) {
        say(draw, "[%.3f <^30:1^, ^3-1:1^>]\n", at);
        at += one_in(&draw->state, 4) ? 0 : between(&draw->state, .1, .4);
    }
    say(draw, "}\n");
}

/* Adds a normal to some textures; on mirrors it is less steep.  A reflected ray along
 * the surface hits it again or not, depending on POV-Ray's tolerance. */
static void say_normal_of(struct language *draw, double steep)
{
    uint64_t before = draw->state;
    draw->state = stream_beside(before, 5, 3);
    draw->steep = steep;
    say(draw, "$4[$own_normal;|$]");
    draw->state = before;
}

void say_normal(struct language *draw)
{
    say_normal_of(draw, .2);
}

void say_steep_normal(struct language *draw)
{
    say_normal_of(draw, 1);
}

/* --- textures ------------------------------------------------------------- */

void say_texture_words(struct language *draw)
{
    bool named = draw->names[NAME_TEXTURE] && one_in(&draw->state, 3);
    say(draw, named ? "$=Look;\n$3[$pigment;|$]$3[$finish;|$]" : "$pigment;$finish;");
    say(draw, "$normal;$turns;");
}

void declare_look(struct language *draw)
{
    size_t which = below(&draw->state, 3);
    say(draw, "$[#declare |#local $]");
    if (which == 0) {
        say(draw, "$+Paint; = pigment {\n$2[$mapped;|$checker;$]}\n$!Paint;");
    } else if (which == 1) {
        say(draw, "$+Shine; = finish {\n");
        say_finish_words(draw, one_in(&draw->state, 5));
        say(draw, "}\n$!Shine;");
    } else
        say(draw, "$+Look; = texture {\n$texture_words;}\n$!Look;");
}
