/* placed_solid.c - random shapes of every kind, random finishes, and CSG trees of such
 * shapes at a place (placed_solid.h). */
#include "tests/oracle/placed_solid.h"

#include "tests/oracle/solid_text.h"

#include "tests/oracle/chance.h"

void place_make_short(struct place *place)
{
    double grain = pow(10, floor(log10(place->size)) - 2);
    for (int i = 0; i < 3; i++)
        place->at[i] = grain * round(place->at[i] / grain);
    place->size = grain * round(place->size / grain);
}

/* ---- Shapes -------------------------------------------------------------- */

typedef void random_shape(uint64_t *state, const struct place *place,
                          struct solid *solid);
#define SHAPE_AT(name) \
    static void name(uint64_t *state, const struct place *place, struct solid *solid)

SHAPE_AT(random_sphere)
{
    double x = place->at[0], y = place->at[1], z = place->at[2];
    if (one_in(state, 8)) {
        solid_words(solid->shape, "sphere { 0, 1 ");
        solid_words(solid->motion,
                    "scale <%.12g, %.12g, %.12g> translate <%.12g, %.12g, %.12g> ",
                    place->size / (double)(1 + below(state, 4)), place->size,
                    place->size, x, y, z);
    } else {
        solid_words(solid->shape, "sphere { <%.12g, %.12g, %.12g>, %.12g ", x, y, z,
                    place->size);
    }
}

SHAPE_AT(random_box)
{
    double x = place->at[0], y = place->at[1], z = place->at[2];
    double s = place->size;
    if (one_in(state, 4)) {
        solid_words(solid->shape, "box { -%.12g, %.12g ", s, s);
        solid_words(solid->motion, "rotate %d*%c translate <%.12g, %.12g, %.12g> ",
                    15 * (int)below(state, 24), "xyz"[below(state, 3)], x, y, z);
    } else {
        solid_words(solid->shape, "box { <%.12g, %.12g, %.12g>, <%.12g, %.12g, %.12g> ",
                    x - s, y - s, z - s, x + s, y + s, z + s);
    }
}

/* Prints a cone or cylinder along an axis: ends, radii and optionally `open`. */
static void print_axis(uint64_t *state, const struct place *place, struct solid *solid,
                       bool cone)
{
    double base[3], cap[3], s = place->size;
    size_t along = below(state, 3);
    for (size_t i = 0; i < 3; i++) {
        base[i] = place->at[i] - (i == along ? s : 0);
        cap[i] = place->at[i] + (i == along ? s : 0);
    }
    const char *open = one_in(state, 4) ? "open " : "";
    if (cone)
        solid_words(
            solid->shape,
            "cone { <%.12g, %.12g, %.12g>, %.12g, <%.12g, %.12g, %.12g>, %.12g %s",
            base[0], base[1], base[2], s, cap[0], cap[1], cap[2],
            one_in(state, 2) ? 0 : s / 2, open);
    else
        solid_words(solid->shape,
                    "cylinder { <%.12g, %.12g, %.12g>, <%.12g, %.12g, %.12g>, %.12g %s",
                    base[0], base[1], base[2], cap[0], cap[1], cap[2], s, open);
}

SHAPE_AT(random_cylinder)
{
    print_axis(state, place, solid, false);
}

SHAPE_AT(random_cone)
{
    print_axis(state, place, solid, true);
}

/* Moves a shape that was generated at the origin to the place. */
static void move_to(uint64_t *state, const struct place *place, struct solid *solid)
{
    solid_words(solid->motion,
                "scale %.12g rotate <%d, %d, 0> translate <%.12g, %.12g, %.12g> ",
                place->size, 30 * (int)below(state, 12), 90 * (int)below(state, 4),
                place->at[0], place->at[1], place->at[2]);
}

/* Makes a spool or an open surface. */
static void random_lathe(uint64_t *state, struct solid *solid)
{
    double radius = .1 * (double)(1 + below(state, 6));
    double height = .1 * (double)below(state, 8) - .3;
    if (one_in(state, 3))
        solid_words(solid->shape, "lathe { 3, <.9, -.8>, <%.12g, %.12g>, <.7, .9> ",
                    radius, height);
    else
        solid_words(solid->shape,
                    "lathe { 6, <0, -1>, <1, -1>, <%.12g, %.12g>, <1, 1>, "
                    "<.4, 1>, <0, %.12g> ",
                    radius, height, height + .1);
}

