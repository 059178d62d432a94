/* language_things.c - solids, and things in their places, by chance. */
#include "tests/oracle/language_shapes.h"

/* Where a solid stands: in a list, as a part of another solid, or as what a
 * difference takes away or an intersection meets. */
enum standing { LISTED, JOINED, CUTTING };

static void say_solid(struct language *draw, int depth, enum standing standing);

/* --- modifiers ------------------------------------------------------------ */

static void say_place(struct language *draw)
{
    begin_line(draw);
    say(draw, "translate <");
    say_number(draw, -2.2, 2.2);
    say(draw, ", ");
    say_number(draw, -1, 1.6);
    say(draw, ", ");
    say_number(draw, -2, 2);
    say(draw, ">\n");
}

/* As a part of a solid, so that no faces coincide. */
static void say_shift(struct language *draw)
{
    say_line(draw, "translate <%.4f, %.4f, %.4f>", between(&draw->state, -.4, .4),
             between(&draw->state, -.4, .4), between(&draw->state, -.4, .4));
}

/* By what has an end not turned inside out: POV-Ray looks at quadrics and quartics
 * in the box about what clips them, inside out or not.  Not by meshes: POV-Ray
 * loses crossings of a mesh with a ray while it asks whether they lie inside of another one. */
static void say_clip(struct language *draw)
{
    open_block(draw, "clipped_by {");
    draw->clipping = true;
    for (size_t left = 1 + one_in(&draw->state, 4); left > 0; left--) {
        bool solid = one_in(&draw->state, 3);
        if (solid)
            open_solid_shape(draw, false);
        else
            open_endless(draw);
        say_turns(draw);
        if (!solid && one_in(&draw->state, 5))
            say_line(draw, "inverse");
        close_block(draw, "}");
    }
    draw->clipping = false;
    close_block(draw, "}");
}

/* Words that change nothing here. */
static void say_idle_word(struct language *draw)
{
    begin_line(draw);
    SAY_ONE_OF(draw, "hollow", "hollow off", "no_radiosity", "photons { }");
    end_line(draw);
}

/* Rays that pass a thing as if it was not there. */
static void say_hidden(struct language *draw, size_t rarity)
{
    if (one_in(&draw->state, rarity))
        say_line(draw, "no_shadow");
    if (one_in(&draw->state, rarity))
        say_line(draw, one_in(&draw->state, 6) ? "no_image off" : "no_image");
    if (one_in(&draw->state, rarity))
        say_line(draw, "no_reflection");
}

static void say_cuts(struct language *draw)
{
    if (one_in(&draw->state, 8))
        say_clip(draw);
    if (one_in(&draw->state, 10))
        say_line(draw, "hollow");
    say_hidden(draw, 10);
}

/* A look before, among or behind the motions. */
static void say_dress(struct language *draw)
{
    say_turns(draw);
    say_look(draw);
    say_turns(draw);
}

/* --- solids --------------------------------------------------------------- */

static void say_leaf(struct language *draw, enum standing standing)
{
    open_solid_shape(draw, false);
    if (one_in(&draw->state, 8))
        say_clip(draw);
    if (one_in(&draw->state, 3))
        say_look(draw);
    say_turns(draw);
    if (standing == CUTTING && one_in(&draw->state, 6))
        say_line(draw, "inverse");
    say_shift(draw);
    close_block(draw, "}");
}

static void say_cutter(struct language *draw, int depth)
{
    if (one_in(&draw->state, 3)) {
        open_endless(draw);
        if (one_in(&draw->state, 3))
            say_look(draw);
        say_turns(draw);
        close_block(draw, "}");
    } else
        say_solid(draw, depth, CUTTING);
}

/* A disc is no part: of an intersection with one POV-Ray leaves out what is
 * beside the box about the disc.  A union is a list: as a part of a solid it
 * keeps its inner faces in POV-Ray, which are seen where something is clipped or
 * open. */
static void say_joined(struct language *draw, int depth, enum standing standing)
{
    static const char *const words[] = { "union", "merge", "intersection", "difference",
                                         "difference" };
    size_t which = below(&draw->state, 5);
    which += which == 0 && standing != LISTED;
    enum standing part = which == 0 ? LISTED : JOINED;
    open_block(draw, "%s {", words[which]);
    say_solid(draw, depth - 1, part);
    for (size_t left = 1 + below(&draw->state, 2); left > 0; left--)
        if (which < 2)
            say_solid(draw, depth - 1, part);
        else
            say_cutter(draw, depth - 1);
    if (one_in(&draw->state, 8))
        say_clip(draw);
    if (one_in(&draw->state, 2))
        say_look(draw);
    say_turns(draw);
    say_shift(draw);
    close_block(draw, "}");
}

