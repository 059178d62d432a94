/* language_objects.c - random solids, and objects at random positions. */
#include "tests/oracle/language_parts.h"

/* The use of a solid: in a list, as part of another solid, or as a subtracted part of a
 * difference or intersection. */
enum standing { LISTED, JOINED, CUTTING };

static void write_solid(struct language *draw, int depth, enum standing standing);

/* Clips by a bounded shape that is not inverted. POV-Ray searches quadrics and quartics
 * only in the box of the clipping shape, even if it is inverted. Meshes do not clip,
 * because POV-Ray loses crossings of a mesh inside another mesh. */
void write_clip(struct language *draw)
{
    write_text(draw, "clipped_by {\n");
    draw->clipping = true;
    for (size_t left = 1 + one_in(&draw->state, 4); left > 0; left--)
        write_text(draw, "$3[$shape;$turns;|$endless;$turns;$5[inverse\n|$]$]}\n");
    draw->clipping = false;
    write_text(draw, "}\n");
}

/* ---- Solids -------------------------------------------------------------- */

static void write_leaf(struct language *draw, enum standing standing)
{
    write_text(draw, "$shape;$8[$clip;|$]$3[$look;|$]$turns;");
    if (standing == CUTTING)
        write_text(draw, "$6[inverse\n|$]");
    write_text(draw, "$shift;}\n");
}

static void write_cutter(struct language *draw, int depth)
{
    if (one_in(&draw->state, 3))
        write_text(draw, "$endless;$3[$look;|$]$turns;}\n");
    else
        write_solid(draw, depth, CUTTING);
}

/* A disc is not used as a part, because POV-Ray drops the parts of an intersection
 * outside the box of its disc. A union is only used in a list. In a solid POV-Ray keeps
 * its inner faces, which openings show. */
static void write_joined(struct language *draw, int depth, enum standing standing)
{
    static const char *const words[] = { "union", "merge", "intersection", "difference",
                                         "difference" };
    size_t which = below(&draw->state, 5);
    which += which == 0 && standing != LISTED;
    enum standing part = which == 0 ? LISTED : JOINED;
    write_text(draw, "%s {\n", words[which]);
    write_solid(draw, depth - 1, part);
    for (size_t left = 1 + below(&draw->state, 2); left > 0; left--)
        if (which < 2)
            write_solid(draw, depth - 1, part);
        else
            write_cutter(draw, depth - 1);
    write_text(draw, "$8[$clip;|$]$2[$look;|$]$turns;$shift;}\n");
}

static void write_solid(struct language *draw, int depth, enum standing standing)
{
    if (draw->names[NAME_SOLID] && one_in(&draw->state, 6))
        write_text(draw, "$reference;");
    else if (depth > 0 && one_in(&draw->state, 2))
        write_joined(draw, depth, standing);
    else
        write_leaf(draw, standing);
}

void write_listed_solid(struct language *draw)
{
    write_solid(draw, 1, LISTED);
}

void write_great_solid(struct language *draw)
{
    write_joined(draw, 2, LISTED);
}

void declare_solid(struct language *draw)
{
    write_text(draw, "#declare $+Solid; =\n");
    if (one_in(&draw->state, 2))
        write_joined(draw, 1, JOINED);
    else
        write_leaf(draw, JOINED);
    write_text(draw, "$!Solid;");
}

/* ---- Statements ---------------------------------------------------------- */

void write_for(struct language *draw)
{
    write_text(draw, "$2[#for (I, 0, ^#1:4^)\n|$[#for (I, ^#1:3^, 0, -1)\n"
                     "|#for (I, ^#1:3^, 0, -1.5)\n$]$]");
    draw->turning = true;
    write_text(
        draw,
        "$small;translate <^3.7:1.2^*I - ^31:2.2^, ^3-1:1.5^, ^3-2:2^*mod(I, 2)>\n"
        "}\n");
    draw->turning = false;
    write_text(draw, "#end\n");
}

/* Makes a macro with a number, a colour and a position as parameters, and two calls. */
void write_macro(struct language *draw)
{
    write_text(
        draw,
        "#macro Made(Size, Share, Place)\n#local Half = Size/2;\nunion {\n"
        "cylinder { -Half*y, Size*y, Half*.7 }\nsphere { Size*y, Half*1.1 }\n"
        "pigment { rgb <Share, 1 - Share, .5> }\n$turns;translate Place\n}\n#end\n");
    for (int i = 0; i < 2; i++) {
        double z = between(&draw->state, -2, 2), y = between(&draw->state, -1, 1);
        double x = between(&draw->state, -2, 2), size = between(&draw->state, .3, .7);
        const char *share = i ? "N0*.1" : ".3";
        write_text(
            draw,
            one_in(&draw->state, 2)
                ? "Made(%.3f, %s, <%.3f, %.3f, %.3f>)\n"
                : "object { Made(%.3f, (%s), <%.3f, %.3f, %.3f>) rotate 10*z }\n",
            size, share, x, y, z);
    }
}