/* Makes a torus or a lathe. */
SHAPE_AT(random_torus)
{
    uint64_t other = stream_beside(*state, 5, 1);
    double minor = .1 + .1 * (double)below(state, 4);
    if (one_in(&other, 2))
        random_lathe(&other, solid);
    else
        solid_words(solid->shape, "torus { .75, %.12g ", minor);
    move_to(state, place, solid);
}

/* Makes a prism. Half of the prisms have quadratic splines. */
SHAPE_AT(random_prism)
{
    uint64_t other = stream_beside(*state, 5, 1);
    solid_words(solid->shape,
                "prism { %s, <-1, -1>, <1, -1>, <1, 1>, <%.12g, 0>, <-1, -1> ",
                one_in(&other, 2) ? "quadratic_spline -.5, .5, 6, <0, .4>"
                                  : "-.5, .5, 5",
                .1 * (double)below(state, 9) - .4);
    move_to(state, place, solid);
}

SHAPE_AT(random_patch)
{
    solid_words(solid->shape,
                "steiner_patch { <-1, -1, 0>, <0, 1, 0>, <1, -1, 0>, "
                "<-.5, 0, %.12g>, <.5, 0, .5>, <0, -1, -.4> ",
                .1 * (double)below(state, 9) - .4);
    move_to(state, place, solid);
}

/* Makes a cone, a sphere, an open cylinder or the outside of a hyperboloid. */
SHAPE_AT(random_quadric)
{
    static const char *const quadrics[] = { "<1, -1, 1>, 0, 0, 0",
                                            "<1, 1, 1>, 0, 0, -1",
                                            "<1, 0, 1>, 0, 0, -1",
                                            "<-1, 1, -1>, 0, 0, .25" };
    solid_words(solid->shape, "quadric { %s ", quadrics[below(state, 4)]);
    move_to(state, place, solid);
}

SHAPE_AT(random_plane)
{
    size_t axis = below(state, 3);
    bool below_it = one_in(state, 2);
    solid_words(solid->shape, "plane { %s%c, %.12g ", below_it ? "" : "-", "xyz"[axis],
                below_it ? place->at[axis] - place->size
                         : -place->at[axis] - place->size);
}

/* Replaces one shape in 15 by a blob. The random numbers of the replaced shape are used
 * nevertheless, so that the rest of the scene does not change. */
SHAPE_AT(random_blob)
{
    uint64_t own = stream_beside(*state, 7, 3);
    if (!one_in(&own, 15))
        return;
    solid_words(solid->shape,
                "blob { threshold .%zu sphere { <-.4, 0, %.12g>, .8, 1 } "
                "cylinder { <.3, -.4, 0>, <.3, .5, 0>, .%zu, 1 } "
                "sphere { <0, %.12g, 0>, .6, %s.8 } ",
                1 + below(&own, 6), .1 * (double)below(&own, 9) - .4,
                3 + below(&own, 5), .1 * (double)below(&own, 9) - .4,
                one_in(&own, 2) ? "-" : "");
    move_to(&own, place, solid);
}

static struct solid *shape_at(uint64_t *state, const struct place *place)
{
    static random_shape *const shapes[] = {
        random_sphere,   random_sphere, random_sphere, random_sphere,
        random_sphere,   random_box,    random_box,    random_box,
        random_cylinder, random_cone,   random_torus,  random_prism,
    };
    struct solid *solid = solid_new(SHAPE, 0);
    uint64_t own = *state; /* no other choice depends on this state */
    if (one_in(state, 60)) /* the layout of a patch is slow */
        random_patch(state, place, solid);
    else
        shapes[below(state, sizeof shapes / sizeof *shapes)](state, place, solid);
    if (own % 12 == 0) {
        (own % 48 ? mesh_star_words : mesh_field_words)(own, solid->shape);
        solid->motion[0] = '\0';
        move_to(&own, place, solid);
    } else {
        random_blob(state, place, solid);
    }
    return solid;
}