static void say_reference(struct language *draw)
{
    open_block(draw, "object {");
    begin_line(draw);
    say_name(draw, NAME_SOLID);
    end_line(draw);
    if (one_in(&draw->state, 2))
        say_look(draw);
    say_turns(draw);
    say_shift(draw);
    close_block(draw, "}");
}

static void say_solid(struct language *draw, int depth, enum standing standing)
{
    if (draw->names[NAME_SOLID] && one_in(&draw->state, 6))
        say_reference(draw);
    else if (depth > 0 && one_in(&draw->state, 2))
        say_joined(draw, depth, standing);
    else
        say_leaf(draw, standing);
}

void declare_solid(struct language *draw)
{
    begin_line(draw);
    say(draw, "#declare ");
    say_new_name(draw, NAME_SOLID);
    say(draw, " =\n");
    if (one_in(&draw->state, 2))
        say_joined(draw, 1, JOINED);
    else
        say_leaf(draw, JOINED);
    draw->names[NAME_SOLID]++;
}

/* --- things --------------------------------------------------------------- */

static void say_shape_thing(struct language *draw)
{
    open_solid_shape(draw, false);
    say_dress(draw);
    say_cuts(draw);
    say_place(draw);
    close_block(draw, "}");
}

static void say_sheet_thing(struct language *draw)
{
    open_sheet(draw);
    say_dress(draw);
    say_hidden(draw, 8);
    say_place(draw);
    close_block(draw, "}");
}

static void say_solid_thing(struct language *draw)
{
    open_block(draw, "object {");
    say_joined(draw, 2, LISTED);
    if (one_in(&draw->state, 2))
        say_look(draw);
    say_turns(draw);
    if (one_in(&draw->state, 6))
        say_idle_word(draw);
    say_hidden(draw, 8);
    say_place(draw);
    close_block(draw, "}");
}

static void say_named_thing(struct language *draw)
{
    open_block(draw, "object {");
    begin_line(draw);
    say_name(draw, NAME_SOLID);
    end_line(draw);
    say_dress(draw);
    say_cuts(draw);
    say_place(draw);
    close_block(draw, "}");
}

/* A list of solids and sheets. */
static void say_group(struct language *draw)
{
    open_block(draw, "union {");
    for (size_t left = 2 + below(&draw->state, 2); left > 0; left--)
        if (one_in(&draw->state, 3)) {
            open_sheet(draw);
            say_turns(draw);
            say_shift(draw);
            close_block(draw, "}");
        } else
            say_solid(draw, 1, LISTED);
    say_dress(draw);
    say_hidden(draw, 12);
    say_place(draw);
    close_block(draw, "}");
}

/* One that is within a box or a ball, as its bound says. */
static void say_bounded_thing(struct language *draw)
{
    open_block(draw, "union {");
    for (int i = 0; i < 2; i++) {
        open_block(draw, i ? "sphere {" : "box {");
        begin_line(draw);
        say_point(draw, -.6, -.1);
        say(draw, ", ");
        if (i)
            say_number(draw, .2, .5);
        else
            say_point(draw, .1, .6);
        end_line(draw);
        if (one_in(&draw->state, 2))
            say_look(draw);
        close_block(draw, "}");
    }
    open_block(draw, "bounded_by {");
    say_line(draw, one_in(&draw->state, 2) ? "box { -1.7, 1.7 }" : "sphere { 0, 1.9 }");
    close_block(draw, "}");
    say_dress(draw);
    say_place(draw);
    close_block(draw, "}");
}

/* Whole solids, without a way in: a ray of the eye enters an open one from behind in
 * POV-Ray, where here it leaves. */
static void say_clear_thing(struct language *draw)
{
    bool bent = one_in(&draw->state, 2);
    open_solid_shape(draw, true);
    say_turns(draw);
    say_clear_look(draw, bent);
    say_hidden(draw, 6);
    say_place(draw);
    close_block(draw, "}");
}

/* --- things by directives ------------------------------------------------- */

static void say_small(struct language *draw)
{
    open_solid_shape(draw, false);
    say_turns(draw);
    say_look(draw);
    say_line(draw, "scale %.3f", between(&draw->state, .3, .6));
}

static void say_loop_place(struct language *draw, const char *name)
{
    say_line(draw, "translate <%.3f*%s - %.3f, %.3f, %.3f*mod(%s, 2)>",
             between(&draw->state, .7, 1.2), name, between(&draw->state, 1, 2.2),
             between(&draw->state, -1, 1.5), between(&draw->state, -2, 2), name);
}

