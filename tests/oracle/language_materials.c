/* language_materials.c - random pigments, finishes, normals and transforms. */
#include "tests/oracle/language_parts.h"

/* --- pigments ------------------------------------------------------------- */

/* Writes a map. Its entries may have equal positions, and need not cover 0 to 1. */
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

/* Writes the look of a closed solid that transmits light. */
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

/* --- normals -------------------------------------------------------------- */

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

/* In POV-Ray a copy of a normal shares its map with the original, and no_bump_scale in
 * the copy also changes the original. Therefore a copy does not have this keyword. */
void begin_copy(struct language *draw)
{
    draw->copied = true;
}

/* Adds a normal to some textures. On mirrors it is less steep, because POV-Ray's
 * tolerance decides whether a ray along the surface hits it again. */
static void write_normal_of(struct language *draw, double steep)
{
    uint64_t before = draw->state;
    draw->state = stream_beside(before, 5, 3);
    draw->steep = steep;
    write_text(draw, "$4[$own_normal;|$]");
    draw->state = before;
    draw->copied = false;
}

void write_normal(struct language *draw)
{
    write_normal_of(draw, .2);
}

void write_steep_normal(struct language *draw)
{
    write_normal_of(draw, 1);
}
