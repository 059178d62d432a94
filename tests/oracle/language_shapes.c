/* language_shapes.c - see language_shapes.h. */
#include "tests/oracle/language_shapes.h"

#include "tests/oracle/mesh_text.h"

#include <stdlib.h>
#include <string.h>

/* --- solids --------------------------------------------------------------- */

/* Of a radius below 0 POV-Ray's bounding box is inside out: it sees the ball only
 * if there are fewer than three things. */
static void open_ball(struct language *draw)
{
    open_block(draw, "sphere {");
    begin_line(draw);
    say_point(draw, -.2, .2);
    SAY_ONE_OF(draw, ", ", " ");
    say(draw, "%.4f\n", between(&draw->state, .4, .9));
}

static void open_box(struct language *draw)
{
    open_block(draw, "box {");
    begin_line(draw);
    say_point(draw, -.8, -.2);
    say(draw, ", ");
    say_point(draw, .2, .8);
    end_line(draw);
}

static void say_ends(struct language *draw, bool cone)
{
    begin_line(draw);
    say_point(draw, -.7, -.2);
    say(draw, ", ");
    if (cone) {
        say_number(draw, .3, .6);
        say(draw, ", ");
    }
    say_point(draw, .2, .7);
    say(draw, ", ");
    if (cone && one_in(&draw->state, 3))
        say(draw, "0");
    else
        say_number(draw, .2, .6);
    end_line(draw);
}

static void open_cylinder(struct language *draw)
{
    open_block(draw, "cylinder {");
    say_ends(draw, false);
}

static void open_cone(struct language *draw)
{
    open_block(draw, "cone {");
    say_ends(draw, true);
}

/* A tube that passes through itself is not drawn: of what is seen only from
 * within POV-Ray gives normals of another part. */
static void open_torus(struct language *draw)
{
    open_block(draw, "torus {");
    begin_line(draw);
    say_number(draw, .5, .8);
    say(draw, ", ");
    say_number(draw, .1, .4);
    end_line(draw);
    say_line(draw, "sturm");
}

static void open_ellipsoid(struct language *draw)
{
    open_block(draw, "quadric {");
    begin_line(draw);
    say_point(draw, 1.4, 4);
    say(draw, ", ");
    say_point(draw, -.5, .5);
    say(draw, ", ");
    say_point(draw, -.2, .2);
    say(draw, ", -%.4f\n", between(&draw->state, .6, 1));
}

/* x^4 + y^4 + z^4 and some of the second order. */
static void open_quartic(struct language *draw)
{
    open_block(draw, "quartic {");
    say_line(draw,
             "<2, 0,0,0, %.3f,0,0, %.3f,0,%.3f, 0,0,0,0,0,%.3f, 0,0,0,0, "
             "3, 0,0, %.3f,0,%.3f, 0,0,0,0, 2, 0,%.3f,0, -%.3f>",
             between(&draw->state, 0, 1), between(&draw->state, 0, 1),
             between(&draw->state, -1, 1), between(&draw->state, -.5, .5),
             between(&draw->state, 0, 1), between(&draw->state, -1, .5),
             between(&draw->state, -.7, .5), between(&draw->state, .4, 1));
    say_line(draw, "sturm");
}

/* An outline that does not cross itself, now and then with a hole; of straight
 * edges or of parabolas, where each loop has a point before its first. */
static void open_prism(struct language *draw)
{
    uint64_t state = stream_beside(draw->state, 5, 1);
    bool curved = one_in(&state, 2);
    bool hole = one_in(&draw->state, 3);
    size_t corners = 3 + below(&draw->state, 4);
    open_block(draw, "prism {");
    begin_line(draw);
    if (curved)
        say(draw, "quadratic_spline ");
    SAY_ONE_OF(draw, "", "linear_sweep ",
               curved ? "linear_sweep " : "linear_sweep linear_spline ");
    say(draw, "%.4f, %.4f, %zu", between(&draw->state, -.7, -.2),
        between(&draw->state, .2, .7), corners + 1 + curved + (hole ? 4 + curved : 0));
    end_line(draw);
    double points[7][2];
    begin_line(draw);
    for (size_t i = 0; i < corners; i++) {
        double angle = 6.2832 * (double)i / (double)corners + .3;
        double far = between(&draw->state, .6, .9);
        points[i][0] = far * cos(angle);
        points[i][1] = far * sin(angle);
    }
    memcpy(points[corners], points[0], sizeof *points);
    if (curved)
        say(draw, "<%.4f, %.4f>, ", points[corners - 1][0], points[corners - 1][1]);
    for (size_t i = 0; i <= corners; i++)
        say(draw, "%s<%.4f, %.4f>", i ? ", " : "", points[i][0], points[i][1]);
    if (hole)
        say(draw, "%s, <.2, .01>, <-.1, .17>, <-.12, -.16>, <.2, .01>",
            curved ? ", <-.12, -.16>" : "");
    end_line(draw);
}

