/* mesh_text.c - see mesh_text.h. */
#include "tests/oracle/mesh_text.h"

#include "tests/oracle/chance.h"

#include <math.h>
#include <string.h>

/* No two are along each other, or an axis. */
static const char *inside(uint64_t *state)
{
    static const char *const vectors[] = { "<.31, .83, .17>", "<-.73, .22, .41>",
                                           "<.11, -.27, .94>" };
    return vectors[below(state, 3)];
}

void mesh_box_words(uint64_t state, double corner[2][3], char words[SOLID_WORDS])
{
    /* a bit of a corner's number for each axis: 1 of x, 2 of y, 4 of z */
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
    enum { ROUND_MOST = 8 };
    char points[SOLID_WORDS] = "", faces[SOLID_WORDS] = "";
    state = stream_beside(state, 7, 1);
    int round = 3 + (int)below(&state, ROUND_MOST - 2);
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
