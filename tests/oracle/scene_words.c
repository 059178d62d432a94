/* scene_words.c - random lights, normals and meshes as scene texts (solid_text.h). */
#include "tests/oracle/solid_text.h"

#include "tests/oracle/chance.h"

#include <string.h>

/* ---- Lights -------------------------------------------------------------- */

static void aim(uint64_t *state, const double position[3], double size,
                char words[SOLID_WORDS])
{
    double way[3] = { 0, -1, 0 };
    if (one_in(state, 4)) { /* along an axis */
        size_t axis = below(state, 3);
        way[1] = 0;
        way[axis] = one_in(state, 2) ? 1 : -1;
    } else {
        way[0] = between(state, -.8, .8);
        way[2] = between(state, -.5, .8);
    }
    solid_words(words, " point_at <%.6g, %.6g, %.6g>", position[0] + size * way[0],
                position[1] + size * way[1], position[2] + size * way[2]);
}

static void fade(uint64_t *state, double size, char words[SOLID_WORDS])
{
    words[0] = '\0';
    if (one_in(state, 2))
        return;
    solid_words(words, " fade_distance %.5g fade_power %.3g",
                size * of_any_size(state, .1, 10),
                one_in(state, 2) ? 2 : between(state, .2, 9));
}

/* Prints an axis. Its components may be integers or any numbers. */
static void write_axis(uint64_t *state, double size, char words[SOLID_WORDS])
{
    double axis[3] = { 0, 0, 0 };
    if (one_in(state, 2))
        axis[below(state, 3)] = 2;
    else
        for (int i = 0; i < 3; i++)
            axis[i] = size * between(state, -.6, .6);
    solid_words(words, "<%.5g, %.5g, %.5g>", axis[0], axis[1], axis[2]);
}

static void spread(uint64_t *state, double size, char words[SOLID_WORDS])
{
    char one[SOLID_WORDS], other[SOLID_WORDS];
    write_axis(state, size, one);
    write_axis(state, size, other);
    size_t across = 1 + below(state, 4), down = 1 + below(state, 3);
    bool circular = across > 1 && down > 1 && one_in(state, 3);
    solid_words(words, " area_light %.60s, %.60s, %zu, %zu%s", one, other, across, down,
                circular ? " circular" : "");
}

void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS])
{
    static const char beam[] = "%s%.99s radius %.4g falloff %.4g tightness %.3g%.99s";
    char at[SOLID_WORDS], fading[SOLID_WORDS];
    state = stream_beside(state, 5, 1);
    words[0] = '\0';
    if (one_in(&state, 2)) {
        if (one_in(&state, 4))
            spread(&state, size, words);
        return;
    }
    aim(&state, position, size, at);
    fade(&state, size, fading);
    double tightness = one_in(&state, 2) ? 0 : between(&state, -1, 20);
    double full = between(&state, -.1, 1.1);
    switch (below(&state, 4)) {
    case 0:
        spread(&state, size, at);
        solid_words(words, "%.99s%.150s", fading, one_in(&state, 2) ? at : "");
        break;
    case 1: solid_words(words, " parallel%.99s%.99s", at, fading); break;
    case 2:
        solid_words(words, beam, " spotlight", at, 60 * full, between(&state, 5, 100),
                    tightness, fading);
        break;
    default:
        solid_words(words, beam, " cylinder", at, size * full,
                    size * between(&state, .1, 1), tightness, fading);
    }
}

/* ---- Normals ------------------------------------------------------------- */

void bump_words(uint64_t state, size_t in, char look[SOLID_WORDS])
{
    static const char *const bumps[] = {
        "gradient x, 2 triangle_wave",
        "onion 3 sine_wave",
        "checker 1",
        "radial 4 frequency 5",
        "hexagon normal { onion 2 scale .3 } normal { planar 3 } "
        "normal { leopard 2 scale .1 }",
        "boxed normal_map { [.2 spherical 5] [.6 gradient y, 9] }",
        "quilted 2 control0 .3",
    };
    char bare[SOLID_WORDS];
    state = stream_beside(state, 7, 3);
    if (!one_in(&state, in))
        return;
    solid_words(bare, "%.*s", SOLID_WORDS - 1, look);
    solid_words(look, "%.150snormal { %.110s scale .7 } ", bare,
                bumps[below(&state, sizeof bumps / sizeof *bumps)]);
}

