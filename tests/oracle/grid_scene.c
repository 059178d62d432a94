/* grid_scene.c - generates random scenes on a coarse grid. */
#include "tests/oracle/random_scenes.h"

#include "tests/oracle/chance.h"
#include "tests/oracle/solid_text.h"

#include <stdio.h>
#include <stdlib.h>

enum { MAX_PARTS = 3, MAX_SOLIDS = 2, MAX_LAMPS = 2, DEPTH = 4, WORDS = SOLID_WORDS };

struct grid {
    char view[WORDS];
    bool aslant;
    double scale; /* scale of everything except the lamps */
    size_t lamp_count, solid_count;
    char lamps[MAX_LAMPS][WORDS];
    struct solid *solids[MAX_SOLIDS + 1]; /* the solids, then the ground */
};

/* ---- Random cases -------------------------------------------------------- */

static double on_grid(uint64_t *state)
{
    return .5 * (double)below(state, 5) - 1;
}

/* Returns a grid coordinate that differs from `place`. */
static double off(uint64_t *state, double place)
{
    double other = on_grid(state);
    while (other == place)
        other = on_grid(state);
    return other;
}

static double size_on_grid(uint64_t *state)
{
    return below(state, 2) ? 1 : .5;
}

/* ---- Shapes -------------------------------------------------------------- */

static void random_box(uint64_t *state, char *shape)
{
    double low[3], high[3];
    for (int i = 0; i < 3; i++) {
        low[i] = on_grid(state);
        high[i] = off(state, low[i]);
    }
    solid_words(shape, "box { <%g, %g, %g>, <%g, %g, %g> ", low[0], low[1], low[2],
                high[0], high[1], high[2]);
}

static void random_sphere(uint64_t *state, char *shape)
{
    double x = on_grid(state), y = on_grid(state), z = on_grid(state);
    solid_words(shape, "sphere { <%g, %g, %g>, %g ", x, y, z, size_on_grid(state));
}

/* Makes an axis from base to cap, parallel to a coordinate axis. */
static void random_axis(uint64_t *state, double base[3], double cap[3])
{
    size_t along = below(state, 3);
    for (int i = 0; i < 3; i++)
        cap[i] = base[i] = on_grid(state);
    cap[along] = off(state, base[along]);
}

static void random_cylinder(uint64_t *state, char *shape)
{
    double base[3], cap[3], radius = size_on_grid(state);
    random_axis(state, base, cap);
    solid_words(shape, "cylinder { <%g, %g, %g>, <%g, %g, %g>, %g %s", base[0], base[1],
                base[2], cap[0], cap[1], cap[2], radius,
                below(state, 4) ? "" : "open ");
}

static void random_cone(uint64_t *state, char *shape)
{
    double base[3], cap[3], radius = .5 * (double)below(state, 3);
    double other = radius == .5 ? 1 : 1 - radius;
    random_axis(state, base, cap);
    solid_words(shape, "cone { <%g, %g, %g>, %g, <%g, %g, %g>, %g %s", base[0], base[1],
                base[2], radius, cap[0], cap[1], cap[2], other,
                below(state, 4) ? "" : "open ");
}

static void random_plane(uint64_t *state, char *shape)
{
    char axis = "xyz"[below(state, 3)];
    solid_words(shape, "plane { %s%c, %g ", below(state, 2) ? "-" : "", axis,
                on_grid(state));
}

/* Makes a disc in the plane of a face of a box. */
static void random_disc(uint64_t *state, char *shape)
{
    char axis = "xyz"[below(state, 3)];
    double center[3];
    for (int i = 0; i < 3; i++)
        center[i] = on_grid(state);
    solid_words(shape, "disc { <%g, %g, %g>, %s%c, %g ", center[0], center[1],
                center[2], below(state, 2) ? "-" : "", axis, size_on_grid(state));
}

static void random_torus(uint64_t *state, char *shape)
{
    double major = size_on_grid(state);
    if (below(state, 4))
        solid_words(shape, "torus { %g, %g ", major, size_on_grid(state) / 2);
    else
        solid_words(shape, "elliptical_torus { %g, %g, %g ", major,
                    size_on_grid(state) / 2, size_on_grid(state));
}

