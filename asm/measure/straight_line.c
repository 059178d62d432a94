/* straight_line.c - fits a straight line by least squares. */
#include "asm/measure/straight_line.h"

/* Sums are relative to the mean of the points. Sums of absolute values would be nearly
 * equal, and their difference would lose most of its digits. */
struct straight_line straight_line_through(const struct weighted_point *points,
                                           size_t count)
{
    double weight = 0, x = 0, y = 0, xx = 0, xy = 0;
    struct straight_line line;
    for (size_t i = 0; i < count; i++) {
        weight += points[i].weight;
        x += points[i].weight * points[i].x;
        y += points[i].weight * points[i].y;
    }
    x /= weight;
    y /= weight;
    for (size_t i = 0; i < count; i++) {
        double off = points[i].x - x;
        xx += points[i].weight * off * off;
        xy += points[i].weight * off * (points[i].y - y);
    }
    line.slope = xy / xx;
    line.at_zero = y - line.slope * x;
    return line;
}

double straight_line_at(const struct straight_line *line, double x)
{
    return line->at_zero + line->slope * x;
}
