/* language_looks.c - random pigments, finishes, normals, textures and transforms. */
#include "tests/oracle/language_parts.h"

/* Rotations and scales; an object at the origin stays there. */
void write_turns(struct language *draw)
{
    for (size_t i = below(&draw->state, 3); i > 0; i--)
        if (draw->names[NAME_MOTION] && one_in(&draw->state, 5))
            write_text(draw, "transform { $=Motion;$[| inverse$] }\n");
        else
            write_text(draw, "$turn;");
}

/* ---- Pigments ------------------------------------------------------------ */

/* Entries may have equal positions, and need not cover 0 to 1. */
void write_map(struct language *draw)
{
    double at = between(&draw->state, -.1, .3);
    write_text(draw, " color_map {\n");
    for (size_t left = 1 + below(&draw->state, 5); left > 0; left--) {
        write_text(draw, "[%.3f $color;]\n", at);
        at += one_in(&draw->state, 4) ? 0 : between(&draw->state, .05, .4);
    }
    write_text(draw, "}\n");
}

void write_plain_color(struct language *draw)
{
    begin_image(draw, 4, false);
    write_text(draw, "$color;\n");
    end_image(draw);
}

void write_pigment(struct language *draw)
{
    write_text(draw, "pigment {\n");
    size_t kind = below(&draw->state, 8);
    if (kind == 0 && draw->names[NAME_PIGMENT])
        write_text(draw, "$=Paint;\n$turns;");
    else
        write_text(draw, kind < 3   ? "$checker;"
                         : kind < 5 ? "$mapped;"
                                    : "$plain_color;");
    write_text(draw, "}\n");
}

/* A closed solid that transmits light, and its texture. */
void write_clear_look(struct language *draw)
{
    open_solid_shape(draw, true);
    write_text(draw, "$turns;pigment {\n");
    below(&draw->state, 8);
    begin_image(draw, 4, true);
    write_text(draw, "$clear_color;");
    end_image(draw);
    write_text(draw, "}\n$2[$finish;|$]$normal;");
}

/* ---- Finishes ------------------------------------------------------------ */

/* Metals are not used where light is transmitted: for a checker whose colours transmit
 * different shares, POV-Ray computes a metal differently. */
void write_metallic(struct language *draw)
{
    if (draw->metals && one_in(&draw->state, 3))
        write_text(draw, "$3[metallic\n|metallic ~.2:1~\n$]");
}

static void write_finish_words(struct language *draw, bool mirror)
{
    if (draw->names[NAME_FINISH] && one_in(&draw->state, 4))
        write_text(draw, "$=Shine;\n");
    write_text(draw, mirror ? "$finish_words;$2[$turned_mirror;|$reflection;$]"
                            : "$finish_words;");
}

static void write_finish_of(struct language *draw, bool mirror)
{
    write_text(draw, "finish {\n");
    write_finish_words(draw, mirror);
    write_text(draw, "}\n");
}

void write_finish(struct language *draw)
{
    write_finish_of(draw, one_in(&draw->state, 5));
}

void write_ground_finish(struct language *draw)
{
    write_finish_of(draw, one_in(&draw->state, 3));
}

/* ---- Normals ------------------------------------------------------------- */

void write_steepness(struct language *draw)
{
    write_text(draw, "%.3f", between(&draw->state, -draw->steep, draw->steep));
}

void write_bump_map(struct language *draw)
{
    bool average = one_in(&draw->state, 3);
    double at = between(&draw->state, 0, .3);
    write_text(draw, average ? "average\n" : "$2[gradient y sine_wave|onion$]\n");
    write_text(draw, "normal_map {\n");
    for (size_t left = 1 + below(&draw->state, 3); left > 0; left--) {
        write_text(draw, "[%.3f $bump;]\n", at);
        at += between(&draw->state, .1, .5);
    }
    write_text(draw, "}\n");
}

void write_slopes(struct language *draw)
{
    double at = between(&draw->state, 0, .3);
    write_text(draw, "$2[gradient y|onion$]\nbump_size $steepness;\nslope_map {\n");
    for (size_t left = 1 + below(&draw->state, 4); left > 0; left--) {
        write_text(draw, "[%.3f <^30:1^, ^3-1:1^>]\n", at);
        at += one_in(&draw->state, 4) ? 0 : between(&draw->state, .1, .4);
    }
    write_text(draw, "}\n");
}

/* Adds a normal to some textures; on mirrors it is less steep.  A reflected ray along
 * the surface hits it again or not, depending on POV-Ray's tolerance. */
static void write_normal_of(struct language *draw, double steep)
{
    uint64_t before = draw->state;
    draw->state = stream_beside(before, 5, 3);
    draw->steep = steep;
    write_text(draw, "$4[$own_normal;|$]");
    draw->state = before;
}

void write_normal(struct language *draw)
{
    write_normal_of(draw, .2);
}

void write_steep_normal(struct language *draw)
{
    write_normal_of(draw, 1);
}

/* ---- Textures ------------------------------------------------------------ */

void write_texture_words(struct language *draw)
{
    bool named = draw->names[NAME_TEXTURE] && one_in(&draw->state, 3);
    write_text(draw,
               named ? "$=Look;\n$3[$pigment;|$]$3[$finish;|$]" : "$pigment;$finish;");
    write_text(draw, "$normal;$turns;");
}

void declare_look(struct language *draw)
{
    size_t which = below(&draw->state, 3);
    write_text(draw, "$[#declare |#local $]");
    if (which == 0) {
        write_text(draw, "$+Paint; = pigment {\n$2[$mapped;|$checker;$]}\n$!Paint;");
    } else if (which == 1) {
        write_text(draw, "$+Shine; = finish {\n");
        write_finish_words(draw, one_in(&draw->state, 5));
        write_text(draw, "}\n$!Shine;");
    } else
        write_text(draw, "$+Look; = texture {\n$texture_words;}\n$!Look;");
}
