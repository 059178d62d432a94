/* emitter.c - builds the pieces that the kernels of emission sample. */
#include "rt/shapes/emitter.h"

#include <stdlib.h>

#include "rt/scene/vector3.h"
#include "rt/shapes/axis.h"

const char emitter_no_memory[] = "out of memory";

void emitter_free(struct emitter *emitter)
{
    free(emitter->pieces);
    free(emitter->areas);
    emitter->pieces = emitter->areas = NULL;
}

/* ---- Pieces -------------------------------------------------------------- */

bool emitter_begin(struct emitter *emitter, const char *kernel, size_t most,
                   size_t words)
{
    emitter->kernel = kernel;
    emitter->piece_words = words;
    emitter->pieces = malloc(most * words * sizeof *emitter->pieces);
    emitter->areas = malloc(most * sizeof *emitter->areas);
    return emitter->pieces && emitter->areas;
}

/* Adds a piece with an area. Returns its words, which the caller sets. */
static double *next_piece(struct emitter *emitter, double area)
{
    emitter->areas[emitter->piece_count] = area;
    emitter->area += area;
    return emitter->pieces + emitter->piece_words * emitter->piece_count++;
}

void emitter_add_frustum(struct emitter *emitter, double y1, double r1, double y2,
                         double r2)
{
    double rise = y2 - y1, widens = r2 - r1;
    double length = sqrt(rise * rise + widens * widens);
    double area = PI * (r1 + r2) * length;
    if (area > 0) {
        const double words[FRUSTUM_WORDS] = { y1, rise,          r1,
                                              r2, rise / length, -widens / length };
        memcpy(next_piece(emitter, area), words, sizeof words);
    }
}

void emitter_add_triangle(struct emitter *emitter, const double a[3], const double b[3],
                          const double c[3])
{
    double first[3], second[3], normal[3], twice, *words;
    subtract3(b, a, first);
    subtract3(c, a, second);
    cross3(first, second, normal);
    twice = length3(normal);
    if (!(twice > 0))
        return;
    scale3(1 / twice, normal);
    words = next_piece(emitter, twice / 2);
    copy3(a, words);
    copy3(first, words + 3);
    copy3(second, words + 6);
    copy3(normal, words + 9);
}

/* ---- Common shapes ------------------------------------------------------- */

enum { MAX_FRUSTA = 3 };

bool emitter_about_axis(struct emitter *emitter, const double base[3],
                        const double cap[3], double *half_length)
{
    double words[12];
    *half_length = axis_words(base, cap, words) / 2;
    for (size_t i = 0; i < 3; i++) {
        double *row = emitter->to_own.rows[i];
        row[0] = words[3 + i];
        row[1] = words[9 + i];
        row[2] = words[6 + i];
        row[3] = words[i];
    }
    return emitter_begin(emitter, "emit_frustum", MAX_FRUSTA, FRUSTUM_WORDS);
}

const char *emitter_cone(const double base[3], double base_radius, const double cap[3],
                         double cap_radius, bool open, struct emitter *emitter)
{
    double half;
    if (!emitter_about_axis(emitter, base, cap, &half))
        return emitter_no_memory;
    emitter_add_frustum(emitter, -half, base_radius, half, cap_radius);
    if (!open) {
        emitter_add_frustum(emitter, -half, 0, -half, base_radius);
        emitter_add_frustum(emitter, half, cap_radius, half, 0);
    }
    return NULL;
}

const char *emitter_torus(double major, double radial, double axial,
                          struct emitter *emitter)
{
    if (radial > major)
        return "a torus that intersects itself cannot emit";
    emitter->kernel = "emit_torus";
    emitter->area = 4 * PI * PI;
    emitter->form[0] = major;
    emitter->form[1] = radial;
    emitter->form[2] = axial;
    return NULL;
}
