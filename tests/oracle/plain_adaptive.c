/* plain_adaptive.c - refines pixels adaptively, block by block (plain_adaptive.h). */
#include "tests/oracle/plain_adaptive.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

enum { BLOCK = 32, COLOURS = 3 };

struct visit {
    const struct frame *first, *sampled;
    size_t samples, width; /* width of `first`: the width of the picture plus 1 */
    double threshold, power;
    struct frame shown; /* has the size of `first` */
    bool *refined;
    struct plain_refined result;
};

static double power(const struct visit *visit, double colour)
{
    return colour > 0 ? pow(colour, visit->power) : 0;
}

static bool differs(struct visit *visit, const struct frame *there, size_t neighbour,
                    size_t pixel)
{
    double distance = 0;
    for (int i = 0; i < COLOURS; i++)
        distance += fabs(power(visit, there->channel[i][neighbour])
                         - power(visit, visit->first->channel[i][pixel]));
    visit->result.margin = fmin(visit->result.margin,
                                fabs(distance - visit->threshold));
    return distance >= visit->threshold;
}

static double sum_of_samples(const struct visit *visit, int channel, size_t pixel)
{
    size_t n = visit->samples, across = n * visit->width;
    size_t row = pixel / visit->width, column = pixel % visit->width;
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            sum += visit->sampled
                       ->channel[channel][(row * n + i) * across + column * n + j];
    return sum;
}

static void refine(struct visit *visit, size_t pixel)
{
    double rays = (double)(visit->samples * visit->samples + 1);
    if (visit->refined[pixel])
        return;
    visit->refined[pixel] = true;
    visit->result.count++;
    for (int i = 0; i < COLOURS; i++)
        visit->shown.channel[i][pixel] = (visit->first->channel[i][pixel]
                                          + sum_of_samples(visit, i, pixel))
                                         / rays;
}

static bool held_against(struct visit *visit, size_t pixel, size_t back, bool in_block)
{
    if (!differs(visit, in_block ? &visit->shown : visit->first, pixel - back, pixel))
        return false;
    if (in_block)
        refine(visit, pixel - back);
    return true;
}

static void visit_pixel(struct visit *visit, size_t row, size_t column)
{
    size_t pixel = row * visit->width + column;
    bool left = held_against(visit, pixel, 1, (column - 1) % BLOCK != 0);
    bool above = held_against(visit, pixel, visit->width, (row - 1) % BLOCK != 0);
    if (left || above)
        refine(visit, pixel);
}

/* Visits the picture block by block. */
static void visit_all(struct visit *visit)
{
    size_t width = visit->width, height = visit->first->height;
    for (size_t top = 1; top < height; top += BLOCK)
        for (size_t left = 1; left < width; left += BLOCK)
            for (size_t row = top; row < height && row < top + BLOCK; row++)
                for (size_t column = left; column < width && column < left + BLOCK;
                     column++)
                    visit_pixel(visit, row, column);
}

static void copy_colours(const struct frame *from, struct frame *to, size_t border)
{
    for (int i = 0; i < COLOURS; i++)
        for (size_t row = border; row < from->height; row++)
            for (size_t column = border; column < from->width; column++)
                to->channel[i][(row - border) * to->width + column - border] =
                    from->channel[i][row * from->width + column];
}

struct plain_refined plain_adaptive(const struct frame *first,
                                    const struct frame *sampled, size_t samples,
                                    double threshold, double gamma,
                                    struct frame *picture)
{
    struct visit visit = { .first = first,
                           .sampled = sampled,
                           .samples = samples,
                           .width = first->width,
                           .threshold = threshold,
                           .power = gamma / 2.5,
                           .result = { 0, INFINITY } };
    visit.refined = calloc(first->width * first->height, sizeof(bool));
    if (!visit.refined || !frame_allocate(&visit.shown, first->width, first->height))
        abort();
    copy_colours(first, &visit.shown, 0);
    visit_all(&visit);
    copy_colours(&visit.shown, picture, 1);
    frame_free(&visit.shown);
    free(visit.refined);
    return visit.result;
}
