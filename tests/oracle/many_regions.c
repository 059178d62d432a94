/* many_regions.c - generates random scenes of many regions. */
#include "tests/oracle/random_scenes.h"

#include "tests/oracle/solid_text.h"
#include "tests/oracle/chance.h"
#include "tests/oracle/placed_solid.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_LAMPS = 3, MAX_GROUPS = 3, MAX_JOINED = 24, WORDS = SOLID_WORDS };

struct regions {
    size_t width, height;
    char settings[WORDS], view[WORDS];
    size_t lamp_count, solid_count;
    char lamps[MAX_LAMPS][WORDS];
    struct solid *solids[MAX_MANY_REGIONS];
    int levels;
    enum mood mood;
    enum certainty certainty;
};

struct drawing {
    uint64_t *state;
    struct regions *scene;
    struct place places[MAX_MANY_REGIONS]; /* places of the scene's solids */
    bool whole;                            /* coordinates are integers */
    bool endless;                          /* some objects are unbounded */
};

/* ---- Groups -------------------------------------------------------------- */

/* The properties of a group, and the function that places its members. */
struct group {
    size_t count, side; /* side: side length of a lattice, in objects */
    double centre[3], spread, size;
    bool same, endless, scattered;
    void (*place)(uint64_t *state, const struct group *group, size_t i,
                  struct place *place);
};

static void about(uint64_t *state, const double centre[3], double spread, double at[3])
{
    for (int i = 0; i < 3; i++)
        at[i] = centre[i] + between(state, -spread, spread);
}

#define PLACE(name) \
    static void name(uint64_t *state UNUSED, const struct group *group, \
                     size_t i UNUSED, struct place *place)

PLACE(in_cloud)
{
    about(state, group->centre, group->spread, place->at);
    place->size = of_any_size(state, .05, .7) * group->spread
                  / cbrt((double)group->count);
}

/* Places clusters at the corners of a cube. */
PLACE(in_clusters)
{
    double centre[3];
    for (int axis = 0; axis < 3; axis++)
        centre[axis] = group->centre[axis] + (i >> axis & 1 ? 1 : -1) * group->spread;
    about(state, centre, .1 * group->spread, place->at);
    place->size = of_any_size(state, .02, .2) * group->spread
                  / cbrt((double)group->count);
}

PLACE(in_row)
{
    memcpy(place->at, group->centre, sizeof place->at);
    place->at[group->side % 3] += (double)i - (double)(group->count / 2);
    place->size = group->size;
}

PLACE(in_lattice)
{
    for (int axis = 0; axis < 3; axis++, i /= group->side)
        place->at[axis] = group->centre[axis] + (double)(i % group->side)
                          - (double)(group->side / 2);
    place->size = group->size;
}

PLACE(in_one_point)
{
    memcpy(place->at, group->centre, sizeof place->at);
    place->size = of_any_size(state, .05, 1) * group->spread;
}

PLACE(nested)
{
    in_one_point(state, group, i, place);
    place->size = group->spread * (double)(i + 1) / (double)group->count;
}

PLACE(tiny_and_huge)
{
    double far = of_any_size(state, 1e-2, 1e4);
    about(state, group->centre, far, place->at);
    place->size = of_any_size(state, 1e-4, .4) * far;
}

static void random_group(uint64_t *state, bool whole, struct group *group)
{
    static void (*const places[])(uint64_t *, const struct group *, size_t,
                                  struct place *) = {
        in_cloud, in_cloud,     in_clusters,   in_clusters, in_row,     in_row,
        nested,   in_one_point, tiny_and_huge, in_lattice,  in_lattice,
    };
    for (int i = 0; i < 3; i++)
        group->centre[i] = whole ? (double)below(state, 5) - 2 : between(state, -2, 2);
    group->place = places[below(state, sizeof places / sizeof *places)];
    group->spread = whole ? 2 : of_any_size(state, .5, 8);
    group->size = one_in(state, 2) ? .5 : between(state, .2, .7);
    group->side = 1 + below(state, 7);
    group->same = one_in(state, 10);
    group->endless = one_in(state, 30);
    group->scattered = group->place == in_cloud || group->place == in_clusters
                       || group->place == tiny_and_huge;
}

static struct solid *copy_of_one(struct drawing *drawing, size_t count)
{
    size_t i = below(drawing->state, count);
    drawing->places[count] = drawing->places[i];
    return solid_copy(drawing->scene->solids[i]);
}

/* Adds a solid. A copy of an existing object has exactly the same position. */
static void add_solid(struct drawing *drawing, const struct group *group, size_t i)
{
    uint64_t *state = drawing->state;
    struct regions *scene = drawing->scene;
    size_t count = scene->solid_count++;
    struct place *place = &drawing->places[count];
    struct solid *solid;
    group->place(state, group, i, place);
    place->whole = drawing->whole;
    place_make_short(place);
    if (count > 0 && ((group->same && i > 0) || one_in(state, 24)))
        solid = copy_of_one(drawing, count);
    else if (group->endless || (drawing->endless && one_in(state, 20)))
        solid = endless_at(state, place);
    else if (one_in(state, 16))
        solid = mesh_at(state, place);
    else
        solid = solid_at(state, place, scene->mood, 2);
    random_look(state, scene->mood, solid->look);
    bump_words(*state, 8, solid->look);
    scene->solids[count] = solid;
}