/* Balls and rods that melt together; what is taken away leaves a dent.  Small
 * parts are not drawn: POV-Ray sees nothing of a blob within a hundredth of where a
 * ray begins.  Nor is sturm, with which it loses a crossing now and then. */
static void say_component(struct language *draw)
{
    bool rod = one_in(&draw->state, 2);
    open_block(draw, rod ? "cylinder {" : "sphere {");
    begin_line(draw);
    say_point(draw, -.4, .4);
    say(draw, ", ");
    if (rod) {
        say_point(draw, .1, .5);
        say(draw, ", ");
    }
    say_number(draw, .4, .7);
    SAY_ONE_OF(draw, ", ", ", strength ", " strength ");
    say(draw, "%s%.4f\n", one_in(&draw->state, 5) ? "-" : "",
        between(&draw->state, .5, 1.2));
    if (one_in(&draw->state, 3))
        say_line(draw, "scale <%.3f, %.3f, 1> rotate <0, %.1f, %.1f>",
                 between(&draw->state, .7, 1.2), between(&draw->state, .7, 1.2),
                 between(&draw->state, 0, 90), between(&draw->state, 0, 90));
    close_block(draw, "}");
}

static void open_blob(struct language *draw)
{
    open_block(draw, "blob {");
    say_line(draw, "threshold %.4f", between(&draw->state, .2, .6));
    say_line(draw, "sphere { <%.3f, 0, %.3f>, .8, 1.3 }",
             between(&draw->state, -.3, .3), between(&draw->state, -.3, .3));
    for (size_t left = below(&draw->state, 4); left > 0; left--)
        say_component(draw);
    if (one_in(&draw->state, 2))
        say_line(draw, "component .8, .7, <0, %.3f, 0>",
                 between(&draw->state, -.5, .5));
}

/* Now and then, instead of another shape: scenes that have none are as they were
 * before there were blobs. */
static bool opens_blob(struct language *draw)
{
    uint64_t kept = draw->state, state = stream_beside(kept, 7, 3);
    if (!one_in(&state, 12))
        return false;
    draw->state = state;
    open_blob(draw);
    draw->state = kept;
    return true;
}

static void (*const closed_shapes[])(struct language *) = {
    open_ball,  open_box,       open_cylinder, open_cone,
    open_torus, open_ellipsoid, open_quartic,  open_prism,
};
enum { CLOSED = sizeof closed_shapes / sizeof *closed_shapes };

/* From the axis to the axis, or open at its ends: rising, with a level segment and
 * an upright one now and then.  It begins with a torus' numbers. */
static void open_lathe(struct language *draw, uint64_t *state, bool closed)
{
    bool open = !closed && one_in(state, 3);
    size_t corners = 1 + below(state, 5);
    double height = -.4, radius = between(state, .2, .9);
    bool level = false;
    open_block(draw, "lathe {");
    begin_line(draw);
    say(draw, "%s%zu", one_in(state, 2) ? "linear_spline " : "",
        corners + (open ? 2 : 4));
    if (!open)
        say(draw, ", <0, -.8>");
    say(draw, ", <");
    say_number(draw, .5, .8);
    say(draw, ", -.8>, <");
    say_number(draw, .1, .4);
    say(draw, ", -.6>");
    for (size_t i = 0; i < corners; i++) {
        say(draw, ", <%.4f, %.4f>", radius, height);
        level = !level && one_in(state, 4);
        height += level ? 0 : between(state, .1, 1.2 / (double)corners);
        radius = level || !one_in(state, 4) ? between(state, .1, .9) : radius;
    }
    say(draw, open ? "\n" : ", <0, %.4f>\n", height);
}

