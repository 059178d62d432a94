/* coincident_scene.c - random bodies on a ground or in stacks (random_scenes.h). */
#include "tests/oracle/random_scenes.h"

#include "tests/oracle/chance.h"
#include "tests/oracle/solid_text.h"

enum { WORDS = SOLID_WORDS, MAX_BODIES = 5 };

/* The position of a body, its half width and its height. */
struct stand {
    double x, y, z, size, height;
};

/* Defines a function that prints a shape: half width s, height h, random number r. */
#define SHAPE(name, random, ...) \
    static void name##_words(uint64_t *state, const struct stand *at, char *words) \
    { \
        double s = at->size, h = at->height, r = random; \
        (void)state, (void)h, (void)r; \
        solid_words(words, __VA_ARGS__); \
    }

SHAPE(whole_box, 0, "box { <%.9g, 0, %.9g>, <%.9g, %.9g, %.9g> ", -s, -s, s, h, s)
SHAPE(box, s *between(state, .6, 1), "box { <%.9g, 0, %.9g>, <%.9g, %.9g, %.9g> ", -s,
      -r, s, h, r)
SHAPE(cylinder, 0, "cylinder { 0, %.9g*y, %.9g ", h, s)
SHAPE(sphere, 0, "sphere { %.9g*y, %.9g ", h, s)
SHAPE(torus, 0, "torus { %.9g, %.9g ", .7 * s, .3 * s)
SHAPE(lathe, 0, "lathe { linear_spline 4, <0, 0>, <%.9g, 0>, <%.9g, %.9g>, <0, %.9g> ",
      s, .8 * s, h, h)
SHAPE(disc, (double)below(state, 2), "disc { %.9g*y, y, %.9g ", r *h, s)
SHAPE(tube, between(state, 0, .5), "cylinder { %.9g*y, %.9g*y, %.9g open ", r *h, h, s)
SHAPE(merge, between(state, .3, .6),
      "merge { box { <%.9g, 0, %.9g>, <0, %.9g, %.9g> } cylinder { 0, %.9g*y, %.9g } ",
      -s, -s, h, s, between(state, .5, .9) * h, r *s)
SHAPE(bored, between(state, .3, .8),
      "difference { box { <%.9g, 0, %.9g>, <%.9g, %.9g, %.9g> } "
      "cylinder { -1*y, %.9g*y, %.9g } ",
      -s, -s, s, h, s, h + 1, r *s)
SHAPE(triangle, h *(double)below(state, 2),
      "triangle { <%.9g, %.9g, %.9g>, <%.9g, %.9g, %.9g>, <%.9g, %.9g, 0> ", -s, r, -s,
      s, r, -s, s, r)

static void cone_words(uint64_t *state, const struct stand *at, char *words)
{
    double share = one_in(state, 3) ? 0 : between(state, .2, .8);
    bool upright = share == 0 || one_in(state, 2);
    solid_words(words, "cone { 0, %.9g, %.9g*y, %.9g ",
                upright ? at->size : share * at->size, at->height,
                upright ? share * at->size : at->size);
}

static void prism_words(uint64_t *state, const struct stand *at, char *words)
{
    double s = at->size, u = between(state, .3, 1), v = between(state, .3, 1);
    solid_words(words,
                "prism { 0, %.9g, 5, <%.9g, %.9g>, <%.9g, %.9g>, "
                "<%.9g, %.9g>, <%.9g, %.9g>, <%.9g, %.9g> ",
                at->height, -s, -s * u, s * v, -s, s, s * u, -s * v, s, -s, -s * u);
}

static void mesh_words(uint64_t *state, const struct stand *at, char *words)
{
    double corner[2][3] = { { -at->size, 0, -at->size },
                            { at->size, at->height, at->size } };
    mesh_box_words(*state, corner, words);
}

/* --- scenes --------------------------------------------------------------- */

struct drawing {
    uint64_t state;
    enum coincident_kind kind;
    char motion[WORDS]; /* transform of the whole scene */
    FILE *text;
};

static void (*const shapes[])(uint64_t *, const struct stand *, char *) = {
    box_words,   whole_box_words, cylinder_words, cone_words,     prism_words,
    mesh_words,  merge_words,     bored_words,    sphere_words,   torus_words,
    lathe_words, disc_words,      tube_words,     triangle_words,
};
enum { SHAPES = sizeof shapes / sizeof *shapes, SHAPES_CLEAR = 8 };

static struct stand random_stand(struct drawing *drawing)
{
    uint64_t *state = &drawing->state;
    if (drawing->kind == COINCIDENT_CLEAR)
        return (struct stand){ between(state, -1.5, 1.5), 0, between(state, -1.5, 1.5),
                               between(state, .3, .9), between(state, .2, 1.2) };
    return (struct stand){ (double)below(state, 2) - .5, .5 * (double)below(state, 2),
                           (double)below(state, 2) - .5, .5, .5 };
}

