/* plain_mass.c - Monte Carlo integration with stratified points (plain_regions.h). */
#include "tests/oracle/plain_regions.h"

#include "tests/oracle/chance.h"
#include "tests/oracle/many_scenes.h"

#include <string.h>

enum { CELLS = 24, TURNS = 8 };

struct box {
    const struct scene *scene;
    const double *middle, *width;
    struct crossing_list *crossings;
};

/* Returns a random coordinate of a cell, relative to the centre of the box. */
static double place_in(uint64_t *state, double width, size_t cell)
{
    return width * (((double)cell + between(state, 0, 1)) / CELLS - .5);
}

/* Adds the points on a line along z that are inside a region. */
static void add_line(const struct box *box, uint64_t *state, double x, double y,
                     double sum[PLAIN_MASS_FIGURES])
{
    const struct ray ray = { { box->middle[0] + x, box->middle[1] + y, box->middle[2] },
                             { 0, 0, 1 } };
    double z[CELLS];
    bool inside[CELLS] = { false };
    for (size_t k = 0; k < CELLS; k++)
        z[k] = place_in(state, box->width[2], k);
    for (size_t i = 0; i < box->scene->region_count; i++) {
        plain_cross_region(box->crossings, box->scene, &box->scene->regions[i], &ray);
        for (size_t k = 0; k < CELLS; k++)
            inside[k] = inside[k] || plain_holds(box->crossings, z[k]);
    }
    for (size_t k = 0; k < CELLS; k++)
        if (inside[k]) {
            sum[0] += 1;
            sum[1] += x;
            sum[2] += y;
            sum[3] += z[k];
        }
}

static void one_turn(const struct box *box, uint64_t *state,
                     double sum[PLAIN_MASS_FIGURES])
{
    const double *width = box->width;
    double cell = width[0] * width[1] * width[2] / (CELLS * CELLS * CELLS);
    for (size_t i = 0; i < CELLS; i++)
        for (size_t k = 0; k < CELLS; k++) {
            double x = place_in(state, width[0], i);
            double y = place_in(state, width[1], k);
            add_line(box, state, x, y, sum);
        }
    for (size_t i = 0; i < PLAIN_MASS_FIGURES; i++)
        sum[i] *= cell;
}

void plain_mass(const struct scene *scene, const double middle[3],
                const double width[3], uint64_t *state,
                double value[PLAIN_MASS_FIGURES], double error[PLAIN_MASS_FIGURES])
{
    struct box box = { scene, middle, width, crossing_list_new(scene) };
    double sum[TURNS][PLAIN_MASS_FIGURES] = { { 0 } };
    need(box.crossings);
    for (size_t turn = 0; turn < TURNS; turn++)
        one_turn(&box, state, sum[turn]);
    for (size_t i = 0; i < PLAIN_MASS_FIGURES; i++) {
        value[i] = error[i] = 0;
        for (size_t turn = 0; turn < TURNS; turn++)
            value[i] += sum[turn][i] / TURNS;
        for (size_t turn = 0; turn < TURNS; turn++)
            error[i] += pow(sum[turn][i] - value[i], 2) / TURNS / (TURNS - 1);
        error[i] = sqrt(error[i]);
    }
    crossing_list_free(box.crossings);
}