/* A body of triangles, in the place of what is drawn. */
static void open_star(struct language *draw, void (*open_shape)(struct language *))
{
    struct language unseen = *draw;
    char *passed, words[SOLID_WORDS];
    mesh_star_words(draw->state, words);
    open_block(draw, "%s", words);
    unseen.text = test_text(&passed);
    open_shape(&unseen);
    fclose(unseen.text);
    free(passed);
    draw->state = unseen.state;
}

void open_solid_shape(struct language *draw, bool closed)
{
    if (opens_blob(draw))
        return;
    /* Nothing else depends on it. */
    bool star = draw->state % 10 == 0 && !draw->clipping;
    size_t which = below(&draw->state, CLOSED);
    uint64_t state = stream_beside(draw->state, 5, 1);
    if (!star && closed_shapes[which] == open_torus && one_in(&state, 2)) {
        open_lathe(draw, &state, closed);
        return;
    }
    if (star)
        open_star(draw, closed_shapes[which]);
    else
        closed_shapes[which](draw);
    bool opens = closed_shapes[which] == open_cylinder
                 || closed_shapes[which] == open_cone
                 || closed_shapes[which] == open_prism;
    if (!closed && opens && one_in(&draw->state, 4) && !star)
        say_line(draw, "open");
}

/* --- without an end ------------------------------------------------------- */

static void open_plane(struct language *draw)
{
    open_block(draw, "plane {");
    begin_line(draw);
    say_arrow(draw, .5, 2);
    say(draw, ", %.4f\n", between(&draw->state, -.2, .5));
}

/* A hyperboloid of one sheet or of two, a cone, a cylinder, a saddle. */
static void open_quadric(struct language *draw)
{
    static const char *const quadrics[] = {
        "<1, -1, 1.2>, <.1, .2, 0>, <.1, 0, 0>, -.1%zu",
        "<-1, 1, -1>, 0, 0, -.0%zu7",
        "<1, 0, 2>, <.2, .1, .3>, 0, -.3%zu",
        "<1, 0, -1>, 0, <0, 1, 0>, .0%zu",
    };
    open_block(draw, "quadric {");
    begin_line(draw);
    say(draw, quadrics[below(&draw->state, 4)], 1 + below(&draw->state, 8));
    end_line(draw);
}

static void open_cubic(struct language *draw)
{
    open_block(draw, one_in(&draw->state, 2) ? "cubic {" : "poly { 3,");
    say_line(draw,
             "<%.3f, 0,0,.2, 0,0,0, 0,0,1, %.3f, 0,0, 0,0,1, %.3f, .1,-1, "
             ".02>",
             between(&draw->state, .2, 1), between(&draw->state, -.5, .5),
             between(&draw->state, -1, -.2));
    say_line(draw, "sturm");
}

void open_endless(struct language *draw)
{
    switch (below(&draw->state, 6)) {
    case 0: open_quadric(draw); break;
    case 1: open_cubic(draw); break;
    default: open_plane(draw); break;
    }
}

/* --- sheets --------------------------------------------------------------- */

static void open_disc(struct language *draw)
{
    open_block(draw, "disc {");
    begin_line(draw);
    say_point(draw, -.2, .2);
    say(draw, ", ");
    say_arrow(draw, .5, 2);
    say(draw, ", %.4f", between(&draw->state, .5, 1));
    if (one_in(&draw->state, 2))
        say(draw, ", %.4f", between(&draw->state, .1, .4));
    end_line(draw);
}

/* bent: how far its normals, if it has any, and its plane lean.  Of one that stands
 * alone POV-Ray shows nothing if its normals are not all on one side of it, in any
 * of the places through which its motions bring it. */
static void open_triangle(struct language *draw, double bent)
{
    static const double corner[3][2] = { { -.9, -.6 }, { .8, -.7 }, { 0, 1 } };
    bool smooth = one_in(&draw->state, 2);
    open_block(draw, smooth ? "smooth_triangle {" : "triangle {");
    begin_line(draw);
    for (int i = 0; i < 3; i++) {
        say(draw, "<%.4f, %.4f, %.4f>", corner[i][0] + between(&draw->state, -.2, .2),
            corner[i][1] + between(&draw->state, -.2, .2),
            between(&draw->state, -bent, bent));
        if (smooth)
            say(draw, ", <%.3f, %.3f, -1>", between(&draw->state, -bent, bent),
                between(&draw->state, -bent, bent));
        say(draw, i < 2 ? ", " : "\n");
    }
}