static void add_groups(struct drawing *drawing, size_t count)
{
    uint64_t *state = drawing->state;
    size_t groups = 1 + below(state, MAX_GROUPS);
    for (size_t i = 0; i < groups; i++) {
        struct group group = { .count = (count + i) / groups };
        random_group(state, drawing->whole, &group);
        if (!group.scattered)
            drawing->scene->certainty = DEPTH_CERTAIN;
        for (size_t k = 0; k < group.count; k++)
            add_solid(drawing, &group, k);
    }
}

/* Adds a plane that contains the bottoms of objects with integer coordinates. The other
 * random choices do not depend on it. */
static void add_ground(struct drawing *drawing)
{
    uint64_t state = stream_beside(*drawing->state, 7, 1);
    struct regions *scene = drawing->scene;
    if (!drawing->whole || below(&state, 3) || scene->solid_count == MAX_MANY_REGIONS)
        return;
    struct solid *ground = solid_new(SHAPE, 0);
    solid_words(ground->shape, "plane { y, %g ", (double)below(&state, 5) - 2.5);
    random_look(&state, scene->mood, ground->look);
    drawing->places[scene->solid_count] = (struct place){ .size = 1 };
    scene->solids[scene->solid_count++] = ground;
}

/* Joins some or all objects of the scene to one solid. */
static void join_some(struct drawing *drawing)
{
    struct regions *scene = drawing->scene;
    bool all = one_in(drawing->state, 3) || scene->solid_count < MAX_JOINED;
    size_t most = all ? scene->solid_count : MAX_JOINED;
    size_t count = 1 + below(drawing->state, most);
    enum solid_joining joining = random_joining(drawing->state);
    struct solid *whole = solid_new(joining, count);
    size_t first = scene->solid_count -= count;
    for (size_t i = 0; i < count; i++)
        whole->parts[i] = scene->solids[first + i];
    scene->solids[scene->solid_count++] = whole;
}

/* ---- Cameras and lights -------------------------------------------------- */

/* Returns the position of a random object. */
static struct place some_place(const struct drawing *drawing)
{
    size_t count = drawing->scene->solid_count;
    if (count == 0)
        return (struct place){ .size = 1 };
    return drawing->places[below(drawing->state, count)];
}

/* Returns the midpoint between two objects, and their distance as the size. */
static struct place whole_place(const struct drawing *drawing)
{
    struct place a = some_place(drawing), b = some_place(drawing);
    double far = 0;
    for (int i = 0; i < 3; i++) {
        far += fabs(a.at[i] - b.at[i]);
        a.at[i] = (a.at[i] + b.at[i]) / 2;
    }
    a.size = fmax(a.size, far);
    return a;
}

static void look_from_afar(const struct drawing *drawing)
{
    uint64_t *state = drawing->state;
    struct place place = one_in(state, 4) ? some_place(drawing) : whole_place(drawing);
    double far = fmax(place.size * between(state, 1.2, 4), 1e-3);
    bool parallel = *state % 6 == 0; /* no other choice depends on this choice */
    solid_words(drawing->scene->view,
                "%slocation <%.12g, %.12g, %.12g> "
                "look_at <%.12g, %.12g, %.12g> right x*%zu/%zu angle %.2f",
                parallel ? "orthographic " : "",
                place.at[0] + far * between(state, -1, 1),
                place.at[1] + far * between(state, -.6, 1),
                place.at[2] - far * between(state, .7, 1.2), place.at[0] + .0131 * far,
                place.at[1] + .0171 * far, place.at[2], drawing->scene->width,
                drawing->scene->height, between(state, 15, 70));
}

/* Directs the camera along an axis, so that rays are parallel to faces. */
static void look_along_an_axis(const struct drawing *drawing)
{
    uint64_t *state = drawing->state;
    drawing->scene->certainty = NOTHING_CERTAIN;
    solid_words(drawing->scene->view,
                "location <%.12g, %.12g, %.12g> direction %d*z right %zu*x up %zu*y",
                .5 * (double)below(state, 9) - 2, .5 * (double)below(state, 9) - 2,
                -.5 * (double)below(state, 20), 4 << below(state, 5),
                drawing->scene->width, drawing->scene->height);
}

static void look_from_within(const struct drawing *drawing)
{
    struct place from = some_place(drawing), to = some_place(drawing);
    drawing->scene->certainty = NOTHING_CERTAIN;
    solid_words(drawing->scene->view,
                "location <%.12g, %.12g, %.12g> look_at <%.12g, %.12g, %.12g> "
                "right x*%zu/%zu angle %.2f",
                from.at[0], from.at[1], from.at[2], to.at[0] + .1, to.at[1] + .01,
                to.at[2] + 1, drawing->scene->width, drawing->scene->height,
                between(drawing->state, 20, 120));
}

