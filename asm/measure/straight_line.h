/* straight_line.h - fits a straight line to weighted points by least squares. The line
 * has the smallest sum of weight (y - line)^2. */
#ifndef ASM_STRAIGHT_LINE_H
#define ASM_STRAIGHT_LINE_H

#include <stddef.h>

struct weighted_point {
    double x, y, weight;
};

struct straight_line {
    double at_zero, slope;
};

/* Returns the fitted line. There must be at least two points with different x and
 * positive weights. */
struct straight_line straight_line_through(const struct weighted_point *points,
                                           size_t count);
double straight_line_at(const struct straight_line *line, double x);

#endif