/* Prints a shape, then its look and motion, and closes its block. */
static void put_body(struct drawing *drawing, bool clear)
{
    uint64_t *state = &drawing->state;
    struct stand at = random_stand(drawing);
    double turn = drawing->kind == COINCIDENT_CLEAR ? between(state, 0, 360)
                                                    : 90 * (double)below(state, 4);
    size_t count = drawing->kind == COINCIDENT_OPAQUE ? SHAPES : SHAPES_CLEAR;
    char words[WORDS] = "";
    shapes[below(state, count)](state, &at, words);
    fprintf(drawing->text, "%s pigment { rgb%s <%.2f, %.2f, %.2f%s> } %s", words,
            clear ? "f" : "", between(state, .6, 1), between(state, .6, 1),
            between(state, .6, 1), clear ? ", .9" : "",
            one_in(state, 6) ? "finish { reflection .1 } " : "");
    if (clear && !one_in(state, 4))
        fprintf(drawing->text, "interior { ior %.2f } ", between(state, 1.1, 1.7));
    fprintf(drawing->text, "rotate %.9g*y translate <%.9g, %.9g, %.9g> %s}\n", turn,
            at.x, at.y, at.z, drawing->motion);
}

/* Prints the ground, whose colour changes slowly. */
static void put_ground(struct drawing *drawing, double lift)
{
    uint64_t *state = &drawing->state;
    bool plane = one_in(state, 2);
    bool clear = drawing->kind == COINCIDENT_STACKED && one_in(state, 3);
    fprintf(drawing->text,
            "%s pigment { gradient x color_map { [0 rgb%s <.2, .4, .9%s>] "
            "[1 rgb%s <1, .8, .3%s>] } translate -.5*x scale 60 "
            "rotate 37*y } translate %.9g*y %s}\n",
            plane ? "plane { y, 0" : "box { <-3, -1, -3>, <3, 0, 3>", clear ? "f" : "",
            clear ? ", .8" : "", clear ? "f" : "", clear ? ", .8" : "", lift,
            drawing->motion);
}

static void put_view(struct drawing *drawing)
{
    uint64_t *state = &drawing->state;
    double x = between(state, -4, 4), y = between(state, 2, 6);
    fprintf(drawing->text,
            "#version 3.7;\nglobal_settings { assumed_gamma 1 "
            "max_trace_level 8 }\nbackground { rgb <.3, .4, .6> }\n"
            "camera { location <%.5f, %.5f, %.5f> "
            "look_at <.013, .3171, .021> right x*%d/%d angle %.2f }\n"
            "light_source { <%.3f, 9, -7>, 1 }\n",
            x, y, between(state, -8, -5), COINCIDENT_WIDTH, COINCIDENT_HEIGHT,
            between(state, 18, 40), between(state, -9, 9));
    if (one_in(state, 3))
        solid_words(drawing->motion, "rotate <%.3f, %.3f, %.3f> translate %.5f*y ",
                    between(state, -9, 9), between(state, 0, 360),
                    between(state, -9, 9), between(state, -.5, .5));
}

enum coincident_kind coincident_scene_kind(uint64_t seed)
{
    static const enum coincident_kind kinds[] = {
        COINCIDENT_STACKED, COINCIDENT_OPAQUE, COINCIDENT_CLEAR,
        COINCIDENT_STACKED, COINCIDENT_CLEAR,  COINCIDENT_CLEAR,
    };
    return kinds[stream_beside(seed, 7, 1) % 6];
}

char *coincident_scene_text(uint64_t seed, double lift)
{
    struct drawing drawing = { .state = stream_beside(seed, 1, 0) };
    char *words;
    drawing.kind = coincident_scene_kind(seed);
    drawing.text = test_text(&words);
    put_view(&drawing);
    bool ground_first = one_in(&drawing.state, 2);
    size_t least = drawing.kind == COINCIDENT_CLEAR ? 1 : 3;
    size_t count = least + below(&drawing.state, MAX_BODIES + 1 - least);
    size_t opaque = below(&drawing.state, 2 * MAX_BODIES);
    if (ground_first)
        put_ground(&drawing, lift);
    for (size_t i = 0; i < count; i++)
        put_body(&drawing, drawing.kind == COINCIDENT_CLEAR
                               || (drawing.kind == COINCIDENT_STACKED && i != opaque));
    if (!ground_first)
        put_ground(&drawing, lift);
    fclose(drawing.text);
    return words;
}