static void random_view(const struct drawing *drawing)
{
    switch (below(drawing->state, 8)) {
    case 0: look_along_an_axis(drawing); break;
    case 1: look_from_within(drawing); break;
    default: look_from_afar(drawing); break;
    }
}

static void random_lamp(const struct drawing *drawing, char *lamp)
{
    uint64_t *state = drawing->state;
    struct place place = some_place(drawing);
    const char *shadowless = one_in(state, 6) ? "shadowless " : "";
    double far = one_in(state, 4) ? 0 : 4 * place.size + 2;
    if (one_in(state, 3))
        far = 20;
    char beam[SOLID_WORDS];
    double at[3], bright = between(state, .3, .9);
    at[2] = place.at[2] - far * between(state, -.3, 1);
    at[1] = place.at[1] + far * between(state, 0, 1);
    at[0] = place.at[0] + far * between(state, -1, 1);
    beam_words(*state, at, place.size + 1, beam);
    solid_words(lamp, "light_source { <%.6g, %.6g, %.6g>, rgb %.2f %s%.250s}", at[0],
                at[1], at[2], bright, shadowless, beam);
}

/* Adds fog to one scene in six. Its depth is similar to the depth of the scene. The
 * other random choices do not depend on it. */
static void random_fog(uint64_t state, char *fog)
{
    state = stream_beside(state, 5, 1);
    if (below(&state, 6))
        return;
    double red = between(&state, 0, 1), green = between(&state, 0, 1);
    double filter = one_in(&state, 2) ? between(&state, 0, 1) : 0;
    double transmit = one_in(&state, 2) ? between(&state, 0, .5) : 0;
    solid_words(fog, "fog { distance %.3f color rgbft <%.2f, %.2f, .7, %.2f, %.2f> }",
                pow(10, between(&state, -1, 3)), red, green, filter, transmit);
}

static void random_settings(const struct drawing *drawing)
{
    static const char *const bailouts[] = { "", "", "adc_bailout 0 ",
                                            "adc_bailout .2 " };
    struct regions *scene = drawing->scene;
    char fog[WORDS] = "";
    random_fog(*drawing->state, fog);
    scene->levels = 1 + (int)below(drawing->state, 5);
    solid_words(scene->settings,
                "global_settings { assumed_gamma 1 max_trace_level %d %s} %.200s",
                scene->levels, bailouts[below(drawing->state, 4)], fog);
}

/* ---- Scenes -------------------------------------------------------------- */

static size_t leaves(const struct solid *solid)
{
    size_t sum = solid->joining == SHAPE;
    for (size_t i = 0; i < solid->count; i++)
        sum += leaves(solid->parts[i]);
    return sum;
}

static double work_of(const struct regions *scene)
{
    double rays = (double)(1 + scene->lamp_count), all = 4;
    if (scene->mood != DULL)
        rays *= scene->mood == MIXED ? 1 + .3 * scene->levels : scene->levels;
    for (size_t i = 0; i < scene->solid_count; i++)
        all += (double)leaves(scene->solids[i]);
    return rays * all * (double)(scene->width * scene->height);
}

static void random_size(const struct drawing *drawing)
{
    struct regions *scene = drawing->scene;
    scene->width = 1 + below(drawing->state, 40);
    scene->height = 1 + below(drawing->state, 30);
    while (work_of(scene) > 150000 && (scene->width > 4 || scene->height > 4)) {
        scene->width = 1 + scene->width * 3 / 4;
        scene->height = 1 + scene->height * 3 / 4;
    }
}

static size_t random_count(uint64_t *state)
{
    if (one_in(state, 8))
        return below(state, 2);
    return (size_t)of_any_size(state, 2, MAX_MANY_REGIONS + .5);
}

static void draw_scene(uint64_t *state, struct regions *scene)
{
    FREED struct drawing *drawing = test_room(sizeof *drawing);
    *state = stream_beside(*state, 1, 0);
    drawing->state = state;
    drawing->scene = scene;
    drawing->whole = one_in(state, 3);
    drawing->endless = one_in(state, 5);
    scene->certainty = drawing->whole ? DEPTH_CERTAIN : ALL_CERTAIN;
    scene->mood = (enum mood)below(state, MOODS);
    add_groups(drawing, random_count(state));
    random_settings(drawing);
    scene->lamp_count = below(state, MAX_LAMPS + 1);
    for (size_t i = 0; i < scene->lamp_count; i++)
        random_lamp(drawing, scene->lamps[i]);
    random_size(drawing);
    random_view(drawing);
    if (scene->solid_count > 0 && one_in(state, 6))
        join_some(drawing);
    add_ground(drawing);
}

struct random_scene many_regions(uint64_t *state)
{
    FREED struct regions *scene = test_room(sizeof *scene);
    draw_scene(state, scene);
    struct random_scene made = {
        .text = solids_text(scene->settings, scene->view, scene->lamps,
                            scene->lamp_count, scene->solids, scene->solid_count, 1),
        .width = scene->width,
        .height = scene->height,
        .certainty = scene->certainty,
        .work = work_of(scene)
    };
    for (size_t i = 0; i < scene->solid_count; i++)
        solid_free(scene->solids[i]);
    return made;
}