static void say_for(struct language *draw)
{
    if (one_in(&draw->state, 2))
        open_block(draw, "#for (I, 0, %zu)", 1 + below(&draw->state, 4));
    else
        open_block(draw, "#for (I, %zu, 0, -%s)", 1 + below(&draw->state, 3),
                   one_in(&draw->state, 2) ? "1" : "1.5");
    draw->turning = true;
    say_small(draw);
    say_loop_place(draw, "I");
    close_block(draw, "}");
    draw->turning = false;
    close_block(draw, "#end");
}

static void say_while(struct language *draw)
{
    say_line(draw, "#declare Turn = 0;");
    open_block(draw, "#while (Turn < %zu)", 2 + below(&draw->state, 4));
    if (one_in(&draw->state, 4))
        say_line(draw, "#if (Turn > 2) #break #end");
    say_small(draw);
    say_loop_place(draw, "Turn");
    close_block(draw, "}");
    say_line(draw, "#declare Turn = Turn + 1;");
    close_block(draw, "#end");
}

static void say_condition(struct language *draw)
{
    begin_line(draw);
    SAY_ONE_OF(draw, "#if (", "#if (", "#if (0.3 > ");
    say_float(draw, 2);
    say(draw, ")\n");
    draw->depth++;
    say_shape_thing(draw);
    draw->depth--;
    if (one_in(&draw->state, 3)) {
        begin_line(draw);
        say(draw, "#elseif (");
        say_float(draw, 2);
        say(draw, ")\n");
        draw->depth++;
        say_shape_thing(draw);
        draw->depth--;
    }
    say_line(draw, "#else");
    draw->depth++;
    say_shape_thing(draw);
    close_block(draw, "#end");
}

static void say_switch(struct language *draw)
{
    begin_line(draw);
    say(draw, "#switch (mod(floor(2*abs(");
    say_float(draw, 2);
    say(draw, ")), 4))\n");
    draw->depth++;
    say_line(draw, "#case (0)");
    say_shape_thing(draw);
    if (one_in(&draw->state, 2))
        say_line(draw, "#break");
    say_line(draw, "#range (1, 2.5)");
    say_sheet_thing(draw);
    say_line(draw, "#break");
    say_line(draw, "#else");
    say_shape_thing(draw);
    close_block(draw, "#end");
}

static void say_defined(struct language *draw)
{
    open_block(draw, one_in(&draw->state, 2) ? "#ifdef (N0)" : "#ifndef (Nobody)");
    say_shape_thing(draw);
    draw->depth--;
    say_line(draw, "#else");
    draw->depth++;
    say_sheet_thing(draw);
    close_block(draw, "#end");
}

/* A macro with a number, a colour and a place, called twice. */
void say_macro(struct language *draw)
{
    static const char *const calls[] = { "Made(%.3f, %s, <%.3f, %.3f, %.3f>)",
                                         "object { Made(%.3f, (%s), <%.3f, "
                                         "%.3f, %.3f>) rotate 10*z }" };
    open_block(draw, "#macro Made(Size, Share, Place)");
    say_line(draw, "#local Half = Size/2;");
    open_block(draw, "union {");
    say_line(draw, "cylinder { -Half*y, Size*y, Half*.7 }");
    say_line(draw, "sphere { Size*y, Half*1.1 }");
    say_line(draw, "pigment { rgb <Share, 1 - Share, .5> }");
    say_turns(draw);
    say_line(draw, "translate Place");
    close_block(draw, "}");
    close_block(draw, "#end");
    for (int i = 0; i < 2; i++)
        say_line(draw, calls[below(&draw->state, 2)], between(&draw->state, .3, .7),
                 i ? "N0*.1" : ".3", between(&draw->state, -2, 2),
                 between(&draw->state, -1, 1), between(&draw->state, -2, 2));
}

void say_thing(struct language *draw)
{
    static void (*const things[])(struct language *) = {
        say_shape_thing, say_shape_thing,   say_sheet_thing, say_sheet_thing,
        say_sheet_thing, say_solid_thing,   say_solid_thing, say_solid_thing,
        say_group,       say_bounded_thing, say_for,         say_while,
        say_condition,   say_switch,        say_defined,
    };
    size_t which = below(&draw->state, 18);
    if (which == 0 && draw->names[NAME_SOLID])
        say_named_thing(draw);
    else if (which < 3 && draw->clear)
        say_clear_thing(draw);
    else
        things[below(&draw->state, sizeof things / sizeof *things)](draw);
}