static void open_lone_triangle(struct language *draw)
{
    open_triangle(draw, .15);
}

static void open_mesh(struct language *draw)
{
    open_block(draw, "mesh {");
    for (size_t left = 1 + below(&draw->state, 4); left > 0; left--) {
        open_triangle(draw, .5);
        close_block(draw, "}");
    }
}

/* A bent net of squares, each cut in two. */
enum { NET = 3 };

static void say_net_points(struct language *draw)
{
    open_block(draw, "vertex_vectors { %d,", NET * NET);
    for (int i = 0; i < NET * NET; i++)
        say_line(draw, "<%.4f, %.4f, %.4f>%s", .7 * (i % NET - 1), .7 * (i / NET - 1),
                 between(&draw->state, -.4, .4), i + 1 < NET * NET ? "," : "");
    close_block(draw, "}");
}

static void say_net_normals(struct language *draw)
{
    open_block(draw, "normal_vectors { %d,", NET * NET);
    for (int i = 0; i < NET * NET; i++)
        say_line(draw, "<%.3f, %.3f, %.3f>%s", between(&draw->state, -.7, .7),
                 between(&draw->state, -.7, .7), -between(&draw->state, .5, 1),
                 i + 1 < NET * NET ? "," : "");
    close_block(draw, "}");
}

static void say_net_faces(struct language *draw)
{
    open_block(draw, "face_indices { %d,", 2 * (NET - 1) * (NET - 1));
    for (int i = 0; i < NET - 1; i++)
        for (int j = 0; j < NET - 1; j++) {
            int at = i * NET + j;
            say_line(draw, "<%d, %d, %d>, <%d, %d, %d>%s", at, at + 1, at + NET + 1,
                     at + NET + 1, at + NET, at, i + j < 2 * NET - 4 ? "," : "");
        }
    close_block(draw, "}");
}

static void open_net(struct language *draw)
{
    open_block(draw, "mesh2 {");
    say_net_points(draw);
    if (one_in(&draw->state, 2))
        say_net_normals(draw);
    say_net_faces(draw);
}

static void open_bicubic(struct language *draw)
{
    size_t steps = 1 + below(&draw->state, 3);
    open_block(draw, "bicubic_patch {");
    say_line(draw, "type %zu flatness %s u_steps %zu v_steps %zu",
             below(&draw->state, 2), one_in(&draw->state, 2) ? "0" : ".05", steps,
             1 + below(&draw->state, 3));
    for (int i = 0; i < 4; i++) {
        begin_line(draw);
        for (int j = 0; j < 4; j++)
            say(draw, "<%.4f, %.4f, %.4f>%s", .55 * (j - 1.5), .55 * (i - 1.5),
                between(&draw->state, -.6, .6), i + j < 6 ? ", " : "");
        end_line(draw);
    }
}

/* An outline with a hole; or a star, which crosses itself. */
static void open_polygon(struct language *draw)
{
    open_block(draw, "polygon {");
    if (one_in(&draw->state, 3))
        say_line(draw, "6, <0, .9>, <.53, -.73>, <-.86, .28>, <.86, .28>, "
                       "<-.53, -.73>, <0, .9>");
    else {
        say_line(draw, "5, <-.8, -.7>, <.8, -.6>, <.7, .8>, <-.9, .6>, "
                       "<-.8, -.7>");
    }
}

/* Of letters with little that is round: POV-Ray keeps them in 32 bits, which is
 * seen in highlights. */
static void open_sign(struct language *draw)
{
    open_block(draw, "text {");
    begin_line(draw);
    say(draw, "ttf \"timrom.ttf\" \"");
    SAY_ONE_OF(draw, "A", "H", "M", "L");
    say(draw, "\" %.3f, %.2f*x\n", between(&draw->state, .1, .5),
        between(&draw->state, 0, .2));
}

void open_sheet(struct language *draw)
{
    static void (*const shapes[])(struct language *) = {
        open_disc, open_disc,    open_lone_triangle, open_mesh,
        open_net,  open_bicubic, open_polygon,
    };
    if (one_in(&draw->state, 12))
        open_sign(draw);
    else
        shapes[below(&draw->state, sizeof shapes / sizeof *shapes)](draw);
}
