/* language_shapes.c - random shapes, whose blocks stay open for modifiers. */
#include "tests/oracle/language_parts.h"
#include "tests/oracle/solid_text.h"

#include <stdlib.h>
#include <string.h>

/* ---- Solids -------------------------------------------------------------- */

/* Makes an outline that does not intersect itself, sometimes with a hole. Its edges are
 * straight or are parabolas, which need an additional point before the first. */
static void open_prism(struct language *draw)
{
    uint64_t state = stream_beside(draw->state, 5, 1);
    bool curved = one_in(&state, 2);
    bool hole = one_in(&draw->state, 3);
    size_t corners = 3 + below(&draw->state, 4);
    write_text(draw, "prism {\n");
    if (curved)
        write_text(draw, "quadratic_spline ");
    write_text(draw, "$[|linear_sweep |linear_sweep %s$]",
               curved ? "" : "linear_spline ");
    write_text(draw, "%.4f, %.4f, %zu", between(&draw->state, -.7, -.2),
               between(&draw->state, .2, .7),
               corners + 1 + curved + (hole ? 4 + curved : 0));
    write_text(draw, "\n");
    double points[7][2];
    for (size_t i = 0; i < corners; i++) {
        double angle = 6.2832 * (double)i / (double)corners + .3;
        double far = between(&draw->state, .6, .9);
        points[i][0] = far * cos(angle);
        points[i][1] = far * sin(angle);
    }
    memcpy(points[corners], points[0], sizeof *points);
    if (curved)
        write_text(draw, "<%.4f, %.4f>, ", points[corners - 1][0],
                   points[corners - 1][1]);
    for (size_t i = 0; i <= corners; i++)
        write_text(draw, "%s<%.4f, %.4f>", i ? ", " : "", points[i][0], points[i][1]);
    if (hole)
        write_text(draw, "%s, <.2, .01>, <-.1, .17>, <-.12, -.16>, <.2, .01>",
                   curved ? ", <-.12, -.16>" : "");
    write_text(draw, "\n");
}

/* Adds a ball or a rod to a blob. A negative strength makes a dent. Components are not
 * small, because POV-Ray finds no blob within a hundredth of the start of a ray. sturm
 * is not used, because with it POV-Ray sometimes loses a crossing. */
void write_component(struct language *draw)
{
    write_text(draw, "$2[cylinder {\n@-.4:.4@, @.1:.5@, |sphere {\n@-.4:.4@, $]~.4:.7~"
                     "$[, |, strength | strength $]");
    double strength = between(&draw->state, .5, 1.2);
    write_text(draw, "$5[-|$]%.4f\n", strength);
    write_text(
        draw,
        "$3[scale <^3.7:1.2^, ^3.7:1.2^, 1> rotate <0, ^10:90^, ^10:90^>\n|$]}\n");
}

/* Replaces some shapes by blobs. Scenes without blobs do not depend on this choice. */
static bool opens_blob(struct language *draw)
{
    uint64_t kept = draw->state, state = stream_beside(kept, 7, 3);
    if (!one_in(&state, 12))
        return false;
    draw->state = state;
    write_text(draw, "$blob_begin;");
    for (size_t left = below(&draw->state, 4); left > 0; left--)
        write_component(draw);
    write_text(draw, "$2[component .8, .7, <0, ^3-.5:.5^, 0>\n|$]");
    draw->state = kept;
    return true;
}

enum { TORUS = 4, PRISM = 7, CLOSED = 8 };
static const char *const closed_shapes[CLOSED] = { "$ball;",     "$box;",
                                                   "$cylinder;", "$cone;",
                                                   "$torus;",    "$ellipsoid;",
                                                   "$quartic;",  NULL };

static void open_closed(struct language *draw, size_t which)
{
    if (which == PRISM)
        open_prism(draw);
    else
        write_pattern(draw, closed_shapes[which]);
}

/* Makes a path from axis to axis, or with open ends. It rises, with some level and some
 * vertical segments. It uses the random numbers of a torus first. */
static void open_lathe(struct language *draw, uint64_t *state, bool closed)
{
    bool open = !closed && one_in(state, 3);
    size_t corners = 1 + below(state, 5);
    double height = -.4, radius = between(state, .2, .9);
    bool level = false;
    write_text(draw, "lathe {\n");
    write_text(draw, "%s%zu", one_in(state, 2) ? "linear_spline " : "",
               corners + (open ? 2 : 4));
    if (!open)
        write_text(draw, ", <0, -.8>");
    write_text(draw, ", <~.5:.8~, -.8>, <~.1:.4~, -.6>");
    for (size_t i = 0; i < corners; i++) {
        write_text(draw, ", <%.4f, %.4f>", radius, height);
        level = !level && one_in(state, 4);
        height += level ? 0 : between(state, .1, 1.2 / (double)corners);
        radius = level || !one_in(state, 4) ? between(state, .1, .9) : radius;
    }
    write_text(draw, open ? "\n" : ", <0, %.4f>\n", height);
}

