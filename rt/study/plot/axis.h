/* axis.h - an axis of a plot: what it reaches over and where it is labelled.
 *
 * gnuplot separates the thousands of numbers only in some locales, so the
 * labels are made here.
 */
#ifndef RT_PLOT_AXIS_H
#define RT_PLOT_AXIS_H

#include "rt/study/plot/plot.h"

struct axis {
    enum plot_scale scale;
    double low, high; /* low > high: nothing yet */
};

enum { AXIS_TICS = 128, AXIS_LABEL_SIZE = 32 };

struct axis_tic {
    double at;
    char label[AXIS_LABEL_SIZE]; /* "16,384"; "" for a small tic between */
};

struct axis axis_new(enum plot_scale scale);
/* Can the axis show the value?  A logarithmic one shows what is above 0. */
bool axis_shows(const struct axis *axis, double value);
/* Let it reach the value. */
void axis_reach(struct axis *axis, double value);
/* No axis of one point: it is widened on both sides. */
void axis_widen(struct axis *axis);
/* Room for the points at both ends. */
void axis_pad(struct axis *axis);
/* On to the next round value on both sides; a linear axis reaches 0. */
void axis_round(struct axis *axis);

/* From 0 at its low end to 1 at its high end. */
double axis_place(const struct axis *axis, double value);
/* A number as labels have it: "16,384". */
void axis_label(char label[AXIS_LABEL_SIZE], double value);
/* At most ten labels, and the tics between them; how many. */
size_t axis_tics(const struct axis *axis, struct axis_tic tics[AXIS_TICS]);

#endif