/* Makes a cylinder, slab, cone, ball, half space, or the outside of a hyperboloid. */
static void random_quadric(uint64_t *state, char *shape)
{
    static const char *const quadrics[] = {
        "<1, 0, 1>, 0, 0, -1",   "<0, 1, 0>, 0, 0, -.25", "<1, -1, 1>, 0, 0, 0",
        "<1, 1, 1>, 0, 0, -1",   "0, 0, <0, 0, 1>, -.5",  "<-1, 1, -1>, 0, 0, .25",
        "<1, 1, 1>, 0, 0, -.25",
    };
    size_t which = below(state, sizeof quadrics / sizeof *quadrics);
    solid_words(shape, "quadric { %s ", quadrics[which]);
}

/* Makes x^4 + y^4 + z^4 = 1. */
static void random_quartic(uint64_t *state UNUSED, char *shape)
{
    solid_words(shape, "quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,"
                       "0,0,0,0,0,0,1,0,0,0,-1> ");
}

/* Makes a flat patch in a plane of the grid, or a curved patch. */
static void random_patch(uint64_t *state, char *shape)
{
    double z = on_grid(state), bend = below(state, 2) ? .5 : 0;
    solid_words(shape,
                "steiner_patch { <-1, -1, %g>, <0, 1, %g>, <1, -1, %g>, "
                "<-.5, 0, %g>, <.5, 0, %g>, <0, -1, %g> ",
                z, z, z, z + bend, z + bend, z - bend);
}

/* Boxes and cylinders are more frequent, because whole faces of them can coincide. */
static void random_shape(uint64_t *state, char *shape)
{
    static void (*const shapes[])(uint64_t *, char *) = {
        random_box,    random_box,      random_box,      random_box,      random_box,
        random_box,    random_cylinder, random_cylinder, random_cylinder, random_sphere,
        random_sphere, random_cone,     random_cone,     random_plane,    random_plane,
        random_torus,  random_quadric,  random_quadric,  random_quartic,  random_patch,
        random_patch,  random_disc,
    };
    shapes[below(state, sizeof shapes / sizeof *shapes)](state, shape);
}

/* ---- Materials and transforms -------------------------------------------- */

static void random_look(uint64_t *state, char *look)
{
    static const char *const looks[] = {
        "pigment { rgbt <%.2f, %.2f, %.2f, .6> } interior { ior 1.3 } ",
        "pigment { rgbf <%.2f, %.2f, %.2f, .8> } ",
        "pigment { rgb <%.2f, %.2f, %.2f> } finish { reflection .4 } ",
        "pigment { checker rgb <%.2f, %.2f, %.2f>, rgb .9 scale .5 } finish { phong .5 } ",
        "pigment { rgb <%.2f, %.2f, %.2f> } ",
    };
    double red = between(state, 0, 1), green = between(state, 0, 1);
    double blue = between(state, 0, 1);
    size_t which = below(state, 8);
    solid_words(look, looks[which < 4 ? which : 4], red, green, blue);
}

static void random_motion(uint64_t *state, char *motion)
{
    char turn[WORDS] = "", shift[WORDS] = "";
    if (below(state, 2))
        solid_words(turn, "rotate <%d, %d, %d> ", 90 * (int)below(state, 4),
                    90 * (int)below(state, 4), 90 * (int)below(state, 4));
    if (below(state, 4) == 0)
        solid_words(shift, "translate <%g, %g, %g> ", on_grid(state) / 2,
                    on_grid(state) / 2, on_grid(state) / 2);
    solid_words(motion, "%.120s%.120s", turn, shift);
}

/* ---- Solids -------------------------------------------------------------- */

static struct solid *random_joining(uint64_t *state)
{
    enum solid_joining joining = UNION + (enum solid_joining)below(state, 4);
    return solid_new(joining, 2 + below(state, MAX_PARTS - 1));
}