/* Makes a pyramid with an open front, a random top and one smooth side, or a closed
 * body. No other random number depends on this choice. */
struct solid *mesh_at(uint64_t *state, const struct place *place)
{
    struct solid *solid = solid_new(SHAPE, 0);
    uint64_t own = *state;
    double x = .25 * (double)below(state, 9) - 1;
    double z = .25 * (double)below(state, 9) - 1;
    solid_words(solid->shape,
                "mesh { triangle { -x, x, <%.12g, 1, %.12g> } "
                "triangle { -x, z, <%.12g, 1, %.12g> } smooth_triangle { "
                "x, <1, 1, 0>, z, <0, 1, 1>, <%.12g, 1, %.12g>, y } ",
                x, z, x, z, x, z);
    if (own % 3 == 0)
        mesh_star_words(own, solid->shape);
    move_to(state, place, solid);
    return solid;
}

struct solid *endless_at(uint64_t *state, const struct place *place)
{
    struct solid *solid = solid_new(SHAPE, 0);
    switch (below(state, 3)) {
    case 0: random_quadric(state, place, solid); break;
    case 1:
        random_sphere(state, place, solid);
        solid->inverse = true;
        break;
    default: random_plane(state, place, solid); break;
    }
    return solid;
}

/* ---- Materials ----------------------------------------------------------- */

void random_look(uint64_t *state, enum mood mood, char *look)
{
    static const char *const inside[] = { "", "", "interior { ior 1.3 } ",
                                          "interior { ior .8 } " };
    static const char *const finishes[] = { "",
                                            "",
                                            "finish { phong .6 } ",
                                            "finish { specular .5 } ",
                                            "finish { reflection .4 } ",
                                            "finish { reflection <.9, .2, .5> } " };
    double red = between(state, 0, 1), green = between(state, 0, 1);
    double blue = between(state, 0, 1);
    static const char *const hidden[] = { "no_shadow ", "no_shadow ", "no_image ",
                                          "no_reflection ", "no_image no_reflection " };
    const char *shadow = one_in(state, 5) ? hidden[below(state, 5)] : "";
    const char *finish = finishes[below(state, mood == DULL ? 4 : 6)];
    if (mood == CLEAR || (mood == MIXED && one_in(state, 4)))
        solid_words(look, "pigment { rgbft <%.2f, %.2f, %.2f, %.2f, %.2f> } %s%s%s",
                    red, green, blue, .3 * (double)below(state, 3),
                    .2 * (double)below(state, 3), inside[below(state, 4)], finish,
                    shadow);
    else if (one_in(state, 8))
        solid_words(look,
                    "pigment { checker rgb <%.2f, %.2f, %.2f>, rgb .9 scale .37 } %s",
                    red, green, blue, shadow);
    else
        solid_words(look, "pigment { rgb <%.2f, %.2f, %.2f> } %s%s", red, green, blue,
                    finish, shadow);
}

/* ---- Solids -------------------------------------------------------------- */

enum solid_joining random_joining(uint64_t *state)
{
    return one_in(state, 8) ? UNION : MERGE + (enum solid_joining)below(state, 3);
}

static struct place near_to(uint64_t *state, const struct place *place)
{
    struct place other = *place;
    for (int i = 0; i < 3; i++)
        other.at[i] += place->size
                       * (place->whole ? .25 * (double)below(state, 5) - .5
                                       : between(state, -.5, .5));
    other.size *= one_in(state, 2) ? .5 : between(state, .4, 1.1);
    place_make_short(&other);
    return other;
}

struct solid *solid_at(uint64_t *state, const struct place *place, enum mood mood,
                       int depth)
{
    if (depth == 0 || !one_in(state, 4))
        return shape_at(state, place);
    struct solid *solid = solid_new(random_joining(state), 2 + below(state, 2));
    for (size_t i = 0; i < solid->count; i++) {
        struct place part = i ? near_to(state, place) : *place;
        solid->parts[i] = solid_at(state, &part, mood, depth - 1);
        if (one_in(state, 3))
            random_look(state, mood, solid->parts[i]->look);
    }
    return solid;
}