/* ---- Meshes -------------------------------------------------------------- */

/* Returns a vector. None is parallel to another one or to an axis. */
static const char *inside(uint64_t *state)
{
    static const char *const vectors[] = { "<.31, .83, .17>", "<-.73, .22, .41>",
                                           "<.11, -.27, .94>" };
    return vectors[below(state, 3)];
}

void mesh_box_words(uint64_t state, double corner[2][3], char words[SOLID_WORDS])
{
    /* a corner's number has a bit for each axis: 1 for x, 2 for y, 4 for z */
    static const int sides[6][4] = { { 0, 1, 3, 2 }, { 4, 5, 7, 6 }, { 0, 2, 6, 4 },
                                     { 1, 3, 7, 5 }, { 0, 4, 5, 1 }, { 2, 6, 7, 3 } };
    char points[SOLID_WORDS] = "", faces[SOLID_WORDS] = "";
    state = stream_beside(state, 7, 1);
    for (int i = 0; i < 8; i++) {
        size_t used = strlen(points);
        snprintf(points + used, sizeof points - used, ", <%g, %g, %g>",
                 corner[i & 1][0], corner[i >> 1 & 1][1], corner[i >> 2][2]);
    }
    for (int i = 0; i < 6; i++) {
        size_t used = strlen(faces), k = below(&state, 2);
        const int *p = sides[i];
        snprintf(faces + used, sizeof faces - used, ", <%d, %d, %d>, <%d, %d, %d>",
                 p[k], p[1 + k], p[2 + k], p[2 + k], p[(3 + k) % 4], p[k]);
    }
    solid_words(words,
                "mesh2 { vertex_vectors { 8%s } face_indices { 12%s } "
                "inside_vector %s ",
                points, faces, inside(&state));
}

void mesh_star_words(uint64_t state, char words[SOLID_WORDS])
{
    enum { MAX_ROUND = 8 };
    char points[SOLID_WORDS] = "", faces[SOLID_WORDS] = "";
    state = stream_beside(state, 7, 1);
    int round = 3 + (int)below(&state, MAX_ROUND - 2);
    for (int i = 0; i < round; i++) {
        size_t used = strlen(points);
        double angle = 6.2832 * i / round;
        double far = i % 2 ? between(&state, .2, .5) : between(&state, .6, .9);
        snprintf(points + used, sizeof points - used, ", <%.3f, %.3f, %.3f>",
                 far * cos(angle), between(&state, -.2, .2), far * sin(angle));
        used = strlen(faces);
        snprintf(faces + used, sizeof faces - used, ", <%d, %d, %d>, <%d, %d, %d>", i,
                 (i + 1) % round, round, (i + 1) % round, i, round + 1);
    }
    solid_words(words,
                "mesh2 { vertex_vectors { %d%s, <.01, %.3f, .02>, <.03, "
                "%.3f, -.01> } face_indices { %d%s } inside_vector %s ",
                round + 2, points, between(&state, .25, .9), between(&state, -.9, .1),
                2 * round, faces, inside(&state));
}

void mesh_field_words(uint64_t state, char words[SOLID_WORDS])
{
    char water[40] = "";
    state = stream_beside(state, 7, 1);
    if (one_in(&state, 2))
        snprintf(water, sizeof water, "water_level %.3f ", between(&state, .2, .6));
    size_t columns = 2 + below(&state, 5), rows = 2 + below(&state, 5);
    double along = between(&state, 2, 9), across = between(&state, 2, 9);
    solid_words(words,
                "height_field { function %zu, %zu { .5 + "
                ".3*sin(%.3f*x)*cos(%.3f*y) } %s%stranslate -.5 scale 1.4 ",
                columns, rows, along, across, one_in(&state, 2) ? "smooth " : "",
                water);
}