/* Replaces a shape by a body of triangles. The shape is generated, but not printed. */
static void open_star(struct language *draw, size_t which)
{
    struct language unseen = *draw;
    char *passed, words[SOLID_WORDS];
    mesh_star_words(draw->state, words);
    write_text(draw, "%s\n", words);
    unseen.text = test_text(&passed);
    open_closed(&unseen, which);
    fclose(unseen.text);
    free(passed);
    draw->state = unseen.state;
}

void open_solid_shape(struct language *draw, bool closed)
{
    if (opens_blob(draw))
        return;
    /* the other random choices do not depend on this choice */
    bool star = draw->state % 10 == 0 && !draw->clipping;
    size_t which = below(&draw->state, CLOSED);
    uint64_t state = stream_beside(draw->state, 5, 1);
    if (!star && which == TORUS && one_in(&state, 2)) {
        open_lathe(draw, &state, closed);
        return;
    }
    if (star)
        open_star(draw, which);
    else
        open_closed(draw, which);
    bool opens = which == 2 || which == 3 || which == PRISM;
    if (!closed && opens && one_in(&draw->state, 4) && !star)
        write_text(draw, "open\n");
}

void open_solid(struct language *draw)
{
    open_solid_shape(draw, false);
}

/* Makes a hyperboloid of one or two sheets, a cone, a cylinder or a saddle. */
void open_quadric(struct language *draw)
{
    static const char *const quadrics[] = {
        "<1, -1, 1.2>, <.1, .2, 0>, <.1, 0, 0>, -.1%zu\n",
        "<-1, 1, -1>, 0, 0, -.0%zu7\n",
        "<1, 0, 2>, <.2, .1, .3>, 0, -.3%zu\n",
        "<1, 0, -1>, 0, <0, 1, 0>, .0%zu\n",
    };
    write_text(draw, "quadric {\n");
    size_t digit = 1 + below(&draw->state, 8);
    write_text(draw, quadrics[below(&draw->state, 4)], digit);
}

/* ---- Surfaces ------------------------------------------------------------ */

/* Makes a triangle. Its plane and its normals, if any, are tilted by `bent`. POV-Ray
 * does not show a single triangle if its normals are on different sides of it, even at
 * an intermediate step of its transforms. */
static void open_triangle(struct language *draw, double bent)
{
    static const double corner[3][2] = { { -.9, -.6 }, { .8, -.7 }, { 0, 1 } };
    bool smooth = one_in(&draw->state, 2);
    write_text(draw, smooth ? "smooth_triangle {\n" : "triangle {\n");
    for (int i = 0; i < 3; i++) {
        write_text(draw, "<%.4f, %.4f, %.4f>",
                   corner[i][0] + between(&draw->state, -.2, .2),
                   corner[i][1] + between(&draw->state, -.2, .2),
                   between(&draw->state, -bent, bent));
        if (smooth)
            write_text(draw, ", <%.3f, %.3f, -1>", between(&draw->state, -bent, bent),
                       between(&draw->state, -bent, bent));
        write_text(draw, i < 2 ? ", " : "\n");
    }
}

void open_lone_triangle(struct language *draw)
{
    open_triangle(draw, .15);
}

void open_bent_triangle(struct language *draw)
{
    open_triangle(draw, .5);
}

/* Makes a bent net of squares. Each square consists of two triangles. */
void open_net(struct language *draw)
{
    enum { NET = 3, POINTS = NET * NET };
    write_text(draw, "mesh2 {\nvertex_vectors { %d,\n", POINTS);
    for (int i = 0; i < POINTS; i++)
        write_text(draw, "<%.4f, %.4f, ^4-.4:.4^>%s\n", .7 * (i % NET - 1),
                   .7 * (i / NET - 1), i + 1 < POINTS ? "," : "");
    write_text(draw, "}\n");
    if (one_in(&draw->state, 2)) {
        write_text(draw, "normal_vectors { %d,\n", POINTS);
        for (int i = 0; i < POINTS; i++)
            write_text(draw, "<^3-.7:.7^, ^3-.7:.7^, -^3.5:1^>%s\n",
                       i + 1 < POINTS ? "," : "");
        write_text(draw, "}\n");
    }
    write_text(draw, "face_indices { %d,\n", 2 * (NET - 1) * (NET - 1));
    for (int i = 0; i < NET - 1; i++)
        for (int j = 0; j < NET - 1; j++) {
            int at = i * NET + j;
            write_text(draw, "<%d, %d, %d>, <%d, %d, %d>%s\n", at, at + 1, at + NET + 1,
                       at + NET + 1, at + NET, at, i + j < 2 * NET - 4 ? "," : "");
        }
    write_text(draw, "}\n");
}

void open_bicubic(struct language *draw)
{
    size_t steps = 1 + below(&draw->state, 3), across = 1 + below(&draw->state, 3);
    const char *flat = one_in(&draw->state, 2) ? "0" : ".05";
    write_text(draw,
               "bicubic_patch {\ntype ^#0:2^ flatness %s u_steps %zu v_steps %zu\n",
               flat, steps, across);
    for (int i = 0; i < 16; i++)
        write_text(draw, "<%.4f, %.4f, ^4-.6:.6^>%s", .55 * (i % 4 - 1.5),
                   .55 * (i / 4 - 1.5),
                   i % 4 < 3 ? ", "
                   : i < 15  ? ", \n"
                             : "\n");
}