/* Clips one in eight solids. The other random choices do not depend on this choice. */
static struct solid *random_clip(uint64_t state)
{
    static void (*const shapes[])(uint64_t *, char *) = {
        random_box,    random_plane, random_plane,   random_cylinder,
        random_sphere, random_cone,  random_quadric, random_torus,
    };
    state = stream_beside(state, 3, 1);
    if (below(&state, 8))
        return NULL;
    struct solid *clip = solid_new(SHAPE, 0);
    shapes[below(&state, sizeof shapes / sizeof *shapes)](&state, clip->shape);
    random_motion(&state, clip->motion);
    clip->inverse = below(&state, 4) == 0;
    return clip;
}

/* Makes one shape in ten a box of triangles, without changing other random choices. */
static void random_box_mesh(uint64_t state, char *shape)
{
    double corner[2][3];
    shape[0] = '\0';
    if (state % 10)
        return;
    for (int i = 0; i < 3; i++) {
        corner[0][i] = on_grid(&state);
        corner[1][i] = off(&state, corner[0][i]);
    }
    mesh_box_words(state, corner, shape);
}

static struct solid *random_solid(uint64_t *state, size_t depth)
{
    char unused[WORDS];
    bool joined = depth > 0 && below(state, 4);
    struct solid *solid = joined ? random_joining(state) : solid_new(SHAPE, 0);
    if (!joined) {
        random_box_mesh(*state, solid->shape);
        random_shape(state, solid->shape[0] ? unused : solid->shape);
    }
    for (size_t i = 0; i < solid->count; i++)
        solid->parts[i] = i > 0 && below(state, 8) == 0
                              ? solid_copy(solid->parts[i - 1])
                              : random_solid(state, depth - 1);
    if (below(state, 3) == 0 || (depth == 0 && below(state, 2)))
        random_look(state, solid->look);
    bump_words(*state, 4, solid->look);
    random_motion(state, solid->motion);
    solid->inverse = below(state, 12) == 0;
    solid->clip = random_clip(*state);
    return solid;
}

/* Makes three of the four triangles between a square's diagonals, flat or bent. */
static struct solid *random_mesh(uint64_t *state)
{
    struct solid *solid = solid_new(SHAPE, 0);
    double z = on_grid(state), s = size_on_grid(state), up = on_grid(state);
    solid_words(solid->shape,
                "mesh { triangle { <-%g, -%g, %g>, <%g, -%g, %g>, <%g, %g, %g> } "
                "triangle { <-%g, -%g, %g>, <%g, %g, %g>, <-%g, %g, %g> } "
                "triangle { <-%g, %g, %g>, <%g, -%g, %g>, <%g, %g, %g> } ",
                s, s, z, s, s, z, s, s, up, s, s, z, s, s, up, s, s, z, s, s, z, s, s,
                z, s, s, up);
    random_look(state, solid->look);
    random_motion(state, solid->motion);
    return solid;
}

/* ---- Scenes -------------------------------------------------------------- */

static void random_view(uint64_t *state, struct grid *scene)
{
    double s = scene->scale = below(state, 8) ? 1 : 1e-4;
    double x = s * on_grid(state), y = s * on_grid(state);
    double z = s * on_grid(state);
    bool parallel = *state % 8 == 0; /* no other choice depends on this choice */
    size_t which = below(state, 8);
    scene->aslant = which > 2;
    if (which > 2)
        solid_words(scene->view,
                    "%slocation %g*<%.5f, %.5f, -%.5f> look_at %g*<.013, .0171, 0> "
                    "right x*%d/%d angle %.2f",
                    parallel ? "orthographic " : "", s, between(state, -6, 6),
                    between(state, -4, 6), between(state, 5, 9), s, GRID_WIDTH,
                    GRID_HEIGHT, between(state, 20, 40));
    else /* rays start on faces, or run along them */
        solid_words(scene->view,
                    "location <%g, %g, %g> direction %d*z right %d*x up %d*y", x, y,
                    which == 2 ? z : -5 * s, which == 2 ? 14 : 28, GRID_WIDTH,
                    GRID_HEIGHT);
}

static void random_lamp(uint64_t *state, char *lamp)
{
    if (below(state, 4) == 0) {
        double at[3];
        char beam[SOLID_WORDS];
        for (int i = 2; i >= 0; i--)
            at[i] = 3 * on_grid(state);
        beam_words(*state, at, 2, beam);
        solid_words(lamp, "light_source { <%g, %g, %g>, .7%.250s }", at[0], at[1],
                    at[2], beam);
    } else
        solid_words(lamp, "light_source { <%.3f, %.3f, -%.3f>, rgb .8 %s}",
                    between(state, -9, 9), between(state, 2, 12), between(state, 4, 9),
                    below(state, 3) ? "" : "shadowless ");
}

/* Puts the solids of one in three scenes on a ground, and makes them transparent. The
 * other random choices do not depend on this choice. */
static void put_on_ground(uint64_t state, struct grid *scene)
{
    state = stream_beside(state, 7, 1);
    if (below(&state, 3))
        return;
    for (size_t i = 0; i < scene->solid_count; i++)
        solid_words(scene->solids[i]->look,
                    "pigment { rgbf <.9, %.2f, .8, .9> } interior { ior %.2f } ",
                    between(&state, .5, 1), between(&state, 1, 1.6));
    struct solid *ground = solid_new(SHAPE, 0);
    if (below(&state, 2))
        solid_words(ground->shape, "plane { y, %g ", on_grid(&state));
    else
        solid_words(ground->shape, "box { <-2, -2, -2>, <2, %g, 2> ", on_grid(&state));
    random_look(&state, ground->look);
    scene->solids[scene->solid_count++] = ground;
}

static void draw_scene(uint64_t *state, struct grid *scene)
{
    *state = stream_beside(*state, 1, 0);
    random_view(state, scene);
    scene->lamp_count = below(state, MAX_LAMPS + 1);
    for (size_t i = 0; i < scene->lamp_count; i++)
        random_lamp(state, scene->lamps[i]);
    scene->solid_count = 1 + below(state, MAX_SOLIDS);
    for (size_t i = 0; i < scene->solid_count; i++)
        scene->solids[i] = below(state, 10) == 0
                               ? random_mesh(state)
                               : random_solid(state, 1 + below(state, DEPTH));
    put_on_ground(*state, scene);
}

/* --- in another order ----------------------------------------------------- */

static char *text_of(struct grid *scene)
{
    return solids_text("global_settings { assumed_gamma 1 max_trace_level 4 }",
                       scene->view, scene->lamps, scene->lamp_count, scene->solids,
                       scene->solid_count, scene->scale);
}

static void shuffle(struct solid **solids, size_t count, uint64_t *state)
{
    for (size_t i = count; i > 1; i--) {
        struct solid **other = &solids[below(state, i)], *kept = *other;
        *other = solids[i - 1];
        solids[i - 1] = kept;
    }
}

/* Shuffles the subtracted parts of a difference, whose order does not matter. */
static void shuffle_parts(struct solid *solid, uint64_t *state)
{
    size_t kept = solid->joining == DIFFERENCE && solid->count > 0;
    for (size_t i = 0; i < solid->count; i++)
        shuffle_parts(solid->parts[i], state);
    shuffle(solid->parts + kept, solid->count - kept, state);
}

struct random_scene grid_scene(uint64_t *state)
{
    struct grid scene = { .aslant = false };
    struct random_scene made = { .width = GRID_WIDTH, .height = GRID_HEIGHT };
    draw_scene(state, &scene);
    made.text = text_of(&scene);
    for (size_t i = 0; i < scene.solid_count; i++)
        shuffle_parts(scene.solids[i], state);
    shuffle(scene.solids, scene.solid_count, state);
    made.other = text_of(&scene);
    made.certainty = scene.aslant ? DEPTH_CERTAIN : NOTHING_CERTAIN;
    for (size_t i = 0; i < scene.solid_count; i++)
        solid_free(scene.solids[i]);
    return made;
}
